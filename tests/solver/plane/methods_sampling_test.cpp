// Methods that sample: rays and the hemicube.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "geometry/plane/generate/generators.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/visibility_polygon.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/methods/ray_samples.h"
#include "solver/plane/methods/item_buffer.h"
#include "solver/plane/methods/method_catalogue.h"

namespace hottel::methods_sampling_test {
namespace {

PreparedScene2 clutter(std::uint64_t edges) {
  GeneratorRequest2 request;
  request.kind = "clutter";
  request.n = edges;
  request.seed = 7;
  return prepare(generate_2(request), Divided2::kYes);
}

ExchangeMatrix run(const std::string& name, const PreparedScene2& prepared, MethodReport* report = nullptr) {
  MethodReport ignored;
  return methods_2().make(name)->compute(prepared, {.granularity = Granularity::kElement},
                                         report != nullptr ? *report : ignored);
}

// Calls visit(exact factor, difference) for every pair that is in one of the two.
template <class Visit>
void for_each_error(const ExchangeMatrix& matrix, const ExchangeMatrix& exact, const Visit& visit) {
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    std::set<std::uint32_t> columns;
    for (const FactorEntry& entry : exact.row(i)) columns.insert(entry.to);
    for (const FactorEntry& entry : matrix.row(i)) columns.insert(entry.to);
    for (const std::uint32_t j : columns) {
      const double factor = exact.factor(i, j).value;
      visit(factor, matrix.factor(i, j).value - factor);
    }
  }
}

double max_error(const ExchangeMatrix& matrix, const ExchangeMatrix& exact) {
  double largest = 0;
  for_each_error(matrix, exact, [&](double, double error) { largest = std::max(largest, std::fabs(error)); });
  return largest;
}

double rms_error(const ExchangeMatrix& matrix, const ExchangeMatrix& exact) {
  double sum = 0, count = 0;
  for_each_error(matrix, exact, [&](double, double error) {
    sum += error * error;
    ++count;
  });
  return std::sqrt(sum / count);
}

void expect_same(const ExchangeMatrix& a, const ExchangeMatrix& b) {
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a.row(i).size(), b.row(i).size());
    for (std::size_t k = 0; k < a.row(i).size(); ++k) {
      EXPECT_EQ(a.row(i)[k].to, b.row(i)[k].to);
      EXPECT_EQ(a.row(i)[k].factor, b.row(i)[k].factor);
    }
  }
}

const std::vector<std::string> kSampled{"rays:1024",       "rays:1000:stratified", "rays:1024:stratified",
                                        "rays:1000:sobol", "rays:1024:sobol",      "hemicube:256",
                                        "hemicube:1024"};

TEST(SamplingMethods2, StayWithinTheirDeclaredErrorOnEveryAnalyticScene) {
  std::map<std::string, int> declared;
  for (const auto& file : std::filesystem::directory_iterator(HOTTEL_SOURCE_DIR "/scenes/analytic")) {
    if (file.path().extension() != ".json") continue;
    const PreparedScene2 prepared = prepare(read_scene_2(file.path()), Divided2::kYes);
    const ExchangeMatrix exact = run("exact", prepared);
    for (const std::string& name : kSampled) {
      const auto error = methods_2().make(name)->declared_error(prepared);
      if (!error) continue;
      ++declared[name];
      EXPECT_LE(max_error(run(name, prepared), exact), *error) << file.path() << ' ' << name;
    }
  }
  for (const std::string& name : kSampled) EXPECT_GT(declared[name], 10) << name;
}

TEST(SamplingMethods2, GiveTheSameForAnyNumberOfThreadsAndRowsThatSumToOne) {
  const PreparedScene2 prepared = clutter(60);
  for (const std::string& name : kSampled) {
    const ThreadLimit one(1);
    MethodReport report;
    const ExchangeMatrix alone = run(name, prepared, &report);
    const ThreadLimit four(4);
    expect_same(alone, run(name, prepared));
    EXPECT_LT(report.row_defect, 1e-12) << name;
  }
}

TEST(SamplingMethods2, SeeNoSkyInAClosedRoom) {
  const PreparedScene2 prepared = clutter(60);
  for (const std::string& name : kSampled) {
    const ExchangeMatrix matrix = run(name, prepared);
    for (std::uint32_t i = 0; i < matrix.size(); ++i) EXPECT_EQ(matrix.factor(i, matrix.sky()).value, 0) << name;
  }
}

TEST(SamplingMethods2, RefuseVariantsThatAreNotThere) {
  for (const char* name :
       {"rays", "rays:", "rays:0", "rays:x", "rays:8:", "rays:8:halton", "rays:8:sobol:seed=", "rays:8:seed=1:sobol",
        "rays:-1", "hemicube", "hemicube:", "hemicube:3", "hemicube:0", "hemicube:64:plain", "hemicube:2097152"})
    EXPECT_THROW(methods_2().make(name), UsageError) << name;
}

// For each row, n sum (F' - F)^2 / F over the columns is distributed as chi square with one degree less than columns.
TEST(Rays2, ErrByTheStandardErrorOfABinomial) {
  const PreparedScene2 prepared = clutter(60);
  const ExchangeMatrix exact = run("exact", prepared);
  for (const int n : {1024, 4096, 16384}) {
    const ExchangeMatrix matrix = run("rays:" + std::to_string(n), prepared);
    double chi_square = 0, degrees = 0;
    for (std::uint32_t i = 0; i < exact.size(); ++i) {
      if (exact.row(i).size() < 2) continue;
      double rest = 0, rest_error = 0;
      int columns = 0;
      const auto add = [&](double factor, double error) {
        chi_square += n * error * error / factor;
        ++columns;
      };
      for (const FactorEntry& entry : exact.row(i)) {
        const double factor = entry.factor.value, error = matrix.factor(i, entry.to).value - factor;
        if (n * factor >= 5) {
          add(factor, error);
        } else {
          rest += factor;
          rest_error += error;
        }
      }
      if (n * rest >= 5) add(rest, rest_error);
      degrees += columns - 1;
    }
    EXPECT_GT(degrees, 500);
    EXPECT_NEAR(chi_square, degrees, 5 * std::sqrt(2 * degrees)) << n;
  }
}

TEST(Rays2, CountAnglesWhereTheyAreUniform) {
  const PreparedScene2 room = prepare(parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"m": {}},
    "polylines": [{"name": "room", "points": [[0, 0], [0, 1], [1, 1], [1, 0]], "closed": true, "material": "m"}]})",
                                                    "room"),
                                      Divided2::kYes);
  // From x on the floor the ceiling is seen by atan(x) + atan(1 - x) of pi.
  const double opposite = 0.5 - std::log(2) / std::numbers::pi;
  const ExchangeMatrix counted = run("rays:65536:sobol:uniform", room);
  EXPECT_NEAR(counted.factor("room[1]", "room[3]").value, opposite, 1e-3);
  EXPECT_NEAR(counted.factor("room[1]", "room[2]").value, (1 - opposite) / 2, 1e-3);
  EXPECT_FALSE(methods_2().make("rays:64:uniform")->declared_error(room));
}

TEST(Rays2, ReportTheStandardErrorOfTheWorstFactorAndTheSeed) {
  const PreparedScene2 prepared = clutter(20);
  MethodReport report;
  const ExchangeMatrix matrix = run("rays:400", prepared, &report);
  double worst = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i))
      worst = std::max(worst, std::sqrt(entry.factor.value * (1 - entry.factor.value) / 400));
  EXPECT_DOUBLE_EQ(report.standard_error.value(), worst);
  EXPECT_THAT(report.notes, ::testing::Contains("seed 1"));
  EXPECT_EQ(methods_2().make("rays:400:seed=5")->info().name, "rays:400:seed=5");
  EXPECT_GT(max_error(run("rays:400:seed=5", prepared), matrix), 0);
}

// Errors fall like n^-1/2, and faster where points spread evenly: like n^-3/4 for the border of a region.
TEST(Rays2, ConvergeFasterWhenStratified) {
  const PreparedScene2 prepared = clutter(40);
  const ExchangeMatrix exact = run("exact", prepared);
  const auto order = [&](const std::string& sampling) {
    const double coarse = rms_error(run("rays:256" + sampling, prepared), exact);
    const double fine = rms_error(run("rays:16384" + sampling, prepared), exact);
    return std::log(coarse / fine) / std::log(64.0);
  };
  EXPECT_NEAR(order(""), 0.5, 0.04);
  EXPECT_NEAR(order(":stratified"), 0.75, 0.06);
  EXPECT_GT(order(":sobol"), 0.69);
}

TEST(RaySamples, LieOneByOneInTheirParts) {
  constexpr int kLevels = 10;
  const auto n = std::uint64_t{1} << kLevels;
  const RaySamples sobol(Sampling::kSobol, n, 3);
  for (int wide = 0; wide <= kLevels; ++wide) {
    std::set<std::pair<int, int>> parts;
    sobol.for_each(17, [&](const RaySamples::Point& p) {
      parts.emplace(static_cast<int>(std::ldexp(p.position, wide)),
                    static_cast<int>(std::ldexp(p.turn, kLevels - wide)));
    });
    EXPECT_EQ(parts.size(), n) << wide;
  }
  const RaySamples grid(Sampling::kStratified, 900, 3);
  std::set<std::pair<int, int>> parts;
  grid.for_each(17, [&](const RaySamples::Point& p) {
    parts.emplace(static_cast<int>(30 * p.position), static_cast<int>(30 * p.turn));
  });
  EXPECT_EQ(parts.size(), 900u);
}

// The points below a falling line are as many as its area says, but for the parts that it meets.
TEST(RaySamples, FollowTheAreaBelowACurve) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const Sampling sampling : {Sampling::kStratified, Sampling::kSobol})
    for (const std::uint64_t n : {1u, 2u, 7u, 64u, 1000u, 1024u, 5000u}) {
      const RaySamples samples(sampling, n, 1);
      for (std::uint32_t element = 0; element < 40; ++element) {
        const double high = unit(random), low = high * unit(random), area = (high + low) / 2;
        double below = 0;
        samples.for_each(element,
                         [&](const RaySamples::Point& p) { below += p.turn < high + p.position * (low - high); });
        const auto all = static_cast<double>(n);
        EXPECT_LE(std::fabs(below - all * area), parts_met_by_a_curve(sampling, n)) << n;
      }
    }
}

TEST(RaySamples, OfDifferentElementsAndSeedsDiffer) {
  std::set<double> positions;
  for (std::uint64_t seed = 0; seed < 10; ++seed)
    for (std::uint32_t element = 0; element < 10; ++element)
      RaySamples(Sampling::kIndependent, 10, seed).for_each(element, [&](const RaySamples::Point& p) {
        EXPECT_GT(p.position, 0);
        EXPECT_LT(p.position, 1);
        positions.insert(p.position);
      });
  EXPECT_EQ(positions.size(), 1000u);
}

TEST(HalfSquare2, HasWeightsThatSumToOne) {
  for (const std::uint32_t resolution : {2u, 4u, 64u, 1000u, 65536u}) {
    const HalfSquare2 square(resolution);
    double sum = 0;
    for (std::size_t k = 0; k < square.pixels(); ++k) {
      EXPECT_GT(square.weight(k), 0);
      EXPECT_LE(square.weight(k), 1.0 / resolution);
      sum += square.weight(k);
    }
    EXPECT_NEAR(sum, 1, 1e-11);
  }
}

TEST(HalfSquare2, FindsAgainWhereAPointOfItIs) {
  const HalfSquare2 square(10);
  for (double screen = 0.25; screen < 20; screen += 0.25) {
    const LocalVector2 p = square.point(screen);
    EXPECT_NEAR(square.screen({3 * p.x, 3 * p.y}), screen, 1e-12);
  }
}

// Each pixel by itself: the item whose line the ray through its centre meets first, between its ends.
TEST(ItemBuffer2, ShowsTheNearestItemInEveryPixel) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  constexpr std::uint32_t kSky = 1000;
  const HalfSquare2 square(64);
  const auto buffer = software_item_buffer_2(64);
  int compared = 0;
  for (int scene = 0; scene < 200; ++scene) {
    std::vector<BufferItem2> items;
    for (std::uint32_t k = 0; k < 12; ++k) {
      LocalVector2 p{unit(random), unit(random)}, q{unit(random), unit(random)};
      if (p.y <= 0 && q.y <= 0) continue;
      if (p.x * q.y - p.y * q.x < 0) std::swap(p, q);
      items.push_back({p, q, k});
    }
    const auto image = buffer->draw(items, kSky);
    for (std::size_t k = 0; k < square.pixels(); ++k) {
      const LocalVector2 d = square.point(static_cast<double>(k) + 0.5);
      double nearest = HUGE_VAL;
      std::uint32_t expected = kSky;
      bool is_clear = true;  // no end lies on the ray
      for (const BufferItem2& item : items) {
        // right + s (left - right) = t d
        const double ax = item.left.x - item.right.x, ay = item.left.y - item.right.y;
        const double determinant = d.x * ay - d.y * ax;
        const double t = (item.right.x * ay - item.right.y * ax) / determinant;
        const double s = (item.right.x * d.y - item.right.y * d.x) / determinant;
        is_clear &= std::fabs(s) > 1e-9 && std::fabs(s - 1) > 1e-9;
        if (s < 0 || s > 1 || t <= 0 || t >= nearest) continue;
        nearest = t;
        expected = item.item;
      }
      if (!is_clear) continue;
      EXPECT_EQ(image[k], expected);
      ++compared;
    }
  }
  EXPECT_GT(compared, 20'000);
}

TEST(ItemBuffer2, LeavesNoPixelBetweenItemsThatShareAnEnd) {
  const auto buffer = software_item_buffer_2(8);
  // The common end lies on the centre of pixel 6; the sky shows nowhere.
  const LocalVector2 common = HalfSquare2(8).point(6.5);
  const auto image = buffer->draw(std::vector<BufferItem2>{{{2, -1}, common, 0}, {common, {-2, -1}, 1}}, 7);
  for (std::size_t k = 0; k < 16; ++k) EXPECT_EQ(image[k], k < 6 ? 0u : 1u) << k;
}

// A fin that stands on the middle of the floor, at a place that is no double, is seen edge-on: nothing of it is seen
// from there, and nothing hides behind it.
TEST(Hemicube2, SeesNothingOfAnEdgeThatEndsAtTheEye) {
  Scene2 scene;
  scene.file = "fin";
  scene.materials.push_back({"white", Spectrum::scalar(Rational(1, 2)), {}});
  const auto add = [&scene](const char* name, const char* x0, const char* y0, const char* x1, const char* y1) {
    const auto number = [](const char* text) { return parse_rational(text).value(); };
    Surface surface;
    surface.name = name;
    surface.group = static_cast<std::uint32_t>(scene.groups.size());
    scene.groups.push_back(name);
    scene.add(surface, {{number(x0), number(y0)}, {number(x1), number(y1)}});
  };
  add("floor", "1", "1/3", "1/3", "1/3");
  add("wall", "1/3", "1/3", "1/3", "1");
  add("roof", "1/3", "1", "1", "1");
  add("other", "1", "1", "1", "1/3");
  add("fin", "2/3", "1/3", "2/3", "0.9");
  const PreparedScene2 prepared = prepare(scene, Divided2::kYes);
  const ExchangeMatrix matrix = run("hemicube:1024", prepared);
  const auto factor = [&](const char* to) { return matrix.factor(0, matrix.find(to).value()).value; };
  EXPECT_EQ(factor("fin"), 0);
  EXPECT_EQ(factor("fin:back"), 0);
  // From the middle of a unit square's side the roof takes sin phi = 1 / sqrt(5), to either side.
  EXPECT_NEAR(factor("roof"), 1 / std::sqrt(5.0), 2.0 / 1024);
  EXPECT_NEAR(factor("wall"), (1 - 1 / std::sqrt(5.0)) / 2, 1.0 / 1024);
  EXPECT_FALSE(methods_2().make("hemicube:1024")->declared_error(prepared).has_value());
}

// The exact factors from the centre of each element, and how many stretches of each element are seen.
struct CentreFactors {
  std::map<std::uint32_t, double> factor;
  std::map<std::uint32_t, int> stretches;
};
CentreFactors centre_factors(const PreparedScene2& prepared, const ElementTable2& table, const PointLocation2& location,
                             std::uint32_t from) {
  const Element& element = table.elements()[from];
  const Edge2& edge = prepared.scene.edges[element.surface];
  const Rational half(1, 2);
  CentreFactors result;
  for (const PointFactor2& each :
       point_factors(prepared.arrangement, location, edge.from, edge.to, element.is_back, half))
    result.factor[table.of(each.side)] += each.factor.ball(128).nearest_of_ends().lower;
  const Vertices2& vertices = prepared.arrangement.vertices();
  const Point2 centre{half * (edge.from.x + edge.to.x), half * (edge.from.y + edge.to.y)};
  View2 view;
  location.look_around(Eye2(vertices, vertices.from_scene(centre)), view);
  for (const View2::Seen& seen : view.seen) ++result.stretches[table.of(seen.behind)];
  return result;
}

TEST(Hemicube2, ConvergesToTheFactorsFromTheCentreByOrderOne) {
  const PreparedScene2 prepared = clutter(40);
  const ElementTable2& table = *prepared.elements(Granularity::kElement);
  const PointLocation2 location(prepared.arrangement.vertices(), prepared.arrangement.triangulation());
  std::vector<CentreFactors> exact;
  for (std::uint32_t i = 0; i < table.count(); ++i)
    exact.push_back(table.has_row(i) ? centre_factors(prepared, table, location, i) : CentreFactors());
  const auto rms = [&](const std::string& name, double pixel_bound) {
    const ExchangeMatrix matrix = run(name, prepared);
    double sum = 0, count = 0;
    for (std::uint32_t i = 0; i < table.count(); ++i)
      for (const auto& [j, factor] : exact[i].factor) {
        const double error = matrix.factor(i, j).value - factor;
        EXPECT_LE(std::fabs(error), exact[i].stretches.at(j) * pixel_bound + 1e-12) << name;
        sum += error * error;
        ++count;
      }
    return std::sqrt(sum / count);
  };
  const double coarse = rms("hemicube:64", 1.0 / 64), fine = rms("hemicube:4096", 1.0 / 4096);
  EXPECT_NEAR(std::log2(coarse / fine) / 6, 1, 0.1);
  // Plain counts stay wrong.
  EXPECT_GT(rms("hemicube:4096:uniform", 1), 20 * fine);
}

}  // namespace
}  // namespace hottel::methods_sampling_test
