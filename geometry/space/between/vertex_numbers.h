// Numbers of some vertices. Internal to geometry/space.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/space/predicates/vertices.h"

namespace hottel {

// The numbers of a few of many vertices, in one piece of memory: a pair of patches numbers those that it meets.
//
// COST: constant.
class VertexNumbers3 {
 public:
  // Returns the number of a vertex, which is this one where it had none; and whether it had none.
  std::pair<std::uint32_t, bool> try_number(VertexId3 vertex, std::uint32_t number) {
    if (2 * (count_ + 1) > places_.size()) grow();
    Place& place = places_[place_of(vertex)];
    if (place.vertex == vertex) return {place.number, false};
    place = {vertex, number};
    ++count_;
    return {number, true};
  }

 private:
  struct Place {
    VertexId3 vertex = VertexId3::none();
    std::uint32_t number = 0;
  };

  // Where a vertex is, or would be.
  std::size_t place_of(VertexId3 vertex) const {
    constexpr std::uint32_t kMix = 0x9e3779b9;  // 2^32 over the golden ratio
    const std::size_t last = places_.size() - 1;
    std::size_t at = (static_cast<std::uint32_t>(vertex.number()) * kMix >> 8) & last;
    while (!places_[at].vertex.is_none() && places_[at].vertex != vertex) at = (at + 1) & last;
    return at;
  }

  void grow() {
    const std::vector<Place> before =
        std::exchange(places_, std::vector<Place>(std::max<std::size_t>(64, 2 * places_.size())));
    for (const Place& place : before)
      if (!place.vertex.is_none()) places_[place_of(place.vertex)] = place;
  }

  std::vector<Place> places_;  // a power of two of them, half of them free at least
  std::size_t count_ = 0;
};

}  // namespace hottel
