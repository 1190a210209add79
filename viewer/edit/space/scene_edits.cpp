#include "viewer/edit/space/scene_edits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/name.h"
#include "geometry/patch_bases.h"
#include "geometry/space/scene/patch_seats.h"
#include "geometry/space/scene/patches.h"
#include "geometry/space/scene/validation.h"
#include "kernel/exact_double.h"
#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "viewer/edit/decimals.h"
#include "viewer/edit/free_names.h"

namespace hottel {
namespace {

using Place = std::function<Point3(const Point3&)>;

bool is_less(const Point3& a, const Point3& b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }

Point3 moved(const Point3& p, const Vector3& way) { return {p.x + way.x, p.y + way.y, p.z + way.z}; }

// The scene to be changed.
Scene3 begin_edit_of_polygons(const Scene3& scene) {
  Scene3 edited = scene;
  edited.expect.clear();
  return edited;
}

// Every corner goes where `place` says.
void place_corners(Polygon3& polygon, const Place& place) {
  for (Point3& p : polygon.points) p = place(p);
  for (auto& hole : polygon.holes)
    for (Point3& p : hole) p = place(p);
  for (auto& facet : polygon.facets)
    for (Point3& p : facet) p = place(p);
}

// Some surfaces and the patches on them, ascending.
std::vector<std::uint32_t> with_patches(const Scene3& scene, std::span<const std::uint32_t> surfaces) {
  std::vector<std::uint32_t> all(surfaces.begin(), surfaces.end());
  for (const std::uint32_t s : all) HOTTEL_REQUIRE(s < scene.surfaces.size());
  if (!PatchBases(scene).is_empty()) {
    const std::vector<std::uint32_t> patches = patches_on(scene, all);
    all.insert(all.end(), patches.begin(), patches.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

// Which surfaces move as a whole, and which of their corners the others have to move.
class MovedCorners {
 public:
  MovedCorners(const Scene3& scene, const Corners3& corners) : points_(corners.points) {
    std::sort(points_.begin(), points_.end(), is_less);
    std::vector<std::uint32_t> whole = corners.surfaces;
    for (std::uint32_t s = 0; s < scene.polygons.size(); ++s)
      if (std::ranges::all_of(corners_of(scene.polygons[s]), [&](const Point3& p) { return is_point(p); }))
        whole.push_back(s);
    is_whole_.resize(scene.polygons.size());
    for (const std::uint32_t s : with_patches(scene, whole)) is_whole_[s] = true;
  }

  bool is_whole(std::uint32_t surface) const { return is_whole_[surface]; }
  bool is_point(const Point3& p) const { return std::binary_search(points_.begin(), points_.end(), p, is_less); }

 private:
  std::vector<Point3> points_;
  std::vector<bool> is_whole_;
};

bool are_on_a_line(const std::vector<Point3>& points) {
  for (std::size_t k = 2; k < points.size(); ++k)
    if (!cross(points[1] - points[0], points[k] - points[0]).is_zero()) return false;
  return true;
}

// Whether a plane polygon stays plane when some of its corners move anyhow, all alike.
bool stays_plane(const std::vector<Point3>& moving, const std::vector<Point3>& standing) {
  if (!are_on_a_line(moving) || !are_on_a_line(standing)) return false;
  return moving.size() == 1 || standing.size() == 1 ||
         cross(moving[1] - moving[0], standing[1] - standing[0]).is_zero();
}

// Groups by their first surfaces, without those that have none.
void settle_groups(Scene3& scene) {
  std::vector<std::optional<std::uint32_t>> place(scene.groups.size());
  std::vector<Group> groups;
  for (Surface& surface : scene.surfaces) {
    auto& at = place[surface.group];
    if (!at) {
      at = static_cast<std::uint32_t>(groups.size());
      groups.push_back(scene.groups[surface.group]);
    }
    surface.group = *at;
  }
  scene.groups = std::move(groups);
}

Scene3 end_edit_of_polygons(Scene3 scene) {
  settle_bands(scene);
  settle_groups(scene);
  settle_bases(scene);
  return scene;
}

std::array<Rational, 2> exact_turn(const Rational& degrees) {
  constexpr double kSteps = 1 << 24;  // of the tangent of half the angle
  const double half = to_double(degrees) * std::numbers::pi / 360;
  const Rational t = Rational(exact_value(std::round(same_bits::tan(half) * kSteps))) / exact_value(kSteps);
  return {(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
}

// A turn about an axis: quarters exactly, the rest by an exact turn.
class Turn3 {
 public:
  Turn3(const Point3& centre, int axis, const Rational& degrees) : centre_(centre), axis_(axis) {
    Integer quarters;
    const Rational turns = degrees / 90;
    mpz_fdiv_q(quarters.get_mpz_t(), turns.get_num_mpz_t(), turns.get_den_mpz_t());
    const Rational rest = degrees - 90 * Rational(quarters);
    is_square_ = rest == 0;
    std::array<Rational, 2> turn{1, 0};
    if (!is_square_) turn = exact_turn(rest);
    for (unsigned long k = mpz_fdiv_ui(quarters.get_mpz_t(), 4); k > 0; --k) turn = {Rational(-turn[1]), turn[0]};
    cosine_ = turn[0];
    sine_ = turn[1];
  }

  bool is_square() const { return is_square_; }
  Point3 operator()(const Point3& p) const {
    const Vector3 v = p - centre_;
    const auto& c = cosine_;
    const auto& s = sine_;
    const Vector3 w = axis_ == 0   ? Vector3{v.x, c * v.y - s * v.z, s * v.y + c * v.z}
                      : axis_ == 1 ? Vector3{c * v.x + s * v.z, v.y, c * v.z - s * v.x}
                                   : Vector3{c * v.x - s * v.y, s * v.x + c * v.y, v.z};
    return moved(centre_, w);
  }

 private:
  Point3 centre_;
  int axis_;
  bool is_square_ = true;
  Rational cosine_, sine_;
};

bool is_polygon(const Polygon3& polygon) { return polygon_problem(polygon).text.empty(); }

// Adds surfaces to a scene.
class Adder3 {
 public:
  explicit Adder3(const Scene3& scene)
      : first_(static_cast<std::uint32_t>(scene.surfaces.size())), edited_(begin_edit_of_polygons(scene)) {}

  Scene3& scene() { return edited_; }
  // What is added from now on is of this group.
  void begin_group(Group group) { edited_.groups.push_back(std::move(group)); }
  std::uint32_t add(Surface surface, Polygon3 polygon) {
    surface.group = static_cast<std::uint32_t>(edited_.groups.size() - 1);
    edited_.add(std::move(surface), std::move(polygon));
    return static_cast<std::uint32_t>(edited_.surfaces.size() - 1);
  }
  void lay_on(std::uint32_t patch, PatchBase base) {
    edited_.surfaces[patch].on = static_cast<std::uint32_t>(edited_.bases.size());
    edited_.bases.push_back(std::move(base));
  }
  AddedSurfaces3 result() && {
    settle_two_sided(edited_);
    AddedSurfaces3 result{end_edit_of_polygons(std::move(edited_)), {}};
    for (std::uint32_t s = first_; s < result.scene.surfaces.size(); ++s) result.surfaces.push_back(s);
    return result;
  }

 private:
  std::uint32_t first_;
  Scene3 edited_;
};

// "box copy[3]" of "box[3]", where "box" became "box copy"; else a free name of its own.
std::string name_of_copy(const std::string& name, const std::string& group, const std::string& copy, FreeNames& names) {
  return name.starts_with(group + "[") ? copy + name.substr(group.size()) : names.copy_of(name);
}

// The names of surfaces and groups that were copied, and those of their copies.
using CopiedNames = std::vector<std::pair<std::string, std::string>>;

const std::string* copy_called(const CopiedNames& names, const std::string& name) {
  const auto found = std::ranges::find(names, name, &CopiedNames::value_type::first);
  return found == names.end() ? nullptr : &found->second;
}

// Its second corner shares one more coordinate with the first: the next one after what both have in common.
Polygon3 rectangle_between(const Point3& corner, const Point3& opposite) {
  Point3 second = corner, fourth = opposite;
  const auto share = [&](Rational Point3::*axis) {
    second.*axis = opposite.*axis;
    fourth.*axis = corner.*axis;
  };
  share(corner.x == opposite.x ? &Point3::y : corner.y == opposite.y ? &Point3::z : &Point3::x);
  Polygon3 polygon;
  polygon.points = {corner, second, opposite, fourth};
  return polygon;
}

// The face that a rectangle lies within, and that looks as it does.
std::optional<Face> base_of(const Scene3& scene, const Polygon3& rectangle) {
  const Vector3 normal = doubled_area(rectangle);
  for (std::uint32_t s = 0; s < scene.polygons.size(); ++s) {
    const Polygon3& polygon = scene.polygons[s];
    if (polygon.is_nearly_plane || scene.surfaces[s].is_obstruction) continue;
    const Vector3 its = doubled_area(polygon);
    const bool is_under = cross(its, normal).is_zero() &&
                          std::ranges::all_of(rectangle.points, [&](const Point3& p) { return contains(polygon, p); });
    if (is_under && is_convex(polygon)) return Face{s, dot(its, normal) < 0};
  }
  return std::nullopt;
}

}  // namespace

Scene3 move_corners(const Scene3& scene, const Corners3& corners, const Vector3& way) {
  const MovedCorners moves(scene, corners);
  Scene3 edited = begin_edit_of_polygons(scene);
  for (std::uint32_t s = 0; s < edited.polygons.size(); ++s)
    place_corners(edited.polygons[s],
                  [&](const Point3& p) { return moves.is_whole(s) || moves.is_point(p) ? moved(p, way) : p; });
  return end_edit_of_polygons(std::move(edited));
}

Scene3 move_corner(const Scene3& scene, std::uint32_t surface, const Point3& corner, const Vector3& way) {
  HOTTEL_REQUIRE(surface < scene.polygons.size());
  Scene3 edited = begin_edit_of_polygons(scene);
  place_corners(edited.polygons[surface], [&](const Point3& p) { return p == corner ? moved(p, way) : p; });
  return end_edit_of_polygons(std::move(edited));
}

std::vector<Vector3> planes_to_keep(const Scene3& scene, const Corners3& corners) {
  const MovedCorners moves(scene, corners);
  const PatchBases patches(scene);
  std::vector<Vector3> normals;
  for (std::uint32_t s = 0; s < scene.polygons.size(); ++s) {
    std::vector<Point3> moving, standing;
    for (const Point3& p : corners_of(scene.polygons[s]))
      (moves.is_whole(s) || moves.is_point(p) ? moving : standing).push_back(p);
    if (moving.empty()) continue;
    const bool slides = patches.is_patch(s) && !std::ranges::any_of(patches.under(s), [&](std::uint32_t base) {
                          return moves.is_whole(base);
                        });
    if (slides || (!standing.empty() && !stays_plane(moving, standing)))
      normals.push_back(doubled_area(scene.polygons[s]));
  }
  return normals;
}

Scene3 rotate_surfaces(const Scene3& scene, std::span<const std::uint32_t> surfaces, const Point3& centre, int axis,
                       const Rational& degrees, int decimals) {
  const std::vector<std::uint32_t> turned = with_patches(scene, surfaces);
  const Turn3 turn(centre, axis, degrees);
  const auto rounded = [&](const Point3& p) {
    const Point3 q = turn(p);
    return Point3{rounded_decimal(q.x, decimals), rounded_decimal(q.y, decimals), rounded_decimal(q.z, decimals)};
  };
  Scene3 edited = begin_edit_of_polygons(scene);
  for (const bool rounds : {true, false}) {
    if (rounds && turn.is_square()) continue;
    for (const std::uint32_t s : turned) {
      edited.polygons[s] = scene.polygons[s];
      place_corners(edited.polygons[s], rounds ? Place(rounded) : Place(turn));
    }
    if (rounds && std::ranges::all_of(turned, [&](std::uint32_t s) { return is_polygon(edited.polygons[s]); })) break;
  }
  return end_edit_of_polygons(std::move(edited));
}

Scene3 reverse_surfaces(const Scene3& scene, std::span<const std::uint32_t> surfaces) {
  Scene3 edited = begin_edit_of_polygons(scene);
  for (const std::uint32_t s : surfaces) {
    HOTTEL_REQUIRE(s < scene.surfaces.size());
    Polygon3& polygon = edited.polygons[s];
    std::reverse(polygon.points.begin() + 1, polygon.points.end());
    for (auto& facet : polygon.facets) std::swap(facet[1], facet[2]);
  }
  return end_edit_of_polygons(std::move(edited));
}

Scene3 erase_surfaces(const Scene3& scene, std::span<const std::uint32_t> surfaces) {
  const std::vector<std::uint32_t> erased = with_patches(scene, surfaces);
  Scene3 edited = begin_edit_of_polygons(scene);
  edited.surfaces.clear();
  edited.polygons.clear();
  edited.masks.clear();
  std::vector<std::optional<std::uint32_t>> place(scene.surfaces.size());
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    if (std::binary_search(erased.begin(), erased.end(), s)) continue;
    place[s] = static_cast<std::uint32_t>(edited.surfaces.size());
    edited.add(scene.surfaces[s], scene.polygons[s]);
  }
  for (const Mask3& mask : scene.masks)
    if (place[mask.surface] && place[mask.base]) edited.masks.push_back({*place[mask.surface], *place[mask.base]});
  return end_edit_of_polygons(std::move(edited));
}

AddedSurfaces3 duplicate_surfaces(const Scene3& scene, std::span<const std::uint32_t> surfaces, const Vector3& way) {
  const std::vector<std::uint32_t> copied = with_patches(scene, surfaces);
  std::vector<std::size_t> wanted(scene.groups.size());
  for (const std::uint32_t s : copied) ++wanted[scene.surfaces[s].group];
  const std::vector<std::size_t> sizes = group_sizes(scene);
  Adder3 adder(scene);
  FreeNames names(scene);
  CopiedNames called;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> patches;
  const auto copy = [&](std::uint32_t s, std::string name) {
    Surface surface = scene.surfaces[s];
    surface.line = 0;
    surface.in_mesh = {};
    surface.name = name;
    Polygon3 polygon = scene.polygons[s];
    place_corners(polygon, [&](const Point3& p) { return moved(p, way); });
    const std::uint32_t at = adder.add(std::move(surface), std::move(polygon));
    called.emplace_back(scene.surfaces[s].name, std::move(name));
    if (scene.surfaces[s].on) patches.emplace_back(s, at);
  };
  std::vector<bool> is_done(scene.groups.size());
  for (const std::uint32_t s : copied) {
    const std::uint32_t group = scene.surfaces[s].group;
    const Group& its = scene.groups[group];
    if (is_done[group]) continue;
    const bool is_whole = wanted[group] == sizes[group] && its.name != scene.surfaces[s].name;
    if (!is_whole) {
      const std::string name = names.copy_of(scene.surfaces[s].name);
      adder.begin_group({name, Behind::kByOutline});
      copy(s, name);
      continue;
    }
    is_done[group] = true;
    const std::string name = names.copy_of(its.name);
    adder.begin_group({name, its.behind});
    for (const std::uint32_t t : copied)
      if (scene.surfaces[t].group == group) copy(t, name_of_copy(scene.surfaces[t].name, its.name, name, names));
    called.emplace_back(its.name, name);
  }
  for (const auto& [patch, at] : patches) {
    const PatchBase& base = scene.bases[*scene.surfaces[patch].on];
    if (const std::string* name = copy_called(called, base.name)) adder.lay_on(at, {*name, base.is_back});
  }
  return std::move(adder).result();
}

AddedSurfaces3 add_box(const Scene3& scene, const Point3& low, const Point3& high, std::uint32_t material) {
  HOTTEL_REQUIRE(low.x < high.x && low.y < high.y && low.z < high.z && material < scene.materials.size());
  const std::string name = FreeNames(scene).numbered("box");
  const auto at = [&](int x, int y, int z) {
    return Point3{x != 0 ? high.x : low.x, y != 0 ? high.y : low.y, z != 0 ? high.z : low.z};
  };
  Adder3 adder(scene);
  adder.begin_group(name);
  const auto add = [&](const char* side, std::vector<Point3> points) {
    adder.add(Surface{.name = name + side, .material = material, .back = {}}, {std::move(points)});
  };
  add(".bottom", {at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)});
  add(".top", {at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
  add(".front", {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)});
  add(".rear", {at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 1)});
  add(".left", {at(0, 1, 0), at(0, 0, 0), at(0, 0, 1), at(0, 1, 1)});
  add(".right", {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)});
  return std::move(adder).result();
}

AddedSurfaces3 add_rectangle(const Scene3& scene, const Point3& corner, const Point3& opposite, bool looks_back,
                             std::uint32_t material) {
  HOTTEL_REQUIRE(material < scene.materials.size());
  const int common =
      (corner.x == opposite.x ? 1 : 0) + (corner.y == opposite.y ? 1 : 0) + (corner.z == opposite.z ? 1 : 0);
  HOTTEL_REQUIRE(common == 1);
  Polygon3 polygon = rectangle_between(corner, opposite);
  const Vector3 area = doubled_area(polygon);
  if ((area.x + area.y + area.z < 0) != looks_back) std::reverse(polygon.points.begin() + 1, polygon.points.end());
  const std::string name = FreeNames(scene).numbered("rectangle");
  const std::optional<Face> base = base_of(scene, polygon);
  Adder3 adder(scene);
  adder.begin_group(name);
  const std::uint32_t at = adder.add(Surface{.name = name, .material = material, .back = {}}, std::move(polygon));
  if (base) adder.lay_on(at, {scene.surfaces[base->surface].name, base->is_back});
  return std::move(adder).result();
}

std::string edit_problem(const Scene3& before, const Scene3& edited) {
  for (std::uint32_t s = 0; s < edited.polygons.size(); ++s) {
    if (s < before.polygons.size() && before.polygons[s] == edited.polygons[s]) continue;
    if (const auto& [problem, hint] = polygon_problem(edited.polygons[s]); !problem.empty())
      return quoted_name(edited.surfaces[s].name) + " " + problem;
  }
  try {
    validate_but_polygons(edited);
    validate_patches(edited);
  } catch (const InputError& error) {
    return std::string(error.what()).substr(error.where().text().size() + 2);
  }
  return "";
}

}  // namespace hottel
