// View modes: computed as the library computes, drawn as its pictures are.
#include "viewer/window/plane/view_mode.h"

#include <gmock/gmock.h>

#include <atomic>
#include <bit>
#include <cmath>
#include <sstream>

#include "geometry/plane/exchange/closed_forms.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/critical_points.h"
#include "geometry/plane/visibility/point_view.h"
#include "geometry/scene_names.h"
#include "io/results/plane/check_report.h"
#include "io/results/plane/visibility_report.h"
#include "io/results/solve_report.h"
#include "io/scene/scene_json.h"
#include "kernel/decimal.h"
#include "kernel/support/interrupt.h"
#include "solver/plane/check/scene_check.h"
#include "solver/plane/compare/method_comparison.h"
#include "solver/plane/methods/computed_factors.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/plane/simulation/queries.h"
#include "tests/viewer/edit/plane/edited_scenes.h"
#include "viewer/edit/plane/scene_edits.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/palette.h"
#include "viewer/picture/plane/error_map.h"
#include "viewer/picture/plane/illumination_painter.h"
#include "viewer/picture/plane/light_pixels.h"
#include "viewer/picture/plane/scene_painter.h"
#include "viewer/picture/plane/visibility_painter.h"
#include "viewer/picture/recording_canvas.h"
#include "viewer/picture/tone_curve.h"
#include "viewer/window/plane/camera.h"
#include "viewer/window/plane/view_painter.h"

namespace hottel::view_mode_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Kind = RecordingCanvas::Kind;

const StageProgress kNoProgress = [](std::string_view, double) {};

LiveState2 state_of(const Scene2& scene) {
  LiveScene2 live({});
  live.set(std::make_shared<const Scene2>(scene), LiveDepth2::kFull);
  EXPECT_TRUE(live.wait(300));
  return *live.state();
}

// The room of all tests here, lit.
const LiveState2& room() {
  static const LiveState2 kRoom = state_of(small_room());
  return kRoom;
}

// A scene without light: two claims on one place.
LiveState2 dark() {
  return state_of(parse_scene_2(
      R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5}, "n": {"emission": 2}},
    "edges": [{"name": "one", "points": [[0,0],[2,0]], "material": "m"},
              {"name": "two", "points": [[1,0],[3,0]], "material": "n"}]})",
      "dark.json"));
}

// The room with a screen that just misses the wall.
Scene2 room_with_a_near_miss() { return move_end(small_room(), 0, true, {1, Rational(29999) / 10000}); }

// Values as bits: in solids there are none.
std::vector<std::uint64_t> bits_of(const SolvedLight2& light) {
  std::vector<std::uint64_t> bits;
  for (const double value : light.grid.values) bits.push_back(std::bit_cast<std::uint64_t>(value));
  return bits;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

// The words of a text: blanks and tabs are all alike.
std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

TEST(ViewMode2, HasAWordEach) {
  std::vector<std::string> words;
  for (int k = 0; k < kViewModes2; ++k) {
    const auto mode = static_cast<ViewMode2>(k);
    EXPECT_EQ(view_mode_2(to_string(mode)), mode);
    words.emplace_back(to_string(mode));
  }
  EXPECT_THAT(words, ElementsAre("light", "floor", "bands", "visibility", "factors", "pair", "errors", "check", "plan",
                                 "sweeps"));
  for (const char* word : {"", "Light", "ligh", "lights"}) EXPECT_EQ(view_mode_2(word), std::nullopt);
}

TEST(ViewMode2, NeedsWorkUnlessTheStateHasIt) {
  for (int k = 0; k < kViewModes2; ++k) {
    ViewRequest2 request{.mode = static_cast<ViewMode2>(k)};
    const bool is_of_mouse = request.mode <= ViewMode2::kVisibility;
    EXPECT_EQ(needs_work(request), !is_of_mouse);
    request.mouse = Point2{1, 1};
    EXPECT_TRUE(needs_work(request));
  }
}

TEST(ComputeView2, TellsTheLightAtTheMouse) {
  const Point2 mouse{Rational(1) / 2, 2};
  const PointLight2 light = light_at(*room().simulation, mouse);
  std::string expected;
  for (const double value : light.mean_irradiance) expected += (expected.empty() ? "" : " ") + shortest(value);
  for (const ViewMode2 mode : {ViewMode2::kLight, ViewMode2::kFloor, ViewMode2::kBands, ViewMode2::kVisibility}) {
    const ViewResult2 result = compute_view(room(), {.mode = mode, .mouse = mouse}, kNoProgress);
    EXPECT_EQ(result.number, expected);
    EXPECT_EQ(result.version, room().version);
    EXPECT_EQ(result.request.mode, mode);
    EXPECT_TRUE(result.is_done);
    EXPECT_EQ(result.sight.has_value(), mode == ViewMode2::kVisibility);
  }
}

TEST(ComputeView2, TellsWhatTheMouseSees) {
  for (const Point2& mouse :
       {Point2{Rational(1) / 2, 2}, Point2{1, 2}, Point2{9, 9}, Point2{Rational(5) / 2, Rational(3) / 2}}) {
    const ViewResult2 result = compute_view(room(), {.mode = ViewMode2::kVisibility, .mouse = mouse}, kNoProgress);
    const PointView2 sight = point_view(*room().prepared, mouse);
    const VisibilityDrawing2 drawing = drawing_of(sight.polygon);
    ASSERT_TRUE(result.sight);
    EXPECT_EQ(result.sight->polygon, drawing.polygon);
    EXPECT_EQ(result.sight->eye, drawing.eye);
    for (const SeenFrom2& seen : sight.faces)
      EXPECT_THAT(words_of(joined(result.lines)),
                  testing::IsSupersetOf(words_of(shortest(seen.fraction.value) + " " + seen.name)));
    if (sight.polygon.area) {
      EXPECT_THAT(joined(result.lines), HasSubstr("area " + decimal_text(*sight.polygon.area)));
    }
  }
}

// A line of the report, without its closed form; what the panel must say of a pair.
TEST(ComputeView2, TellsAllThatIsKnownOfAPair) {
  const Scene2& scene = room().prepared->scene;
  const Face from{1, false}, to{3, false};
  const PairSight2 sight{.from = "room[0]",
                         .to = "room[2]",
                         .face_from = from,
                         .face_to = to,
                         .pair = exact_pair(*room().prepared, from, to),
                         .critical = critical_points(*room().prepared, from, to)};
  ASSERT_EQ(scene.surfaces[1].name, "room[0]");
  const ViewResult2 whole =
      compute_view(room(), {.mode = ViewMode2::kPair, .face = "room[0]", .other = "room[2]", .wants_closed_form = true},
                   kNoProgress);
  EXPECT_EQ(words_of(joined(whole.lines)), words_of(pair_answer(sight).text));
  ASSERT_TRUE(whole.pair);
  EXPECT_EQ(whole.pair->critical_on_a, drawing_of(sight).critical_on_a);
  EXPECT_FALSE(whole.pair->critical_on_a.empty());

  const ViewResult2 brief =
      compute_view(room(), {.mode = ViewMode2::kPair, .face = "room[0]", .other = "room[2]"}, kNoProgress);
  EXPECT_EQ(brief.lines.size(), whole.lines.size());
  EXPECT_THAT(joined(brief.lines), Not(HasSubstr("sqrt")));
  EXPECT_THAT(joined(whole.lines), HasSubstr("sqrt"));
  const double factor = view_factor(*room().simulation, "room[0]", "room[2]").value;
  EXPECT_EQ(std::stod(brief.number), factor);
  EXPECT_EQ(std::stod(whole.number), factor);
}

TEST(ComputeView2, TellsTheFactorOfTheFaceUnderTheMouse) {
  const Face from{1, false};
  for (std::uint32_t s = 0; s < small_room().surfaces.size(); ++s)
    for (const bool is_back : {false, true}) {
      const Face to{s, is_back};
      const ViewResult2 result = compute_view(
          room(), {.mode = ViewMode2::kFactors, .face = "room[0]", .other = face_name(small_room(), to)}, kNoProgress);
      EXPECT_FALSE(result.pair);
      EXPECT_THAT(result.lines, Not(Contains(StartsWith("critical"))));
      const ExactPair2 pair = exact_pair(*room().prepared, from, to);
      EXPECT_NEAR(std::stod(result.number),
                  std::stod(decimal_text(pair.exchange)) / std::stod(decimal_text(pair.area_from)), 1e-15)
          << s;
    }
}

// A version that counts its surfaces otherwise: faces are asked for by name.
TEST(ComputeView2, FacesAreThoseOfTheirNamesInEveryVersion) {
  const LiveState2 without_screen = state_of(erase_surfaces(small_room(), std::vector<std::uint32_t>{0}));
  const ViewRequest2 request{.mode = ViewMode2::kPair, .face = "room[0]", .other = "room[2]"};
  const ViewResult2 here = compute_view(room(), request, kNoProgress),
                    there = compute_view(without_screen, request, kNoProgress);
  EXPECT_EQ(there.lines[0], here.lines[0]);
  EXPECT_EQ(std::stod(there.number), view_factor(*without_screen.simulation, "room[0]", "room[2]").value);
  EXPECT_EQ(face_called(*without_screen.scene, "room[0]"), (Face{0, false}));
  EXPECT_EQ(face_called(*room().scene, "screen:back"), (Face{0, true}));
  EXPECT_EQ(face_called(*without_screen.scene, "screen"), std::nullopt);
}

TEST(ComputeView2, AsksForFacesThatAreMissing) {
  EXPECT_THAT(compute_view(room(), {.mode = ViewMode2::kPair}, kNoProgress).lines,
              ElementsAre(HasSubstr("then another")));
  EXPECT_THAT(compute_view(room(), {.mode = ViewMode2::kFactors}, kNoProgress).lines, ElementsAre("click a face"));
  EXPECT_THAT(compute_view(room(), {.mode = ViewMode2::kFactors, .face = "room[3]"}, kNoProgress).lines,
              ElementsAre("from room[3]", HasSubstr("under the mouse")));
  // Faces of another version of the scene.
  EXPECT_TRUE(compute_view(room(), {.mode = ViewMode2::kPair, .face = "none"}, kNoProgress).lines.empty());
  EXPECT_FALSE(compute_view(room(), {.mode = ViewMode2::kPair, .face = "room[0]", .other = "none"}, kNoProgress).pair);
}

TEST(ComputeView2, HasErrorsAsCompareHasThem) {
  for (const char* name : {"rays:1000", "center-vis", "gauss:2"}) {
    const ViewResult2 result = compute_view(room(), {.mode = ViewMode2::kErrors, .method = name}, kNoProgress);
    const MethodComparison2 comparison(*room().simulation);
    const MethodResult expected = comparison.run(*methods_2().make(name), 1);
    EXPECT_EQ(result.number, shortest(expected.errors.max)) << name;
    ASSERT_FALSE(result.lines.empty());
    EXPECT_EQ(result.lines[0], expected.info.name);
    const ScenePicture2 picture = error_map_picture_2(comparison, expected);
    ASSERT_EQ(result.plan.has_value(), picture.colouring.has_value()) << name;
    if (!result.plan) continue;
    EXPECT_EQ(result.plan->colouring->front, picture.colouring->front);
    EXPECT_EQ(result.plan->colouring->elements, picture.colouring->elements);
    EXPECT_EQ(result.plan->pixels->image, picture.pixels->image);
    EXPECT_THAT(result.times, HasSubstr(expected.info.name));
  }
}

TEST(ComputeView2, TellsWhatCannotBeHad) {
  const ViewResult2 none = compute_view(room(), {.mode = ViewMode2::kErrors, .method = "no such method"}, kNoProgress);
  EXPECT_THAT(none.lines, ElementsAre(HasSubstr("no such method")));
  for (int k = 0; k < kViewModes2; ++k) {
    const ViewRequest2 request{.mode = static_cast<ViewMode2>(k), .mouse = Point2{1, 1}, .face = "one", .other = "two"};
    const ViewResult2 result = compute_view(dark(), request, kNoProgress);  // and does not throw
    EXPECT_FALSE(result.light);
    EXPECT_FALSE(result.plan);
  }
}

TEST(ComputeView2, FindsWhatCheckFinds) {
  for (const LiveState2& state : {dark(), state_of(room_with_a_near_miss())}) {
    const ViewResult2 result = compute_view(state, {.mode = ViewMode2::kCheck}, kNoProgress);
    const auto check = state.simulation->check();
    std::size_t places = 0;
    for (std::size_t k = 0; k < check->findings.size(); ++k) {
      const Finding2& finding = check->findings[k];
      EXPECT_THAT(joined(result.lines), HasSubstr(std::to_string(k + 1)));
      EXPECT_THAT(joined(result.lines), HasSubstr(finding.message));
      EXPECT_THAT(joined(result.lines), HasSubstr(finding.suggestion));
      if (!finding.at) continue;
      ASSERT_LT(places, result.findings.size());
      EXPECT_EQ(result.findings[places].at, *finding.at);
      EXPECT_EQ(result.findings[places].severity, finding.severity);
      EXPECT_EQ(result.findings[places++].number, k + 1);
    }
    EXPECT_EQ(places, result.findings.size());
    EXPECT_FALSE(check->findings.empty());
  }
}

TEST(ComputeView2, SaysThePlanOfTheSimulation) {
  const ViewResult2 result = compute_view(room(), {.mode = ViewMode2::kPlan}, kNoProgress);
  EXPECT_EQ(words_of(joined(result.lines)), words_of(plan_text(*room().simulation->plan())));
}

TEST(ComputeView2, SweepsAreThoseOfSolveWithSoManyIterations) {
  for (const Solver solver : {Solver::kGaussSeidel, Solver::kJacobi, Solver::kShooting, Solver::kCg}) {
    std::vector<ViewResult2> told;
    ViewResult2 last = compute_view(room(), {.mode = ViewMode2::kSweeps, .solver = solver}, kNoProgress);
    EXPECT_TRUE(last.is_done);
    const StageProgress until_five = [&](std::string_view, double) {};
    try {
      compute_view(room(), {.mode = ViewMode2::kSweeps, .solver = solver}, until_five, [&](const ViewResult2& result) {
        told.push_back(result);
        if (told.size() == 5) throw Interrupted();
      });
      FAIL();
    } catch (const Interrupted&) {
    }
    ASSERT_EQ(told.size(), 5u);
    told.push_back(last);
    for (std::size_t k = 0; k < told.size(); ++k) {
      const int sweeps = k < 5 ? static_cast<int>(k) : kMostSweeps;
      SimulationRequest2 request{.system = {.solver = solver, .iterations = sweeps}};
      const Simulation2 fresh(small_room(), request);
      ASSERT_TRUE(told[k].light);
      EXPECT_TRUE(bits_of(*told[k].light) == bits_of(*fresh.light())) << to_string(solver) << " " << k;
      EXPECT_EQ(told[k].is_done, k == 5);
      EXPECT_THAT(told[k].lines[0], HasSubstr(", " + std::to_string(sweeps) + " "));
    }
  }
}

// Work that waits is asked about every 20 ms, and ends where its own stop is asked for.
TEST(ComputeView2, StopsWhereItIsStopped) {
  const std::atomic<bool> is_stopped = true;
  const StopScope scope(&is_stopped);
  const StageProgress progress = [](std::string_view, double) { throw_if_interrupted(); };
  LiveState2 fresh;
  fresh.simulation = Simulation2(small_room());
  fresh.factors = room().factors;
  for (const ViewMode2 mode : {ViewMode2::kErrors, ViewMode2::kCheck, ViewMode2::kSweeps})
    EXPECT_THROW(compute_view(fresh, {.mode = mode}, progress), Interrupted) << to_string(mode);
}

// How it is drawn.

constexpr FrameSize kSize{640, 480};
constexpr double kUnit = 1, kFooter = 118;

Frame2 frame_of(const Scene2& scene) {
  Camera2 camera;
  camera.fit(scene, kSize, 20, 20, 130);
  return camera.frame(kSize);
}

RecordingCanvas drawn(const LiveState2& state, const ViewRequest2& request, const ViewResult2* result = nullptr,
                      ToneChoice tone = {}) {
  RecordingCanvas canvas(kSize.width, kSize.height);
  draw_view(canvas, frame_of(*state.scene), kUnit,
            {.state = &state, .request = &request, .result = result, .tone = tone});
  return canvas;
}

RecordingCanvas drawn(const LiveState2& state, const ViewRequest2& request, const ViewResult2& result) {
  return drawn(state, request, &result);
}

template <class Painter>
RecordingCanvas painted(const Painter& painter) {
  RecordingCanvas canvas(kSize.width, kSize.height);
  painter.draw(canvas);
  return canvas;
}

SceneSheet2 sheet_of(const LiveState2& state) {
  return SceneSheet2(*state.prepared, frame_of(*state.scene), kUnit, kFooter);
}

// Whether two canvases had the very same calls.
void expect_same(const RecordingCanvas& a, const RecordingCanvas& b) {
  ASSERT_EQ(a.calls().size(), b.calls().size());
  ASSERT_FALSE(a.calls().empty());
  for (std::size_t k = 0; k < a.calls().size(); ++k) {
    const auto &x = a.calls()[k], &y = b.calls()[k];
    EXPECT_TRUE(x.kind == y.kind && x.mark == y.mark && x.points == y.points && x.colour == y.colour &&
                x.size == y.size && x.text == y.text && x.image == y.image && x.clip == y.clip)
        << k;
  }
}

TEST(DrawView2, PlansAreThoseOfThePicture) {
  const ScenePicture2 plain;
  const RecordingCanvas expected = painted(ScenePicturePainter2(*room().prepared, plain, sheet_of(room())));
  expect_same(drawn(room(), {.mode = ViewMode2::kPlan}), expected);
  // What has nothing to show yet is the plan too.
  for (const ViewMode2 mode : {ViewMode2::kVisibility, ViewMode2::kFactors, ViewMode2::kPair, ViewMode2::kCheck})
    expect_same(drawn(room(), {.mode = mode}), expected);
}

TEST(DrawView2, SightIsThatOfThePicture) {
  const ViewRequest2 request{.mode = ViewMode2::kVisibility, .mouse = Point2{Rational(1) / 2, 2}};
  const ViewResult2 result = compute_view(room(), request, kNoProgress);
  expect_same(drawn(room(), request, result), painted(VisibilityPainter2(*result.sight, sheet_of(room()))));
}

TEST(DrawView2, PairsAreThoseOfThePicture) {
  const ViewRequest2 request{.mode = ViewMode2::kPair, .face = "room[0]", .other = "room[2]"};
  const ViewResult2 result = compute_view(room(), request, kNoProgress);
  const RecordingCanvas canvas = drawn(room(), request, result);
  expect_same(canvas, painted(PairPainter2(*result.pair, sheet_of(room()))));
  EXPECT_GT(canvas.count(Mark::kCritical), 0u);
}

TEST(DrawView2, ResultsOfAnotherVersionAreNotDrawn) {
  LiveState2 later = room();
  ++later.version;
  for (int k = 0; k < kViewModes2; ++k) {
    const ViewRequest2 request{
        .mode = static_cast<ViewMode2>(k), .mouse = Point2{1, 1}, .face = "room[0]", .other = "room[2]"};
    if (request.mode == ViewMode2::kSweeps) continue;  // its light is tested below
    const ViewResult2 result = compute_view(room(), request, kNoProgress);
    expect_same(drawn(later, request, result), drawn(later, request));
  }
  const ViewRequest2 request{.mode = ViewMode2::kSweeps};
  ViewResult2 result{.version = room().version, .request = request};
  auto doubled = std::make_shared<SolvedLight2>(*room().light);
  for (double& value : doubled->grid.values) value *= value;
  result.light = doubled;
  expect_same(drawn(later, request, result), drawn(later, request));
  EXPECT_NE(drawn(room(), request, result).calls(Mark::kLight, Kind::kImage)[0].image,
            drawn(room(), request).calls(Mark::kLight, Kind::kImage)[0].image);
}

TEST(DrawView2, BandsAreOneStripeForEachElement) {
  const RecordingCanvas canvas = drawn(room(), {.mode = ViewMode2::kBands});
  const ExchangeMatrix& matrix = room().factors->matrix;
  std::size_t rows = 0;
  std::vector<Colour> colours;
  double most = 0;
  const auto mean = [&](std::uint32_t i) {
    double sum = 0;
    for (const ChannelSolution& channel : room().radiosities->channels) sum += channel.elements[i].radiosity;
    return sum / static_cast<double>(room().radiosities->channels.size());
  };
  for (const ChannelSolution& channel : room().radiosities->channels)
    for (const ElementRadiosity& element : channel.elements) most = std::max(most, element.radiosity);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    ++rows;
    colours.push_back(map_colour(ColourScale{1e-3 * most, most, true}.position(mean(i))));
  }
  // The floor beneath the step's foot and parts of walls apart, each element has one straight part.
  EXPECT_GE(canvas.count(Mark::kStripe), rows - 2);
  for (const auto& stripe : canvas.calls(Mark::kStripe)) EXPECT_THAT(colours, Contains(stripe.colour));
  std::size_t of_step = 0;  // two surfaces of two elements each
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    of_step += matrix.has_row(i) && matrix.elements()[i].surface / 2 == 2 ? 1 : 0;
  EXPECT_GE(of_step, 2u);
}

TEST(DrawView2, FactorsColourTheFacesThatAreSeen) {
  const Face from{1, false};
  const RecordingCanvas canvas = drawn(room(), {.mode = ViewMode2::kFactors, .face = "room[0]"});
  const ExchangeMatrix by_face = *[&] {
    SimulationRequest2 request;
    request.granularity = Granularity::kFace;
    return std::make_shared<ExchangeMatrix>(room().simulation->with_request(request).factors()->matrix);
  }();
  double largest = 0;
  std::vector<double> factors;
  for (std::uint32_t i = 0; i < by_face.size(); ++i) {
    if (by_face.elements()[i].surface != from.surface || by_face.elements()[i].is_back) continue;
    for (const FactorEntry& entry : by_face.row(i)) {
      if (entry.to == by_face.sky()) continue;
      factors.push_back(entry.factor.value);
      largest = std::max(largest, entry.factor.value);
    }
  }
  ASSERT_GT(factors.size(), 3u);
  EXPECT_GT(canvas.count(Mark::kStripe), 3u);
  const ColourScale scale{1e-4, largest, true};
  for (const auto& stripe : canvas.calls(Mark::kStripe)) {
    double nearest = 1;
    for (const double factor : factors) {
      const Colour colour = map_colour(scale.position(factor));
      nearest = std::min(nearest, std::abs(colour.r - stripe.colour.r) + std::abs(colour.g - stripe.colour.g) +
                                      std::abs(colour.b - stripe.colour.b));
    }
    EXPECT_LT(nearest, 1e-6);
  }
  EXPECT_TRUE(canvas.wrote("view factor from room[0]"));
}

TEST(DrawView2, LightLiesBeneathThePlan) {
  const RecordingCanvas canvas = drawn(room(), {});
  const auto light = canvas.calls(Mark::kLight, Kind::kImage);
  ASSERT_EQ(light.size(), 1u);
  EXPECT_EQ(light[0].image, light_texture_2(room(), {}, light[0].image.width / room().light->grid.grid.nx));
  // That of the state is taken as it is; of another state, or by another tone, it is not drawn.
  const auto state = std::make_shared<const LiveState2>(room());
  const LightTexture2 texture{state, {}, 3, light_texture_2(*state, {}, 3)};
  const ViewRequest2 request;
  const auto image = [&](const LiveState2& drawn, const ToneChoice& tone) {
    RecordingCanvas given(kSize.width, kSize.height);
    draw_view(given, frame_of(*drawn.scene), kUnit,
              {.state = &drawn, .request = &request, .tone = tone, .texture = &texture});
    return given.calls(Mark::kLight, Kind::kImage)[0].image;
  };
  EXPECT_EQ(image(*state, {}), texture.raster);
  EXPECT_EQ(image(room(), {}), light[0].image);
  EXPECT_NE(image(*state, {Tone::kMax, 2}), texture.raster);
  const Frame2 frame = frame_of(*room().scene);
  const Grid2& grid = room().light->grid.grid;
  EXPECT_EQ(light[0].points[0], frame.at(Point2{grid.min.x, grid.max.y}));
  EXPECT_EQ(light[0].points[1], frame.at(Point2{grid.max.x, grid.min.y}));
  // All after it is LitPlan2.
  const IlluminationGrid2& values = room().light->grid;
  const ToneCurve tone(Tone::kLog, 1, values.values, values.channels);
  RecordingCanvas plan(kSize.width, kSize.height);
  LitPlan2(*room().prepared, frame, kUnit).draw(plan, tone);
  ASSERT_EQ(canvas.calls().size(), plan.calls().size() + 2);
  for (std::size_t k = 0; k < plan.calls().size(); ++k) {
    EXPECT_EQ(canvas.calls()[k + 2].points, plan.calls()[k].points);
    EXPECT_EQ(canvas.calls()[k + 2].mark, plan.calls()[k].mark);
  }
}

TEST(DrawView2, TexturesAreThePixelsOfThePicture) {
  const IlluminationGrid2& values = room().light->grid;
  for (const Tone tone : {Tone::kLog, Tone::kReinhard, Tone::kLinear, Tone::kMax})
    for (const std::uint32_t pixels : {1u, 2u, 5u}) {
      const ToneCurve curve(tone, 2, values.values, values.channels);
      const Raster expected = toned_pixels_2(
          values, LightPixels2(values, pixels, pixels, pixels > 1 ? room().scene.get() : nullptr), curve);
      EXPECT_EQ(light_texture_2(room(), {tone, 2}, pixels), expected);
      EXPECT_EQ(expected.width, values.grid.nx * pixels);
    }
}

TEST(DrawView2, FloorsShowTheirColourTimesTheLight) {
  const RecordingCanvas canvas = drawn(room(), {.mode = ViewMode2::kFloor});
  const auto light = canvas.calls(Mark::kLight, Kind::kImage);
  ASSERT_EQ(light.size(), 1u);
  const Raster& image = light[0].image;
  const IlluminationGrid2& values = room().light->grid;
  ASSERT_EQ(image.width, values.grid.nx);
  ASSERT_EQ(image.height, values.grid.ny);
  double most = 0;
  for (const double value : values.values)
    if (value > most) most = value;
  const double floor[3] = {palette::kFloor.r, palette::kFloor.g, palette::kFloor.b};
  std::uint32_t cells = 0;
  for (std::uint32_t y = 0; y < image.height; ++y)
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const std::uint32_t pixel = image.pixels[std::size_t{image.height - 1 - y} * image.width + x];
      if (std::isnan(values.at(x, y))) continue;  // a solid lies over it
      ++cells;
      for (std::uint32_t c = 0; c < 3; ++c) {
        const double linear = values.at(x, y, std::min(c, values.channels - 1)) / most;
        const double expected = 255 * srgb_from_linear(linear * linear_from_srgb(floor[c]));
        EXPECT_NEAR(pixel >> (16 - 8 * c) & 255, expected, 3) << x << " " << y;
      }
    }
  EXPECT_GT(cells, 20u);
  // The brightest is the floor's own colour; where light is brighter than that it stays.
  const RecordingCanvas brighter = drawn(room(), {.mode = ViewMode2::kFloor}, nullptr, {Tone::kLog, 1e9});
  std::uint32_t full = 0;
  const auto image_of_all = brighter.calls(Mark::kLight, Kind::kImage)[0].image;
  for (const std::uint32_t pixel : image_of_all.pixels) full += pixel == pixel_of(palette::kFloor) ? 1 : 0;
  EXPECT_GT(full, 0u);
}

TEST(DrawView2, ChecksRingWhatWasFound) {
  const LiveState2 state = state_of(room_with_a_near_miss());
  const ViewRequest2 request{.mode = ViewMode2::kCheck};
  const ViewResult2 result = compute_view(state, request, kNoProgress);
  ASSERT_FALSE(result.findings.empty());
  const RecordingCanvas canvas = drawn(state, request, result);
  const auto rings = canvas.calls(Mark::kCritical, Kind::kCircle);
  ASSERT_EQ(rings.size(), result.findings.size());
  for (std::size_t k = 0; k < rings.size(); ++k) {
    EXPECT_EQ(rings[k].points[0], frame_of(*state.scene).at(result.findings[k].at));
    EXPECT_TRUE(canvas.wrote(std::to_string(result.findings[k].number)));
  }
}

TEST(DrawView2, SplitsLightAndErrorsAtTheBar) {
  const ViewRequest2 request{.mode = ViewMode2::kErrors};
  const ViewResult2 result = compute_view(room(), request, kNoProgress);
  for (const double split : {0.0, 0.25, 0.7, 1.0, 7.0, -3.0}) {
    RecordingCanvas canvas(kSize.width, kSize.height);
    draw_view(canvas, frame_of(*room().scene), kUnit,
              {.state = &room(), .request = &request, .result = &result, .split = split});
    const double x = std::clamp(split, 0.0, 1.0) * kSize.width;
    const auto images = canvas.calls(Mark::kLight, Kind::kImage);
    if (x >= kSize.width) {
      EXPECT_EQ(images.size(), 1u);
      continue;
    }
    ASSERT_EQ(images.size(), 2u);
    EXPECT_EQ(images[1].points[0], (Pixel{std::floor(x), 0}));
    EXPECT_EQ(images[1].points[1], (Pixel{kSize.width, kSize.height}));
    EXPECT_EQ(images[1].image.width, kSize.width - static_cast<std::uint32_t>(x));
    for (const auto& bar : canvas.calls(Mark::kAxis, Kind::kStroke)) EXPECT_EQ(bar.points[0].x, x);
  }
  // Until there are errors: light alone.
  expect_same(drawn(room(), request), drawn(room(), {}));
}

TEST(DrawView2, WithoutAPreparedSceneThereAreEdgesAlone) {
  const LiveState2 state = dark();
  ASSERT_EQ(state.prepared, nullptr);
  for (int k = 0; k < kViewModes2; ++k) {
    const RecordingCanvas canvas =
        drawn(state, {.mode = static_cast<ViewMode2>(k), .face = face_name(*state.scene, {0, false})});
    EXPECT_EQ(canvas.count(Mark::kEdge), state.scene->edges.size());
    EXPECT_EQ(canvas.calls().size(), state.scene->edges.size() + 1);
    EXPECT_EQ(canvas.count(Mark::kPaper), 1u);
  }
}

TEST(DrawView2, WithoutLightThereIsThePlan) {
  Scene2 open = small_room();
  open = erase_surfaces(open, std::vector<std::uint32_t>{1});  // "closed" is broken
  const LiveState2 state = state_of(open);
  ASSERT_NE(state.prepared, nullptr);
  ASSERT_EQ(state.light, nullptr);
  const ScenePicture2 plain;
  const RecordingCanvas plan = painted(ScenePicturePainter2(*state.prepared, plain, sheet_of(state)));
  for (const ViewMode2 mode :
       {ViewMode2::kLight, ViewMode2::kFloor, ViewMode2::kBands, ViewMode2::kErrors, ViewMode2::kSweeps})
    expect_same(drawn(state, {.mode = mode}), plan);
}

}  // namespace
}  // namespace hottel::view_mode_test
