// Radiosities where factors, areas, losses and light are of any size that a double has, or beyond: bounds hold, and
// stay narrow wherever the factors are known to half an ulp.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/plane/exchange/exchange.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/gray_exchange.h"
#include "solver/radiosity/matrix_checks.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::radiosity_extremes_test {
namespace {

using namespace testing_radiosity;

constexpr Solver kSolvers[] = {Solver::kCholesky, Solver::kCg,          Solver::kLu,      Solver::kBicgstab,
                               Solver::kJacobi,   Solver::kGaussSeidel, Solver::kShooting};

Rational power_of_ten(int exponent) { return parse_rational(fmt::format("1e{}", exponent)).value(); }

Rounded rounded(const Rational& value) {
  const double nearest = to_double(value);
  if (std::isinf(nearest)) return {nearest, -1};
  return {nearest, static_cast<signed char>(cmp(value, Rational(nearest)))};
}

// A closed system given by what its pairs exchange, S_ij = A_i F_ij, as rational numbers.
struct RationalSystem {
  std::vector<std::vector<Rational>> factors;  // exact, the sky last
  ExchangeMatrix matrix;
  std::vector<Material> materials;  // of each element
  Spectrum sky;

  // Elements as many as rows of `exchange`, which is symmetric; its last column is the sky.
  RationalSystem(const std::vector<std::vector<Rational>>& exchange, std::vector<Material> of_elements, Rational of_sky)
      : materials(std::move(of_elements)), sky(Spectrum::scalar(of_sky)) {
    std::vector<Element> elements;
    std::vector<std::size_t> begin{0};
    std::vector<FactorEntry> entries;
    for (std::uint32_t i = 0; i < exchange.size(); ++i) {
      Rational area = 0;
      for (const Rational& s : exchange[i]) area += s;
      factors.emplace_back();
      for (std::uint32_t j = 0; j <= exchange.size(); ++j) {
        factors[i].push_back(exchange[i][j] / area);
        if (exchange[i][j] > 0) entries.push_back({j, rounded(factors[i][j]), 1});
      }
      begin.push_back(entries.size());
      elements.push_back({fmt::format("face{}", i), i, 0, 1, false, i, rounded(area)});
    }
    matrix = ExchangeMatrix(elements, Guarantee::kExact);
    matrix.assign(std::move(begin), std::move(entries));
  }

  // By elimination with rational numbers. REQUIRES a solution.
  std::vector<Rational> radiosity() const {
    const std::size_t n = factors.size();
    std::vector<std::vector<Rational>> a(n, std::vector<Rational>(n + 1));
    for (std::size_t i = 0; i < n; ++i) {
      const Rational& rho = materials[i].reflectivity.value[0];
      for (std::size_t j = 0; j < n; ++j) a[i][j] = (i == j ? 1 : 0) - rho * factors[i][j];
      a[i][n] = materials[i].emission.value[0] + rho * factors[i][n] * sky.value[0];
    }
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < n; ++i) {
        if (i == k || a[i][k] == 0) continue;
        const Rational factor = a[i][k] / a[k][k];
        for (std::size_t j = k; j <= n; ++j) a[i][j] -= factor * a[k][j];
      }
    std::vector<Rational> result;
    for (std::size_t i = 0; i < n; ++i) result.push_back(a[i][n] / a[i][i]);
    return result;
  }

  Rational net(const std::vector<Rational>& of, std::size_t i) const {
    Rational irradiance = factors[i].back() * sky.value[0];
    for (std::size_t j = 0; j < of.size(); ++j) irradiance += factors[i][j] * of[j];
    return of[i] - irradiance;
  }

  bool has_only_normal_factors() const {
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      for (const FactorEntry& entry : matrix.row(i))
        if (!std::isnormal(entry.factor.value)) return false;
    return true;
  }
};

// Exchange, losses and light, each spread over `decades` powers of ten both ways.
RationalSystem random_system(std::uint64_t seed, int decades) {
  std::mt19937_64 random(seed);
  const auto any = [&](int most) { return static_cast<int>(random() % static_cast<std::uint64_t>(most)); };
  const auto of_any_size = [&]() -> Rational {
    return Rational(1 + any(996), 997) * power_of_ten(any(2 * decades + 1) - decades);
  };
  const std::size_t n = 2 + any(5);
  std::vector<std::vector<Rational>> exchange(n, std::vector<Rational>(n + 1, Rational(0)));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j)
      if (j == i + 1 || any(3) > 0) exchange[i][j] = exchange[j][i] = of_any_size();
    if (any(4) == 0) exchange[i][n] = of_any_size();
  }
  std::vector<Material> materials;
  for (std::size_t i = 0; i < n; ++i) {
    const Rational loss = power_of_ten(-any(decades + 1));
    const Rational reflectivities[] = {1, 1 - loss, 1 - loss, loss, Rational(1, 2), 0};
    materials.push_back({fmt::format("m{}", i), Spectrum::scalar(reflectivities[any(6)]),
                         Spectrum::scalar(any(2) == 0 ? Rational(0) : of_any_size())});
  }
  materials[any(static_cast<int>(n))].reflectivity = Spectrum::scalar(Rational(any(2), 3));  // light dies out
  return {exchange, materials, any(2) == 0 ? Rational(0) : of_any_size()};
}

bool net_holds(const ElementRadiosity& e, const Rational& exact) {
  return (std::isinf(e.net_lower) || Rational(e.net_lower) <= exact) &&
         (std::isinf(e.net_upper) || Rational(e.net_upper) >= exact);
}

struct Storm {
  int solved = 0, refused = 0, misses = 0, wide = 0;
  double widest = 0;
  std::string first;

  void add(const RationalSystem& system, const std::vector<Rational>& exact, const RadiosityOptions& options,
           const std::string& what) {
    RadiositySolution solution;
    try {
      solution = solve_radiosity(system.matrix, system.materials, system.sky, options);
      ++solved;
    } catch (const RequestError&) {
      ++refused;
      return;
    }
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const ElementRadiosity& e = solution.channels[0].elements[i];
      const bool holds = Rational(e.lower) <= exact[i] && (std::isinf(e.upper) || Rational(e.upper) >= exact[i]) &&
                         e.lower <= e.radiosity && e.radiosity <= e.upper && net_holds(e, system.net(exact, i));
      if (!holds && misses++ == 0)
        first = fmt::format("{} face{}: {} in [{}, {}], exact {}", what, i, e.radiosity, e.lower, e.upper,
                            to_double(exact[i]));
      if (std::isnormal(e.lower) && std::isfinite(e.upper)) widest = std::max(widest, e.upper / e.lower - 1);
      if (std::isnormal(to_double(exact[i])) && !(e.upper <= e.lower * (1 + 1e-12)) && wide++ == 0 && first.empty())
        first = fmt::format("{} face{} is wide: {} in [{}, {}], exact {}", what, i, e.radiosity, e.lower, e.upper,
                            to_double(exact[i]));
    }
  }
};

TEST(RadiosityExtremes, BoundsHoldForNumbersOfAnySize) {
  Storm storm;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const RationalSystem system = random_system(seed, 300);
    const std::vector<Rational> exact = system.radiosity();
    for (const Solver solver : kSolvers)
      storm.add(system, exact, {solver, 200, {}, {}}, fmt::format("{} {}", seed, to_string(solver)));
    storm.add(system, exact, {}, fmt::format("{}", seed));
  }
  EXPECT_EQ(storm.misses, 0) << storm.first;
  EXPECT_GT(storm.solved, 10 * storm.refused);  // radiosities or all there is of a factor beyond doubles
  fmt::print("{} solved, {} refused, {} of the radiosities wide\n", storm.solved, storm.refused, storm.wide);
}

TEST(RadiosityExtremes, BoundsAreNarrowWhereTheFactorsAreKnown) {
  for (const int decades : {10, 50, 100}) {
    Storm storm;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      const RationalSystem system = random_system(seed, decades);
      const std::vector<Rational> exact = system.radiosity();
      ASSERT_TRUE(system.has_only_normal_factors());
      for (const Solver solver : {Solver::kAuto, Solver::kCholesky, Solver::kCg})
        storm.add(system, exact, {solver, {}, {}, {}}, fmt::format("{} {}", seed, to_string(solver)));
    }
    EXPECT_EQ(storm.misses, 0) << storm.first;
    EXPECT_EQ(storm.wide, 0) << storm.first;
    EXPECT_EQ(storm.refused, 0);
    fmt::print("{} decades: {} solved, relative widths up to {:.2g}\n", decades, storm.solved, storm.widest);
  }
}

// A room of mirrors, of that half width and height, with a black lamp in it whose back is a mirror.
Scene2 mirror_room(const std::string& half, const std::string& height, const std::string& lamp, const std::string& at) {
  return scene_of(fmt::format(
      R"({{"hottel":1,"dimension":2,"materials":{{"l":{{"emission":1}},"m":{{"reflectivity":1}}}},
"edges":[{{"name":"lamp","points":[["-{2}","{3}"],["{2}","{3}"]],"material":"l","back":"m"}}],
"polylines":[{{"name":"r","points":[["-{0}",0],["-{0}","{1}"],["{0}","{1}"],["{0}",0]],"closed":true,"material":"m"}}]}})",
      half, height, lamp, at));
}

TEST(RadiosityExtremes, ARoomOfMirrorsIsAsBrightAsItsLampHoweverSmallThatIs) {
  const Scene2 rooms[] = {mirror_room("100", "100", "0.01", "0.5"), mirror_room("10", "100", "0.01", "0.5"),
                          mirror_room("40", "100", "0.01", "0.5"),  mirror_room("1", "1", "1e-155", "0.5"),
                          mirror_room("1", "1", "1e-161", "0.5"),   mirror_room("1e200", "1e200", "1e-200", "1e-200")};
  for (const Scene2& room : rooms) {
    const ExchangeMatrix matrix = exact_exchange(prepare(room), {Granularity::kFace});
    for (const Solver solver : kSolvers) {
      const RadiositySolution solution =
          solve_radiosity(matrix, room.materials, room.sky_emission, {solver, 100, {}, {}});
      for (std::uint32_t i = 0; i < matrix.size(); ++i) {
        if (!matrix.has_row(i)) continue;
        const ElementRadiosity& e = solution.channels[0].elements[i];
        EXPECT_EQ(e.lower, 1) << to_string(solver) << " " << matrix.elements()[i].name;
        EXPECT_EQ(e.upper, 1) << to_string(solver) << " " << matrix.elements()[i].name;
      }
    }
  }
}

TEST(RadiosityExtremes, BoundsAreNarrowWhereAllLightIsLostInAVerySmallPlace) {
  for (const char* size : {"1e-5", "1e-20", "1e-50"}) {
    const Scene2 room = scene_of(fmt::format(
        R"({{"hottel":1,"dimension":2,
"materials":{{"l":{{"emission":1,"reflectivity":1}},"m":{{"reflectivity":1}},"h":{{"reflectivity":0.5}}}},
"polylines":[{{"name":"r","points":[[0,0],[0,1],[1,1],[1,0]],"material":"m"}},
{{"name":"lamp","points":[[1,0],["0.5",0]],"material":"l"}},{{"name":"floor","points":[["0.5",0],["{0}",0]],"material":"m"}},
{{"name":"hole","points":[["{0}",0],[0,0]],"material":"h"}}]}})",
        size));
    const ExactScene scene(room);
    for (const Solver solver : {Solver::kAuto, Solver::kCholesky, Solver::kCg}) {
      const RadiositySolution solution = scene.solve({solver, {}, {}, {}});
      EXPECT_LE(solution.max_relative_width, 1e-14) << size;
      // What the lamp sends out the hole takes: half of what falls on it.
      EXPECT_NEAR(solution.channels[0].elements[scene.matrix().find("r[0]").value()].radiosity * std::stod(size), 1,
                  2e-5);
    }
  }
}

TEST(RadiosityExtremes, AFurnaceIsOneWhereTheLossIsADenormal) {
  Scene2 room = convex_polygon(6);
  for (Material& material : room.materials) {
    material.reflectivity = Spectrum::scalar(1 - power_of_ten(-310));
    material.emission = Spectrum::scalar(power_of_ten(-310));
  }
  room.materials[0].emission = Spectrum::scalar(2 * power_of_ten(-310));
  const ExactScene scene(room);
  for (const Solver solver : {Solver::kCholesky, Solver::kCg}) {
    const RadiositySolution solution = scene.solve({solver, {}, {}, {}});
    EXPECT_LE(solution.max_relative_width, 1e-14);
    for (const ElementRadiosity& e : solution.channels[0].elements)
      if (e.reflectivity > 0) {
        EXPECT_NEAR(e.radiosity, 1 + 1 / 6.0, 1e-5);
      }
  }
}

TEST(RadiosityExtremes, AreasBeyondTheRangeOfDoublesAreNamedAndDoNotSpoilTheLight) {
  for (const char* size : {"1e308", "1e-324"}) {
    const Scene2 plates = scene_of(fmt::format(
        R"({{"hottel":1,"dimension":2,"materials":{{"a":{{"reflectivity":0.5,"emission":1}}}},"edges":[
{{"name":"x","points":[["-{0}",0],["{0}",0]],"material":"a"}},
{{"name":"y","points":[["{0}","{0}"],["-{0}","{0}"]],"material":"a"}}]}})",
        size));
    const ExchangeMatrix matrix = exact_exchange(prepare(plates), {Granularity::kFace});
    const RadiositySolution solution = solve_radiosity(matrix, plates.materials, plates.sky_emission);
    for (const char* name : {"x", "y"}) {
      const ElementRadiosity& e = solution.channels[0].elements[matrix.find(name).value()];
      EXPECT_LE(e.lower, 1);
      EXPECT_GE(e.upper, 1);
      EXPECT_LE(e.upper - e.lower, 1e-14);
    }
    if (std::string(size) != "1e308") continue;
    try {
      require_doubles(matrix, plates.sky_emission, solution);
      FAIL() << "an area of 2e308 is no double";
    } catch (const RequestError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("the area of 'x'"));
    }
  }
}

TEST(RadiosityExtremes, ScriptFOfALampAmongMirrorsIsAllThatItSendsOut) {
  for (const Scene2& room : {mirror_room("100", "100", "0.01", "0.5"), mirror_room("1", "1", "1e-100", "0.5")}) {
    const ExchangeMatrix factors = gray_exchange(exact_exchange(prepare(room), {Granularity::kFace}), room.materials);
    const std::uint32_t lamp = factors.find("lamp").value();
    ASSERT_EQ(factors.row(lamp).size(), 1u);
    EXPECT_GE(factors.bounds(lamp, 0).lower, 1 - 1e-15);
    EXPECT_EQ(factors.bounds(lamp, 0).upper, 1);
  }
}

TEST(RadiosityExtremes, ScriptFOfNextToMirrorsSharesOutWhatLittleTheyAbsorb) {
  Scene2 room = convex_polygon(5);
  const ExchangeMatrix matrix = exact_exchange(prepare(room), {Granularity::kFace});
  for (const int decades : {100, 200, 290}) {
    const Rational emissivity = power_of_ten(-decades);
    for (Material& material : room.materials) material.reflectivity = Spectrum::scalar(1 - emissivity);
    const ExchangeMatrix factors = gray_exchange(matrix, room.materials);
    const Rational perimeter = [&] {
      Rational sum = 0;
      for (std::uint32_t i = 0; i < 5; ++i)
        sum += Rational(matrix.elements()[*matrix.find(room.surfaces[i].name)].area.value);
      return sum;
    }();
    const std::uint32_t from = matrix.find(room.surfaces[0].name).value();
    for (const FactorEntry& entry : factors.row(from)) {
      // Light stays so long that all get their share of it, by area.
      const Rational share = Rational(matrix.elements()[entry.to].area.value) / perimeter;
      EXPECT_NEAR(to_double(entry.factor.value / emissivity), to_double(share), 1e-14) << decades;
    }
    for (std::size_t k = 0; k < factors.row(from).size(); ++k) {
      const Enclosure bounds = factors.bounds(from, k);
      EXPECT_LE(bounds.upper - bounds.lower, 1e-14 * bounds.upper) << decades;
    }
  }
}

}  // namespace
}  // namespace hottel::radiosity_extremes_test
