#include "geometry/space/exchange/exchange_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "geometry/memory_text.h"
#include "geometry/space/exchange/exchange_memory.h"
#include "geometry/space/exchange/groups_alone.h"
#include "geometry/space/exchange/pair_names.h"
#include "geometry/space/exchange/pair_sums.h"
#include "geometry/space/exchange/require_measured.h"
#include "geometry/space/exchange/rest_for_sky.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"

namespace hottel {
namespace {

// The pairs of so many bytes that the memory holds beside the elements. Throws RequestError where these are too many.
std::uint64_t most_pairs(const Scene3& scene, const ExchangeRequest& request, std::uint64_t each) {
  const std::uint64_t elements = element_counts(scene, request.granularity).all, memory = request.memory;
  if (memory == 0) return std::numeric_limits<std::uint64_t>::max();
  if (elements > memory / kBytesPerElement3) refuse_memory(scene, elements, "elements", kBytesPerElement3, memory);
  if (each == 0) return std::numeric_limits<std::uint64_t>::max();
  return (memory - elements * kBytesPerElement3) / each;
}

// Where all pairs there are of the chosen rows would be too many, it is estimated how many of all see each other.
void require_room_for_pairs(const PreparedScene3& prepared, const ElementTable3& table,
                            const std::vector<char>& is_chosen, std::uint64_t most, std::uint64_t each,
                            std::uint64_t memory) {
  const double patches = static_cast<double>(table.parts().size());
  const auto chosen = static_cast<double>(
      std::ranges::count_if(table.parts(), [&](const auto& part) { return is_chosen[part.label] != 0; }));
  if (std::min(patches / 2, chosen) * patches <= static_cast<double>(most)) return;
  if (const std::uint64_t pairs = estimated_pairs(prepared, table); pairs > most)
    refuse_memory(prepared.scene, pairs, "visible pairs", each, memory);
}

// How many threads may measure pairs, one at least: what they take is within what the pairs of this many patches leave
// of the memory, or within half of it.
std::uint64_t most_threads(std::uint64_t elements, std::uint64_t patches, std::uint64_t memory) {
  if (memory == 0) return std::numeric_limits<std::uint64_t>::max();
  const auto allowed = static_cast<double>(memory), count = static_cast<double>(patches);
  const double tables = static_cast<double>(elements) * kBytesPerElement3 + count * count / 2 * kBytesPerPair3;
  return static_cast<std::uint64_t>(std::max(1.0, std::max(allowed - tables, allowed / 2) / kBytesPerThread3));
}

// Measures S0 of the pairs that need it, of elements of several patches: the others have it, or nothing hides anything.
void measure_groups_alone(const PreparedScene3& prepared, const ElementTable3& table, double tolerance,
                          std::span<PairSum3> pairs) {
  const GroupsAlone3 groups(prepared, table, tolerance);
  parallel_for(pairs.size(), [&](std::size_t k) {
    PairSum3& pair = pairs[k];
    const bool is_known = pair.j == table.sky() || pair.is_zero() || pair.is_whole || pair.alone != 0;
    if (is_known || (table.is_one_patch(pair.i) && table.is_one_patch(pair.j))) return;
    pair.is_whole = groups.is_undisturbed(pair.i, pair.j);
    if (!pair.is_whole) pair.alone = groups.measure(pair.i, pair.j).value;
  });
}

// Areas are doubles in the unit of PairIntegrator3, where the scene is 2^53 large at most.
void require_areas(const ElementTable3& table) {
  constexpr double kLeastArea = 0x1p-900;
  for (std::uint32_t i = 0; i < table.count(); ++i)
    if (table.has_row(i) && !(table.extent(i).enclosure().lower >= kLeastArea))
      throw RequestError(fmt::format("{} is too small: surfaces may be 1e150 times smaller than the scene",
                                     quoted_name(table.elements()[i].name)));
}

// All pairs, in order.
class PairsOfAllRows final : public PairSource3 {
 public:
  PairsOfAllRows(std::uint32_t rows, std::vector<PairSum3> pairs) : cuts_(rows, 1), pairs_(std::move(pairs)) {}

  const RowCuts& cuts() override { return cuts_; }
  std::vector<PairSum3> pairs(std::size_t) override { return std::move(pairs_); }

 private:
  RowCuts cuts_;
  std::vector<PairSum3> pairs_;
};

}  // namespace

ExchangeRows3::ExchangeRows3(const PreparedScene3& prepared, const ExchangeRequest& request, PairKeeper3* keeper)
    : prepared_(prepared),
      request_(request),
      keeper_(keeper),
      most_(most_pairs(prepared.scene, request, keeper != nullptr ? keeper->bytes_per_pair() : kBytesPerPair3)),
      table_(*prepared.elements(request.granularity)),
      is_chosen_(table_.count() + std::size_t{1}, 0),
      has_come_(is_chosen_),
      checks_(request.sky == SkyBy::kClosure ? checks_of_sky(table_) : std::vector<char>()) {
  HOTTEL_REQUIRE(request.tolerance > 0);
  Stopwatch watch;
  for (const std::uint32_t i : request.rows.labels(table_.elements())) is_chosen_[i] = 1;
  require_areas(table_);
  require_room_for_pairs(prepared, table_, is_chosen_, most_,
                         keeper != nullptr ? keeper->bytes_per_pair() : kBytesPerPair3, request.memory);
  if (keeper != nullptr) hand_on([this](std::span<const PairSum3> pairs, const PairRanges&) { keep(pairs); });
  for (std::uint32_t i = 0; i < table_.count(); ++i) missing_ += is_asked(i) ? 1 : 0;
  report_.seconds["prepare"] = prepared.seconds;
  report_.seconds["label"] = watch.lap();
}

void ExchangeRows3::measure(const PairTurn3& turn, const std::function<void(double)>& progress) {
  const DefaultFloatingPoint arithmetic;
  Stopwatch watch;
  std::optional<ThreadLimit> limit;
  const std::uint64_t threads = most_threads(table_.count(), table_.parts().size(), request_.memory);
  if (threads < static_cast<std::uint64_t>(threads_allowed())) limit.emplace(static_cast<int>(threads));
  ExchangeReport3 counts = report_;
  PairSums3 sums = sum_pairs(prepared_, table_,
                             {.tolerance = request_.tolerance,
                              .proves = request_.proves,
                              .wants_visibility = request_.wants_visibility,
                              .most_pairs = most_ - std::min<std::uint64_t>(most_, pairs_.size() + kept_),
                              .progress = progress,
                              .turn = &turn,
                              .shared = request_.granularity,
                              .sink = sink_,
                              .has_sink_alone = keeper_ != nullptr,
                              .between = between_},
                             counts);
  const auto is_of_sky = [this](const FailedPair3& failure) { return failure.j == table_.sky(); };
  const auto of_others = std::stable_partition(sums.failures.begin(), sums.failures.end(), is_of_sky);
  require_measured(prepared_, table_, request_.tolerance, {of_others, sums.failures.end()});
  without_sky_.insert(without_sky_.end(), sums.failures.begin(), of_others);
  report_ = std::move(counts);
  report_.seconds["pairs"] += watch.lap();
  if (keeper_ != nullptr)
    keep(sums.pairs);
  else if (pairs_.empty())
    pairs_ = std::move(sums.pairs);
  else
    pairs_.insert(pairs_.end(), sums.pairs.begin(), sums.pairs.end());
}

std::span<const PairSum3> ExchangeRows3::add(std::span<const std::uint32_t> labels,
                                             const std::function<void(double)>& progress) {
  std::vector<char> is_now(has_come_.size(), 0);
  for (const std::uint32_t label : labels) is_now[label] = is_missing(label);
  const std::size_t before = pairs_.size();
  measure({.is_now = is_now,
           .was_before = has_come_,
           .known = known_.elements() == 0 ? nullptr : &known_,
           .with_sky = is_by_closure() ? &checks_ : nullptr},
          progress);
  for (std::uint32_t i = 0; i < table_.count(); ++i) {
    if (is_now[i] == 0) continue;
    has_come_[i] = 1;
    --missing_;
  }
  measure_skies();
  return std::span(pairs_).subspan(before);
}

// Those that exchange light. What has no sum within the tolerance is among them: such pairs are refused, or are with
// the sky and replaced.
void ExchangeRows3::keep(std::span<const PairSum3> pairs) {
  std::vector<PairSum3> some;
  std::ranges::copy_if(pairs, std::back_inserter(some), [](const PairSum3& pair) { return !pair.is_zero(); });
  kept_ += some.size();
  keeper_->keep(some);
}

// By label: whose sky factor has to be integrated although closure was asked for.
std::vector<char> ExchangeRows3::skies_left() {
  if (keeper_ == nullptr) return skies_to_integrate(table_, request_.tolerance, pairs_);
  std::vector<char> left(is_chosen_.size(), 0);
  for (std::size_t k = 0; k < keeper_->cuts().count(); ++k) {
    const std::vector<char> here = skies_to_integrate(table_, request_.tolerance, keeper_->pairs(k));
    const RowRange rows = keeper_->cuts().range(k);
    std::copy(here.begin() + rows.first, here.begin() + rows.end, left.begin() + rows.first);
  }
  return left;
}

// By closure, when all other pairs are there.
void ExchangeRows3::measure_skies() {
  if (!is_by_closure() || missing_ > 0 || has_skies_) return;
  const DefaultFloatingPoint arithmetic;
  std::vector<char> left = skies_left();
  for (std::uint32_t i = 0; i < table_.count(); ++i) left[i] = is_chosen_[i] != 0 ? left[i] : 0;
  const std::vector<char> none(left.size(), 0);
  if (std::ranges::find(left, 1) != left.end())
    measure({.is_now = left,
             .was_before = none,
             .known = known_.elements() == 0 ? nullptr : &known_,
             .with_sky = &left,
             .is_of_sky_alone = true},
            {});
  has_skies_ = true;
}

void ExchangeRows3::add_all(const std::function<void(double)>& progress) {
  std::vector<std::uint32_t> labels;
  for (std::uint32_t i = 0; i < table_.count(); ++i)
    if (is_missing(i)) labels.push_back(i);
  add(labels, progress);
}

void ExchangeRows3::take(std::vector<PairSum3> pairs, PairRanges known) {
  HOTTEL_REQUIRE(pairs_.empty() && known.elements() == table_.count());
  pairs_ = std::move(pairs);
  known_ = std::move(known);
  if (!known_.has_all()) return;
  for (std::uint32_t i = 0; i < table_.count(); ++i) has_come_[i] = is_asked(i) ? 1 : 0;
  missing_ = 0;
}

void ExchangeRows3::hand_on(PairSink3 sink, std::chrono::duration<double> between) {
  sink_ = [this, sink = std::move(sink)](std::span<PairSum3> pairs, const PairRanges& known) {
    measure_alone(pairs);
    sink(pairs, known);
  };
  between_ = between;
}

double ExchangeRows3::factor(const PairSum3& pair, std::uint32_t from) const {
  if (pair.is_zero() || !table_.has_row(from)) return 0;
  return factor_of_3(table_, pair, from, factor_bounds_3(table_, pair, from));
}

std::vector<std::vector<std::array<double, 3>>> ExchangeRows3::corners() const {
  return element_corners(table_, prepared_.occluders().vertices());
}

void ExchangeRows3::measure_alone() { measure_alone(pairs_); }

void ExchangeRows3::measure_alone(std::span<PairSum3> pairs) const {
  const DefaultFloatingPoint arithmetic;
  if (request_.wants_visibility) measure_groups_alone(prepared_, table_, request_.tolerance, pairs);
}

ExchangeMatrix ExchangeRows3::matrix(ExchangeReport3* report) {
  HOTTEL_REQUIRE(missing_ == 0 && keeper_ == nullptr);
  measure_skies();
  Stopwatch watch;
  std::erase_if(pairs_, [this](const PairSum3& pair) {
    return pair.is_zero() || (is_chosen_[pair.i] == 0 && is_chosen_[pair.j] == 0);
  });
  std::ranges::sort(pairs_, {}, [](const PairSum3& pair) { return std::pair(pair.i, pair.j); });
  measure_alone();
  PairsOfAllRows pairs(table_.count(), std::move(pairs_));
  MeasuredRows3 rows(prepared_, table_, request_, is_chosen_, pairs, failed_skies(), report_);
  report_.seconds["visibility"] = watch.lap();
  rows.load(0);
  report_.seconds["matrix"] = watch.lap();
  if (report != nullptr) *report = std::move(report_);
  return rows.take_matrix();
}

std::unique_ptr<MeasuredRows3> ExchangeRows3::rows(ExchangeReport3* report) {
  HOTTEL_REQUIRE(missing_ == 0 && keeper_ != nullptr);
  measure_skies();
  Stopwatch watch;
  auto rows =
      std::make_unique<MeasuredRows3>(prepared_, table_, request_, is_chosen_, *keeper_, failed_skies(), report_);
  report_.seconds["visibility"] = watch.lap();
  if (report != nullptr) *report = std::move(report_);
  return rows;
}

// Pairs with the sky that could not be measured, in order.
std::vector<FailedPair3> ExchangeRows3::failed_skies() {
  std::ranges::sort(without_sky_, {}, &FailedPair3::i);
  return std::move(without_sky_);
}

}  // namespace hottel
