#include "viewer/picture/space/pixel_values.h"

#include "geometry/space/visibility/convex_cut.h"

namespace hottel {
namespace {

template <class Height>
PixelPolygon cut(const PixelPolygon& polygon, const Height& height) {
  return cut_convex(polygon, height, place_between_3);
}

}  // namespace

Pixel place_between_3(const Pixel& a, const Pixel& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

Pixel middle_of_corners_3(std::span<const Pixel> polygon) {
  Pixel sum;
  for (const Pixel& p : polygon) sum = {sum.x + p.x, sum.y + p.y};
  return {sum.x / static_cast<double>(polygon.size()), sum.y / static_cast<double>(polygon.size())};
}

double pixel_area_doubled_3(std::span<const Pixel> polygon) {
  double sum = 0;
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const Pixel &o = polygon[0], &a = polygon[k - 1], &b = polygon[k];
    sum += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  }
  return sum;
}

PixelStrip3::PixelStrip3(std::span<const Pixel> whole, double top) {
  polygon = cut(cut({whole.begin(), whole.end()}, [&](const Pixel& p) { return p.y - top; }),
                [&](const Pixel& p) { return top + 1 - p.y; });
  if (polygon.size() < 3) return;
  double at_top[2] = {left, right}, at_bottom[2] = {left, right};
  for (const Pixel& p : polygon) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    const auto note = [&](double(&span)[2]) {
      span[0] = std::min(span[0], p.x);
      span[1] = std::max(span[1], p.x);
    };
    if (p.y <= top) note(at_top);
    if (p.y >= top + 1) note(at_bottom);
  }
  full_left = std::max(at_top[0], at_bottom[0]);
  full_right = std::min(at_top[1], at_bottom[1]);
}

PixelCover3 PixelStrip3::cover(std::uint32_t x, std::uint32_t y) const {
  const PixelPolygon part =
      cut(cut(polygon, [&](const Pixel& p) { return p.x - x; }), [&](const Pixel& p) { return x + 1.0 - p.x; });
  PixelCover3 result{x, y, 0, {x + 0.5, y + 0.5}};
  if (part.size() < 3) return result;
  double sum = 0;
  Pixel moment{0, 0};
  const Pixel& o = part[0];
  for (std::size_t k = 2; k < part.size(); ++k) {
    const Pixel &a = part[k - 1], &b = part[k];
    const double area = (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
    sum += area;
    moment.x += area * (a.x - o.x + (b.x - o.x)) / 3;
    moment.y += area * (a.y - o.y + (b.y - o.y)) / 3;
  }
  result.part = std::fabs(sum) / 2;
  if (sum != 0) result.middle = {o.x + moment.x / sum, o.y + moment.y / sum};
  return result;
}

void add_polygon(std::span<const Pixel> polygon, std::span<const double> value, PixelValues3& pixels) {
  for_each_covered_pixel(polygon, pixels.width, pixels.height, [&](const PixelCover3& cover) {
    double* pixel = pixels.values.data() + (std::size_t{cover.y} * pixels.width + cover.x) * pixels.channels;
    for (std::size_t c = 0; c < pixels.channels; ++c) pixel[c] += cover.part * value[c];
  });
}

}  // namespace hottel
