#include "geometry/plane/arrangement/hilbert_order.h"

#include <algorithm>
#include <utility>

namespace hottel {
namespace {

constexpr int kLevels = 16;

// Position of cell (x, y) of a 2^16 x 2^16 grid along the Hilbert curve.
std::uint64_t hilbert_position(std::uint32_t x, std::uint32_t y) {
  std::uint64_t position = 0;
  for (std::uint32_t s = 1u << (kLevels - 1); s > 0; s >>= 1) {
    const std::uint32_t rx = (x & s) != 0, ry = (y & s) != 0;
    position = 4 * position + ((3 * rx) ^ ry);
    if (ry == 0) {
      if (rx == 1) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return position;
}

}  // namespace

std::vector<std::size_t> hilbert_order(const std::vector<Vertices2::Approximate>& points) {
  if (points.empty()) return {};
  double x0 = points[0].x, x1 = x0, y0 = points[0].y, y1 = y0;
  for (const auto& p : points) {
    x0 = std::min(x0, p.x);
    x1 = std::max(x1, p.x);
    y0 = std::min(y0, p.y);
    y1 = std::max(y1, p.y);
  }
  const double extent = std::max(x1 - x0, y1 - y0);
  const double cells = extent > 1e-300 && extent < 1e300 ? ((1 << kLevels) - 1) / extent : 0;
  const auto cell = [cells](double distance) {
    const double scaled = distance * cells;
    return scaled > 0 ? static_cast<std::uint32_t>(scaled) : 0u;  // also where coordinates exceed the double range
  };
  std::vector<std::pair<std::uint64_t, std::size_t>> numbered(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    numbered[i] = {hilbert_position(cell(points[i].x - x0), cell(points[i].y - y0)), i};
  std::sort(numbered.begin(), numbered.end());
  std::vector<std::size_t> order;
  order.reserve(points.size());
  for (const auto& [position, i] : numbered) order.push_back(i);
  return order;
}

std::vector<VertexId> hilbert_order(const Vertices2& vertices) {
  std::vector<Vertices2::Approximate> points(vertices.size());
  for (const VertexId i : vertices.ids()) points[i.index()] = vertices.approximate(i);
  const std::vector<std::size_t> order = hilbert_order(points);
  std::vector<VertexId> result;
  result.reserve(order.size());
  for (const std::size_t i : order) result.emplace_back(i);
  return result;
}

}  // namespace hottel
