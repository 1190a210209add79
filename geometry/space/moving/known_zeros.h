// Signs that are zero all along a stretch. Internal to geometry/space/exchange.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/space/moving/moving_corner.h"

namespace hottel {

// The corners that lie in a plane for every t, as far as they were found, of one stretch.
//
//   (1) has() is true only of what was added since forget() was called last; some of that may be lost
//
// COST: constant.
class KnownZeros3 {
 public:
  void forget() { ++stretch_; }
  bool has(const MovingCorner3& corner, PlaneId3 plane) const { return has(zero(corner, plane)); }
  bool has(std::uint32_t point, PlaneId3 plane) const { return has(zero(point, plane)); }
  void add(const MovingCorner3& corner, PlaneId3 plane) {
    const Zero found = zero(corner, plane);
    kept_[place(found)] = found;
  }

 private:
  static constexpr std::size_t kPlaces = 1024;
  static constexpr std::uint64_t kPoint = std::uint64_t{1} << 63;
  struct Zero {
    std::uint64_t corner = 0;  // its planes, in order, or its point
    std::uint32_t plane = 0, stretch = 0;
  };

  Zero zero(std::uint32_t point, PlaneId3 plane) const {
    return {kPoint | point, static_cast<std::uint32_t>(plane.number()), stretch_};
  }
  Zero zero(const MovingCorner3& corner, PlaneId3 plane) const {
    if (corner.point != MovingCorner3::kNoPoint) return zero(corner.point, plane);
    const auto a = static_cast<std::uint32_t>(corner.first.plane.number());
    const auto b = static_cast<std::uint32_t>(corner.second.plane.number());
    return {(std::uint64_t{std::min(a, b)} << 32) | std::max(a, b), static_cast<std::uint32_t>(plane.number()),
            stretch_};
  }
  bool has(const Zero& wanted) const {
    const Zero& kept = kept_[place(wanted)];
    return kept.stretch == wanted.stretch && kept.plane == wanted.plane && kept.corner == wanted.corner;
  }
  static std::size_t place(const Zero& zero) {
    constexpr std::uint64_t kMix = 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio
    return ((zero.corner * kMix) ^ ((zero.plane + 1) * kMix >> 7)) * kMix >> 54;
  }

  std::vector<Zero> kept_ = std::vector<Zero>(kPlaces);
  std::uint32_t stretch_ = 1;
};

}  // namespace hottel
