#include "viewer/picture/raster_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

constexpr std::size_t kRowsAtOnce = 32;
constexpr std::uint32_t kOne = 256;               // of a weight
constexpr std::uint32_t kEvenBytes = 0x00FF00FF;  // two levels of a pixel, with room above each

// Which pixels of one axis of the target are drawn, [begin, end), and where they lie in the source.
struct Axis {
  std::uint32_t begin = 0, end = 0;
  double from, scale;
  std::uint32_t count;  // of the source

  Axis(double lower, double upper, std::uint32_t target, std::uint32_t source)
      : from(lower), scale(source / (upper - lower)), count(source) {
    if (source == 0 || !(lower < upper)) return;
    const auto first_centre = [&](double at) {
      return static_cast<std::uint32_t>(std::clamp(std::ceil(at - 0.5), 0.0, static_cast<double>(target)));
    };
    begin = first_centre(lower);
    end = first_centre(upper);
  }
  std::size_t size() const { return end - begin; }
  double centre(std::uint32_t at) const { return (at + 0.5 - from) * scale; }
  std::uint32_t nearest(std::uint32_t at) const {
    return static_cast<std::uint32_t>(std::clamp(std::floor(centre(at)), 0.0, count - 1.0));
  }
};

// A place between two neighbouring pixels of the source: the share of the second is weight / kOne.
struct Between {
  std::uint32_t first, second, weight;
};

Between between(const Axis& axis, std::uint32_t at) {
  const double place = std::clamp(axis.centre(at) - 0.5, 0.0, axis.count - 1.0);
  const auto first = static_cast<std::uint32_t>(place);
  return {first, std::min(first + 1, axis.count - 1), static_cast<std::uint32_t>((place - first) * kOne + 0.5)};
}

std::uint32_t blend(std::uint32_t a, std::uint32_t b, std::uint32_t weight) {
  constexpr std::uint32_t kHalf = kOne / 2 * 0x00010001;
  const std::uint32_t even = (a & kEvenBytes) * (kOne - weight) + (b & kEvenBytes) * weight + kHalf;
  const std::uint32_t odd = (a >> 8 & kEvenBytes) * (kOne - weight) + (b >> 8 & kEvenBytes) * weight + kHalf;
  return (even >> 8 & kEvenBytes) | (odd & ~kEvenBytes);
}

void draw_nearest(Raster& target, const Axis& columns, const Axis& rows, const Raster& source) {
  std::vector<std::uint32_t> places(columns.size());
  for (std::size_t k = 0; k < places.size(); ++k)
    places[k] = columns.nearest(columns.begin + static_cast<std::uint32_t>(k));
  parallel_ranges(rows.size(), kRowsAtOnce, [&](std::size_t begin, std::size_t end) {
    const std::uint32_t* drawn = nullptr;  // the row above, and what it is of
    std::uint32_t drawn_place = 0;
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t y = rows.begin + static_cast<std::uint32_t>(k), place = rows.nearest(y);
      std::uint32_t* to = target.pixels.data() + std::size_t{y} * target.width + columns.begin;
      if (drawn != nullptr && place == drawn_place) {
        std::memcpy(to, drawn, places.size() * sizeof *to);
      } else {
        const std::uint32_t* from = source.pixels.data() + std::size_t{place} * source.width;
        for (std::size_t x = 0; x < places.size(); ++x) to[x] = from[places[x]];
      }
      drawn = to;
      drawn_place = place;
    }
  });
}

void draw_smooth(Raster& target, const Axis& columns, const Axis& rows, const Raster& source) {
  std::vector<Between> places(columns.size());
  for (std::size_t k = 0; k < places.size(); ++k)
    places[k] = between(columns, columns.begin + static_cast<std::uint32_t>(k));
  const std::uint32_t left = places.front().first, right = places.back().second;
  parallel_ranges(rows.size(), kRowsAtOnce, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> blended(source.width);  // a row between two of the source
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t y = rows.begin + static_cast<std::uint32_t>(k);
      const Between place = between(rows, y);
      const std::uint32_t* above = source.pixels.data() + std::size_t{place.first} * source.width;
      const std::uint32_t* below = source.pixels.data() + std::size_t{place.second} * source.width;
      for (std::uint32_t x = left; x <= right; ++x) blended[x] = blend(above[x], below[x], place.weight);
      std::uint32_t* to = target.pixels.data() + std::size_t{y} * target.width + columns.begin;
      for (std::size_t x = 0; x < places.size(); ++x)
        to[x] = blend(blended[places[x].first], blended[places[x].second], places[x].weight);
    }
  });
}

bool is_whole(const Raster& raster) { return raster.pixels.size() == std::size_t{raster.width} * raster.height; }

}  // namespace

void draw_pixels(Raster& target, Pixel top_left, Pixel bottom_right, const Raster& source, bool smooth) {
  HOTTEL_REQUIRE(is_whole(target) && is_whole(source));
  const Axis columns(top_left.x, bottom_right.x, target.width, source.width);
  const Axis rows(top_left.y, bottom_right.y, target.height, source.height);
  if (columns.size() == 0 || rows.size() == 0) return;
  (smooth ? draw_smooth : draw_nearest)(target, columns, rows, source);
}

void dim(Raster& raster, double fraction) {
  HOTTEL_REQUIRE(fraction >= 0 && fraction <= 1);
  const auto share = static_cast<std::uint32_t>(std::lround((1 - fraction) * kOne));
  parallel_ranges(raster.pixels.size(), std::size_t{1} << 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      std::uint32_t& pixel = raster.pixels[k];
      const std::uint32_t red_and_blue = (pixel & kEvenBytes) * share >> 8 & kEvenBytes;
      const std::uint32_t green = (pixel >> 8 & 0xFF) * share & 0xFF00;
      pixel = (pixel & 0xFF000000) | red_and_blue | green;
    }
  });
}

}  // namespace hottel
