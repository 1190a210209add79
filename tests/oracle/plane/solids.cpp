#include "tests/oracle/plane/solids.h"

#include <algorithm>

namespace hottel::oracle {

namespace {

using Point = std::pair<mpq_class, mpq_class>;
using Index = std::size_t;
using Marks = std::vector<char>;  // by region

// How often a closed group goes counter-clockwise around a point, by the edges straight above the point. REQUIRES that
// no corner is straight above it.
int winding(const std::vector<InputSegment>& edges, const std::vector<Index>& group, const Point& p) {
  int number = 0;
  for (const Index k : group) {
    const InputSegment& e = edges[k];
    const bool is_left_a = e.ax < p.first, is_left_b = e.bx < p.first;
    if (is_left_a == is_left_b) continue;
    const mpq_class y = e.ay + (p.first - e.ax) / (e.bx - e.ax) * (e.by - e.ay);
    if (y > p.second) number += is_left_b ? 1 : -1;
  }
  return number;
}

class Finder {
 public:
  Finder(const std::vector<InputSegment>& edges, const Regions& regions, const std::vector<std::vector<Lying>>& lying)
      : edges_(edges), regions_(regions), lying_(lying), groups_(groups_of(edges)), group_of_(edges.size()) {
    for (Index g = 0; g < groups_.size(); ++g)
      for (const Index k : groups_[g]) group_of_[k] = g;
    for (Index g = 0; g < groups_.size(); ++g) {
      outline_.push_back(has_back(g) ? Marks() : inside(g, 1));
      room_.push_back(inside(g, -1));
    }
  }

  Solids find() {
    Solids result;
    result.makers.resize(regions_.all.size());
    std::vector<std::set<Index>> said_solid(regions_.all.size()), said_open(regions_.all.size());
    for (Index g = 0; g < groups_.size(); ++g) {
      const Behind said = edges_[groups_[g].front()].behind;
      Marks made = outline_[g];
      if (made.empty()) made.assign(regions_.all.size(), 0);
      take_rooms_from(g, made, result.has_room);
      const bool speaks_of_outline = said == Behind::kOpen && !outline_[g].empty();
      bool bounds_some = false;
      if (said != Behind::kNothingSaid && !speaks_of_outline)
        for (Index r = 0; r < regions_.all.size(); ++r)
          if (is_behind(g, r)) made[r] = bounds_some = true;
      if (said == Behind::kSolid && outline_[g].empty() && !bounds_some) result.unbounded.push_back(g);
      for (Index r = 0; r < regions_.all.size(); ++r) {
        if (!made[r]) continue;
        if (said != Behind::kOpen) result.makers[r].insert(g);
        if (said == Behind::kSolid) said_solid[r].insert(g);
        if (said == Behind::kOpen) said_open[r].insert(g);
      }
    }
    for (Index r = 0; r < regions_.all.size(); ++r)
      for (const Index solid : said_solid[r])
        for (const Index open : said_open[r]) result.contradictions.emplace(solid, open);
    return result;
  }

 private:
  bool has_back(Index g) const {
    return std::any_of(groups_[g].begin(), groups_[g].end(), [&](Index k) { return edges_[k].back_material >= 0; });
  }

  // Where the winding number of a closed group is `turn`; nothing if it is ever anything but that and 0, or never that.
  Marks inside(Index g, int turn) const {
    if (!is_closed(edges_, groups_[g])) return {};
    Marks marks(regions_.all.size());
    for (Index r = 0; r < regions_.all.size(); ++r) {
      const int number = winding(edges_, groups_[g], regions_.all[r].inside);
      if (number != 0 && number != turn) return {};
      marks[r] = number == turn;
    }
    return std::find(marks.begin(), marks.end(), 1) == marks.end() ? Marks() : marks;
  }

  bool is_on(Index piece, Index g) const {
    return std::any_of(lying_[piece].begin(), lying_[piece].end(),
                       [&](const Lying& lying) { return group_of_[lying.edge] == g; });
  }

  bool lies_in(Index room, Index solid) const {
    for (Index p = 0; p < lying_.size(); ++p) {
      if (!is_on(p, room)) continue;
      const Index left = regions_.left[p], right = regions_.right[p];
      if (room_[room][left] == room_[room][right]) continue;  // no wall: it goes there and back
      if (!outline_[solid][room_[room][left] ? left : right]) return false;
    }
    return true;
  }

  void take_rooms_from(Index solid, Marks& made, bool& has_room) const {
    if (outline_[solid].empty()) return;
    for (Index room = 0; room < groups_.size(); ++room) {
      if (room_[room].empty() || !lies_in(room, solid)) continue;
      has_room = true;
      for (Index r = 0; r < made.size(); ++r) made[r] = made[r] && !room_[room][r];
    }
  }

  // Does a back of g without material look into the region, which is bounded, and no front of it?
  bool is_behind(Index g, Index r) const {
    if (!regions_.all[r].is_bounded) return false;
    bool has_some_back = false;
    for (Index p = 0; p < lying_.size(); ++p)
      for (const Lying& lying : lying_[p]) {
        if (group_of_[lying.edge] != g) continue;
        const Index front = lying.is_forwards ? regions_.right[p] : regions_.left[p];
        const Index back = lying.is_forwards ? regions_.left[p] : regions_.right[p];
        if (front == r) return false;
        has_some_back |= back == r && edges_[lying.edge].back_material < 0;
      }
    return has_some_back;
  }

  const std::vector<InputSegment>& edges_;
  const Regions& regions_;
  const std::vector<std::vector<Lying>>& lying_;
  const Groups groups_;
  std::vector<Index> group_of_;        // of each edge
  std::vector<Marks> outline_, room_;  // by group: its inside, nothing if it is no outline of a solid (no room)
};

}  // namespace

Groups groups_of(const std::vector<InputSegment>& edges) {
  Groups groups;
  for (Index k = 0; k < edges.size(); ++k) {
    if (k == 0 || edges[k].group == kAlone || edges[k].group != edges[k - 1].group) groups.emplace_back();
    groups.back().push_back(k);
  }
  return groups;
}

bool is_closed(const std::vector<InputSegment>& edges, const std::vector<std::size_t>& group) {
  if (group.size() < 2) return false;
  for (Index k = 0; k < group.size(); ++k) {
    const InputSegment &e = edges[group[k]], &next = edges[group[(k + 1) % group.size()]];
    if (e.bx != next.ax || e.by != next.ay) return false;
  }
  return true;
}

Solids solids_of(const std::vector<InputSegment>& edges, const Regions& regions,
                 const std::vector<std::vector<Lying>>& lying_on_pieces) {
  return Finder(edges, regions, lying_on_pieces).find();
}

bool may_have_solids(const std::vector<InputSegment>& edges) {
  const Groups groups = groups_of(edges);
  return std::any_of(groups.begin(), groups.end(), [&](const std::vector<Index>& group) {
    return edges[group.front()].behind != Behind::kNothingSaid || is_closed(edges, group);
  });
}

}  // namespace hottel::oracle
