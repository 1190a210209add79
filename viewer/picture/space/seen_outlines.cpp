#include "viewer/picture/space/seen_outlines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "geometry/space/visibility/visibility_map.h"
#include "kernel/support/interrupt.h"
#include "viewer/picture/space/border_lines.h"
#include "viewer/picture/space/eye_map.h"
#include "viewer/picture/space/projection.h"

namespace hottel {
namespace {

constexpr double kOnPlane = 1e-9;  // sine of the angle at which a direction counts as in a plane
constexpr double kSameEnd = 1e-7;  // of the length of what is drawn of a line: gaps that are none

// The plane of the eye and a border; nothing where the border is seen end on.
std::optional<Direction3> plane_of(const BorderLines3::Border& border) {
  const Direction3 normal = cross(border.begin, border.end);
  const double size = length(normal);
  if (!(size > kOnPlane * length(border.begin) * length(border.end))) return std::nullopt;
  return (1 / size) * normal;
}

bool is_on(const Direction3& plane, const Direction3& way) { return std::fabs(dot(plane, way)) <= kOnPlane; }

// Where on its line a border is met, in a direction in its plane.
double met_at(const BorderLines3::Border& border, const Direction3& plane, const Direction3& way) {
  const double to_end = dot(cross(border.begin, way), plane), to_begin = dot(cross(way, border.end), plane);
  const double share = to_end / (to_end + to_begin);
  return std::lerp(border.at_begin, border.at_end, std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0);
}

// Ascending, and those that meet joined.
std::vector<BorderPart3> joined(std::vector<BorderPart3> parts) {
  std::ranges::sort(parts, {}, &BorderPart3::from);
  std::vector<BorderPart3> result;
  const double gap = parts.empty() ? 0 : kSameEnd * (parts.back().to - parts.front().from);
  for (const BorderPart3& part : parts) {
    if (!result.empty() && part.from <= result.back().to + gap)
      result.back().to = std::max(result.back().to, part.to);
    else
      result.push_back(part);
  }
  return result;
}

// The sides that fragments have, each once.
std::vector<Face> seen_sides(const VisibilityMap3& map) {
  std::vector<Face> sides;
  for (const VisibilityMap3::Fragment& fragment : map.fragments)
    if (sides.empty() || sides.back() != fragment.face) sides.push_back(fragment.face);
  return sides;
}

class Outlines {
 public:
  Outlines(const PreparedScene3& prepared, const Camera3& camera)
      : prepared_(prepared),
        eye_(camera.eye),
        map_(eye_map_3(prepared, camera)),
        projection_(camera),
        lines_(prepared, camera.eye, seen_sides(map_), kRoundBend3),
        seen_(lines_.count()) {}

  std::vector<OutlineStroke3> strokes() {
    std::size_t side = 0;
    for (std::size_t k = 0; k < map_.fragments.size(); ++k) {
      if (k > 0 && map_.fragments[k].face != map_.fragments[k - 1].face) ++side;
      add_fragment(map_.fragments[k], lines_.borders(side));
    }
    for (std::uint32_t line = 0; line < seen_.size(); ++line)
      for (const BorderPart3& part : joined(std::move(seen_[line])))
        add_stroke(lines_.place(line, part.from), lines_.place(line, part.to));
    return std::move(strokes_);
  }

 private:
  void add_fragment(const VisibilityMap3::Fragment& fragment, std::span<const BorderLines3::Border> borders) {
    throw_if_interrupted();
    for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) {
      const VisibilityMap3::Corner& corner = map_.corners[c];
      const Direction3& from = corner.direction;
      const Direction3& to = map_.corners[c + 1 == fragment.end ? fragment.begin : c + 1].direction;
      if (add_border(borders, from, to)) continue;
      const PlaneDefinition3& plane = map_.planes[corner.side.plane.index()];
      // Both pieces have such a side: one of them tells it.
      if (plane.kind == PlaneDefinition3::Kind::kCrossing && plane.b < plane.a) add_crossing(plane.a, from, to);
    }
  }

  // Where the plane of a piece is crossed, as far as the piece itself is.
  void add_crossing(std::uint32_t piece, Direction3 from, Direction3 to) {
    std::vector<Direction3> ways;
    Direction3 middle;
    for (const Point3& point : prepared_.arrangement().pieces()[piece].polygon.points) {
      ways.push_back(rounded_way(eye_, point));
      middle = middle + ways.back();
    }
    for (std::size_t k = 0; k < ways.size(); ++k) {
      Direction3 inward = cross(ways[k], ways[k + 1 == ways.size() ? 0 : k + 1]);
      if (dot(inward, middle) < 0) inward = -inward;
      const double a = dot(inward, from), b = dot(inward, to);
      if (a <= 0 && b <= 0) return;
      if (a < 0) from = from + (a / (a - b)) * (to - from);
      if (b < 0) to = to + (b / (b - a)) * (from - to);
    }
    add_stroke(from, to);
  }

  // Returns false where the side of a fragment is no border of its piece.
  bool add_border(std::span<const BorderLines3::Border> borders, const Direction3& from, const Direction3& to) {
    for (const BorderLines3::Border& border : borders) {
      const auto plane = plane_of(border);
      if (!plane || !is_on(*plane, from) || !is_on(*plane, to)) continue;
      const double a = met_at(border, *plane, from), b = met_at(border, *plane, to);
      for (const BorderPart3& drawn : border.drawn) {
        const BorderPart3 part{std::max(drawn.from, std::min(a, b)), std::min(drawn.to, std::max(a, b))};
        if (part.from < part.to) seen_[border.line].push_back(part);
      }
      return true;
    }
    return false;
  }

  void add_stroke(const Direction3& from, const Direction3& to) {
    if (const auto line = projection_.line(from, to)) strokes_.push_back({(*line)[0], (*line)[1]});
  }

  const PreparedScene3& prepared_;
  Point3 eye_;
  VisibilityMap3 map_;
  Projection3 projection_;
  BorderLines3 lines_;
  std::vector<std::vector<BorderPart3>> seen_;  // by line
  std::vector<OutlineStroke3> strokes_;
};

}  // namespace

std::vector<OutlineStroke3> seen_outlines_3(const PreparedScene3& prepared, const Camera3& camera) {
  return Outlines(prepared, camera).strokes();
}

}  // namespace hottel
