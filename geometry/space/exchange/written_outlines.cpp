#include "geometry/space/exchange/written_outlines.h"

#include <algorithm>
#include <span>
#include <utility>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/scene/joined_outline.h"
#include "geometry/space/scene/plane_frame.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

WrittenLoop3 written(const std::vector<Point3>& points) {
  WrittenLoop3 loop;
  for (const Point3& p : points) loop.push_back({written_double(p.x), written_double(p.y), written_double(p.z)});
  return loop;
}

// A loop of a plane; `is_up`: seen from the side of its normal it is as in the plane, else the other way round.
WrittenLoop3 written(const std::vector<FlatPoint3>& flat, const PlaneFrame3& frame, bool is_up) {
  std::vector<Point3> points;
  for (const FlatPoint3& p : flat) points.push_back(frame.point(p));
  if (!is_up) std::ranges::reverse(points);
  return written(points);
}

// Polygons of one plane, all with their fronts on one side.
struct Coplanar {
  PlaneFrame3 frame;
  bool is_up;
  std::vector<std::vector<FlatPoint3>> polygons;
};

std::vector<Coplanar> by_planes(const Vertices3& vertices, std::span<const ElementTable3::Part> parts) {
  std::vector<Coplanar> planes;
  for (const ElementTable3::Part& part : parts) {
    const std::vector<Point3> corners = corners_of(vertices, part.patch);
    const PlaneFrame3 frame(corners);
    const auto known = std::ranges::find(planes, frame.key(), [](const Coplanar& plane) { return plane.frame.key(); });
    if (known == planes.end())
      planes.push_back({frame, frame.is_front_up(corners), {frame.outline(corners)}});
    else
      known->polygons.push_back(frame.outline(corners));
  }
  return planes;
}

WrittenOutline3 outline_of(const Vertices3& vertices, std::span<const ElementTable3::Part> parts) {
  if (parts.size() == 1) return {{written(corners_of(vertices, parts.front().patch))}};
  WrittenOutline3 result;
  for (const Coplanar& plane : by_planes(vertices, parts))
    for (const FlatPart3& part : joined_outline(plane.polygons)) {
      std::vector<WrittenLoop3>& loops = result.emplace_back();
      loops.push_back(written(part.outline, plane.frame, plane.is_up));
      for (const auto& hole : part.holes) loops.push_back(written(hole, plane.frame, plane.is_up));
    }
  return result;
}

}  // namespace

std::vector<WrittenOutline3> written_outlines(const ElementTable3& table, const Vertices3& vertices) {
  std::vector<WrittenOutline3> result(table.count());
  if (table.is_by_group()) return result;
  for (std::uint32_t label = 0; label < table.count(); ++label)
    result[label] = outline_of(vertices, table.free_parts(label));
  return result;
}

}  // namespace hottel
