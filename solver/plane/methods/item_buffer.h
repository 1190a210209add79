// What is seen in each pixel of a half-square about a point of an element.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "solver/plane/methods/element_geometry.h"

namespace hottel {

// The half of a square of side 2 that stands over an element, with the eye in the middle of its base: coordinates are x
// along the element and y over it. Its front edge y = 1 has `resolution` pixels, the half edges x = 1 and x = -1 have
// resolution / 2 each; they are numbered from the horizon at x > 0 counter-clockwise to the horizon at x < 0.
class HalfSquare2 {
 public:
  explicit HalfSquare2(std::uint32_t resolution) : resolution_(resolution) {}  // REQUIRES an even number, >= 2

  std::size_t pixels() const { return std::size_t{2} * resolution_; }

  // Where the direction to a point with y > 0 meets the half-square, in pixels from the start: in [0, pixels()].
  double screen(const LocalVector2& p) const;
  // A point of the half-square: the inverse of screen().
  LocalVector2 point(double screen) const;
  // Fraction of diffuse light that arrives through a pixel, (sin phi' - sin phi) / 2 between its borders. (The usual
  // delta form factor is this integral by the midpoint rule.) All together are 1.
  double weight(std::size_t pixel) const;

 private:
  std::uint32_t resolution_;
};

// A straight item as seen from the eye: its ends relative to the eye, left counter-clockwise of right by less than pi,
// one of them at least with y > 0. What lies below y = 0 is cut off.
struct BufferItem2 {
  LocalVector2 right, left;
  std::uint32_t item = 0;
};

// Draws items by their depth.
//
//   (1) a pixel shows the item that is nearest in the direction of the pixel's centre, or the background
//   (2) an item covers the centre k + 1/2 iff screen(right) <= k + 1/2 < screen(left): of two that share an end one
//       and only one covers a centre on it
//   (3) implementations may differ only on pixels whose centre lies within 2^-7 pixel of an end, or whose two depths
//       differ by less than 2^-20 of themselves
class ItemBuffer2 {
 public:
  virtual ~ItemBuffer2() = default;
  // Returns an item for each pixel; valid until the next call.
  virtual std::span<const std::uint32_t> draw(std::span<const BufferItem2> items, std::uint32_t background) = 0;
};

using MakeItemBuffer2 = std::function<std::unique_ptr<ItemBuffer2>(std::uint32_t resolution)>;

// In software, in doubles: on every machine the same.
// COST: that of the pixels covered.
std::unique_ptr<ItemBuffer2> software_item_buffer_2(std::uint32_t resolution);

}  // namespace hottel
