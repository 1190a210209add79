#include "viewer/picture/plane/drawable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/plane/scene/bounding_box.h"

namespace hottel {
namespace {

constexpr long kMostExtentsAway = 1'000'000'000;  // from the origin: then a double tells a millionth of a pixel

}  // namespace

void require_drawable(const Scene2& scene) {
  if (scene.surfaces.empty()) return;
  const Surface* farthest = &scene.surfaces.front();
  Rational largest;
  for (std::size_t s = 0; s < scene.edges.size(); ++s)
    for (const Point2& p : {scene.edges[s].from, scene.edges[s].to}) {
      const Rational distance = std::max<Rational>(abs(p.x), abs(p.y));
      if (distance <= largest) continue;
      largest = distance;
      farthest = &scene.surfaces[s];
    }
  const Box2 box = bounding_box(scene);
  const Rational extent = std::max(box.width(), box.height());
  const char* why = to_double(largest) > kLargestDrawn      ? "larger than 1e300"
                    : to_double(extent) < 1 / kLargestDrawn ? "smaller than 1e-300, all of them"
                    : extent * kMostExtentsAway < largest   ? "too large for the size of the scene"
                                                            : nullptr;
  if (why)
    throw RequestError(
        fmt::format("{}:{}: the coordinates of '{}' are {}: a drawing like this places points by doubles", scene.file,
                    farthest->line, farthest->name, why));
}

void require_drawable(const Scene2& scene, const Point2& point, const std::string& text) {
  if (std::max(std::abs(to_double(point.x)), std::abs(to_double(point.y))) > kLargestDrawn)
    throw RequestError(scene.file + ": the point " + text + " is too far away to be drawn");
}

}  // namespace hottel
