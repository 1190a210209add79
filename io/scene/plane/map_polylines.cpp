#include "io/scene/plane/map_polylines.h"

#include <algorithm>
#include <utility>

#include "geometry/name.h"
#include "geometry/plane/arrangement/ring_crossing.h"
#include "kernel/decimal.h"

namespace hottel {
namespace {

// Twice the area, positive counter-clockwise.
Rational doubled_area(const MapPolylines2::Points& ring) {
  Rational sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point2 &a = ring[k].at, &b = ring[(k + 1) % ring.size()].at;
    sum += a.x * b.y - b.x * a.y;
  }
  return sum;
}

bool is_closed(const MapPolylines2::Points& points) {
  return points.size() > 1 && points.front().at == points.back().at;
}

std::string place(const Point2& at) { return "(" + decimal_text(at.x) + ", " + decimal_text(at.y) + ")"; }

std::string place(const PolylinePoint2& point) {
  return place(point.at) + (point.line > 0 ? " (line " + std::to_string(point.line) + ")" : "");
}

}  // namespace

void MapPolylines2::add_line(Points line, const MapFeature2& feature, const FileLine& where) {
  if (line.size() < 2) throw InputError(where, "a line has fewer than two points");
  if (std::all_of(line.begin(), line.end(), [&](const PolylinePoint2& p) { return p.at == line.front().at; }))
    return pass_over(PassedKind::kLineWithoutLength, {where, "a line has no length: all its points are the same"});
  drop_repeated_points(line, where);
  const bool closed = line.size() > 3 && is_closed(line);
  if (closed) line.pop_back();
  add(std::move(line), closed, feature);
}

void MapPolylines2::add_closed_line(Points line, const MapFeature2& feature, const FileLine& where) {
  if (!is_closed(line)) throw InputError(where, "a LINEARRING is not closed: its last point must be its first");
  add_line(std::move(line), feature, where);
}

void MapPolylines2::add_ring(Points ring, bool is_hole, const MapFeature2& feature, const FileLine& where) {
  if (!is_closed(ring)) throw InputError(where, "a ring of a polygon is not closed: its last point must be its first");
  drop_repeated_points(ring, where);
  ring.pop_back();
  if (ring.size() < 3) throw InputError(where, "a ring of a polygon has fewer than three corners");
  refuse_crossing(ring, feature, where);
  const Rational area = doubled_area(ring);
  if (area == 0) throw InputError(where, "a ring of a polygon has no area");
  // The front is on the right: clockwise looks inward.
  const bool looks_inward = is_hole == (feature.side == MapSide2::kOutside);
  if ((area < 0) != looks_inward) std::reverse(ring.begin() + 1, ring.end());
  add(std::move(ring), true, feature);
}

ValidScene2 MapPolylines2::scene() {
  if (scene_.surfaces.empty())
    throw instead_ ? *instead_ : InputError({scene_.file, 0}, "there is no line and no polygon in it");
  return std::move(scene_);
}

// Where points have lines the first that repeats is told by its own.
void MapPolylines2::drop_repeated_points(Points& points, const FileLine& where) {
  const auto is_same = [](const PolylinePoint2& a, const PolylinePoint2& b) { return a.at == b.at; };
  const auto first = std::adjacent_find(points.begin(), points.end(), is_same);
  if (first == points.end()) return;
  const int line = (first + 1)->line;
  pass_over(PassedKind::kRepeatedPoint, {where.file, line > 0 ? line : where.line},
            drop_repeated(points, false, is_same));
}

// What lies right of a ring that crosses itself is its inside here and its outside there.
void MapPolylines2::refuse_crossing(const Points& ring, const MapFeature2& feature, const FileLine& where) {
  std::vector<Point2> points;
  points.reserve(ring.size());
  for (const PolylinePoint2& point : ring) points.push_back(point.at);
  const auto crossing = find_ring_crossing(points);
  if (!crossing) return;
  throw InputError(
      where, "the ring " + quoted_name(free_name(feature)) + " of a polygon crosses itself at " + place(crossing->at),
      {"there the side that begins in " + place(ring[crossing->first]) + " meets the one that begins in " +
       place(ring[crossing->second])});
}

void MapPolylines2::add(Points points, bool closed, const MapFeature2& feature) {
  Surface like;
  like.material = material(feature.material);
  if (!feature.back.empty()) like.back = material(feature.back);
  like.elements = feature.elements;
  like.group = static_cast<std::uint32_t>(scene_.groups.size());
  const std::string name = free_name(feature);
  scene_.groups.push_back(name);
  add_polyline(scene_, like, name, std::move(points), closed);
}

std::string MapPolylines2::free_name(const MapFeature2& feature) {
  if (feature.name.empty()) return "polyline[" + std::to_string(scene_.groups.size()) + "]";
  if (const auto problem = name_problem(feature.name); !problem.empty())
    throw InputError({scene_.file, feature.name_line},
                     "the name " + quoted_name(feature.name) + " " + std::string(problem));
  return names_.take(feature.name);
}

std::uint32_t MapPolylines2::material(const std::string& name) {
  const auto [found, is_new] = material_.emplace(name, static_cast<std::uint32_t>(scene_.materials.size()));
  if (is_new) scene_.materials.push_back({name, Spectrum::scalar(kMapReflectivity), {}});
  return found->second;
}

}  // namespace hottel
