#include "viewer/picture/plane/corners.h"

#include <algorithm>
#include <numeric>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/failure.h"

namespace hottel {

Corners2::Corners2(const Scene2& scene, const Frame2& frame) {
  const std::size_t n = scene.surfaces.size();
  std::vector<Pixel> pixels;
  pixels.reserve(2 * n);
  for (const Edge2& edge : scene.edges) {
    pixels.push_back(frame.at(edge.from));
    pixels.push_back(frame.at(edge.to));
  }
  const auto point = [&](std::uint32_t k) -> const Point2& {
    return k % 2 == 0 ? scene.edges[k / 2].from : scene.edges[k / 2].to;
  };
  // Rounding keeps the order, so exact comparisons are needed only where pixels are equal.
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    if (pixels[a].x != pixels[b].x) return pixels[a].x < pixels[b].x;
    if (point(a).x != point(b).x) return point(a).x < point(b).x;  // far fewer multiplications than cmp() where equal
    if (pixels[a].y != pixels[b].y) return pixels[a].y > pixels[b].y;
    return point(a).y != point(b).y && point(a).y < point(b).y;
  };
  std::vector<std::uint32_t> order(2 * n);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), before);
  from.resize(n);
  to.resize(n);
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || before(order[k - 1], order[k])) at.push_back(pixels[order[k]]);
    (order[k] % 2 == 0 ? from : to)[order[k] / 2] = static_cast<std::uint32_t>(at.size() - 1);
  }
}

FaceRuns2::FaceRuns2(const PreparedScene2& prepared, const Frame2& frame, Granularity granularity) {
  HOTTEL_REQUIRE(granularity != Granularity::kGroup);
  const Vertices2& vertices = prepared.arrangement.vertices();
  for (const VertexId v : vertices.ids()) {
    corners_.at.push_back(frame.at(vertices.to_scene(vertices.exact(v))));
  }
  const ElementTable2& labels = *prepared.elements(granularity);
  elements_ = labels.elements();
  begin_.assign(prepared.scene.surfaces.size() + 1, 0);
  for (std::uint32_t label = 0; label < labels.count(); ++label) {
    const Element& element = labels.elements()[label];
    for (const Segment2& run : labels.runs(label)) {
      corners_.from.push_back(static_cast<std::uint32_t>(run.a.index()));
      corners_.to.push_back(static_cast<std::uint32_t>(run.b.index()));
      face_.push_back({element.surface, element.is_back});
      element_.push_back(label);
    }
    begin_[element.surface + 1] = static_cast<std::uint32_t>(face_.size());
  }
}

}  // namespace hottel
