#include "solver/space/compare/verdict.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/facing.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/unobstructed/unobstructed.h"
#include "kernel/support/failure.h"
#include "solver/compare/judged_scene.h"
#include "solver/compare/pairwise_methods.h"
#include "solver/methods/gauss_rule.h"
#include "solver/methods/vertex_variant.h"
#include "solver/space/methods/cosine_kernel.h"
#include "solver/space/methods/element_geometry.h"
#include "solver/space/methods/method_catalogue.h"
#include "solver/space/methods/patch_rule.h"
#include "solver/space/methods/segment_visibility.h"

namespace hottel {
namespace {

constexpr double kTolerance = 1e-9;

class JudgedScene3 final : public JudgedScene {
 public:
  explicit JudgedScene3(const PreparedScene3& prepared) : prepared_(prepared) {}

  const std::string& surface_name(std::uint32_t surface) const override {
    return prepared_.scene.surfaces[surface].name;
  }

  double unobstructed_factor(std::uint32_t from, std::uint32_t to) const override {
    const Occluders3& occluders = prepared_.occluders();
    const ElementTable3& table = geometry_.table();
    double measure = 0;
    for (const ElementTable3::Part& a : table.parts(from))
      for (const ElementTable3::Part& b : table.free_parts(to))
        if (face_each_other(occluders, a, b))
          measure += unobstructed_measure(occluders.vertices(), a.patch, b.patch, kTolerance).measure;
    return measure / table.extent(from).value;
  }

  const std::vector<PointRule>& point_rules() const override {
    static const std::vector rules{PointRule::kCenter, PointRule::kDisk, PointRule::kVertices, PointRule::kGauss2,
                                   PointRule::kGauss4};
    return rules;
  }
  double factor_by(PointRule rule, std::uint32_t from, std::uint32_t to) const override {
    double factor = 0;
    for (const ElementPatch3& a : geometry_.patches(from))
      for (const ElementPatch3& b : geometry_.patches(to))
        if (a.piece != b.piece) factor += a.share * factor_of_patches(rule, a, b);
    return factor;
  }

  std::optional<PairPlace> place_of(std::uint32_t from, std::uint32_t to) const override {
    if (geometry_.patches(from).empty() || geometry_.patches(to).empty()) return std::nullopt;
    const ElementPatch3 &a = geometry_.patches(from).front(), &b = geometry_.patches(to).front();
    return pair_place(b.centre - a.centre, a.normal, b.normal);
  }

  std::vector<PairwiseMethod> pairwise_methods() const override {
    std::vector<PairwiseMethod> methods = pairwise_methods_of(methods_3(), prepared_);
    methods.push_back({"center-vis",
                       [this](std::uint32_t from, std::uint32_t to) { return factor_by(PointRule::kCenter, from, to); },
                       true});
    return methods;
  }

  ExchangeMatrix uniform_factors(std::uint32_t rays) const override {
    return uniform_factors_of(methods_3(), prepared_, rays);
  }

  bool reaches_behind(std::uint32_t from, std::uint32_t to) const override {
    for (const ElementPatch3& a : geometry_.patches(from))
      for (const ElementPatch3& b : geometry_.patches(to)) {
        const auto before = [&](const Vector3d& corner) { return dot(a.normal, corner - a.corners.front()); };
        const auto [least, most] = std::ranges::minmax(b.corners, {}, before);
        if (is_behind_in_part(before(least), before(most), std::sqrt(std::min(a.area, b.area)))) return true;
      }
    return false;
  }

  std::optional<ExchangeMatrix> factors_of_both_sides() const override {
    Scene3 scene = prepared_.scene;
    for (Surface& surface : scene.surfaces)
      if (!surface.back) surface.back = surface.material;
    try {
      return exact_exchange(prepare(std::move(scene)),
                            {.granularity = Granularity::kElement, .wants_visibility = false});
    } catch (const InputError&) {
      return std::nullopt;
    } catch (const RequestError&) {
      return std::nullopt;
    }
  }

 private:
  double factor_of_patches(PointRule rule, const ElementPatch3& a, const ElementPatch3& b) const {
    switch (rule) {
      case PointRule::kDisk:
        return factor_of_disk(a, b);
      case PointRule::kVertices:
        return b.area * mean_over_corners(a, b, nearest_vertices_);
      case PointRule::kGauss2:
      case PointRule::kGauss4: {
        const auto& points = rule == PointRule::kGauss2 ? two_points_ : four_points_;
        double mean = 0;
        for (const RulePoint3& x : points[geometry_.number_of(a)])
          for (const RulePoint3& y : points[geometry_.number_of(b)])
            mean += x.weight * y.weight * cosine_kernel(x.at, a.normal, y.at, b.normal);
        return b.area * mean;
      }
      case PointRule::kCenter:
        break;
    }
    return b.area * between_centres(a, b);
  }
  std::vector<std::vector<RulePoint3>> points_of_patches(int n) const {
    const GaussRule rule = gauss_rule(n);
    std::vector<std::vector<RulePoint3>> points;
    for (const ElementPatch3& patch : geometry_.all_patches()) points.push_back(rule_points(patch, rule));
    return points;
  }

  const PreparedScene3& prepared_;
  ElementGeometry3 geometry_{prepared_};
  // By patch.
  std::vector<std::vector<RulePoint3>> two_points_ = points_of_patches(2), four_points_ = points_of_patches(4);
  double nearest_vertices_ = kNearestVertices * SegmentVisibility3(prepared_.occluders()).diagonal() / 2;
};

}  // namespace

Verdict judge(const PreparedScene3& prepared, const ExchangeMatrix& exact, const ExchangeMatrix& matrix,
              const VerdictOptions& options, const VerdictWatch& watch) {
  return judge(JudgedScene3(prepared), exact, matrix, options, watch);
}

}  // namespace hottel
