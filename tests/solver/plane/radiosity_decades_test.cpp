// Light over hundreds of decades in one scene: nobody's bounds suffer from what shines elsewhere.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "solver/radiosity/net_flux.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::radiosity_decades_test {
namespace {

using namespace testing_radiosity;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Solver kSolvers[] = {Solver::kAuto,     Solver::kCholesky, Solver::kCg,          Solver::kLu,
                               Solver::kBicgstab, Solver::kJacobi,   Solver::kGaussSeidel, Solver::kShooting};
constexpr double kFewUlps = 1e-14;

bool is_refined(Solver solver) {
  return solver == Solver::kAuto || solver == Solver::kCholesky || solver == Solver::kCg;
}

double largest_double_below(const Rational& value) {
  const double nearest = to_double(value);
  return Rational(nearest) > value ? std::nextafter(nearest, -HUGE_VAL) : nearest;
}

// What holds whatever the solver.
void expect_laws(const ExactScene& scene, const RadiositySolution& solution, const std::string& what) {
  BoundsCheck check;
  check.add(scene, solution, scene.scene().materials);
  EXPECT_EQ(check.misses, 0u) << what << " " << check.first_miss;
  for (std::size_t c = 0; c < solution.channels.size(); ++c)
    for (std::uint32_t i = 0; i < scene.matrix().size(); ++i) {
      if (!scene.matrix().has_row(i)) continue;
      const ElementRadiosity& e = solution.channels[c].elements[i];
      const std::string at = what + " " + scene.matrix().elements()[i].name;
      const Rational& emission = scene.scene().materials[*scene.matrix().elements()[i].material].emission.value[c];
      EXPECT_GE(e.lower, largest_double_below(emission)) << at;
      EXPECT_GE(e.irradiance, 0) << at;
      EXPECT_EQ(e.net(), e.radiosity - e.irradiance) << at;
      EXPECT_LE(e.net_lower, e.net_value) << at;
      EXPECT_GE(e.net_upper, e.net_value) << at;
    }
}

double widest(const RadiositySolution& solution) {
  double result = 0;
  for (const ChannelSolution& channel : solution.channels)
    for (const ElementRadiosity& e : channel.elements)
      if (std::isnormal(e.lower)) result = std::max(result, e.upper / e.lower - 1);
  return result;
}

// A square room of side 1 at x = 3 k: a lamp that emits so much below, walls of their own around.
std::string room(int k, const std::string& lamp_reflectivity) {
  return fmt::format(
      R"({{"name":"lamp{0}","points":[[{2},0],[{1},0]],"material":"l{0}"}},
{{"name":"west{0}","points":[[{1},0],[{1},1]],"material":"w"}},{{"name":"north{0}","points":[[{1},1],[{2},1]],"material":"{3}"}},
{{"name":"east{0}","points":[[{2},1],[{2},0]],"material":"w"}})",
      k, 3 * k, 3 * k + 1, lamp_reflectivity == "0" ? "b" : "w");
}

Scene2 rooms(const std::vector<std::string>& emissions, const std::string& lamp_reflectivity) {
  std::string materials = R"("w":{"reflectivity":["1/2","9/10","1/3"]},"b":{"reflectivity":0})", edges;
  for (std::size_t k = 0; k < emissions.size(); ++k) {
    materials += fmt::format(R"(,"l{}":{{"emission":{},"reflectivity":{}}})", k, emissions[k], lamp_reflectivity);
    edges += (k == 0 ? "" : ",\n") + room(static_cast<int>(k), lamp_reflectivity);
  }
  return scene_of(R"({"hottel":1,"dimension":2,"materials":{)" + materials + R"(},"edges":[)" + edges + "]}");
}

TEST(LightOverManyDecades, OfRoomsThatDoNotSeeEachOtherIsBoundedInEachByItself) {
  const std::vector<std::string> emissions{"1e-300", "1e150", "1", "0", "[1e-290,1,1e140]", "[1e150,0,1e-300]"};
  for (const std::string lamp : {"0.5", "0"}) {
    const ExactScene scene(rooms(emissions, lamp));
    for (const Solver solver : kSolvers) {
      const RadiositySolution solution = scene.solve({solver, {}, {}, {}});
      expect_laws(scene, solution, to_string(solver));
      EXPECT_LE(widest(solution), is_refined(solver) ? kFewUlps : 1e-10) << to_string(solver);
      EXPECT_THAT(solution.notes, IsEmpty()) << to_string(solver);
    }
  }
}

TEST(LightOverManyDecades, IsTheSameInARoomWhateverShinesInOthers) {
  const ExactScene alone(rooms({"1e-300"}, "0.5")), beside(rooms({"1e-300", "1e150"}, "0.5"));
  for (const Solver solver : {Solver::kAuto, Solver::kCholesky, Solver::kJacobi, Solver::kGaussSeidel}) {
    const RadiositySolution a = alone.solve({solver, 7, {}, {}}), b = beside.solve({solver, 7, {}, {}});
    for (const char* name : {"lamp0", "west0", "north0", "east0"})
      for (std::size_t c = 0; c < a.channels.size(); ++c) {
        const ElementRadiosity& x = a.channels[c].elements[*alone.matrix().find(name)];
        const ElementRadiosity& y = b.channels[c].elements[*beside.matrix().find(name)];
        EXPECT_EQ(x.radiosity, y.radiosity) << to_string(solver) << " " << name;
        EXPECT_EQ(x.irradiance, y.irradiance) << to_string(solver) << " " << name;
        EXPECT_EQ(x.lower, y.lower) << to_string(solver) << " " << name;
        EXPECT_EQ(x.upper, y.upper) << to_string(solver) << " " << name;
      }
  }
}

// Two rooms, a wall between them with a slit in its middle that is so wide.
Scene2 rooms_with_slit(const std::string& width, const std::string& bright, const std::string& faint,
                       const std::string& reflectivity) {
  const Rational half = parse_rational(width).value() / 2;
  const std::string low = to_string(Rational(1, 2) - half), high = to_string(Rational(1, 2) + half);
  return scene_of(fmt::format(
      R"({{"hottel":1,"dimension":2,"materials":{{"w":{{"reflectivity":"1/2"}},
"bright":{{"emission":{2},"reflectivity":{4}}},"faint":{{"emission":{3},"reflectivity":0.25}}}},
"polylines":[{{"name":"a","points":[[1,0],[0,0],[0,1],[1,1]],"material":"w"}},
{{"name":"b","points":[[1,1],[2,1],[2,0]],"material":"w"}}],
"edges":[{{"name":"low","points":[[1,0],[1,"{0}"]],"material":"faint","back":"bright"}},
{{"name":"high","points":[[1,"{1}"],[1,1]],"material":"w","back":"w"}},
{{"name":"floor","points":[[2,0],[1,0]],"material":"w"}}]}})",
      low, high, bright, faint, reflectivity));
}

TEST(LightOverManyDecades, ThroughASlitIsBoundedNarrowlyOnBothSides) {
  for (const char* width : {"1e-3", "1e-15", "1e-30"})
    for (const char* faint : {"0", "1e-300", "1e-20"})
      for (const char* reflectivity : {"0", "0.5"}) {
        const ExactScene scene(rooms_with_slit(width, "1e150", faint, reflectivity));
        for (const Solver solver : kSolvers) {
          const std::string what = fmt::format("{} {} {} {}", width, faint, reflectivity, to_string(solver));
          const RadiositySolution solution = scene.solve({solver, {}, {}, {}});
          expect_laws(scene, solution, what);
          if (!is_refined(solver)) continue;
          EXPECT_LE(widest(solution), 1e-13) << what;
          EXPECT_THAT(solution.notes, IsEmpty()) << what;
        }
      }
}

TEST(LightOverManyDecades, IsNotedByNameWhereRelativeAccuracyIsLost) {
  // Some factors through this slit are 1e-600, which no double tells from 0.
  const ExactScene scene(rooms_with_slit("1e-300", "1e150", "1e-20", "0.5"));
  const RadiositySolution narrow = scene.solve(), wide = scene.solve({Solver::kCg, {}, {}, {}});
  EXPECT_LE(widest(narrow), kFewUlps);
  EXPECT_THAT(narrow.notes, IsEmpty());
  EXPECT_GT(widest(wide), 1);
  ASSERT_EQ(wide.notes.size(), 1u);
  EXPECT_THAT(wide.notes[0], HasSubstr("relative accuracy is lost in "));
  EXPECT_THAT(wide.notes[0], HasSubstr(" radiosities far below the brightest: the bounds of '"));
  EXPECT_THAT(wide.notes[0], HasSubstr("the bounds of 'low' are "));
  for (std::uint32_t i = 0; i < scene.matrix().size(); ++i) {
    const ElementRadiosity &a = narrow.channels[0].elements[i], &b = wide.channels[0].elements[i];
    EXPECT_LE(std::max(a.lower, b.lower), std::min(a.upper, b.upper)) << i;
    EXPECT_GE(b.lower, std::nextafter(b.emission, 0)) << i;
  }
  // What is wide throughout is no news.
  const std::vector<std::string> notes =
      ExactScene(analytic_scene("square_radiosity")).solve({Solver::kJacobi, 3, {}, {}}).notes;
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_THAT(notes[0], HasSubstr("jacobi stopped after 3 iterations with a relative residual of "));
}

// A random scene whose surfaces have materials of their own, with light of any size.
Scene2 random_decades(std::uint64_t seed) {
  Scene2 scene = random_scene(seed);
  std::mt19937_64 random(seed);
  const auto any_size = [&] {
    const int exponent = static_cast<int>(random() % 451) - 300;
    return parse_rational(fmt::format("{}e{}", 1 + random() % 99, exponent)).value();
  };
  for (Material& material : scene.materials) {
    Spectrum light = Spectrum::scalar(any_size());
    if (random() % 2 == 0) {
      light.is_scalar = false;
      for (Rational& value : light.value) value = random() % 3 == 0 ? Rational(0) : any_size();
    }
    if (material.reflectivity.value[0] != 1 && random() % 3 > 0) material.emission = light;
    if (material.reflectivity.value[0] > Rational(99, 100) && material.reflectivity.value[0] != 1)
      material.reflectivity = Spectrum::scalar(Rational(99, 100));
  }
  scene.sky_emission = Spectrum::scalar(random() % 2 == 0 ? Rational(0) : any_size());
  return scene;
}

TEST(LightOverManyDecades, OfRandomScenesIsBoundedBySolversOfAllKinds) {
  double width = 0;
  int scenes = 0, noted = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const ExactScene scene(random_decades(seed), seed % 5 == 0 ? Divided2::kYes : Divided2::kNo);
    for (const Solver solver : kSolvers) {
      if (solver != Solver::kAuto && seed % 4 != 0) continue;
      RadiosityOptions options;
      options.solver = solver;
      if (!is_refined(solver)) options.iterations = 50;
      const RadiositySolution solution = scene.solve(options);
      expect_laws(scene, solution, fmt::format("{} {}", seed, to_string(solver)));
      noted += !solution.notes.empty();
      if (!is_refined(solver)) continue;
      ++scenes;
      width = std::max(width, widest(solution));
      EXPECT_LE(widest(solution), 1e-13) << seed << " " << to_string(solver);
    }
  }
  fmt::print("{} solutions, relative widths up to {:.2g}; {} with notes\n", scenes, width, noted);
}

TEST(StoppedIterations, ExchangeWhatTheyHaveAndOweTheirResidual) {
  const ExactScene scene(analytic_scene("square_radiosity_bright"));
  const auto& elements = scene.matrix().elements();
  for (const Solver solver :
       {Solver::kCg, Solver::kBicgstab, Solver::kJacobi, Solver::kGaussSeidel, Solver::kShooting}) {
    const RadiositySolution solution = scene.solve({solver, 3, {}, {}});
    const ChannelSolution& channel = solution.channels[0];
    double flux = 0, owed = 0, size = 0;
    for (std::uint32_t i = 0; i < scene.matrix().size(); ++i) {
      if (!scene.matrix().has_row(i)) continue;
      const ElementRadiosity& e = channel.elements[i];
      const double area = elements[i].area.value;
      double irradiance = 0;
      for (const FactorEntry& entry : scene.matrix().row(i))
        if (entry.to != scene.matrix().sky()) irradiance += entry.factor.value * channel.elements[entry.to].radiosity;
      EXPECT_NEAR(e.irradiance, irradiance, 1e-15 * irradiance) << to_string(solver);
      EXPECT_EQ(e.net(), e.radiosity - e.irradiance) << to_string(solver);
      EXPECT_NEAR(e.net_value, e.net(), 4e-16 * (e.radiosity + e.irradiance)) << to_string(solver);
      flux += area * e.net_value;
      owed += area * (e.emission + e.reflectivity * e.irradiance - e.radiosity);
      size += area * e.radiosity;
    }
    EXPECT_NEAR(flux, 0, 1e-15 * size) << to_string(solver) << ": what is sent out arrives somewhere";
    EXPECT_NEAR(channel.energy.defect, owed, 1e-14 * size) << to_string(solver);
    for (const NetFlux& face :
         net_flux(scene.matrix(), solution, {}, [](const Element& element) { return element.name; })) {
      const NetFlux::Power& power = face.by_channel[0];
      EXPECT_LE(power.lower, power.value);
      EXPECT_GE(power.upper, power.value);
      const ElementRadiosity& e = channel.elements[*scene.matrix().find(face.name)];
      EXPECT_NEAR(power.value, *face.area * e.net(), 1e-15 * *face.area * (e.radiosity + e.irradiance));
    }
  }
}

}  // namespace
}  // namespace hottel::radiosity_decades_test
