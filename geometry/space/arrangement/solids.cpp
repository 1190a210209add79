#include "geometry/space/arrangement/solids.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "geometry/name.h"
#include "geometry/space/arrangement/outline_sum.h"
#include "geometry/space/predicates/vertices.h"
#include "geometry/space/scene/plane_triangulation.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

using Kind = ClosedMesh3::Kind;
constexpr std::array<Rational Point3::*, 3> kAxes{&Point3::x, &Point3::y, &Point3::z};
constexpr std::array<Rational Vector3::*, 3> kWays{&Vector3::x, &Vector3::y, &Vector3::z};

// A point where the outlines of some polygons, each in its sense, do not cancel; nothing where they do.
std::optional<Point3> open_end(const Scene3& scene, const std::vector<std::uint32_t>& surfaces) {
  std::vector<Side3> sides;
  std::vector<Point3> points;
  for (const std::uint32_t s : surfaces)
    for (Side3& side : sides_of(scene.polygons[s])) {
      points.push_back(side.from);
      sides.push_back(std::move(side));
    }
  const Vertices3 vertices(points);
  const auto integers = [&vertices](const Point3& point) {
    const Point3 p = vertices.from_scene(point);
    return IntegerVector{p.x.get_num(), p.y.get_num(), p.z.get_num()};
  };
  OutlineSum3 outlines;
  for (const Side3& side : sides) outlines.add(integers(side.from), integers(side.to));
  const std::optional<IntegerVector> open = outlines.open_end();
  if (!open) return std::nullopt;
  const auto at = [&vertices](const Rational& origin, const Integer& place) {
    return Rational(origin + vertices.scale() * place);
  };
  const Point3& origin = vertices.origin();
  return Point3{at(origin.x, open->x), at(origin.y, open->y), at(origin.z, open->z)};
}

[[noreturn]] void refuse(const Scene3& scene, const std::vector<std::uint32_t>& surfaces, const std::string& name,
                         const std::string& why) {
  throw InputError(place_of(scene, scene.surfaces[surfaces.front()]), quoted_name(name) + " cannot be solid: " + why);
}

std::vector<std::vector<Point3>> convex_parts(const Polygon3& polygon, const PlaneFrame3& frame,
                                              const FlatRegion3& region) {
  if (is_convex(polygon)) return {polygon.points};
  std::vector<std::vector<Point3>> result;
  for (const auto& piece : convex_pieces(region)) {
    auto& points = result.emplace_back();
    for (const FlatPoint3& p : piece) points.push_back(frame.point(p));
  }
  return result;
}

// Points within a convex polygon, by number: the first is the mean of its corners.
FlatPoint3 within(const std::vector<FlatPoint3>& points, long number) {
  FlatPoint3 sum;
  long all = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const long weight = 1 + number * static_cast<long>((k * k + 3 * k) % 7);
    sum = {sum.u + weight * points[k].u, sum.v + weight * points[k].v};
    all += weight;
  }
  return {sum.u / all, sum.v / all};
}

// Whether a face that is not in the plane touches a point of it.
bool is_touched(const ClosedMesh3& mesh, const PlaneFrame3& frame, const Point3& point) {
  return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const ClosedMesh3::Face& face) {
    if (face.frame.height(point) != 0 || face.frame.key() == frame.key()) return false;
    const FlatPoint3 p = face.frame.flat(point);
    return face.region.is_on_border(p) || face.region.contains(p);
  });
}

template <class Meshes>
FlatPoint3 untouched_point(const Meshes& meshes, const PlaneFrame3& frame, const std::vector<FlatPoint3>& polygon) {
  for (long number = 0;; ++number) {
    const FlatPoint3 at = within(polygon, number);
    const Point3 point = frame.point(at);
    ClosedMesh3::Box box;
    box.include(point);
    if (std::none_of(meshes.begin(), meshes.end(),
                     [&](const ClosedMesh3& mesh) { return mesh.box.meets(box) && is_touched(mesh, frame, point); }))
      return at;
  }
}

// Where a convex polygon of another plane meets a plane: along a segment, or in less.
std::optional<FlatSegment3> meeting(const std::vector<Point3>& polygon, const PlaneFrame3& frame) {
  std::vector<FlatPoint3> ends;
  std::vector<Rational> heights;
  for (const Point3& p : polygon) heights.push_back(frame.height(p));
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::size_t next = (k + 1) % polygon.size();
    if (heights[k] == 0) ends.push_back(frame.flat(polygon[k]));
    if (sgn(heights[k]) * sgn(heights[next]) >= 0) continue;
    const Rational t = heights[k] / (heights[k] - heights[next]);
    const Vector3 way = polygon[next] - polygon[k];
    ends.push_back(frame.flat({polygon[k].x + t * way.x, polygon[k].y + t * way.y, polygon[k].z + t * way.z}));
  }
  if (ends.size() < 2) return std::nullopt;
  // Straight corners may lie between the two ends.
  const auto [low, high] = std::minmax_element(ends.begin(), ends.end(), [](const FlatPoint3& a, const FlatPoint3& b) {
    return std::tie(a.u, a.v) < std::tie(b.u, b.v);
  });
  return FlatSegment3{*low, *high};
}

// Rays by number: the first runs along an axis, the others a little beside it, each to another side.
Vector3 ray(std::size_t number, std::size_t axis, int side) {
  Vector3 way;
  way.*kWays[axis] = side;
  if (number == 0) return way;
  const auto n = static_cast<long>(number);
  way.*kWays[(axis + 1) % 3] = Rational(n % 2 == 0 ? n : -n, 1009 + 10 * n);
  way.*kWays[(axis + 2) % 3] = Rational(n % 3 == 0 ? n : -n, 1511 + 7 * n * n);
  return way;
}

// The winding number of a mesh around a point from which a ray sets out; faces in whose plane the point lies are not
// met. Nothing where the ray meets the border of a face.
std::optional<int> winding_along(const ClosedMesh3& mesh, const Point3& from, const Vector3& way, std::size_t axis,
                                 bool is_along_axis) {
  const std::array<double, 3> at = to_doubles(from);
  int winding = 0;
  for (const ClosedMesh3::Face& face : mesh.faces) {
    if (is_along_axis) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      if (at[u] < face.box.low[u] || at[u] > face.box.high[u] || at[v] < face.box.low[v] || at[v] > face.box.high[v])
        continue;
    }
    const Rational height = face.frame.height(from);
    if (height == 0) continue;
    const auto& key = face.frame.key();
    const Rational slope = key[0] * way.x + key[1] * way.y + key[2] * way.z;
    if (slope == 0 || sgn(slope) == sgn(height)) continue;
    const Rational t = -height / slope;
    const FlatPoint3 hit = face.frame.flat({from.x + t * way.x, from.y + t * way.y, from.z + t * way.z});
    if (face.region.is_on_border(hit)) return std::nullopt;
    if (face.region.contains(hit)) winding += (slope > 0) == face.is_front_up ? 1 : -1;
  }
  return winding;
}

int winding_around(const ClosedMesh3& mesh, const Point3& from, std::size_t axis, int side) {
  for (std::size_t number = 0;; ++number)
    if (const auto winding = winding_along(mesh, from, ray(number, axis, side), axis, number == 0)) return *winding;
}

// Winding numbers around a point that is moved a little to a side of a plane.
class BesidePlane {
 public:
  explicit BesidePlane(const PlaneSidePoint3& side) : from_(side.frame->point(side.at)) {
    box_.include(from_);
    find_way(side);
  }

  int winding(const ClosedMesh3& mesh) const {
    return box_.meets(mesh.box) ? winding_around(mesh, from_, axis_, way_) : 0;
  }

 private:
  void find_way(const PlaneSidePoint3& side);

  Point3 from_;
  ClosedMesh3::Box box_;
  std::size_t axis_ = 0;
  int way_ = 1;
};

// Rays beside the axis run to the same side of the plane: the axis has the largest part of the normal.
void BesidePlane::find_way(const PlaneSidePoint3& side) {
  const auto& key = side.frame->key();
  for (std::size_t a = 1; a < 3; ++a)
    if (abs(key[a]) > abs(key[axis_])) axis_ = a;
  way_ = side.is_up ? sgn(key[axis_]) : -sgn(key[axis_]);
}

bool is_on(const ClosedMesh3& mesh, const Point3& point) {
  return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const ClosedMesh3::Face& face) {
    if (face.frame.height(point) != 0) return false;
    const FlatPoint3 p = face.frame.flat(point);
    return face.region.is_on_border(p) || face.region.contains(p);
  });
}

int winding_at(const ClosedMesh3& mesh, const Point3& point) {
  ClosedMesh3::Box box;
  box.include(point);
  return box.meets(mesh.box) ? winding_around(mesh, point, 2, 1) : 0;
}

void append_cuts_of(const ClosedMesh3& mesh, const PlaneFrame3& frame, const std::vector<FlatPoint3>& polygon,
                    const ClosedMesh3::Box& box, bool with_coplanar, std::vector<FlatSegment3>& cuts) {
  if (!box.meets(mesh.box)) return;
  const auto add = [&](const FlatSegment3& segment) {
    if (!(segment[0] == segment[1]) && enters(polygon, {segment[0], segment[1]})) cuts.push_back(segment);
  };
  for (const ClosedMesh3::Face& face : mesh.faces) {
    if (!box.meets(face.box)) continue;
    if (face.frame.key() == frame.key()) {
      if (!with_coplanar) continue;
      std::vector<FlatSegment3> sides;
      face.region.append_sides(sides);
      std::for_each(sides.begin(), sides.end(), add);
      continue;
    }
    for (const auto& piece : face.pieces)
      if (const auto segment = meeting(piece, frame)) add(*segment);
  }
}

// Calls look(at) for a point of each part into which a mesh cuts a face, until it says false.
template <class Look>
bool look_at_parts(const ClosedMesh3::Face& face, const ClosedMesh3& mesh, const Look& look) {
  for (const auto& piece : face.pieces) {
    const std::vector<FlatPoint3> polygon = face.frame.outline(piece);
    std::vector<FlatSegment3> cuts;
    append_cuts_of(mesh, face.frame, polygon, face.box, true, cuts);
    if (cuts.empty()) {
      if (!look(untouched_point(std::span(&mesh, 1), face.frame, polygon))) return false;
      continue;
    }
    FlatRegion3 region({polygon});
    region.append_sides(cuts);
    const PlaneTriangulation3 triangulation(cuts);
    for (std::uint32_t k = 0; k < triangulation.triangles().size(); ++k)
      if (region.contains(triangulation.centre(k)) &&
          !look(untouched_point(std::span(&mesh, 1), face.frame, triangulation.corners_of(k))))
        return false;
  }
  return true;
}

// Whether no point of a room's faces is outside a mesh.
bool lies_in(const ClosedMesh3& room, const ClosedMesh3& mesh) {
  return std::all_of(room.faces.begin(), room.faces.end(), [&](const ClosedMesh3::Face& face) {
    return look_at_parts(face, mesh, [&](const FlatPoint3& at) {
      return BesidePlane({&face.frame, at, true}).winding(mesh) == 1 ||
             BesidePlane({&face.frame, at, false}).winding(mesh) == 1;
    });
  });
}

// What the winding numbers before and behind all faces of a closed mesh say of it.
Kind kind_of(const ClosedMesh3& mesh) {
  int low = 0, high = 0;
  for (const ClosedMesh3::Face& face : mesh.faces)
    look_at_parts(face, mesh, [&](const FlatPoint3& at) {
      for (const bool is_up : {false, true}) {
        const int winding = BesidePlane({&face.frame, at, is_up}).winding(mesh);
        low = std::min(low, winding);
        high = std::max(high, winding);
      }
      return true;
    });
  return low == 0 && high == 1 ? Kind::kSolid : low == -1 && high == 0 ? Kind::kRoom : Kind::kTangled;
}

ClosedMesh3 mesh_of_polygons(const Scene3& scene, const std::vector<std::uint32_t>& surfaces) {
  ClosedMesh3 mesh;
  for (const std::uint32_t s : surfaces)
    for (const Polygon3& polygon : facets_of(scene.polygons[s])) {
      const PlaneFrame3 frame(polygon.points);
      FlatRegion3 region = frame.region(polygon.points, polygon.holes);
      auto parts = convex_parts(polygon, frame, region);
      ClosedMesh3::Box box;
      for (const Point3& p : polygon.points) box.include(p);
      mesh.box.include(box);
      mesh.faces.push_back({s, frame, std::move(region), frame.is_front_up(polygon.points), std::move(parts), box});
    }
  return mesh;
}

}  // namespace

void ClosedMesh3::Box::include(const Point3& point) {
  for (std::size_t a = 0; a < 3; ++a) {
    const double value = to_double(point.*kAxes[a]);
    low[a] = std::min(low[a], std::nextafter(value, -kInfinity));
    high[a] = std::max(high[a], std::nextafter(value, kInfinity));
  }
}

void ClosedMesh3::Box::include(const Box& other) {
  for (std::size_t a = 0; a < 3; ++a) {
    low[a] = std::min(low[a], other.low[a]);
    high[a] = std::max(high[a], other.high[a]);
  }
}

bool ClosedMesh3::Box::meets(const Box& other) const {
  for (std::size_t a = 0; a < 3; ++a)
    if (low[a] > other.high[a] || other.low[a] > high[a]) return false;
  return true;
}

// Polygons that may be a closed mesh.
struct Solids3::Candidate {
  std::string name;
  std::vector<std::uint32_t> surfaces, groups;
  Behind behind = Behind::kByOutline;
};

Solids3::Solids3(const Scene3& scene) : mesh_of_(scene.groups.size()) {
  std::vector<Candidate> groups;
  for (const Group& group : scene.groups)
    groups.push_back({group.name, {}, {static_cast<std::uint32_t>(groups.size())}, group.behind});
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    if (!scene.surfaces[s].on) groups[scene.surfaces[s].group].surfaces.push_back(s);
  for (Candidate candidate : groups) {
    // Of a group of a body it is known later what has to be solid.
    if (!scene.groups[candidate.groups.front()].body.empty() && candidate.behind == Behind::kSolid)
      candidate.behind = Behind::kByOutline;
    add_if_closed(scene, candidate);
  }
  add_bodies(scene, std::move(groups));
  rooms_in_.resize(meshes_.size());
  for (std::uint32_t m = 0; m < meshes_.size(); ++m)
    for (std::uint32_t r = 0; r < meshes_.size(); ++r) {
      const ClosedMesh3 &mesh = meshes_[m], &room = meshes_[r];
      if (mesh.kind != Kind::kSolid || room.kind != Kind::kRoom || !mesh.box.meets(room.box)) continue;
      if (lies_in(room, mesh)) rooms_in_[m].push_back(r);
    }
}

// Bodies of which no group closes alone; and groups of others that have to be solid, and are not.
void Solids3::add_bodies(const Scene3& scene, std::vector<Candidate> groups) {
  std::map<std::string, Candidate> bodies;
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    if (scene.groups[g].body.empty()) continue;
    Candidate& body = bodies[scene.groups[g].body];
    body.name = scene.groups[g].body;
    body.surfaces.insert(body.surfaces.end(), groups[g].surfaces.begin(), groups[g].surfaces.end());
    body.groups.push_back(g);
    if (groups[g].behind != Behind::kByOutline && body.behind != Behind::kOpen) body.behind = groups[g].behind;
  }
  for (auto& [name, body] : bodies) {
    const bool closes_apart =
        std::any_of(body.groups.begin(), body.groups.end(), [&](std::uint32_t g) { return mesh_of_[g].has_value(); });
    std::sort(body.surfaces.begin(), body.surfaces.end());
    if (!closes_apart) {
      add_if_closed(scene, body);
      continue;
    }
    for (const std::uint32_t g : body.groups)
      if (groups[g].behind == Behind::kSolid && !mesh_of_[g]) add_if_closed(scene, groups[g]);
  }
  std::vector<std::uint32_t> order(meshes_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return meshes_[a].group < meshes_[b].group; });
  std::vector<std::uint32_t> place(order.size());
  std::vector<ClosedMesh3> sorted;
  for (const std::uint32_t m : order) {
    place[m] = static_cast<std::uint32_t>(sorted.size());
    sorted.push_back(std::move(meshes_[m]));
  }
  meshes_ = std::move(sorted);
  for (auto& mesh : mesh_of_)
    if (mesh) mesh = place[*mesh];
}

// Refuses what has to be solid and is not.
bool Solids3::add_if_closed(const Scene3& scene, const Candidate& candidate) {
  const auto& surfaces = candidate.surfaces;
  const auto has_back = [&](std::uint32_t s) { return scene.surfaces[s].back.has_value(); };
  const bool is_asked = candidate.behind == Behind::kSolid && !surfaces.empty();
  if (std::any_of(surfaces.begin(), surfaces.end(), has_back)) {
    if (is_asked) refuse(scene, surfaces, candidate.name, "a back of it has a material");
    return false;
  }
  if (candidate.behind == Behind::kOpen || (surfaces.size() < 4 && !is_asked)) return false;
  if (const auto open = open_end(scene, surfaces)) {
    if (is_asked)
      refuse(scene, surfaces, candidate.name,
             "its mesh is not closed: a side at " + place_text(*open) + " is the side of one face only");
    return false;
  }
  ClosedMesh3 mesh = mesh_of_polygons(scene, surfaces);
  mesh.group = candidate.groups.front();
  mesh.name = candidate.name;
  mesh.kind = kind_of(mesh);
  if (is_asked && mesh.kind != Kind::kSolid)
    refuse(scene, surfaces, candidate.name,
           mesh.kind == Kind::kRoom ? "its fronts look inward: turn its faces round"
                                    : "it winds around some points more than once, or both ways");
  has_solid_ |= mesh.kind == Kind::kSolid;
  for (const std::uint32_t g : candidate.groups) mesh_of_[g] = static_cast<std::uint32_t>(meshes_.size());
  meshes_.push_back(std::move(mesh));
  return true;
}

const ClosedMesh3* Solids3::mesh_of(std::uint32_t group) const {
  return group < mesh_of_.size() && mesh_of_[group] ? &meshes_[*mesh_of_[group]] : nullptr;
}

FlatPoint3 Solids3::inner_point(const PlaneFrame3& frame, const std::vector<FlatPoint3>& polygon) const {
  return untouched_point(meshes_, frame, polygon);
}

std::optional<std::uint32_t> Solids3::behind(const PlaneSidePoint3& side) const {
  const BesidePlane beside(side);
  for (std::uint32_t m = 0; m < meshes_.size(); ++m)
    if (is_within(m, beside)) return m;
  return std::nullopt;
}

bool Solids3::is_behind(const PlaneSidePoint3& side, const ClosedMesh3& mesh) const {
  return is_within(static_cast<std::size_t>(&mesh - meshes_.data()), BesidePlane(side));
}

template <class Beside>
bool Solids3::is_within(std::size_t mesh, const Beside& beside) const {
  if (meshes_[mesh].kind != Kind::kSolid || beside.winding(meshes_[mesh]) != 1) return false;
  const auto& rooms = rooms_in_[mesh];
  return std::none_of(rooms.begin(), rooms.end(),
                      [&](std::uint32_t room) { return beside.winding(meshes_[room]) == -1; });
}

std::optional<std::uint32_t> Solids3::around(const Point3& point) const {
  for (std::uint32_t m = 0; m < meshes_.size(); ++m) {
    const ClosedMesh3& mesh = meshes_[m];
    if (mesh.kind != Kind::kSolid || is_on(mesh, point) || winding_at(mesh, point) != 1) continue;
    const bool is_free = std::any_of(rooms_in_[m].begin(), rooms_in_[m].end(), [&](std::uint32_t r) {
      return is_on(meshes_[r], point) || winding_at(meshes_[r], point) == -1;
    });
    if (!is_free) return m;
  }
  return std::nullopt;
}

void Solids3::append_cuts(const PlaneFrame3& frame, const std::vector<FlatPoint3>& polygon, const ClosedMesh3::Box& box,
                          std::vector<FlatSegment3>& cuts) const {
  for (const ClosedMesh3& mesh : meshes_)
    if (mesh.kind != Kind::kTangled) append_cuts_of(mesh, frame, polygon, box, false, cuts);
}

}  // namespace hottel
