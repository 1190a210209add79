#include "tests/oracle/plane/regions.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace hottel::oracle {

namespace {

using Index = std::size_t;

bool is_upright(const Stretch& piece) { return piece.a.first == piece.b.first; }

mpq_class height(const Stretch& piece, const mpq_class& x) {
  const mpq_class share = (x - piece.a.first) / (piece.b.first - piece.a.first);
  return piece.a.second + share * (piece.b.second - piece.a.second);
}

// What lies between two neighbouring verticals: pieces from below, and one trapezoid more than pieces.
struct Slab {
  mpq_class middle;
  std::vector<Index> pieces;
  Index first_trapezoid;
};

class Trapezoids {
 public:
  explicit Trapezoids(const std::vector<Stretch>& pieces) : pieces_(pieces) {
    std::set<mpq_class> verticals;
    for (const Stretch& piece : pieces) verticals.insert({piece.a.first, piece.b.first});
    verticals_.assign(verticals.begin(), verticals.end());
    for (Index k = 0; k <= verticals_.size(); ++k) add_slab(k);
    root_.resize(count_);
    std::iota(root_.begin(), root_.end(), Index{0});
    for (Index k = 0; k < verticals_.size(); ++k) join_across(k);
  }

  Regions regions() {
    Regions result;
    std::map<Index, Index> number;  // of the region of a root
    for (const Slab& slab : slabs_)
      for (Index level = 0; level <= slab.pieces.size(); ++level) {
        const Index root = root_of(slab.first_trapezoid + level);
        const bool reaches_infinity =
            &slab == &slabs_.front() || &slab == &slabs_.back() || level == 0 || level == slab.pieces.size();
        const auto [place, is_new] = number.try_emplace(root, result.all.size());
        if (is_new) result.all.push_back({true, point_in(slab, level)});
        if (reaches_infinity) result.all[place->second].is_bounded = false;
      }
    for (Index k = 0; k < pieces_.size(); ++k) {
      const auto [left, right] = beside(k);
      result.left.push_back(number.at(root_of(left)));
      result.right.push_back(number.at(root_of(right)));
    }
    return result;
  }

 private:
  // The slab before vertical k.
  void add_slab(Index k) {
    Slab slab;
    slab.first_trapezoid = count_;
    if (k > 0 && k < verticals_.size()) {
      slab.middle = (verticals_[k - 1] + verticals_[k]) / 2;
      std::vector<std::pair<mpq_class, Index>> met;
      for (Index piece = 0; piece < pieces_.size(); ++piece)
        if (pieces_[piece].a.first <= verticals_[k - 1] && verticals_[k] <= pieces_[piece].b.first)
          met.emplace_back(height(pieces_[piece], slab.middle), piece);
      std::sort(met.begin(), met.end());
      for (const auto& entry : met) slab.pieces.push_back(entry.second);
    } else if (!verticals_.empty()) {
      slab.middle = k == 0 ? mpq_class(verticals_.front() - 1) : mpq_class(verticals_.back() + 1);
    }
    count_ += slab.pieces.size() + 1;
    slabs_.push_back(std::move(slab));
  }

  // The trapezoid of a slab that reaches the height y on one of its verticals x, where no piece is.
  Index at(const Slab& slab, const mpq_class& x, const mpq_class& y) const {
    const auto above = std::partition_point(slab.pieces.begin(), slab.pieces.end(),
                                            [&](Index piece) { return height(pieces_[piece], x) < y; });
    const auto level = static_cast<Index>(above - slab.pieces.begin());
    return slab.first_trapezoid + level;
  }

  void join_across(Index k) {
    const mpq_class& x = verticals_[k];
    std::set<mpq_class> heights;  // where a piece meets the vertical
    std::vector<const Stretch*> along;
    for (const Stretch& piece : pieces_) {
      if (is_upright(piece) && piece.a.first == x) {
        heights.insert({piece.a.second, piece.b.second});
        along.push_back(&piece);
      } else if (piece.a.first <= x && x <= piece.b.first) {
        heights.insert(height(piece, x));
      }
    }
    std::vector<mpq_class> between{*heights.begin() - 1};
    for (auto low = heights.begin(), high = std::next(low); high != heights.end(); ++low, ++high)
      between.push_back((*low + *high) / 2);
    between.push_back(*heights.rbegin() + 1);
    for (const mpq_class& y : between) {
      const bool is_shut = std::any_of(
          along.begin(), along.end(), [&](const Stretch* piece) { return piece->a.second < y && y < piece->b.second; });
      if (!is_shut) root_[root_of(at(slabs_[k], x, y))] = root_of(at(slabs_[k + 1], x, y));
    }
  }

  // The trapezoids on the left and the right of a piece.
  std::pair<Index, Index> beside(Index piece) const {
    const Stretch& p = pieces_[piece];
    const auto place = std::lower_bound(verticals_.begin(), verticals_.end(), p.a.first);
    const auto k = static_cast<Index>(place - verticals_.begin());
    if (is_upright(p)) {
      const mpq_class y = (p.a.second + p.b.second) / 2;
      return {at(slabs_[k], p.a.first, y), at(slabs_[k + 1], p.a.first, y)};
    }
    const Slab& slab = slabs_[k + 1];
    const auto level =
        static_cast<Index>(std::find(slab.pieces.begin(), slab.pieces.end(), piece) - slab.pieces.begin());
    return {slab.first_trapezoid + level + 1, slab.first_trapezoid + level};
  }

  std::pair<mpq_class, mpq_class> point_in(const Slab& slab, Index level) const {
    const auto piece_height = [&](Index k) { return height(pieces_[slab.pieces[k]], slab.middle); };
    if (slab.pieces.empty()) return {slab.middle, 0};
    if (level == 0) return {slab.middle, piece_height(0) - 1};
    if (level == slab.pieces.size()) return {slab.middle, piece_height(level - 1) + 1};
    return {slab.middle, (piece_height(level - 1) + piece_height(level)) / 2};
  }

  Index root_of(Index trapezoid) const {
    while (root_[trapezoid] != trapezoid) trapezoid = root_[trapezoid];
    return trapezoid;
  }

  const std::vector<Stretch>& pieces_;
  std::vector<mpq_class> verticals_;
  std::vector<Slab> slabs_;  // one more than verticals
  Index count_ = 0;
  std::vector<Index> root_;
};

}  // namespace

Regions regions_of(const std::vector<Stretch>& pieces) { return Trapezoids(pieces).regions(); }

}  // namespace hottel::oracle
