#include "geometry/plane/check/needles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "geometry/plane/check/wording.h"
#include "kernel/plain_functions.h"

namespace hottel {
namespace {

// The angle at v from `right` to `left`, less than a straight one, when it is a needle; else a negative number.
double needle_degrees(const Vertices2& vertices, VertexId v, VertexId right, VertexId left) {
  const auto &o = vertices.approximate(v), &p = vertices.approximate(right), &q = vertices.approximate(left);
  const double px = p.x - o.x, py = p.y - o.y, qx = q.x - o.x, qy = q.y - o.y;
  const double size = (std::fabs(px) + std::fabs(py)) * (std::fabs(qx) + std::fabs(qy));
  const double error = vertices.approximation_error() *
                       (std::fabs(px) + std::fabs(py) + std::fabs(qx) + std::fabs(qy) + vertices.approximation_error());
  if (px * qy - py * qx > 2 * size / kNeedlePart + 4 * error) return -1;
  const Point2 eo = vertices.exact(v), ep = vertices.exact(right), eq = vertices.exact(left);
  const Rational x1 = ep.x - eo.x, y1 = ep.y - eo.y, x2 = eq.x - eo.x, y2 = eq.y - eo.y;
  const Rational cross = x1 * y2 - y1 * x2, dot = x1 * x2 + y1 * y2;
  if (dot <= 0 || cross <= 0 || cross * kNeedlePart >= dot) return -1;
  return same_bits::atan(to_double(cross / dot)) * 180 / std::numbers::pi;
}

}  // namespace

std::vector<Needle2> find_needles(const Arrangement2& arrangement) {
  const Vertices2& vertices = arrangement.vertices();
  std::vector<Needle2> needles;
  std::vector<StarEntry2> around;
  for (const VertexId v : vertices.ids()) {
    around.clear();
    for (const StarEntry2& entry : arrangement.triangulation().star(v))
      if (entry.left != kNoPiece) around.push_back(entry);
    for (std::size_t k = 0; around.size() > 1 && k < around.size(); ++k) {
      const StarEntry2 &right = around[k], &left = around[(k + 1) % around.size()];
      if (arrangement.is_covered(right.left)) continue;  // in a solid
      const double degrees = needle_degrees(vertices, v, right.neighbour, left.neighbour);
      if (degrees >= 0) needles.push_back({v, piece_of(right.left), piece_of(left.left), degrees});
    }
  }
  return needles;
}

Findings2 needle_findings(const Scene2& scene, const Arrangement2& arrangement) {
  Findings2 findings;
  for (const Needle2& needle : find_needles(arrangement)) {
    const Point2 at = arrangement.vertices().to_scene(arrangement.vertices().exact(needle.at));
    std::vector<std::uint32_t> surfaces{arrangement.sources(needle.right).front().surface,
                                        arrangement.sources(needle.left).front().surface};
    std::sort(surfaces.begin(), surfaces.end());
    std::string message = fmt::format("{} meet at {} in an angle of about {:.3g} degrees", names_text(scene, surfaces),
                                      place_text(at), needle.degrees);
    findings.push_back({Severity::kNote, "needle", std::move(surfaces), at, std::move(message),
                        "factors are exact here too; approximate methods lose digits between such surfaces"});
  }
  return findings;
}

}  // namespace hottel
