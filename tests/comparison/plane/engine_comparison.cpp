#include "tests/comparison/plane/engine_comparison.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/plane/exchange/closed_forms.h"
#include "geometry/plane/exchange/exchange.h"
#include "tests/oracle/plane/brute_force.h"

namespace hottel::oracle {

namespace {

constexpr unsigned kBits = 512;  // of the reference values

mpf_class value_of(const LengthSum& lengths) {
  mpf_class sum(0, kBits);
  for (const auto& [squared, coefficient] : lengths) sum += coefficient * sqrt(mpf_class(squared, kBits));
  return sum;
}

// Sign of a - b, where what is left at 400 bits is taken for equality.
int compare(const mpf_class& a, const mpf_class& b) {
  mpf_class tolerance(1, kBits);
  mpf_div_2exp(tolerance.get_mpf_t(), tolerance.get_mpf_t(), 400);
  const mpf_class difference(a - b, kBits);
  if (abs(difference) < tolerance) return 0;
  return sgn(difference);
}

mpf_class half_way(double a, double b) { return (mpf_class(a, kBits) + mpf_class(b, kBits)) / 2; }

// Is the double nearest to the real number, ties to even?
bool is_nearest(double rounded, const mpf_class& real) {
  const double below = std::nextafter(rounded, -HUGE_VAL), above = std::nextafter(rounded, HUGE_VAL);
  const bool is_even = std::fmod(std::scalbn(rounded, 52 - std::ilogb(rounded)), 2) == 0;
  const int low = compare(half_way(below, rounded), real), high = compare(half_way(rounded, above), real);
  return is_even ? low <= 0 && high >= 0 : low < 0 && high > 0;
}

std::string digits(const mpf_class& value) { return fmt::format("{:.17g}", value.get_d()); }

// The labels of the engine, and the label of each face of the oracle among them.
class Labelling {
 public:
  Labelling(const Scene2& scene, Granularity granularity) {
    std::vector<std::uint32_t> first_of_group(scene.groups.size(), kNone);
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
      const Surface& surface = scene.surfaces[s];
      const std::uint32_t set = granularity == Granularity::kGroup ? surface.group : s;
      std::uint32_t first = granularity == Granularity::kGroup ? first_of_group[surface.group] : kNone;
      const bool is_known = first != kNone;
      if (!is_known) first = count();
      first_of_group[surface.group] = first;
      const std::uint32_t parts = granularity == Granularity::kElement ? surface.elements : 1;
      const std::uint32_t backs = surface.back ? parts : 1,
                          first_back = first + (granularity == Granularity::kGroup ? 1 : parts);
      if (!is_known) {
        set_.insert(set_.end(), parts + backs, set);
        has_material_.insert(has_material_.end(), parts, 1);
        has_material_.insert(has_material_.end(), backs, 0);
      }
      for (std::uint32_t k = 0; k < parts; ++k) {
        of_.push_back(first + k);
        of_.push_back(first_back + (backs > 1 ? k : 0));
        if (surface.back) has_material_[of_.back()] = 1;
        set_of_edge_.push_back(set);
      }
    }
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(set_.size()); }
  bool has_material(std::uint32_t label) const { return has_material_[label] != 0; }
  // Which surfaces are kept for it: a surface, or those of a group.
  std::uint32_t set(std::uint32_t label) const { return set_[label]; }
  std::uint32_t set_of_edge(std::size_t edge) const { return set_of_edge_[edge]; }

  // The pieces with these labels; what is covered keeps its own.
  std::vector<Segment> relabelled(std::vector<Segment> pieces) const {
    for (Segment& piece : pieces)
      for (int* label : {&piece.left, &piece.right})
        if (*label >= 0) *label = static_cast<int>(of_[static_cast<std::size_t>(*label)]);
    return pieces;
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::vector<std::uint32_t> of_;           // by label of the oracle
  std::vector<std::uint32_t> set_;          // by label
  std::vector<char> has_material_;          // by label
  std::vector<std::uint32_t> set_of_edge_;  // by edge of the oracle
};

// One scene, both ways.
class Comparison {
 public:
  Comparison(const Scene2& scene, ComparisonCounts& counts, Granularity granularity, Hidden hidden)
      : granularity_(granularity),
        hidden_(hidden),
        counts_(counts),
        labelling_(scene, granularity),
        split_(split(to_edges(scene, divided()))),
        pieces_(labelling_.relabelled(split_.pieces)),
        measures_(exchange_measures(pieces_)),
        prepared_(prepare(scene, divided())),
        matrix_(exact_exchange(prepared_, {.granularity = granularity})),
        sky_(matrix_.sky()) {
    for (const Segment& piece : pieces_) {
      const Rational x = piece.bx - piece.ax, y = piece.by - piece.ay;
      for (const int label : {piece.left, piece.right}) ++length_[label][x * x + y * y];
    }
  }

  std::string run() {
    ++counts_.scenes;
    wrong_ = ownership_differs(prepared_, split_);
    demand(matrix_.size() == labelling_.count(), [&] { return fmt::format("{} labels", matrix_.size()); });
    for (const auto& measure : measures_) {
      const auto& pair = measure.first;
      demand((pair.first == kCovered) == (pair.second == kCovered) || exact_sum(measure.second).terms().empty(),
             [&pair] { return fmt::format("{} sees {} and one is in a solid", pair.first, pair.second); });
    }
    if (!wrong_.empty()) return wrong_;
    check_sums();
    for (std::uint32_t i = 0; i < matrix_.size(); ++i) {
      demand(matrix_.has_row(i) == has_row(i), [&] { return fmt::format("row {}: there or not", i); });
      if (matrix_.has_row(i) && has_row(i)) check_row(i);
    }
    if (hidden_ == Hidden::kYes) check_hidden();
    return wrong_;
  }

 private:
  Divided2 divided() const { return granularity_ == Granularity::kElement ? Divided2::kYes : Divided2::kNo; }

  template <class Message>
  void demand(bool holds, const Message& message) {
    if (!holds) wrong_ += message() + "\n";
  }

  // The oracle's label of an engine's label.
  int label(std::uint32_t i) const { return i == sky_ ? kInfinity : static_cast<int>(i); }

  bool has_row(std::uint32_t i) const { return i != sky_ && labelling_.has_material(i) && length_.contains(label(i)); }

  static const LengthSum& of_pair(const Measures& measures, int i, int j) {
    static const LengthSum nothing;
    const auto place = measures.find(std::minmax({i, j}));
    return place == measures.end() ? nothing : place->second;
  }
  const LengthSum& measure(std::uint32_t i, std::uint32_t j) const { return of_pair(measures_, label(i), label(j)); }

  void check_sums() {
    std::vector<hottel::ElementPair> pairs;
    for (std::uint32_t i = 0; i < sky_; ++i)
      for (std::uint32_t j = i; j <= sky_; ++j)
        if (has_row(i) || has_row(j)) pairs.emplace_back(i, j);
    const std::vector<RootSum> sums = exact_exchange_measures(prepared_, granularity_, pairs);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const std::uint32_t i = pairs[k].first, j = pairs[k].second;
      ++counts_.pairs;
      counts_.sums += !sums[k].is_zero();
      is_zero_[pairs[k]] = sums[k].is_zero();
      const ExactSum mine = to_exact_sum(sums[k] * Rational(2)), other = exact_sum(measure(i, j));
      demand(mine == other, [&] {
        return fmt::format("2 S({}, {}) = {}, the oracle has {}", i, j, mine.to_string(), other.to_string());
      });
    }
  }

  void check_row(std::uint32_t from) {
    const mpf_class twice_length(2 * value_of(length_.at(label(from))), kBits);
    auto entry = matrix_.row(from).begin();
    for (std::uint32_t to = 0; to <= sky_; ++to) {
      const bool is_listed = entry != matrix_.row(from).end() && entry->to == to;
      demand(is_listed != is_zero_.at(std::minmax({from, to})),
             [&] { return fmt::format("F({}, {}): an entry iff not zero", from, to); });
      if (!is_listed) {
        ++counts_.zeros;
        continue;
      }
      check_factor(from, to, entry->factor, mpf_class(value_of(measure(from, to)) / twice_length, kBits));
      if (to == sky_)
        demand(entry->visibility == entry->factor.value, [&] { return fmt::format("Vis({}, sky) is not F", from); });
      else
        check_visibility(entry->visibility, from, to);
      ++entry;
    }
  }

  void check_factor(std::uint32_t from, std::uint32_t to, const Rounded& factor, const mpf_class& real) {
    ++counts_.factors;
    const int side = compare(real, mpf_class(factor.value, kBits));
    counts_.doubles += side == 0;
    const Enclosure enclosure = factor.enclosure();
    const bool contains = compare(mpf_class(enclosure.lower, kBits), real) <= 0 &&
                          compare(mpf_class(enclosure.upper, kBits), real) >= 0 && enclosure.contains(factor.value);
    const bool is_narrow = enclosure.upper <= std::nextafter(enclosure.lower, 2.0);
    demand(is_nearest(factor.value, real) && factor.side == side && contains && is_narrow, [&] {
      return fmt::format("F({}, {}) = {} on side {}, the oracle has {}", from, to, factor.value, factor.side,
                         digits(real));
    });
  }

  // 2 S0, by the brute force on the pieces that lie on a surface of i or j, all others taken away. All labels of the
  // same surfaces are measured at once; what belongs to none of them is black.
  const LengthSum& free_measure(std::uint32_t i, std::uint32_t j) {
    const auto [first, second] = std::minmax({labelling_.set(i), labelling_.set(j)});
    const auto [place, is_new] = alone_.try_emplace({first, second});
    if (is_new) {
      std::vector<Segment> kept;
      for (std::size_t p = 0; p < pieces_.size(); ++p) {
        const auto is_of_either = [&, low = first, high = second](std::uint32_t set) {
          return set == low || set == high;
        };
        if (std::none_of(split_.lying[p].begin(), split_.lying[p].end(),
                         [&](const Lying& lying) { return is_of_either(labelling_.set_of_edge(lying.edge)); }))
          continue;
        Segment piece = pieces_[p];
        for (int* label : {&piece.left, &piece.right})
          if (*label >= 0 && !is_of_either(labelling_.set(static_cast<std::uint32_t>(*label)))) *label = kCovered;
        kept.push_back(piece);
      }
      place->second = exchange_measures(kept);
    }
    return of_pair(place->second, label(i), label(j));
  }

  void check_visibility(double visibility, std::uint32_t from, std::uint32_t to) {
    ++counts_.visibilities;
    const mpf_class real(value_of(measure(from, to)) / value_of(free_measure(from, to)), kBits);
    const bool is_whole = compare(real, mpf_class(1, kBits)) == 0;
    const double largest = std::nextafter(1.0, 0.0);  // of what is hidden in part
    const bool is_rounded = visibility == largest ? compare(real, half_way(std::nextafter(largest, 0.0), largest)) > 0
                                                  : is_nearest(visibility, real);
    demand(visibility > 0 && visibility <= 1 && (visibility == 1) == is_whole && is_rounded,
           [&] { return fmt::format("Vis({}, {}) = {}, the oracle has {}", from, to, visibility, digits(real)); });
  }

  void check_hidden() {
    const std::vector<hottel::ElementPair> found = hidden_pairs(prepared_, granularity_, matrix_);
    std::vector<hottel::ElementPair> expected;
    for (std::uint32_t i = 0; i < sky_; ++i)
      for (std::uint32_t j = 0; j <= sky_; ++j)
        if (has_row(i) && is_zero_.at(std::minmax({i, j})) &&
            (j == sky_ || !exact_sum(free_measure(i, j)).terms().empty()))
          expected.emplace_back(i, j);
    counts_.hidden += expected.size();
    demand(found == expected,
           [&] { return fmt::format("{} hidden pairs, the oracle has {}", found.size(), expected.size()); });
  }

  const Granularity granularity_;
  const Hidden hidden_;
  ComparisonCounts& counts_;
  Labelling labelling_;
  Split split_;
  std::vector<Segment> pieces_;  // with labels of the engine
  Measures measures_;
  PreparedScene2 prepared_;
  ExchangeMatrix matrix_;
  std::uint32_t sky_;
  std::map<int, LengthSum> length_;  // by label, as lengths of owned pieces
  std::map<hottel::ElementPair, bool> is_zero_;
  std::map<hottel::ElementPair, Measures> alone_;  // by pair of sets
  std::string wrong_;
};

}  // namespace

ExactSum to_exact_sum(const RootSum& sum) {
  ExactSum result;
  for (const RootSum::Term& term : sum.terms()) result.add(term.coefficient, Rational(term.radicand));
  return result;
}

std::string disagreement(const Scene2& scene, ComparisonCounts& counts, Granularity granularity, Hidden hidden) {
  return Comparison(scene, counts, granularity, hidden).run();
}

}  // namespace hottel::oracle
