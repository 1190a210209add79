#include "geometry/space/arrangement/merged_occluders.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace hottel {
namespace {

using Outline = std::vector<VertexId3>;

// Joins polygons, one after the other. The first of those joined keeps the outline of all.
class Joiner {
 public:
  explicit Joiner(const Occluders3& polygons) : polygons_(polygons), first_(polygons.size()) {
    std::iota(first_.begin(), first_.end(), 0u);
    const auto precedes = [&polygons](std::uint32_t s, std::uint32_t t) {
      const IntegerVector &a = polygons.exact_normal(s), &b = polygons.exact_normal(t);
      return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    std::map<std::uint32_t, std::uint32_t, decltype(precedes)> directions(precedes);
    for (std::uint32_t s = 0; s < polygons.size(); ++s) {
      direction_.push_back(directions.try_emplace(s, static_cast<std::uint32_t>(directions.size())).first->second);
      outlines_.emplace_back(polygons.outline(s).begin(), polygons.outline(s).end());
      set_owner(s);
    }
    for (std::uint32_t s = 0; s < polygons.size(); ++s)
      while (joins_one(s)) {
      }
  }

  std::uint32_t first(std::uint32_t s) const {
    while (first_[s] != s) s = first_[s];
    return s;
  }
  Outline& outline(std::uint32_t first) { return outlines_[first]; }

 private:
  // Of an edge: which way its polygon faces, and its ends in order.
  using Key = std::tuple<std::uint32_t, VertexId3, VertexId3>;

  static VertexId3 at(const Outline& outline, std::size_t k) { return outline[k % outline.size()]; }

  void set_owner(std::uint32_t s) {
    const Outline& outline = outlines_[s];
    for (std::size_t k = 0; k < outline.size(); ++k) owner_[Key{direction_[s], outline[k], at(outline, k + 1)}] = s;
  }

  // The sign of the turn at b.
  int turn(std::uint32_t s, VertexId3 a, VertexId3 b, VertexId3 c) const {
    return sgn(dot(polygons_.exact_normal(s), turn_at(polygons_.vertices(), a, b, c)));
  }

  // Joins one neighbour to what begins with s, if there is one: false where there is none.
  bool joins_one(std::uint32_t s) {
    const std::uint32_t p = first(s);
    const std::size_t count = outlines_[p].size();
    for (std::size_t k = 0; k < count; ++k) {
      const auto neighbour = owner_.find({direction_[p], at(outlines_[p], k + 1), outlines_[p][k]});
      if (neighbour != owner_.end() && neighbour->second != p && join(p, k, neighbour->second)) return true;
    }
    return false;
  }

  // Joins q to p along edge k of p, where the union is convex.
  bool join(std::uint32_t p, std::size_t k, std::uint32_t q) {
    const Outline &a = outlines_[p], &b = outlines_[q];
    const VertexId3 from = a[k], to = at(a, k + 1);
    const std::size_t n = a.size(), m = b.size();
    const auto place = static_cast<std::size_t>(std::find(b.begin(), b.end(), from) - b.begin());
    const int at_from = turn(p, at(a, k + n - 1), from, at(b, place + 1));
    const int at_to = turn(p, at(b, place + m - 2), to, at(a, k + 2));
    if (at_from < 0 || at_to < 0) return false;
    Outline whole;
    if (at_from > 0) whole.push_back(from);
    for (std::size_t i = 1; i + 1 < m; ++i) whole.push_back(at(b, place + i));
    if (at_to > 0) whole.push_back(to);
    for (std::size_t i = 2; i < n; ++i) whole.push_back(at(a, k + i));
    for (const std::uint32_t s : {p, q}) {
      const Outline& outline = outlines_[s];
      for (std::size_t i = 0; i < outline.size(); ++i) owner_.erase({direction_[s], outline[i], at(outline, i + 1)});
    }
    const auto [kept, dropped] = std::minmax(p, q);
    outlines_[kept] = std::move(whole);
    outlines_[dropped].clear();
    first_[dropped] = kept;
    set_owner(kept);
    return true;
  }

  const Occluders3& polygons_;
  std::vector<std::uint32_t> first_, direction_;
  std::vector<Outline> outlines_;
  std::map<Key, std::uint32_t> owner_;
};

}  // namespace

MergedOccluders3::MergedOccluders3(const Occluders3& polygons) : polygons_(polygons) {
  Joiner joiner(polygons);
  std::vector<Outline> outlines;
  surface_of_.resize(polygons.size());
  for (std::uint32_t s = 0; s < polygons.size(); ++s) {
    const std::uint32_t first = joiner.first(s);
    if (first == s) {
      surface_of_[s] = static_cast<std::uint32_t>(outlines.size());
      outlines.push_back(std::move(joiner.outline(s)));
      members_.emplace_back();
    } else {
      surface_of_[s] = surface_of_[first];
    }
    members_[surface_of_[s]].push_back(s);
  }
  if (outlines.size() < polygons.size()) merged_.emplace(polygons.vertices(), outlines);
}

}  // namespace hottel
