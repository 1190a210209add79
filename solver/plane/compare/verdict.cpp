#include "solver/plane/compare/verdict.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/exchange/pair_alone.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "solver/compare/judged_scene.h"
#include "solver/compare/pairwise_methods.h"
#include "solver/methods/gauss_rule.h"
#include "solver/methods/vertex_variant.h"
#include "solver/plane/methods/cosine_kernel.h"
#include "solver/plane/methods/element_geometry.h"
#include "solver/plane/methods/method_catalogue.h"

namespace hottel {
namespace {

class JudgedScene2 final : public JudgedScene {
 public:
  explicit JudgedScene2(const PreparedScene2& prepared) : prepared_(prepared) {}

  const std::string& surface_name(std::uint32_t surface) const override {
    return prepared_.scene.surfaces[surface].name;
  }

  double unobstructed_factor(std::uint32_t from, std::uint32_t to) const override { return alone_.factor(from, to); }

  const std::vector<PointRule>& point_rules() const override {
    static const std::vector rules{PointRule::kCenter, PointRule::kVertices, PointRule::kGauss2, PointRule::kGauss4};
    return rules;
  }
  double factor_by(PointRule rule, std::uint32_t from, std::uint32_t to) const override {
    double measure = 0;
    for (const ElementRun2& a : geometry_.runs(from))
      for (const ElementRun2& b : geometry_.runs(to)) measure += a.length * b.length * mean_kernel(rule, a, b);
    return measure / geometry_.length(from);
  }

  std::optional<PairPlace> place_of(std::uint32_t from, std::uint32_t to) const override {
    if (geometry_.runs(from).empty() || geometry_.runs(to).empty()) return std::nullopt;
    const ElementRun2 &a = geometry_.runs(from).front(), &b = geometry_.runs(to).front();
    return pair_place(b.centre - a.centre, a.normal(), b.normal());
  }

  std::vector<PairwiseMethod> pairwise_methods() const override {
    std::vector<PairwiseMethod> methods = pairwise_methods_of(methods_2(), prepared_);
    methods.push_back({"center-vis",
                       [this](std::uint32_t from, std::uint32_t to) { return factor_by(PointRule::kCenter, from, to); },
                       true});
    const double constant = 1 / to_double(geometry_.unit() * geometry_.unit());
    if (std::isnormal(constant))
      methods.push_back({"center-vis:inverse-square=1",
                         [this, constant](std::uint32_t from, std::uint32_t to) {
                           double factor = 0;
                           for (const ElementRun2& a : geometry_.runs(from))
                             for (const ElementRun2& b : geometry_.runs(to)) factor += a.share * inverse_square(a, b);
                           return constant * factor;
                         },
                         true});
    return methods;
  }

  ExchangeMatrix uniform_factors(std::uint32_t rays) const override {
    return uniform_factors_of(methods_2(), prepared_, rays);
  }

  bool reaches_behind(std::uint32_t from, std::uint32_t to) const override {
    for (const ElementRun2& a : geometry_.runs(from))
      for (const ElementRun2& b : geometry_.runs(to))
        if (const auto [least, most] = std::minmax({dot(a.normal(), b.from - a.from), dot(a.normal(), b.to - a.from)});
            is_behind_in_part(least, most, std::min(a.length, b.length)))
          return true;
    return false;
  }

  std::optional<ExchangeMatrix> factors_of_both_sides() const override {
    Scene2 scene = prepared_.scene;
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
      Surface& surface = scene.surfaces[s];
      if (!surface.back) surface.back = surface.material;
      if (prepared_.division[s].is_cut()) continue;
      surface.elements = 1;
      surface.trees = {};
    }
    try {
      const PreparedScene2 both = prepare(std::move(scene), Divided2::kYes);
      return exact_exchange(both, {.granularity = Granularity::kElement, .wants_visibility = false});
    } catch (const InputError&) {
      return std::nullopt;
    }
  }

 private:
  double mean_kernel(PointRule rule, const ElementRun2& a, const ElementRun2& b) const {
    if (rule == PointRule::kCenter) return between_centres(a, b);
    if (rule == PointRule::kVertices) return mean_over_ends(a, b, kNearestVertices * geometry_.diagonal() / 2);
    const GaussRule& points = rule == PointRule::kGauss2 ? two_points_ : four_points_;
    double mean = 0;
    for (std::size_t k = 0; k < points.place.size(); ++k)
      for (std::size_t l = 0; l < points.place.size(); ++l)
        mean += points.weight[k] * points.weight[l] *
                cosine_kernel(a.at(points.place[k]), a.normal(), b.at(points.place[l]), b.normal());
    return mean;
  }

  const PreparedScene2& prepared_;
  PairsAlone2 alone_{prepared_, *prepared_.elements(Granularity::kElement), Granularity::kElement};
  ElementGeometry2 geometry_{prepared_};
  GaussRule two_points_ = gauss_rule(2), four_points_ = gauss_rule(4);
};

}  // namespace

Verdict judge(const PreparedScene2& prepared, const ExchangeMatrix& exact, const ExchangeMatrix& matrix,
              const VerdictOptions& options, const VerdictWatch& watch) {
  return judge(JudgedScene2(prepared), exact, matrix, options, watch);
}

}  // namespace hottel
