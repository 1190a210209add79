#include "tests/solver/plane/exact_radiosity.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "geometry/plane/exchange/closed_forms.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/generate/generators.h"
#include "io/scene/scene_json.h"

namespace hottel::testing_radiosity {

mpf_class number(const Rational& q) { return mpf_class(q, kBits); }

mpf_class number(const RootSum& sum) {
  mpf_class result(0, kBits);
  for (const RootSum::Term& term : sum.terms())
    result += number(term.coefficient) * sqrt(mpf_class(term.radicand, kBits));
  return result;
}

std::vector<std::vector<mpf_class>> solve_dense(std::vector<std::vector<mpf_class>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || rows[i][k] == 0) continue;
      const mpf_class factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j < rows[i].size(); ++j) rows[i][j] -= factor * rows[k][j];
    }
  for (std::size_t i = 0; i < n; ++i) {
    const mpf_class pivot = rows[i][i];
    rows[i].erase(rows[i].begin(), rows[i].begin() + static_cast<std::ptrdiff_t>(n));
    for (mpf_class& value : rows[i]) value /= pivot;
  }
  return rows;
}

ExactScene::ExactScene(Scene2 scene, Divided2 divided) : prepared_(prepare(std::move(scene), divided)) {
  const Granularity granularity = divided == Divided2::kYes ? Granularity::kElement : Granularity::kFace;
  matrix_ = exact_exchange(prepared_, {granularity});
  std::vector<ElementPair> pairs;
  for (std::uint32_t i = 0; i < matrix_.size(); ++i)
    for (const FactorEntry& entry : matrix_.row(i))
      if (i <= entry.to || !matrix_.has_row(entry.to)) pairs.emplace_back(std::min(i, entry.to), std::max(i, entry.to));
  const std::vector<RootSum> measures = exact_exchange_measures(prepared_, granularity, pairs);
  for (const RootSum& area : exact_areas(prepared_, granularity)) areas_.push_back(number(area));
  factors_.assign(matrix_.size(), std::vector<mpf_class>(matrix_.size() + 1, mpf_class(0, kBits)));
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [i, j] = pairs[k];
    const mpf_class measure = number(measures[k]);
    if (matrix_.has_row(i)) factors_[i][j] = measure / areas_[i];
    if (j < matrix_.size() && matrix_.has_row(j)) factors_[j][i] = measure / areas_[j];
  }
}

std::vector<mpf_class> radiosity_of(const ExchangeMatrix& matrix, const WideFactors& factors,
                                    const std::vector<Material>& materials, const Spectrum& sky, int channel) {
  const std::size_t n = matrix.size();
  std::vector<std::vector<mpf_class>> a(n, std::vector<mpf_class>(n + 1, mpf_class(0, kBits)));
  for (std::uint32_t i = 0; i < n; ++i) {
    if (matrix.has_row(i)) {
      const Material& material = materials[*matrix.elements()[i].material];
      const mpf_class rho = number(material.reflectivity.value[channel]);
      for (std::size_t j = 0; j < n; ++j) a[i][j] = -rho * factors[i][j];
      a[i][n] = number(material.emission.value[channel]) + rho * factors[i][n] * number(sky.value[channel]);
    }
    a[i][i] += 1;
  }
  std::vector<mpf_class> result;
  for (const auto& row : solve_dense(std::move(a))) result.push_back(row.front());
  return result;
}

void BoundsCheck::add(const ExactScene& scene, const RadiositySolution& solution,
                      const std::vector<Material>& materials) {
  for (std::size_t channel = 0; channel < solution.channels.size(); ++channel) {
    const auto exact = scene.radiosity(materials, scene.scene().sky_emission, static_cast<int>(channel));
    for (std::uint32_t i = 0; i < scene.matrix().size(); ++i) {
      if (!scene.matrix().has_row(i)) continue;
      const ElementRadiosity& e = solution.channels[channel].elements[i];
      ++checked;
      const mpf_class slack = abs(exact[i]) * 1e-75;  // what the reference itself may be off by
      const bool holds = mpf_class(e.lower, kBits) <= exact[i] + slack &&
                         (std::isinf(e.upper) || mpf_class(e.upper, kBits) >= exact[i] - slack) &&
                         e.lower <= e.radiosity && e.radiosity <= e.upper;
      if (!holds) {
        ++misses;
        if (first_miss.empty())
          first_miss = fmt::format("{} {}: {} [{}, {}], exact {}", scene.scene().about,
                                   scene.matrix().elements()[i].name, e.radiosity, e.lower, e.upper, exact[i].get_d());
      }
      if (e.radiosity > 0 && e.upper > e.lower) {
        narrowest = std::min(narrowest, (e.upper - e.lower) / e.radiosity);
        widest = std::max(widest, (e.upper - e.lower) / e.radiosity);
      }
    }
  }
}

Scene2 scene_of(const std::string& text) { return parse_scene_2(text, "text"); }

Scene2 analytic_scene(const std::string& stem) {
  return read_scene_2(std::filesystem::path(HOTTEL_SOURCE_DIR) / "scenes" / "analytic" / (stem + ".json"));
}

Scene2 convex_polygon(int n) {
  Scene2 scene;
  scene.about = fmt::format("convex {}-gon", n);
  scene.materials = {{"lamp", {}, Spectrum::scalar(1)}, {"wall", {}, {}}};
  scene.groups = {"polygon"};
  const auto corner = [&](int k) {
    const double angle = -2 * 3.14159265358979 * k / n;
    return Point2{Rational(std::lround(1e6 * std::cos(angle))), Rational(std::lround(1e6 * std::sin(angle)))};
  };
  for (int k = 0; k < n; ++k) {
    Surface surface;
    surface.name = fmt::format("side[{}]", k);
    surface.material = k == 0 ? 0 : 1;
    scene.add(surface, {corner(k), corner((k + 1) % n)});
  }
  return scene;
}

Scene2 random_scene(std::uint64_t seed) {
  const auto& kinds = generator_kinds_2();
  const GeneratorKind2& kind = kinds[seed % kinds.size()];
  GeneratorRequest2 request;
  request.kind = kind.name;
  request.seed = seed;
  request.n = std::max<std::uint64_t>(kind.min_edges, 12 + 7 * seed % 19);
  Scene2 scene = generate_2(request);
  scene.about = fmt::format("{} {}", kind.name, seed);
  const Rational near_one = 1 - Rational(1, Integer(1) << (seed % 50));
  const Rational reflectivities[] = {Rational(1, 2), near_one, Rational(9, 10),  0,
                                     Rational(2, 3), 1,        Rational(1, 1000)};
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    Material& material = scene.materials[m];
    material.reflectivity = Spectrum::scalar(reflectivities[(seed + 3 * m) % 7]);
    if (m + 1 == scene.materials.size()) material.emission = Spectrum::scalar(Rational(1 + seed % 9, 7));
  }
  if (kind.name == "lattice") {  // overlaps: one material, or claims conflict
    scene.materials[0].reflectivity =
        Spectrum::scalar(seed % 2 == 0 ? Rational(2, 3) : Rational(near_one / 2 + Rational(1, 2)));
  } else {  // one face that takes light, so that there is a solution whatever the others do
    scene.materials.push_back({"taker", Spectrum::scalar(Rational(1, 4)), Spectrum::scalar(Rational(seed % 3))});
    scene.surfaces[seed % scene.surfaces.size()].material = static_cast<std::uint32_t>(scene.materials.size() - 1);
  }
  scene.sky_emission = Spectrum::scalar(Rational(seed % 4, 3));
  if (seed % 5 == 0)
    for (Surface& surface : scene.surfaces) surface.elements = 1 + seed % 2;
  return scene;
}

}  // namespace hottel::testing_radiosity
