#include "solver/space/light/refinement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/division.h"
#include "geometry/space/visibility/exact_visibility_map.h"
#include "kernel/plain_functions.h"
#include "kernel/support/parallel.h"
#include "solver/space/light/scene_light_shares.h"

namespace hottel {
namespace {

// A round cone of directions that holds others.
struct Circle {
  Direction3 middle;
  double radius = 4;  // above pi: all directions

  template <class Corners>
  static Circle around(const Corners& directions) {
    Direction3 sum;
    for (const Direction3& direction : directions) sum = sum + direction;
    if (!(length(sum) > 1e-3)) return {};
    Circle circle{unit(sum), 0};
    for (const Direction3& direction : directions)
      circle.radius = std::max(circle.radius, same_bits::acos(std::clamp(dot(circle.middle, direction), -1.0, 1.0)));
    // Within less than half a turn around, a circle that holds the corners holds what is between them.
    return circle.radius < 1.5 ? circle : Circle{};
  }
  bool may_meet(const Circle& other) const {
    constexpr double kRounding = 1e-7;  // of directions, and of acos
    const double apart = same_bits::acos(std::clamp(dot(middle, other.middle), -1.0, 1.0));
    return apart <= radius + other.radius + kRounding;
  }
};

// What a light reaches of patches.
class LitPatches3 {
 public:
  LitPatches3(const PreparedScene3& prepared, const Light& light, const LightPlace3& place)
      : map_(exact_visibility_map_of(prepared, light, place)),
        beam_(beam_of(light, place)),
        is_in_solid_(!light.is_sun() && prepared.arrangement().solids().around(place.position).has_value()) {
    for (std::size_t f = 0; f < map_.size(); ++f) {
      const VisibilityMap3::Fragment& fragment = map_.map().fragments[f];
      std::vector<Direction3> corners;
      for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) corners.push_back(map_.map().corners[c].direction);
      circles_.push_back(Circle::around(corners));
      meets_.push_back(beam_.meets(map_.cone(f)));
      is_seen_.insert(fragment.face.number());
    }
  }

  void add(const ElementTable3::Part& part, ReachSum& sum) const {
    const Face side{part.patch.surface, part.is_back};
    if (is_in_solid_ || !is_seen_.contains(side.number())) return sum.add(Reach::kNothing);
    const ExactCone3 cone = map_.cone_of(part.patch);
    const Circle circle = map_.sun() ? circle_of(cone) : circle_of(part.patch);
    for (std::size_t f = 0; f < map_.size() && !sum.is_part(); ++f) {
      if (!circles_[f].may_meet(circle)) continue;
      const std::optional<ExactCone3> common = common_cone(map_.cone(f), cone);
      if (!common) continue;
      const bool is_own = map_.map().fragments[f].face == side;
      sum.add(!is_own ? Reach::kNothing : lit(f, *common));
    }
  }

 private:
  static Circle circle_of(const ExactCone3& cone) {
    std::vector<Direction3> corners;
    for (const IntegerVector& corner : cone.corners) {
      const BoundedVector w = rounded(corner, bits(corner) - 53);
      corners.push_back(unit(Direction3{w.x, w.y, w.z}));
    }
    return Circle::around(corners);
  }

  Circle circle_of(const Patch3& patch) const {
    std::vector<Direction3> corners;
    for (const Point3& corner : corners_of(map_.occluders().vertices(), patch)) {
      const Vector3 way = corner - map_.eye();
      const Direction3 direction{to_double(way.x), to_double(way.y), to_double(way.z)};
      const double size = std::max({std::fabs(direction.x), std::fabs(direction.y), std::fabs(direction.z)});
      if (!(size > 1e-140 && size < 1e140)) return {};
      corners.push_back(unit(direction));
    }
    return Circle::around(corners);
  }

  Reach lit(std::size_t f, const ExactCone3& common) const {
    BeamPower3::Meets meets = meets_[f];
    if (meets == BeamPower3::Meets::kPart) meets = beam_.meets(common);
    return meets == BeamPower3::Meets::kAll    ? Reach::kAll
           : meets == BeamPower3::Meets::kPart ? Reach::kPart
                                               : Reach::kNothing;
  }

  ExactVisibilityMap3 map_;
  BeamPower3 beam_;
  bool is_in_solid_;
  std::vector<Circle> circles_;           // by fragment
  std::vector<BeamPower3::Meets> meets_;  // by fragment
  std::set<std::uint32_t> is_seen_;       // sides of pieces, by number
};

bool is_crossed(const ElementTable3& table, std::uint32_t label, const std::vector<LitPatches3>& lights) {
  return std::ranges::any_of(lights, [&](const LitPatches3& light) {
    ReachSum sum;
    for (const ElementTable3::Part& part : table.free_parts(label)) {
      light.add(part, sum);
      if (sum.is_part()) return true;
    }
    return false;
  });
}

// The leaves of a face, and which of them were made last.
struct FaceLeaves {
  std::vector<TreeNode> leaves;
  std::vector<char> is_new;

  void add(const TreeNode& leaf, bool is_its_first) {
    leaves.push_back(leaf);
    is_new.push_back(is_its_first ? 1 : 0);
  }
};

// Those at some places divided in four. A whole polygon becomes the roots of its trees.
FaceLeaves divided(const FaceLeaves& face, const std::vector<char>& is_crossed, std::uint32_t roots) {
  FaceLeaves result;
  if (face.leaves.size() == 1 && roots > 1 && is_crossed[0] != 0) {
    for (const TreeNode& root : uniform_leaves(roots, 4, 0)) result.add(root, true);
    return result;
  }
  for (std::size_t k = 0; k < face.leaves.size(); ++k) {
    const TreeNode& leaf = face.leaves[k];
    if (is_crossed[k] == 0)
      result.add(leaf, false);
    else
      for (int digit = 0; digit < 4; ++digit) result.add({leaf.part, leaf.path.child(digit)}, true);
  }
  return result;
}

// Divides what the borders of lights cross, once. Returns whether something is left that may have to be divided.
bool divide_once(const PreparedScene3& prepared, Scene3& scene, const std::vector<LitPatches3>& lights, int deepest,
                 std::vector<FaceLeaves>& faces) {
  const std::shared_ptr<const ElementTable3> its = prepared.under(scene).elements(Granularity::kElement);
  const ElementTable3& table = *its;
  std::vector<std::uint32_t> first(faces.size(), table.count());  // label of each face
  for (std::uint32_t label = table.count(); label-- > 0;) {
    const Element& element = table.elements()[label];
    first[Face{element.surface, element.is_back}.number()] = label;
  }
  std::vector<char> crossed(table.count(), 0);
  parallel_for(
      faces.size(),
      [&](std::size_t f) {
        for (std::size_t k = 0; k < faces[f].leaves.size(); ++k) {
          const auto label = first[f] + static_cast<std::uint32_t>(k);
          if (faces[f].is_new[k] != 0 && faces[f].leaves[k].path.depth() < deepest && table.has_row(label))
            crossed[label] = is_crossed(table, label, lights) ? 1 : 0;
        }
      },
      1);
  bool is_any = false;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const Face face = Face::of(f);
    const auto begin = crossed.begin() + static_cast<std::ptrdiff_t>(first[f]);
    const std::vector<char> here(begin, begin + static_cast<std::ptrdiff_t>(faces[f].leaves.size()));
    if (std::ranges::count(here, 1) == 0) {
      std::ranges::fill(faces[f].is_new, 0);
      continue;
    }
    is_any = true;
    Surface& surface = scene.surfaces[face.surface];
    faces[f] = divided(faces[f], here, root_count(scene.polygons[face.surface], surface.elements));
    (face.is_back ? surface.trees.back : surface.trees.front) = faces[f].leaves;
  }
  return is_any;
}

}  // namespace

std::vector<SurfaceTrees> refined_trees(const PreparedScene3& prepared, const RefinementLevels& levels) {
  const DefaultFloatingPoint arithmetic;
  std::vector<SurfaceTrees> trees(prepared.scene.surfaces.size());
  if (!levels.is_any()) return trees;
  Scene3 scene = prepared.scene;
  // Of polygons that are no quads or triangles the trees are under triangles: where nothing crosses them they stay
  // whole.
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    Surface& surface = scene.surfaces[s];
    surface.trees = {};
    if (levels.everywhere == 0) continue;
    const std::uint32_t roots = root_count(scene.polygons[s], surface.elements);
    for (const bool is_back : {false, true})
      if (surface.material_of(is_back))
        (is_back ? surface.trees.back : surface.trees.front) = uniform_leaves(roots, 4, levels.everywhere);
  }
  std::vector<LitPatches3> lights;
  if (levels.at_borders > levels.everywhere)
    for (std::size_t k = 0; k < scene.lights.size(); ++k)
      lights.emplace_back(prepared, scene.lights[k], scene.light_places[k]);
  if (!lights.empty()) {
    std::vector<FaceLeaves> faces(2 * scene.surfaces.size());
    const std::shared_ptr<const ElementTable3> table = prepared.under(scene).elements(Granularity::kElement);
    for (const Element& element : table->elements())
      faces[Face{element.surface, element.is_back}.number()].add(element.node(), true);
    while (divide_once(prepared, scene, lights, levels.at_borders, faces)) {
    }
  }
  for (std::size_t s = 0; s < trees.size(); ++s) trees[s] = std::move(scene.surfaces[s].trees);
  return trees;
}

}  // namespace hottel
