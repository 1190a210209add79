#include "io/scene/space/patched_faces.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "geometry/space/scene/plane_frame.h"
#include "geometry/space/scene/plane_triangulation.h"
#include "geometry/space/scene/polygon_places.h"
#include "io/scene/space/mesh_pieces.h"
#include "kernel/support/disjoint_sets.h"

namespace hottel {

namespace {

// The surfaces that patches join, each with all that it lies on and all that lies on it.
std::vector<std::vector<std::uint32_t>> joined_by_patches(const PatchCarriers3& carriers) {
  const auto n = static_cast<std::uint32_t>(carriers.scene().surfaces.size());
  DisjointSets sets(n);
  std::vector<char> is_joined(n, 0);
  for (std::uint32_t s = 0; s < n; ++s) {
    if (!carriers.bases().is_patch(s)) continue;
    is_joined[s] = 1;
    for (const std::uint32_t base : carriers.of(s)) {
      is_joined[base] = 1;
      sets.join(s, base);
    }
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> joined;
  for (std::uint32_t s = 0; s < n; ++s)
    if (is_joined[s] != 0) joined[sets.root(s)].push_back(s);
  std::vector<std::vector<std::uint32_t>> result;
  for (auto& [first, surfaces] : joined) result.push_back(std::move(surfaces));
  return result;
}

// Points found by their place.
class PointFinder {
 public:
  explicit PointFinder(const std::vector<Point3>& points) {
    for (const Point3& point : points) points_.push_back({to_doubles(point), &point});
    std::ranges::sort(points_, {}, [](const Known& known) { return known.at[0]; });
  }

  // Those in a side, its ends left out, from its beginning on.
  std::vector<Point3> in_side(const Point3& from, const Point3& to) const {
    const std::array<double, 3> a = to_doubles(from), b = to_doubles(to);  // rounding keeps order
    auto k =
        std::ranges::lower_bound(points_, std::min(a[0], b[0]), {}, [](const Known& known) { return known.at[0]; });
    const Vector3 way = to - from;
    std::vector<std::pair<Rational, const Point3*>> found;
    for (; k != points_.end() && k->at[0] <= std::max(a[0], b[0]); ++k) {
      bool is_near = true;
      for (std::size_t axis = 1; axis < 3; ++axis)
        is_near &= k->at[axis] >= std::min(a[axis], b[axis]) && k->at[axis] <= std::max(a[axis], b[axis]);
      if (!is_near) continue;
      const Vector3 here = *k->point - from;
      if (!cross(way, here).is_zero()) continue;
      Rational place = dot(way, here);
      if (place > 0 && place < dot(way, way)) found.emplace_back(std::move(place), k->point);
    }
    std::ranges::sort(found, {}, [](const auto& entry) -> const Rational& { return entry.first; });
    std::vector<Point3> result;
    for (const auto& [place, point] : found)
      if (result.empty() || result.back() != *point) result.push_back(*point);
    return result;
  }

 private:
  struct Known {
    std::array<double, 3> at;
    const Point3* point;
  };
  std::vector<Known> points_;
};

// Puts points into the sides of a loop in which they lie; returns whether there are any.
bool put_into(std::vector<Point3>& loop, const PointFinder& finder) {
  std::vector<Point3> result;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    result.push_back(loop[k]);
    std::ranges::move(finder.in_side(loop[k], loop[(k + 1) % loop.size()]), std::back_inserter(result));
  }
  const bool has_more = result.size() > loop.size();
  loop = std::move(result);
  return has_more;
}

// The triangles of a plane polygon, the same ones of what looks the other way.
std::vector<Polygon3> same_triangles(Polygon3 polygon) {
  const bool is_up = PlaneFrame3(polygon.points).is_front_up(polygon.points);
  if (!is_up) std::ranges::reverse(polygon.points);
  std::vector<Point3>& points = polygon.points;
  std::rotate(points.begin(), std::ranges::min_element(points, precedes), points.end());
  std::vector<Polygon3> triangles = mesh_triangles(polygon);
  if (!is_up)
    for (Polygon3& triangle : triangles) std::reverse(triangle.points.begin() + 1, triangle.points.end());
  return triangles;
}

}  // namespace

// A surface in a plane, or a facet of one.
struct PatchedFaces3::Part {
  std::uint32_t surface;
  PlaneFrame3 frame;
  FlatRegion3 region;
  bool is_front_up;
};

PatchedFaces3::PatchedFaces3(const PatchCarriers3& carriers, const Holds& holds, const Leaves& leaves)
    : carriers_(&carriers), is_cut_(carriers.scene().surfaces.size(), 0), is_left_(is_cut_.size(), 0) {
  if (carriers.bases().is_empty()) return;
  for (const std::vector<std::uint32_t>& surfaces : joined_by_patches(carriers)) {
    if (!leaves || !std::ranges::all_of(surfaces, leaves))
      cut(surfaces, holds);
    else
      for (const std::uint32_t s : surfaces) is_left_[s] = 1;
  }
  if (!rounded_.empty()) share_corners();
}

std::vector<Polygon3> PatchedFaces3::of(const Face& face) const {
  if (const auto found = pieces_.find(face.number()); found != pieces_.end()) return found->second;
  if (is_cut_[face.surface] != 0) return {};
  return beside_patches(*carriers_, face);
}

// Where all is held nothing is done.
void PatchedFaces3::cut(const std::vector<std::uint32_t>& surfaces, const Holds& holds) {
  std::map<PlaneFrame3::Key, std::vector<Part>> planes;
  for (const std::uint32_t s : surfaces)
    for (const Polygon3& polygon : facets_of(carriers_->scene().polygons[s])) {
      const PlaneFrame3 frame(polygon.points);
      planes[frame.key()].push_back(
          {s, frame, frame.region(polygon.points, polygon.holes), frame.is_front_up(polygon.points)});
    }
  std::map<std::uint32_t, std::vector<Polygon3>> pieces;
  for (const auto& [key, parts] : planes) cut_plane(parts, pieces);
  std::vector<Point3> rounded;
  for (const auto& [face, triangles] : pieces)
    for (const Polygon3& triangle : triangles)
      std::ranges::copy_if(triangle.points, std::back_inserter(rounded), [&](const Point3& p) { return !holds(p); });
  if (rounded.empty()) return;
  for (const std::uint32_t s : surfaces) is_cut_[s] = 1;
  pieces_.merge(pieces);
  rounded_.insert(rounded_.end(), rounded.begin(), rounded.end());
}

// The triangles of one plane, each to all faces that have a place there.
void PatchedFaces3::cut_plane(const std::vector<Part>& parts,
                              std::map<std::uint32_t, std::vector<Polygon3>>& pieces) const {
  std::vector<FlatSegment3> segments;
  for (const Part& part : parts) part.region.append_sides(segments);
  const PlaneTriangulation3 triangulation(segments);
  for (std::uint32_t t = 0; t < triangulation.triangles().size(); ++t) {
    const FlatPoint3 at = triangulation.centre(t);
    std::vector<Face> above, below;
    for (const Part& part : parts) {
      if (!part.region.contains(at)) continue;
      above.push_back({part.surface, !part.is_front_up});
      below.push_back({part.surface, part.is_front_up});
    }
    Polygon3 up;
    for (const FlatPoint3& p : triangulation.corners_of(t)) up.points.push_back(parts.front().frame.point(p));
    Polygon3 down = up;
    std::reverse(down.points.begin() + 1, down.points.end());
    for (const Face& face : above)
      if (carriers_->bases().has_place(face, above)) pieces[face.number()].push_back(face.is_back ? down : up);
    for (const Face& face : below)
      if (carriers_->bases().has_place(face, below)) pieces[face.number()].push_back(face.is_back ? up : down);
  }
}

// Gives the sides of all polygons the rounded points in them as corners.
void PatchedFaces3::share_corners() {
  const PointFinder finder(rounded_);
  const Scene3& scene = carriers_->scene();
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    if (is_left_[s] != 0) continue;
    std::array<std::vector<Polygon3>, 2> faces;
    bool is_changed = false;
    for (const bool is_back : {false, true})
      for (const Polygon3& whole : of({s, is_back}))
        for (Polygon3& polygon : facets_of(whole)) {
          bool has_more = put_into(polygon.points, finder);
          for (std::vector<Point3>& hole : polygon.holes) has_more |= put_into(hole, finder);
          std::vector<Polygon3>& parts = faces[is_back ? 1 : 0];
          if (has_more)
            std::ranges::move(same_triangles(std::move(polygon)), std::back_inserter(parts));
          else
            parts.push_back(std::move(polygon));
          is_changed |= has_more;
        }
    if (!is_changed) continue;
    is_cut_[s] = 1;
    for (const bool is_back : {false, true}) pieces_[Face{s, is_back}.number()] = std::move(faces[is_back ? 1 : 0]);
  }
}

}  // namespace hottel
