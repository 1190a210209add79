// What a scene lists, as the oracles take it.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <vector>

namespace hottel::oracle {

// What is said to be behind the backs of a group.
enum class Behind { kNothingSaid, kSolid, kOpen };

inline constexpr int kAlone = -1;

// An edge as a scene lists it. Materials are compared by number; none (a black back that claims nothing) is -1.
// REQUIRES: a != b.
struct InputSegment {
  mpq_class ax, ay, bx, by;
  int front_material = 0;  // of the right side of a -> b
  int back_material = -1;
  int group = kAlone;  // edges that follow each other in the list with the same number are one polyline
  Behind behind = Behind::kNothingSaid;  // the same for all of a group
  // Of a patch: the edges of the list that it lies on, or on whose backs it does. REQUIRES that it is alone.
  std::vector<std::size_t> on{};
  bool is_on_back = false;
};

// The edges of each group, in the order of the list.
using Groups = std::vector<std::vector<std::size_t>>;
Groups groups_of(const std::vector<InputSegment>& edges);

// Does each edge begin where the one before ends, and the first where the last ends? REQUIRES two edges or more, or
// it is false.
bool is_closed(const std::vector<InputSegment>& edges, const std::vector<std::size_t>& group);

}  // namespace hottel::oracle
