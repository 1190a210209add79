// One solver, many lights: bits against solvers that have solved nothing before, bounds against solutions to a hundred
// digits.
#include "solver/radiosity/radiosity_solver.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/generate/generators.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/radiosity/a_priori_bounds.h"
#include "solver/radiosity/net_flux.h"
#include "tests/solver/plane/bounds_hold.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::radiosity_solver_test {
namespace {

using namespace testing_radiosity;
using Random = std::mt19937_64;

std::shared_ptr<const ExchangeMatrix> shared(const ExchangeMatrix& matrix) {
  return std::make_shared<const ExchangeMatrix>(matrix);
}

ExactScene random_exact_scene(std::uint64_t seed) {
  return ExactScene(random_scene(seed), seed % 5 == 0 ? Divided2::kYes : Divided2::kNo);
}

double share(Random& random) { return std::uniform_real_distribution<double>(0, 1)(random); }

// All that a solution says but its seconds, as text: doubles by their bits.
std::string bits(const RadiositySolution& solution) {
  std::string text = fmt::format("{} {} {} {} {}\n", to_string(solution.guarantee), to_string(solution.used),
                                 solution.unknowns, solution.components, solution.factorizations);
  const auto add = [&text](std::initializer_list<double> numbers) {
    for (const double number : numbers) text += fmt::format(" {:x}", std::bit_cast<std::uint64_t>(number));
    text += '\n';
  };
  const auto add_energy = [&](const EnergyBalance& e) { add({e.emitted, e.absorbed, e.to_sky, e.defect}); };
  for (std::size_t c = 0; c < solution.channels.size(); ++c) {
    const ChannelSolution& channel = solution.channels[c];
    text += solution.channel_names[c] + '\n';
    for (const ElementRadiosity& e : channel.elements)
      add({e.emission, e.reflectivity, e.radiosity, e.lower, e.upper, e.irradiance, e.net_lower, e.net_upper,
           e.net_value});
    for (const double residual : channel.residual_history) add({residual});
    for (const DarkComponent& dark : channel.dark) text += fmt::format("dark {} {}\n", dark.first_element, dark.size);
    add_energy(channel.energy);
    add({channel.max_relative_width});
  }
  add_energy(solution.energy);
  add({solution.max_relative_width, solution.closure_defect, solution.reciprocity_defect});
  for (const std::string& note : solution.notes) text += note + '\n';
  return text;
}

// The bits of a solution, or why there is none.
std::string bits(const RadiositySolver& solver, const RadiositySources& sources) {
  try {
    return bits(solver.solve(sources));
  } catch (const RequestError& error) {
    return error.what();
  }
}

// What random sources may be.
struct Kind {
  bool is_gray = true, has_direct = true;
  double width = 0;   // relative, up to which numbers are enclosed; 0: doubles
  double dark = 0.5;  // the part of elements that neither emit nor are shone on
  double most_direct = 1;
};

SourceSpectrum random_spectrum(const Kind& kind, double most, Random& random) {
  const auto number = [&]() -> Enclosure {
    if (share(random) < kind.dark) return {0, 0};
    const double lower = most * share(random);
    return {lower, lower * (1 + kind.width * share(random))};
  };
  if (kind.is_gray) return SourceSpectrum::scalar(number());
  return SourceSpectrum::of({number(), number(), number()});
}

RadiositySources random_sources(const ExchangeMatrix& matrix, const Kind& kind, Random& random) {
  RadiositySources result;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    result.emission.push_back(random_spectrum(kind, 1, random));
    if (kind.has_direct) result.direct_irradiance.push_back(random_spectrum(kind, kind.most_direct, random));
  }
  if (share(random) < 0.5) result.sky = random_spectrum(kind, 1, random);
  return result;
}

// Rooms side by side that do not see each other, each a square with its own reflectivity.
Scene2 rooms(const std::vector<Rational>& reflectivity) {
  std::string materials, edges;
  for (std::size_t k = 0; k < reflectivity.size(); ++k) {
    const std::string comma = k == 0 ? "" : ", ";
    materials += fmt::format(R"({}"m{}": {{"reflectivity": "{}"}})", comma, k, to_string(reflectivity[k]));
    const std::size_t x = 3 * k;
    edges += fmt::format(
        R"({0}{{"name": "s{1}", "points": [[{3},0],[{2},0]], "material": "m{1}"}},
           {{"name": "w{1}", "points": [[{2},0],[{2},1]], "material": "m{1}"}},
           {{"name": "n{1}", "points": [[{2},1],[{3},1]], "material": "m{1}"}},
           {{"name": "e{1}", "points": [[{3},1],[{3},0]], "material": "m{1}"}})",
        comma, k, x, x + 1);
  }
  return scene_of(
      fmt::format(R"({{"hottel": 1, "dimension": 2, "materials": {{{}}}, "edges": [{}]}})", materials, edges));
}

// The same factors, each of them an estimate, or known to lie within a part of itself.
ExchangeMatrix weakened(const ExchangeMatrix& exact, Guarantee guarantee, double width = 0) {
  std::vector<std::size_t> begin{0};
  std::vector<FactorEntry> entries;
  std::vector<Enclosure> bounds;
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    for (FactorEntry entry : exact.row(i)) {
      const double factor = entry.factor.value;
      entry.factor.side = 0;
      entries.push_back(entry);
      bounds.push_back({std::nextafter(factor * (1 - width), 0), std::nextafter(factor * (1 + width), 2)});
    }
    begin.push_back(entries.size());
  }
  ExchangeMatrix matrix(exact.elements(), guarantee);
  matrix.assign(std::move(begin), std::move(entries), {}, std::move(bounds));
  return matrix;
}

// Solves several lights one after the other, twice over, and compares each with a solver that has solved nothing.
void expect_no_memory(const ExchangeMatrix& matrix, const std::vector<Spectrum>& reflectivity,
                      const RadiosityOptions& options, const std::vector<RadiositySources>& lights,
                      const std::string& what) {
  const auto held = shared(matrix);
  std::vector<std::string> fresh;
  for (const RadiositySources& light : lights)
    fresh.push_back(bits(RadiositySolver(held, reflectivity, options), light));
  const RadiositySolver solver(held, reflectivity, options);
  for (int round = 0; round < 2; ++round)
    for (std::size_t k = 0; k < lights.size(); ++k)
      EXPECT_TRUE(bits(solver, lights[k]) == fresh[k]) << what << ", light " << k << ", round " << round;
}

TEST(RadiositySolver, GivesTheSameBitsAsTheOneCall) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const ExactScene scene = random_exact_scene(seed);
    const auto& materials = scene.scene().materials;
    const RadiositySolver solver(shared(scene.matrix()), reflectivities_of(materials));
    const RadiositySources sources = sources_of(scene.matrix(), materials, scene.scene().sky_emission);
    const std::string once = bits(scene.solve());
    EXPECT_EQ(bits(solver.solve(sources)), once);
    RadiositySources with_zeros = sources;  // no light is no light, however it is said
    with_zeros.direct_irradiance.resize(scene.matrix().size());
    EXPECT_EQ(bits(solver.solve(with_zeros)), once);
  }
}

TEST(RadiositySolver, ForgetsWhatWasSolvedBefore) {
  Random random(1);
  std::size_t lit = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const ExactScene scene = random_exact_scene(seed);
    std::vector<Spectrum> reflectivity = reflectivities_of(scene.scene().materials);
    if (seed % 3 == 0)  // two systems
      for (Spectrum& spectrum : reflectivity) spectrum = {{spectrum.value[0], spectrum.value[0] / 2, 0}, false};
    std::vector<RadiositySources> lights;
    for (int k = 0; k < 4; ++k)
      lights.push_back(random_sources(scene.matrix(), {k % 2 == 0, k != 1, k == 3 ? 0.1 : 0, 0.8}, random));
    lights.push_back(sources_of(scene.matrix(), scene.scene().materials, scene.scene().sky_emission));
    expect_no_memory(scene.matrix(), reflectivity, {}, lights, scene.scene().about);
    lit += RadiositySolver(shared(scene.matrix()), reflectivity).solve(lights[3]).factorizations;
  }
  EXPECT_GT(lit, 120u);
}

TEST(RadiositySolver, ForgetsWhichComponentsWereLitBefore) {
  Random random(2);
  const ExactScene scene(
      rooms({Rational(1, 2), 1 - Rational(1, Integer(1) << 48), 1, Rational(2, 3), 1 - Rational(1, Integer(1) << 90)}));
  std::vector<RadiositySources> lights;
  for (int k = 0; k < 12; ++k) lights.push_back(random_sources(scene.matrix(), {k % 2 == 0, true, 0, 0.9}, random));
  for (RadiositySources& light : lights)  // but for two of them, the mirrors stay dark
    if (&light - lights.data() > 1)
      for (std::uint32_t i = 0; i < scene.matrix().size(); ++i)
        if (const auto m = scene.matrix().elements()[i].material; m && *m == 2)
          light.emission[i] = light.direct_irradiance[i] = {};
  const std::vector<Spectrum> reflectivity = reflectivities_of(scene.scene().materials);
  for (const Solver solver : {Solver::kAuto, Solver::kCholesky, Solver::kCg, Solver::kLu, Solver::kBicgstab,
                              Solver::kJacobi, Solver::kGaussSeidel, Solver::kShooting}) {
    RadiosityOptions options;
    options.solver = solver;
    if (solver != Solver::kAuto && solver != Solver::kCholesky && solver != Solver::kLu) options.iterations = 20;
    expect_no_memory(scene.matrix(), reflectivity, options, lights, to_string(solver));
    if (solver == Solver::kCholesky || solver == Solver::kCg) continue;
    expect_no_memory(weakened(scene.matrix(), Guarantee::kEstimated), reflectivity, options, lights,
                     std::string("estimated ") + to_string(solver));
  }
  expect_no_memory(weakened(scene.matrix(), Guarantee::kEnclosed, 1e-3), reflectivity, {}, lights, "enclosed");
}

TEST(RadiositySolver, ForgetsWhatWasSolvedBeforeInLargeScenes) {
  // One room of many faces takes conjugate gradients when it is lit; a small one beside it takes elimination alone.
  Random random(3);
  Scene2 scene = generate_2({"clutter", 900, 5});
  const ExchangeMatrix matrix = exact_exchange(prepare(scene), {.wants_visibility = false});
  std::vector<Spectrum> reflectivity = reflectivities_of(scene.materials);
  for (Spectrum& spectrum : reflectivity) spectrum.is_scalar = false;
  std::vector<RadiositySources> lights{random_sources(matrix, {true, true, 0, 0.99}, random),
                                       random_sources(matrix, {false, false, 0, 0.9}, random)};
  const RadiositySolver solver(shared(matrix), reflectivity);
  EXPECT_EQ(solver.solve(lights[1]).used, Solver::kCg);
  expect_no_memory(matrix, reflectivity, {}, lights, "cg");
}

// Radiosities by element for numbers of the sources, by Gaussian elimination with kBits.
struct Numbers {
  std::vector<mpf_class> emission, direct;
  mpf_class sky;
};

mpf_class number_within(const RationalEnclosure& within, int kind, Random& random) {
  const double at = kind == 0           ? 0
                    : kind == 1         ? 1
                    : random() % 4 == 0 ? static_cast<double>(random() % 2)
                                        : share(random);
  return number(Rational(within.lower + Rational(at) * (within.upper - within.lower)));
}

// kind: 0 the lower ends, 1 the upper ends, else random numbers within.
Numbers numbers_within(const ExchangeMatrix& matrix, const RadiositySources& sources, int channel, int kind,
                       Random& random) {
  Numbers result;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    result.emission.push_back(number_within(sources.emission[i][channel], kind, random));
    result.direct.push_back(sources.direct_irradiance.empty()
                                ? mpf_class(0, kBits)
                                : number_within(sources.direct_irradiance[i][channel], kind, random));
  }
  result.sky = number_within(sources.sky[channel], kind, random);
  return result;
}

struct OneLight {
  std::vector<mpf_class> radiosity, irradiance;
};

OneLight light_of(const ExchangeMatrix& matrix, const WideFactors& factors, const std::vector<Rational>& reflectivity,
                  const Numbers& numbers) {
  const std::size_t n = matrix.size();
  std::vector<std::vector<mpf_class>> a(n, std::vector<mpf_class>(n + 1, mpf_class(0, kBits)));
  for (std::uint32_t i = 0; i < n; ++i) {
    if (matrix.has_row(i)) {
      const mpf_class rho = number(reflectivity[*matrix.elements()[i].material]);
      for (std::size_t j = 0; j < n; ++j) a[i][j] = -rho * factors[i][j];
      a[i][n] = numbers.emission[i] + rho * (factors[i][n] * numbers.sky + numbers.direct[i]);
    }
    a[i][i] += 1;
  }
  OneLight result;
  for (const auto& row : solve_dense(std::move(a))) result.radiosity.push_back(row.front());
  for (std::uint32_t i = 0; i < n; ++i) {
    mpf_class sum = factors[i][n] * numbers.sky + numbers.direct[i];
    for (std::size_t j = 0; j < n; ++j) sum += factors[i][j] * result.radiosity[j];
    result.irradiance.push_back(sum);
  }
  return result;
}

struct WithinCheck : BoundsHold {
  std::size_t wide_ends = 0;

  // `is_end`: the numbers are those at which the radiosities have their bounds.
  void add(const ExchangeMatrix& matrix, const WideFactors& factors, const std::vector<Rational>& reflectivity,
           const Numbers& numbers, const ChannelSolution& solution, double ElementRadiosity::*end = nullptr) {
    const OneLight light = light_of(matrix, factors, reflectivity, numbers);
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      const ElementRadiosity& e = solution.elements[i];
      const mpf_class net =
          numbers.emission[i] - (1 - number(reflectivity[*matrix.elements()[i].material])) * light.irradiance[i];
      require(i, light.radiosity[i], {e.lower, e.upper}, e.radiosity, "radiosity");
      require(i, net, {e.net_lower, e.net_upper}, e.net_value, "net");
      if (end && abs(light.radiosity[i] - mpf_class(e.*end, kBits)) > 1e-13 * light.radiosity[i]) ++wide_ends;
    }
  }
};

TEST(RadiositySolver, BoundsHoldForAnySourcesWithinTheirEnclosuresAndAreTight) {
  Random random(4);
  WithinCheck check;
  double widest = 0;
  for (std::uint64_t seed = 0; seed < 210; ++seed) {
    const ExactScene scene = random_exact_scene(seed);
    const ExchangeMatrix& matrix = scene.matrix();
    const std::vector<Spectrum> reflectivity = reflectivities_of(scene.scene().materials);
    const double widths[] = {0, 1e-15, 1e-9, 0.3, 1e3};
    const Kind kind{seed % 2 == 0, seed % 7 != 0, widths[seed % 5], 0.4, seed % 3 == 0 ? 1e6 : 1};
    const RadiositySources sources = random_sources(matrix, kind, random);
    const RadiositySolution solution = RadiositySolver(shared(matrix), reflectivity).solve(sources);
    for (std::size_t c = 0; c < solution.channels.size(); ++c) {
      const int channel = static_cast<int>(c);
      const std::vector<Rational> rho = in_channel(reflectivity, channel);
      for (int at = 0; at < 4; ++at) {
        const bool is_at_end = at < 2 && kind.width != 1e-15;
        const auto end = at == 0 ? &ElementRadiosity::lower : &ElementRadiosity::upper;
        check.add(matrix, scene.factors(), rho, numbers_within(matrix, sources, channel, at, random),
                  solution.channels[c], is_at_end ? end : nullptr);
      }
    }
    if (kind.width <= 1e-15) widest = std::max(widest, solution.max_relative_width);
  }
  EXPECT_EQ(check.misses, 0u) << check.first_miss;
  EXPECT_EQ(check.wide_ends, 0u);
  EXPECT_GT(check.checked, 40'000u);
  EXPECT_LT(widest, 2e-14);
  fmt::print("{} radiosities and nets, {} misses; widest of sources within a few ulps {:.2g}\n", check.checked,
             check.misses, widest);
}

TEST(RadiositySolver, BoundsHoldWhereFactorsAreEnclosedToo) {
  Random random(5);
  WithinCheck check;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const ExactScene scene = random_exact_scene(seed);
    std::vector<Spectrum> reflectivity = reflectivities_of(scene.scene().materials);
    for (Spectrum& spectrum : reflectivity)
      if (spectrum.value[0] > Rational(9, 10)) spectrum = Spectrum::scalar(Rational(9, 10));
    const ExchangeMatrix matrix = weakened(scene.matrix(), Guarantee::kEnclosed, 1e-2);
    const RadiositySources sources = random_sources(matrix, {true, true, seed % 2 == 0 ? 0.2 : 0, 0.5}, random);
    const RadiositySolution solution = RadiositySolver(shared(matrix), reflectivity).solve(sources);
    for (int k = 0; k < 4; ++k) {
      WideFactors factors(matrix.size(), std::vector<mpf_class>(matrix.size() + 1, mpf_class(0, kBits)));
      for (std::uint32_t i = 0; i < matrix.size(); ++i)
        for (std::size_t entry = 0; entry < matrix.row(i).size(); ++entry) {
          const Enclosure bounds = matrix.bounds(i, entry);
          factors[i][matrix.row(i)[entry].to] =
              number_within({Rational(bounds.lower), Rational(bounds.upper)}, k, random);
        }
      check.add(matrix, factors, in_channel(reflectivity, 0), numbers_within(matrix, sources, 0, k, random),
                solution.channels[0]);
    }
    // Bounds for any factors that sum to 1 hold for the exact ones.
    RadiositySolution narrowed = solution;
    set_a_priori_bounds(matrix, reflectivity, sources, narrowed);
    for (int k = 0; k < 3; ++k)
      check.add(matrix, scene.factors(), in_channel(reflectivity, 0), numbers_within(matrix, sources, 0, k, random),
                narrowed.channels[0]);
  }
  EXPECT_EQ(check.misses, 0u) << check.first_miss;
}

TEST(RadiositySolver, IsLinear) {
  Random random(6);
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const ExactScene scene = random_exact_scene(seed);
    const ExchangeMatrix& matrix = scene.matrix();
    const RadiositySolver solver(shared(matrix), reflectivities_of(scene.scene().materials));
    const RadiositySources a = random_sources(matrix, {}, random), b = random_sources(matrix, {}, random);
    const auto combined = [&](const Rational& of_b) {
      const auto number = [&](const SourceSpectrum& x, const SourceSpectrum& y) {
        return SourceSpectrum(Spectrum::scalar(x[0].lower + of_b * y[0].lower));
      };
      RadiositySources result;
      result.sky = number(a.sky, b.sky);
      for (std::uint32_t i = 0; i < matrix.size(); ++i) {
        result.emission.push_back(number(a.emission[i], b.emission[i]));
        result.direct_irradiance.push_back(number(a.direct_irradiance[i], b.direct_irradiance[i]));
      }
      return result;
    };
    const RadiositySolution of_a = solver.solve(a), of_b = solver.solve(b);
    const RadiositySolution of_both = solver.solve(combined(Rational(1, 3)));
    const auto outward = [](double value) { return 4e-16 * std::abs(value); };
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      const ElementRadiosity &x = of_a.channels[0].elements[i], &y = of_b.channels[0].elements[i],
                             &z = of_both.channels[0].elements[i];
      EXPECT_LE(z.lower, x.upper + y.upper / 3 + outward(z.lower));
      EXPECT_GE(z.upper, x.lower + y.lower / 3 - outward(z.upper));
      EXPECT_NEAR(z.irradiance, x.irradiance + y.irradiance / 3, 1e-13 * (1 + z.irradiance));
    }
  }
}

TEST(RadiositySolver, DirectIrradianceMattersToRadiositiesAsItsReflectionDoes) {
  Random random(7);
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const ExactScene scene = random_exact_scene(seed);
    const ExchangeMatrix& matrix = scene.matrix();
    const std::vector<Spectrum> reflectivity = reflectivities_of(scene.scene().materials);
    const RadiositySolver solver(shared(matrix), reflectivity);
    const RadiositySources given = random_sources(matrix, {seed % 2 == 0, true, 0, 0.5}, random);
    RadiositySources raised = given;
    raised.direct_irradiance.clear();
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      Spectrum sum;
      sum.is_scalar = given.emission[i].is_scalar();
      for (int c = 0; c < 3; ++c)
        sum.value[c] = given.emission[i][c].lower +
                       reflectivity[*matrix.elements()[i].material].value[c] * given.direct_irradiance[i][c].lower;
      raised.emission[i] = sum;
    }
    const RadiositySolution direct = solver.solve(given), reflected = solver.solve(raised);
    ASSERT_EQ(direct.channels.size(), reflected.channels.size());
    for (std::size_t c = 0; c < direct.channels.size(); ++c) {
      EXPECT_EQ(direct.channels[c].residual_history, reflected.channels[c].residual_history);
      for (std::uint32_t i = 0; i < matrix.size(); ++i) {
        const ElementRadiosity &d = direct.channels[c].elements[i], &r = reflected.channels[c].elements[i];
        // The lower bound may be that of what is emitted, which is known to half an ulp.
        EXPECT_TRUE(d.lower == r.lower || std::nextafter(d.lower, r.lower) == r.lower) << d.lower << " " << r.lower;
        EXPECT_TRUE(d.radiosity == r.radiosity || d.radiosity == std::nextafter(r.radiosity, d.radiosity));
        EXPECT_EQ(d.upper, r.upper);
        // B = E + rho H.
        if (matrix.has_row(i)) {
          EXPECT_EQ(d.emission, given.emission[i][static_cast<int>(c)].lower.get_d());
          EXPECT_NEAR(d.emission + d.reflectivity * d.irradiance, d.radiosity, 1e-13 * (1 + d.radiosity));
          EXPECT_EQ(d.net(), d.radiosity - d.irradiance);
        }
      }
    }
  }
}

TEST(RadiositySolver, EnergyClosesAndDirectLightCountsAsEmitted) {
  Random random(8);
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const ExactScene scene = random_exact_scene(seed);
    const ExchangeMatrix& matrix = scene.matrix();
    const std::vector<Spectrum> reflectivity = reflectivities_of(scene.scene().materials);
    const RadiositySources sources = random_sources(matrix, {true, true, seed % 4 == 0 ? 1e-3 : 0, 0.5}, random);
    const RadiositySolution solution = RadiositySolver(shared(matrix), reflectivity).solve(sources);
    double emitted = 0, direct = 0;
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      const double area = matrix.elements()[i].area.value;
      const auto middle = [](const SourceSpectrum& s) { return s.at(End::kMiddle)[0].lower.get_d(); };
      emitted += area * middle(sources.emission[i]);
      direct += area * middle(sources.direct_irradiance[i]);
      emitted += area * matrix.factor(i, matrix.sky()).value * middle(sources.sky);
    }
    const EnergyBalance& energy = solution.energy;
    EXPECT_NEAR(energy.emitted, emitted + direct, 1e-12 * (emitted + direct));
    EXPECT_LE(std::abs(energy.defect), 1e-13 * energy.emitted);
    EXPECT_NEAR(energy.emitted, energy.absorbed + energy.to_sky, 1e-12 * energy.emitted);
    double net = 0;  // what comes directly comes from no face
    for (const NetFlux& flux : net_flux(matrix, solution, sources.sky, [](const Element& e) { return e.name; }))
      net += flux.by_channel[0].value;
    EXPECT_NEAR(net, -direct, 1e-12 * (emitted + direct));
  }
}

TEST(RadiositySolver, FacesThatAreShoneOnEmit) {
  const ExactScene scene(rooms({1, Rational(1, 2), 0}));
  const ExchangeMatrix& matrix = scene.matrix();
  const RadiositySolver solver(shared(matrix), reflectivities_of(scene.scene().materials));
  RadiositySources sources = sources_of(matrix, scene.scene().materials, {});
  sources.direct_irradiance.resize(matrix.size());
  const auto shine_on = [&](const std::string& name, const Enclosure& within) {
    sources.direct_irradiance[matrix.find(name).value()] = SourceSpectrum::scalar(within);
  };
  const auto of = [&](const RadiositySolution& solution, const std::string& name) {
    return solution.channels[0].elements[matrix.find(name).value()];
  };
  // Nothing.
  const RadiositySolution dark = solver.solve(sources);
  EXPECT_EQ(dark.used, Solver::kAuto);
  EXPECT_EQ(dark.channels[0].dark.size(), 2u);
  ASSERT_EQ(dark.notes.size(), 1u);
  EXPECT_THAT(dark.notes[0], testing::HasSubstr("'s0'"));
  // A black face: it takes all, and sends nothing out.
  shine_on("s2", {2, 2});
  const RadiositySolution black = solver.solve(sources);
  EXPECT_EQ(black.used, Solver::kAuto);
  EXPECT_EQ(of(black, "s2").radiosity, 0);
  EXPECT_EQ(of(black, "s2").irradiance, 2);
  EXPECT_EQ(of(black, "s2").net_value, -2);
  EXPECT_EQ(black.energy.emitted, 2);
  EXPECT_EQ(black.energy.absorbed, 2);
  // A face that reflects, by light that may be none.
  shine_on("s1", {0, 4});
  const RadiositySolution lit = solver.solve(sources);
  EXPECT_EQ(lit.channels[0].dark.size(), 1u);
  EXPECT_EQ(of(lit, "s1").lower, 0);
  EXPECT_GE(of(lit, "s1").upper, 2);
  EXPECT_EQ(of(lit, "s1").emission, 0);
  EXPECT_GT(of(lit, "n1").upper, 0);
  // Mirrors all round.
  shine_on("s0", {0, 1});
  EXPECT_THAT([&] { solver.solve(sources); }, testing::ThrowsMessage<RequestError>(testing::HasSubstr("'s0'")));
  shine_on("s0", {0, 0});
  EXPECT_EQ(bits(solver.solve(sources)), bits(lit));
}

TEST(RadiositySolver, HasThreeChannelsUnlessAllIsGray) {
  const ExactScene scene(rooms({Rational(1, 2)}));
  const ExchangeMatrix& matrix = scene.matrix();
  const std::vector<Spectrum> gray = reflectivities_of(scene.scene().materials);
  const std::vector<Spectrum> coloured{{{Rational(1, 2), Rational(1, 2), Rational(1, 2)}, false}};
  const auto channels = [&](const std::vector<Spectrum>& reflectivity, const RadiositySources& sources) {
    const RadiositySolution solution = RadiositySolver(shared(matrix), reflectivity).solve(sources);
    EXPECT_EQ(solution.channels.size(), solution.channel_names.size());
    return solution.channels.size();
  };
  const SourceSpectrum one = Spectrum::scalar(1), rgb = SourceSpectrum::of({Enclosure{1, 1}, {1, 1}, {1, 1}});
  const std::uint32_t row = matrix.find("s0").value();
  RadiositySources sources;
  sources.emission.resize(matrix.size());
  sources.direct_irradiance.resize(matrix.size());
  EXPECT_EQ(channels(gray, sources), 1u);
  EXPECT_EQ(channels(coloured, sources), 3u);
  sources.emission[row] = sources.direct_irradiance[row] = sources.sky = one;
  EXPECT_EQ(channels(gray, sources), 1u);
  for (SourceSpectrum* spectrum : {&sources.emission[row], &sources.direct_irradiance[row], &sources.sky}) {
    *spectrum = rgb;
    EXPECT_EQ(channels(gray, sources), 3u);
    *spectrum = one;
  }
  sources.has_channels = true;
  EXPECT_EQ(channels(gray, sources), 3u);
}

TEST(RadiositySolver, RefusesSourcesOfAnotherMatrix) {
  const ExactScene scene(rooms({Rational(1, 2)}));
  const RadiositySolver solver(shared(scene.matrix()), reflectivities_of(scene.scene().materials));
  RadiositySources sources;
  EXPECT_THROW(solver.solve(sources), ContractViolation);
  sources.emission.resize(scene.matrix().size());
  EXPECT_NO_THROW(solver.solve(sources));
  sources.direct_irradiance.resize(scene.matrix().size() + 1);
  EXPECT_THROW(solver.solve(sources), ContractViolation);
  EXPECT_THROW(RadiositySolver(shared(scene.matrix()), {}), ContractViolation);
  EXPECT_THROW(RadiositySolver(nullptr, {}), ContractViolation);
  const std::vector<Spectrum> reflectivity = reflectivities_of(scene.scene().materials);
  EXPECT_THROW(RadiositySolver(shared(scene.matrix()), reflectivity, {.iterations = -1}), ContractViolation);
  EXPECT_THROW(RadiositySolver(shared(scene.matrix()), reflectivity, {.until = -1e-9}), ContractViolation);
}

TEST(RadiositySolver, TellsHowFarItIsAndStopsWhenToldTo) {
  const ExactScene scene(rooms({Rational(1, 2), Rational(1, 3)}));
  const std::vector<Spectrum> reflectivity = reflectivities_of(scene.scene().materials);
  const RadiositySolver solver(shared(scene.matrix()), reflectivity);
  Random random(9);
  const RadiositySources sources = random_sources(scene.matrix(), {false, true, 0.1, 0.5}, random);
  std::vector<double> told;
  const std::string result = bits(solver.solve(sources, [&](double fraction) { told.push_back(fraction); }));
  ASSERT_EQ(told.size(), 9u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1);
  struct Stop {};
  EXPECT_THROW(solver.solve(sources, [](double) { throw Stop(); }), Stop);
  EXPECT_EQ(bits(solver.solve(sources)), result);
  EXPECT_GT(solver.seconds(), 0);
}

TEST(RadiositySolver, GivesThreadsThatSolveAtOnceWhatItGivesOne) {
  Random random(10);
  const ExactScene polygon(convex_polygon(40)), few(rooms({Rational(1, 2), 1 - Rational(1, Integer(1) << 70)}));
  for (const ExactScene* scene : {&polygon, &few}) {
    std::vector<Spectrum> reflectivity = reflectivities_of(scene->scene().materials);
    for (Spectrum& spectrum : reflectivity)
      if (spectrum.value[0] == 0) spectrum = Spectrum::scalar(Rational(19, 20));
    std::vector<RadiositySources> lights;
    for (int k = 0; k < 6; ++k)
      lights.push_back(random_sources(scene->matrix(), {k % 2 == 0, true, k == 4 ? 0.01 : 0, 0.95}, random));
    for (const auto& [guarantee, named] :
         {std::pair{Guarantee::kExact, Solver::kAuto}, std::pair{Guarantee::kExact, Solver::kCg},
          std::pair{Guarantee::kExact, Solver::kJacobi}, std::pair{Guarantee::kEstimated, Solver::kAuto},
          std::pair{Guarantee::kEnclosed, Solver::kAuto}}) {
      const auto matrix =
          guarantee == Guarantee::kExact ? shared(scene->matrix()) : shared(weakened(scene->matrix(), guarantee, 1e-3));
      RadiosityOptions options;
      options.solver = named;
      if (named == Solver::kJacobi) options.iterations = 10;
      std::vector<std::string> serial, at_once(lights.size());
      for (const RadiositySources& light : lights)
        serial.push_back(bits(RadiositySolver(matrix, reflectivity, options), light));
      const RadiositySolver solver(matrix, reflectivity, options);
      std::vector<std::thread> threads;
      for (std::size_t k = 0; k < lights.size(); ++k)
        threads.emplace_back([&, k] { at_once[k] = bits(solver, lights[k]); });
      for (std::thread& thread : threads) thread.join();
      for (std::size_t k = 0; k < lights.size(); ++k)
        EXPECT_TRUE(at_once[k] == serial[k]) << to_string(guarantee) << " " << to_string(named) << ", light " << k;
      // And from work that is itself parallel.
      parallel_for(lights.size(), [&](std::size_t k) { at_once[k] = bits(solver, lights[k]); });
      EXPECT_TRUE(at_once == serial) << to_string(guarantee) << " " << to_string(named);
    }
  }
}

}  // namespace
}  // namespace hottel::radiosity_solver_test
