// Walks through the regions of an arrangement with the winding numbers of closed groups.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane/arrangement/free_regions.h"

namespace hottel {

// How often the surfaces of a group run along a piece, from its first to its second end, less how often back.
struct NetRun2 {
  std::uint32_t group;
  std::int32_t net;
};

// The net runs of all pieces that are not zero. A closed outline that goes along a piece and back again adds none.
//
//   (1) of(p) is what the p-th call of add_piece was given, p from 0
//   (2) a piece may have no runs: of(p) is empty then
//
// REQUIRES: of(p) only for pieces that were added.
// COST: 8 bytes a run and 4 a piece.
class NetRuns2 {
 public:
  NetRuns2() : begin_{0} {}
  // The runs of the next piece, each group at most once. REQUIRES: no net run is 0, or walk_regions() tells of changes
  // that are none.
  void add_piece(const std::vector<NetRun2>& runs) {
    runs_.insert(runs_.end(), runs.begin(), runs.end());
    begin_.push_back(static_cast<std::uint32_t>(runs_.size()));
  }
  std::span<const NetRun2> of(std::size_t piece) const {
    return {runs_.data() + begin_[piece], runs_.data() + begin_[piece + 1]};
  }

 private:
  std::vector<NetRun2> runs_;
  std::vector<std::uint32_t> begin_;
};

// Visits every region once, from neighbour to neighbour, starting with region 0, the outside, where all winding
// numbers are 0. On the way it calls change(group, from, to) for each winding number that changes, there and back
// again; then, on the first visit of a region, visit(region).
//
//   (1) the winding number of a group is greater by its net run on the left of a piece than on the right of it
//   (2) when visit(region) is called, all calls of change() so far add up to the winding numbers of that region
//   (3) the order of the regions depends on the arrangement alone
//   (4) at the end every winding number is back at 0
//
// The way back is kept in a list: no recursion, however many regions lie inside each other.
// REQUIRES: net runs of closed groups, each below `group_count`: else winding numbers depend on the way.
// COST: twice the sides of pieces.
template <class Change, class Visit>
void walk_regions(const FreeRegions2& regions, const NetRuns2& runs, std::size_t group_count, const Change& change,
                  const Visit& visit) {
  struct Step {
    std::uint32_t region;
    PieceSideId entered_by;  // the side of the region before; none for the first
    std::size_t next_side;
  };
  std::vector<std::int32_t> winding(group_count, 0);
  const auto cross = [&](PieceSideId side, bool there) {
    const bool to_left = is_right(side) == there;
    for (const NetRun2& run : runs.of(piece_of(side))) {
      std::int32_t& number = winding[run.group];
      const std::int32_t before = number;
      number += to_left ? run.net : -run.net;
      change(run.group, before, number);
    }
  };
  std::vector<char> is_visited(regions.count(), 0);
  std::vector<Step> way{{0, PieceSideId::none(), 0}};
  is_visited[0] = 1;
  visit(std::uint32_t{0});
  while (!way.empty()) {
    Step& step = way.back();
    const auto sides = regions.sides(step.region);
    if (step.next_side == sides.size()) {
      if (!step.entered_by.is_none()) cross(step.entered_by, false);
      way.pop_back();
      continue;
    }
    const PieceSideId side = sides[step.next_side++];
    const std::uint32_t beyond = regions.of(opposite(side));
    if (is_visited[beyond] != 0) continue;
    is_visited[beyond] = 1;
    cross(side, true);
    visit(beyond);
    way.push_back({beyond, side, 0});
  }
}

}  // namespace hottel
