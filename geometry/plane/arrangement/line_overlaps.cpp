#include "geometry/plane/arrangement/line_overlaps.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "geometry/plane/arrangement/point_index.h"

namespace hottel {
namespace {

// Numbers the lines through segments.
class LineIndex {
 public:
  std::uint32_t insert(const Point2& p, const Point2& q) {
    if (p.x == q.x) return static_cast<std::uint32_t>(2 * vertical_.insert({p.x, 0}).index());
    const Rational slope = (q.y - p.y) / (q.x - p.x);
    return static_cast<std::uint32_t>(2 * others_.insert({slope, p.y - slope * p.x}).index() + 1);
  }

 private:
  PointIndex2 vertical_, others_;  // places of vertical lines; slope and height of the others
};

// One group of equal segments, from its lower to its upper end in lexicographic order.
struct Stretch {
  std::uint32_t line;
  VertexId low, high;
  std::uint32_t group;
};

// Where a stretch begins or ends on its line.
struct Change {
  VertexId at;
  std::uint32_t group;
  bool begins;
};

}  // namespace

EqualSegments2::EqualSegments2(const std::vector<Segment2>& segments) {
  const auto key = [&](std::uint32_t s) {
    const auto [a, b] = segments[s];
    return std::pair(std::min(a, b), std::max(a, b));
  };
  std::vector<std::uint32_t> order(segments.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t s, std::uint32_t t) {
    const auto a = key(s), b = key(t);
    return a != b ? a < b : s < t;
  });
  // By first member: next[s] is the member after s of its group.
  const auto none = static_cast<std::uint32_t>(segments.size());
  std::vector<std::uint32_t> next(segments.size(), none);
  std::vector<char> is_first(segments.size(), 1);
  for (std::size_t k = 1; k < order.size(); ++k)
    if (key(order[k - 1]) == key(order[k])) {
      next[order[k - 1]] = order[k];
      is_first[order[k]] = 0;
    }
  members_.reserve(segments.size());
  begin_.push_back(0);
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    if (!is_first[s]) continue;
    for (std::uint32_t member = s; member != none; member = next[member]) members_.push_back(member);
    begin_.push_back(static_cast<std::uint32_t>(members_.size()));
  }
}

std::vector<CoveredSegment2> cut_along_lines(const Vertices2& vertices, const std::vector<Segment2>& segments,
                                             const std::vector<std::span<const std::uint32_t>>& groups) {
  LineIndex lines;
  std::vector<Stretch> stretches;
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    const auto [a, b] = segments[groups[g].front()];
    const std::uint32_t line = lines.insert(vertices.exact(a), vertices.exact(b));
    const bool ascends = vertices.precedes(a, b);
    stretches.push_back({line, ascends ? a : b, ascends ? b : a, g});
  }
  std::stable_sort(stretches.begin(), stretches.end(),
                   [](const Stretch& s, const Stretch& t) { return s.line < t.line; });

  std::vector<CoveredSegment2> result;
  std::vector<Change> changes;
  std::set<std::uint32_t> covering;  // groups, from change to change
  const auto add = [&](VertexId low, VertexId high) {
    CoveredSegment2 part{{low, high}, {}};
    for (const std::uint32_t g : covering) part.sources.insert(part.sources.end(), groups[g].begin(), groups[g].end());
    std::sort(part.sources.begin(), part.sources.end());
    const Segment2& first = segments[part.sources.front()];
    if (!vertices.precedes(first.a, first.b)) std::swap(part.segment.a, part.segment.b);
    result.push_back(std::move(part));
  };
  for (auto begin = stretches.begin(); begin != stretches.end();) {
    changes.clear();
    for (const std::uint32_t line = begin->line; begin != stretches.end() && begin->line == line; ++begin) {
      changes.push_back({begin->low, begin->group, true});
      changes.push_back({begin->high, begin->group, false});
    }
    std::stable_sort(changes.begin(), changes.end(),
                     [&](const Change& c, const Change& d) { return c.at != d.at && vertices.precedes(c.at, d.at); });
    for (std::size_t k = 0; k < changes.size(); ++k) {
      if (k > 0 && changes[k].at != changes[k - 1].at && !covering.empty()) add(changes[k - 1].at, changes[k].at);
      if (changes[k].begins)
        covering.insert(changes[k].group);
      else
        covering.erase(changes[k].group);
    }
  }
  return result;
}

}  // namespace hottel
