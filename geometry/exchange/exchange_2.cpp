#include "geometry/exchange/exchange_2.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "geometry/exchange/exchange_sums_2.h"
#include "geometry/exchange/unobstructed_2.h"
#include "kernel/failure.h"

namespace hottel {
namespace {

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

constexpr double kNotAsked = std::numeric_limits<double>::quiet_NaN();

// "Below 1 whenever something hides a part", above 0 always: a quotient that would round to 1 from below or to 0 from
// above keeps its distance.
double visibility_of(const Rounded& quotient) {
  if (quotient.value == 1.0 && quotient.side < 0) return std::nextafter(1.0, 0.0);
  if (quotient.value == 0.0 && quotient.side > 0) return std::numeric_limits<double>::denorm_min();
  return quotient.value;
}

// S0(i, j) of two labels (neither the sky) in scene units: everything but the two taken away.
RootSum unobstructed_exchange(const PreparedScene2& prepared, const Labels2& labels, Per per, std::uint32_t i,
                              std::uint32_t j) {
  const Vertices2& vertices = prepared.arrangement.vertices();
  RootSum sum;
  if (per != Per::kGroup) {
    for (const Segment2& f : labels.runs(i))
      for (const Segment2& g : labels.runs(j)) sum += unobstructed_exact(vertices, f, g);
    sum *= vertices.scale() / 2;
    return sum;
  }
  // Two groups alone: a scene of its own.
  const std::uint32_t group[2] = {prepared.scene.surfaces[labels.elements()[i].surface].group,
                                  prepared.scene.surfaces[labels.elements()[j].surface].group};
  Scene2 alone = prepared.scene;
  std::erase_if(alone.surfaces, [&](const Surface2& s) { return s.group != group[0] && s.group != group[1]; });
  const PreparedScene2 two = prepare(std::move(alone));
  const Labels2 two_labels(two.scene, two.arrangement, two.division, per);
  LabelPair pair{0, 0};
  for (std::uint32_t label = 0; label < two_labels.count(); ++label) {
    if (two_labels.elements()[label].name == labels.elements()[i].name) pair.first = label;
    if (two_labels.elements()[label].name == labels.elements()[j].name) pair.second = label;
  }
  return exact_exchange_measures(two, per, {pair}).front();
}

// What is printed of one pair, and what the fixed-point sums could not settle.
struct RoundedPair {
  Rounded forth, back;
  double visibility = kNotAsked;
  double measure = kNotAsked;
  bool is_forth_open = false, is_back_open = false, is_visibility_open = false, is_measure_open = false,
       is_zero = false;

  bool is_open() const { return is_forth_open || is_back_open || is_visibility_open || is_measure_open; }
};

// Rounds pair sums, by fixed point where that settles it.
class Rounding {
 public:
  Rounding(const PreparedScene2& prepared, const Labels2& labels, const ExchangeOptions2& options)
      : prepared_(prepared),
        labels_(labels),
        options_(options),
        half_unit_(prepared.arrangement.vertices().fixed_unit() * prepared.arrangement.vertices().scale() / 2) {}

  RoundedPair quick(const PairSum& pair, TierCounts& tiers) const {
    const Vertices2& vertices = prepared_.arrangement.vertices();
    const FixedSum sum = pair.sum(vertices.length_error());
    RoundedPair result;
    // A sum that may be zero is looked at exactly before anything is printed of it.
    const bool may_be_zero = static_cast<double>(pair.value) <= sum.error;
    const auto settle = [&](const FixedSum& divisor, Rounded& number, bool& is_open) {
      const bool is_coarse = may_be_zero || static_cast<double>(divisor.value) <= divisor.error;
      const auto rounded = is_coarse ? std::nullopt : round_quotient(sum, divisor);
      is_open = !rounded;
      if (!rounded) return;
      number = rounded->number;
      tiers.count(rounded->tier);
    };
    if (labels_.has_row(pair.i)) settle(twice(labels_.length(pair.i)), result.forth, result.is_forth_open);
    if (labels_.has_row(pair.j)) settle(twice(labels_.length(pair.j)), result.back, result.is_back_open);
    if (options_.wants_measures) {
      const auto rounded = may_be_zero ? std::nullopt : round_scaled(sum, half_unit_);
      result.is_measure_open = !rounded;
      if (rounded) result.measure = rounded->number.value;
    }
    if (!options_.wants_visibility || pair.j == labels_.sky()) return result;
    if (options_.per == Per::kGroup) {
      result.is_visibility_open = true;
    } else if (!pair.is_obstructed && !may_be_zero) {
      result.visibility = 1;
      tiers.count(Tier::kDouble);
    } else {
      Rounded visibility;
      const auto free = unobstructed(pair);
      if (free && static_cast<double>(free->value) > free->error)
        settle(*free, visibility, result.is_visibility_open);
      else
        result.is_visibility_open = true;
      result.visibility = visibility_of(visibility);
    }
    return result;
  }

  // Settles what quick() left open, from 2 S(i, j) in integer form.
  void exactly(const PairSum& pair, const RootSum& sum, RoundedPair& result, TierCounts& tiers) const {
    const Vertices2& vertices = prepared_.arrangement.vertices();
    if (sum.is_zero()) {
      result = {};
      result.is_zero = true;
      return;
    }
    const auto settle = [&](std::uint32_t label) {
      const RoundedByTier rounded = round_quotient(sum, labels_.exact_length(label, vertices) * Rational(2));
      tiers.count(rounded.tier);
      return rounded.number;
    };
    if (result.is_forth_open) result.forth = settle(pair.i);
    if (result.is_back_open) result.back = settle(pair.j);
    if (result.is_measure_open)
      result.measure = round_quotient(sum * (vertices.scale() / 2), RootSum(Rational(1))).number.value;
    if (!result.is_visibility_open) return;
    const RootSum free =
        unobstructed_exchange(prepared_, labels_, options_.per, pair.i, pair.j) * (Rational(2) / vertices.scale());
    if ((free - sum).is_zero()) {
      result.visibility = 1;
      tiers.count(Tier::kRootSum);
    } else {
      const RoundedByTier rounded = round_quotient(sum, free);
      tiers.count(rounded.tier);
      result.visibility = visibility_of(rounded.number);
    }
  }

 private:
  static FixedSum twice(const FixedSum& sum) { return {2 * sum.value, 2 * sum.error}; }

  std::optional<FixedSum> unobstructed(const PairSum& pair) const {
    FixedSum total;
    for (const Segment2& f : labels_.runs(pair.i))
      for (const Segment2& g : labels_.runs(pair.j)) {
        const auto sum = unobstructed_sum(prepared_.arrangement.vertices(), f, g);
        if (!sum) return std::nullopt;
        total.value += sum->value;
        total.error += sum->error;
      }
    return total;
  }

  const PreparedScene2& prepared_;
  const Labels2& labels_;
  const ExchangeOptions2& options_;
  const FixedScale half_unit_;  // 2 S in fixed point to S in scene units
};

// Every pair of faces as if nothing stood between them. COST: O(n²) strings.
std::vector<PairSum> sum_all_pairs(const Arrangement2& arrangement, const Labels2& labels) {
  const Vertices2& vertices = arrangement.vertices();
  std::vector<PairSum> pairs;
  for (std::uint32_t i = 0; i < labels.count(); ++i)
    for (std::uint32_t j = i; j < labels.count(); ++j) {
      if (!labels.has_row(i) || !labels.has_row(j)) continue;
      PairSum pair{i, j, 0, false, 0};
      for (const Segment2& f : labels.runs(i))
        for (const Segment2& g : labels.runs(j)) {
          const auto sum = unobstructed_sum(vertices, f, g);
          HOTTEL_REQUIRE(sum.has_value());
          pair.value += sum->value;
          pair.inexact += static_cast<std::uint32_t>(std::lround(sum->error / vertices.length_error()));
        }
      if (pair.value != 0 || pair.inexact != 0) pairs.push_back(pair);
    }
  return pairs;
}

// A face that sees one thing only sees it with factor 1, by closure: no arithmetic is needed to know it.
void settle_lonely_rows(const std::vector<PairSum>& pairs, const Labels2& labels, std::vector<RoundedPair>& rounded) {
  std::vector<std::uint32_t> partners(labels.count() + 1, 0);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    ++partners[pairs[k].i];
    if (pairs[k].i != pairs[k].j) ++partners[pairs[k].j];
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    RoundedPair& pair = rounded[k];
    if (pair.is_forth_open && partners[pairs[k].i] == 1) {
      pair.forth = {1.0, 0};
      pair.is_forth_open = false;
    }
    if (pair.is_back_open && pairs[k].j != labels.sky() && partners[pairs[k].j] == 1) {
      pair.back = {1.0, 0};
      pair.is_back_open = false;
    }
  }
}

ExchangeMatrix to_matrix(const Labels2& labels, const std::vector<PairSum>& pairs,
                         const std::vector<RoundedPair>& rounded, bool with_measures) {
  ExchangeMatrix matrix(labels.elements(), Guarantee::kExact);
  std::vector<std::size_t> begin(labels.count() + 1, 0);
  const auto each_entry = [&](const auto& visit) {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (rounded[k].is_zero) continue;
      const auto [i, j] = std::pair(pairs[k].i, pairs[k].j);
      if (labels.has_row(i)) visit(i, j, rounded[k].forth, rounded[k]);
      if (j != i && labels.has_row(j)) visit(j, i, rounded[k].back, rounded[k]);
    }
  };
  each_entry([&](std::uint32_t from, std::uint32_t, const Rounded&, const RoundedPair&) { ++begin[from + 1]; });
  for (std::uint32_t i = 0; i < labels.count(); ++i) begin[i + 1] += begin[i];
  std::vector<FactorEntry> entries(begin.back());
  std::vector<double> measures(with_measures ? begin.back() : 0);
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  each_entry([&](std::uint32_t from, std::uint32_t to, const Rounded& factor, const RoundedPair& pair) {
    const std::size_t place = next[from]++;
    entries[place] = {to, factor, to == labels.sky() ? factor.value : pair.visibility};
    if (with_measures) measures[place] = pair.measure;
  });
  matrix.assign(std::move(begin), std::move(entries), std::move(measures));
  return matrix;
}

}  // namespace

PreparedScene2 prepare(Scene2 scene, Divided divided) {
  Stopwatch watch;
  Division division;
  for (const Surface2& surface : scene.surfaces) division.push_back(divided == Divided::kYes ? surface.elements : 1);
  Arrangement2 arrangement(scene, division);
  PreparedScene2 prepared{std::move(scene), std::move(division), std::move(arrangement), 0};
  prepared.seconds = watch.lap();
  return prepared;
}

bool is_convex_room(const Scene2& scene) {
  const std::size_t n = scene.surfaces.size();
  if (n < 3) return false;
  // A clockwise closed chain is convex iff it never turns left and its direction goes around once: the sign of its
  // direction along x then changes twice.
  int changes = 0, last = 0, first = 0;
  bool turns = false;
  for (std::size_t k = 0; k < n; ++k) {
    const Surface2 &surface = scene.surfaces[k], &next = scene.surfaces[(k + 1) % n];
    if (surface.back || !(surface.to == next.from)) return false;
    const Rational dx = surface.to.x - surface.from.x, dy = surface.to.y - surface.from.y;
    const Rational ex = next.to.x - next.from.x, ey = next.to.y - next.from.y;
    const Rational turn = dx * ey - dy * ex;
    if (turn > 0 || (turn == 0 && dx * ex + dy * ey < 0)) return false;
    turns |= turn < 0;
    const int sign = sgn(dx);
    if (sign == 0) continue;
    if (last != 0 && sign != last) ++changes;
    if (first == 0) first = sign;
    last = sign;
  }
  if (last != first) ++changes;
  return turns && changes == 2;
}

ExchangeMatrix exact_exchange(const PreparedScene2& prepared, const ExchangeOptions2& options, ExchangeReport* report) {
  Stopwatch watch;
  ExchangeReport ignored;
  ExchangeReport& r = report != nullptr ? *report : ignored;
  const Arrangement2& arrangement = prepared.arrangement;
  const Labels2 labels(prepared.scene, arrangement, prepared.division, options.per);
  r.seconds["prepare"] = prepared.seconds;
  r.seconds["label"] = watch.lap();

  std::uint64_t most_pairs = std::numeric_limits<std::uint64_t>::max();
  if (options.memory > 0) {
    most_pairs = options.memory / kBytesPerPair;
    if (const std::uint64_t pairs = estimated_pairs(arrangement, labels); pairs > most_pairs)
      throw RequestError("about " + std::to_string(pairs) + " visible pairs need about " +
                         std::to_string(pairs * kBytesPerPair) + " bytes; allowed are " +
                         std::to_string(options.memory));
  }
  SumCounts counts;
  const std::vector<PairSum> pairs = options.occlusion
                                         ? sum_visible_pairs(arrangement, labels, options.progress, most_pairs, counts)
                                         : sum_all_pairs(arrangement, labels);
  r.seconds[options.occlusion ? "sweep" : "strings"] = watch.lap();
  r.closure_is_exact = closure_defect(pairs, labels) == 0;
  HOTTEL_REQUIRE(r.closure_is_exact);

  const Rounding rounding(prepared, labels, options);
  std::vector<RoundedPair> rounded(pairs.size());
  tbb::enumerable_thread_specific<TierCounts> tiers;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pairs.size(), 256), [&](const auto& range) {
    for (std::size_t k = range.begin(); k != range.end(); ++k) rounded[k] = rounding.quick(pairs[k], tiers.local());
  });
  settle_lonely_rows(pairs, labels, rounded);
  r.seconds["round"] = watch.lap();

  std::vector<std::size_t> open;
  std::vector<LabelPair> open_pairs;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (rounded[k].is_open()) {
      open.push_back(k);
      open_pairs.emplace_back(pairs[k].i, pairs[k].j);
    }
  if (!open.empty()) {
    const std::vector<RootSum> sums = exact_sums(arrangement, labels, open_pairs);
    tbb::parallel_for(std::size_t{0}, open.size(), [&](std::size_t k) {
      rounding.exactly(pairs[open[k]], sums[k], rounded[open[k]], tiers.local());
    });
  }
  for (const TierCounts& some : tiers) r.tiers += some;
  r.seconds["exact"] = watch.lap();

  r.surfaces = prepared.scene.surfaces.size();
  r.vertices = arrangement.vertices().size();
  r.pieces = arrangement.pieces().size();
  r.elements = labels.count();
  r.pairs = static_cast<std::uint64_t>(
      std::count_if(rounded.begin(), rounded.end(), [](const auto& pair) { return !pair.is_zero; }));
  r.gaps = counts.gaps;
  r.terms = counts.updates;
  ExchangeMatrix matrix = to_matrix(labels, pairs, rounded, options.wants_measures);
  r.seconds["matrix"] = watch.lap();
  return matrix;
}

std::vector<RootSum> exact_exchange_measures(const PreparedScene2& prepared, Per per,
                                             const std::vector<LabelPair>& pairs) {
  const Labels2 labels(prepared.scene, prepared.arrangement, prepared.division, per);
  std::vector<RootSum> sums = exact_sums(prepared.arrangement, labels, pairs);
  for (RootSum& sum : sums) sum *= prepared.arrangement.vertices().scale() / 2;
  return sums;
}

ExactPair2 exact_pair(const PreparedScene2& prepared, Per per, std::uint32_t from, std::uint32_t to) {
  const Labels2 labels(prepared.scene, prepared.arrangement, prepared.division, per);
  const Vertices2& vertices = prepared.arrangement.vertices();
  ExactPair2 result;
  result.exchange = exact_exchange_measures(prepared, per, {{std::min(from, to), std::max(from, to)}}).front();
  result.area_from = labels.exact_length(from, vertices) * vertices.scale();
  if (to == labels.sky()) {
    result.unobstructed = result.area_from;
  } else {
    result.area_to = labels.exact_length(to, vertices) * vertices.scale();
    result.unobstructed = unobstructed_exchange(prepared, labels, per, from, to);
  }
  return result;
}

std::vector<RootSum> exact_areas(const PreparedScene2& prepared, Per per) {
  const Labels2 labels(prepared.scene, prepared.arrangement, prepared.division, per);
  const Vertices2& vertices = prepared.arrangement.vertices();
  std::vector<RootSum> areas;
  for (std::uint32_t label = 0; label < labels.count(); ++label)
    areas.push_back(labels.exact_length(label, vertices) * vertices.scale());
  return areas;
}

std::vector<LabelPair> hidden_pairs(const PreparedScene2& prepared, Per per, const ExchangeMatrix& matrix) {
  const Labels2 labels(prepared.scene, prepared.arrangement, prepared.division, per);
  const Vertices2& vertices = prepared.arrangement.vertices();
  const auto would_exchange = [&](std::uint32_t i, std::uint32_t j) {
    if (per == Per::kGroup) return !unobstructed_exchange(prepared, labels, per, i, j).is_zero();
    for (const Segment2& f : labels.runs(i))
      for (const Segment2& g : labels.runs(j))
        if (face_each_other(vertices, f, g)) return true;
    return false;
  };
  std::vector<LabelPair> result;
  for (std::uint32_t i = 0; i < labels.count(); ++i) {
    if (!matrix.has_row(i)) continue;
    const auto row = matrix.row(i);
    auto entry = row.begin();
    for (std::uint32_t j = 0; j < labels.count(); ++j) {
      while (entry != row.end() && entry->to < j) ++entry;
      if (entry != row.end() && entry->to == j) continue;
      if (would_exchange(i, j)) result.emplace_back(i, j);
    }
    if (row.empty() || row.back().to != labels.sky()) result.emplace_back(i, labels.sky());
  }
  return result;
}

}  // namespace hottel
