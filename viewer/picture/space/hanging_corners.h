// Corners of elements that lie within a side of a coarser one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hottel {

// A corner strictly within a side from one corner to another, and how far along it is.
struct HangingCorner3 {
  std::uint32_t corner, from, to;
  double share;  // 0 to 1: of the way
};

// Returns hanging corners in an order in which the ends of a side come before what hangs in it.
//
//   (1) the order is a function of what is given: of corners that need not wait for each other the first one is first
//   (2) where sides lead round in a circle, each with an end within the next one, as those of bricks laid as a pinwheel
//       do, and two that overlap, the corners in them are left out, and those on the way from one circle to another.
//       Of trees none do: what a corner hangs in is of a coarser element
// REQUIRES no corner twice. COST: linear.
std::vector<HangingCorner3> in_order(const std::vector<HangingCorner3>& hanging);

// Gives each hanging corner the value between those of the ends of its side, of all channels: values by corner and
// channel. One whose side has an end without a value (NaN) keeps its own.
//
//   (1) values run linearly along each side: an affine field stays as it is, but for rounding
//   (2) no value leaves the range of the corners that do not hang; what is equal there is equal everywhere, exactly
// REQUIRES the order of in_order.
void hang(std::span<const HangingCorner3> ordered, std::size_t channels, std::vector<double>& values);

}  // namespace hottel
