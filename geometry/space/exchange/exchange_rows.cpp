#include "geometry/space/exchange/exchange_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "geometry/space/contacts/near_contacts.h"
#include "geometry/space/exchange/exchange_memory.h"
#include "geometry/space/exchange/groups_alone.h"
#include "geometry/space/exchange/narrow_by_rows.h"
#include "geometry/space/exchange/pair_names.h"
#include "geometry/space/exchange/pair_sums.h"
#include "geometry/space/exchange/rest_for_sky.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/vectors/local_vector.h"
#include "geometry/unit_of_length.h"
#include "geometry/unmeasured_pairs.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"

namespace hottel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Rounded up, so that it holds.
std::string reached_text(const FailedPair3& failure) {
  if (failure.is_undecided || !(failure.reached > 0 && std::isfinite(failure.reached))) return failure.problem;
  const double scale = std::pow(10.0, std::floor(std::log10(failure.reached)) - 1);
  return fmt::format("{:.1e} was reached: {}", std::ceil(failure.reached / scale) * scale, failure.problem);
}

void require_measured(const PreparedScene3& prepared, const ElementTable3& table, double tolerance,
                      const std::vector<FailedPair3>& failures) {
  if (failures.empty()) return;
  std::string text =
      fmt::format("{} could not be measured within {} of the smaller area",
                  failures.size() == 1 ? "a pair" : fmt::format("{} pairs", failures.size()), shortest(tolerance));
  for (std::size_t k = 0; k < std::min(failures.size(), kNamedPairs); ++k)
    text += fmt::format("{} {} ({})", k == 0 ? ":" : ";", pair_text(table.elements(), failures[k].i, failures[k].j),
                        reached_text(failures[k]));
  if (failures.size() > kNamedPairs) text += "; ...";
  if (!find_contacts(prepared.scene).near.empty())
    text += ". Some surfaces all but touch: 'hottel check' says where, and its --fix joins them";
  throw UnmeasuredPairs(text, failures.size());
}

[[noreturn]] void refuse_memory(std::uint64_t count, const char* what, std::uint64_t each, std::uint64_t allowed) {
  throw RequestError(fmt::format("about {} {} need about {} bytes; allowed are {}", count, what,
                                 static_cast<double>(count) * static_cast<double>(each) < 1e19
                                     ? fmt::format("{}", count * each)
                                     : fmt::format("{:.2g}", static_cast<double>(count) * static_cast<double>(each)),
                                 allowed));
}

// The pairs that the memory holds beside the elements. Throws RequestError where these are too many.
std::uint64_t most_pairs(std::uint64_t elements, std::uint64_t memory) {
  if (memory == 0) return std::numeric_limits<std::uint64_t>::max();
  if (elements > memory / kBytesPerElement3) refuse_memory(elements, "elements", kBytesPerElement3, memory);
  return (memory - elements * kBytesPerElement3) / kBytesPerPair3;
}

// Where all pairs there are of the chosen rows would be too many, it is estimated how many of all see each other.
void require_room_for_pairs(const PreparedScene3& prepared, const ElementTable3& table,
                            const std::vector<char>& is_chosen, std::uint64_t most, std::uint64_t memory) {
  const double patches = static_cast<double>(table.parts().size());
  const auto chosen = static_cast<double>(
      std::ranges::count_if(table.parts(), [&](const auto& part) { return is_chosen[part.label] != 0; }));
  if (std::min(patches / 2, chosen) * patches <= static_cast<double>(most)) return;
  if (const std::uint64_t pairs = estimated_pairs(prepared, table); pairs > most)
    refuse_memory(pairs, "visible pairs", kBytesPerPair3, memory);
}

// How many threads may measure pairs, one at least: what they take is within what the pairs of this many patches leave
// of the memory, or within half of it.
std::uint64_t most_threads(std::uint64_t elements, std::uint64_t patches, std::uint64_t memory) {
  if (memory == 0) return std::numeric_limits<std::uint64_t>::max();
  const auto allowed = static_cast<double>(memory), count = static_cast<double>(patches);
  const double tables = static_cast<double>(elements) * kBytesPerElement3 + count * count / 2 * kBytesPerPair3;
  return static_cast<std::uint64_t>(std::max(1.0, std::max(allowed - tables, allowed / 2) / kBytesPerThread3));
}

// What a pair is in both of its rows.
struct PairEntry {
  double visibility = 1, measure = 0;
  bool is_enclosed = false;
};

// No element sends or gets more than its area. So both factors of a pair are of one S, also where one of them is 1.
void keep_within_areas(const ElementTable3& table, PairSum3& pair) {
  for (const std::uint32_t label : {pair.i, pair.j}) {
    if (label == table.sky()) continue;
    const Rounded& area = table.extent(label);
    pair.measure = std::min(pair.measure, area.value);
    pair.bounds.upper = std::min(pair.bounds.upper, area.enclosure().upper);
  }
}

Enclosure bounds_of(const ElementTable3& table, const PairSum3& pair, std::uint32_t from) {
  const Enclosure area = table.extent(from).enclosure();
  const double lower = pair.bounds.lower > 0 ? std::nextafter(pair.bounds.lower / area.upper, 0.0) : 0;
  const double upper = std::nextafter(pair.bounds.upper / area.lower, kInfinity);
  return {std::min(lower, 1.0), upper < 1 ? upper : 1.0};
}

// Within its bounds, and above 0.
double factor_of(const ElementTable3& table, const PairSum3& pair, std::uint32_t from, const Enclosure& bounds) {
  const double factor = pair.measure / table.extent(from).value;
  return std::clamp(factor > 0 ? factor : std::numeric_limits<double>::denorm_min(), bounds.lower, bounds.upper);
}

class MatrixOfSums {
 public:
  MatrixOfSums(const ElementTable3& table, const std::vector<char>& is_chosen, const std::vector<PairSum3>& pairs,
               std::vector<PairEntry> entries)
      : table_(table), is_chosen_(is_chosen), pairs_(pairs), of_pair_(std::move(entries)) {}

  ExchangeMatrix make(bool with_measures) const {
    ExchangeMatrix matrix(table_.elements(), Guarantee::kEstimated);
    std::vector<std::size_t> begin(table_.count() + std::size_t{1}, 0);
    for_each([&](std::uint32_t from, std::uint32_t, std::size_t) { ++begin[from + 1]; });
    for (std::uint32_t i = 0; i < table_.count(); ++i) begin[i + 1] += begin[i];
    FactorEntries entries(begin.back());
    std::vector<double> measures(with_measures ? begin.back() : 0);
    std::vector<Enclosure> bounds(begin.back());
    std::vector<Guarantee> guarantees(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for_each([&](std::uint32_t from, std::uint32_t to, std::size_t k) {
      const std::size_t place = next[from]++;
      bounds[place] = bounds_of(table_, pairs_[k], from);
      const double factor = factor_of(table_, pairs_[k], from, bounds[place]);
      entries.set(place, {to, {factor, 0}, to == table_.sky() ? factor : of_pair_[k].visibility});
      guarantees[place] = of_pair_[k].is_enclosed ? Guarantee::kEnclosed : Guarantee::kEstimated;
      if (with_measures) measures[place] = of_pair_[k].measure;
    });
    matrix.assign(std::move(begin), std::move(entries), std::move(measures), std::move(bounds), std::move(guarantees));
    if (has_all_rows()) matrix.promise_closed_rows();
    return matrix;
  }

 private:
  // Rows ascend, and so do columns in a row: pairs are sorted, the smaller number first.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      const auto [i, j] = std::pair(pairs_[k].i, pairs_[k].j);
      if (has_row(i)) visit(i, j, k);
      if (j != i && has_row(j)) visit(j, i, k);
    }
  }
  bool has_row(std::uint32_t label) const { return is_chosen_[label] != 0 && table_.has_row(label); }
  bool has_all_rows() const {
    for (std::uint32_t label = 0; label < table_.count(); ++label)
      if (table_.has_row(label) && !has_row(label)) return false;
    return true;
  }

  const ElementTable3& table_;
  const std::vector<char>& is_chosen_;
  const std::vector<PairSum3>& pairs_;
  std::vector<PairEntry> of_pair_;
};

// S / S0 of a pair of which something hides a part, and something is seen.
double partial_visibility(double measure, double alone) {
  const double quotient = measure / alone;
  const double most = std::nextafter(1.0, 0.0);
  return quotient > 0 ? std::min(quotient, most) : quotient <= 0 ? std::numeric_limits<double>::denorm_min() : most;
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

double visibility_of(const ElementTable3& table, const PairSum3& pair) {
  return pair.j == table.sky() || pair.is_whole ? 1 : partial_visibility(pair.measure, pair.alone);
}

// The smaller of both areas, in the unit of PairIntegrator3. The sky has none.
double smaller_area(const ElementTable3& table, const PairSum3& pair) {
  const double area = table.extent(pair.i).enclosure().lower;
  return pair.j == table.sky() ? area : std::min(area, table.extent(pair.j).enclosure().lower);
}

bool is_enclosed(const PairSum3& pair, double most) {
  return pair.bounds.upper - pair.measure <= most && pair.measure - pair.bounds.lower <= most &&
         pair.bounds.contains(pair.measure);
}

// The largest |row sum - 1|.
double closure_defect(const ExchangeMatrix& matrix, const std::vector<char>& is_chosen) {
  double most = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (is_chosen[i] == 0 || !matrix.has_row(i)) continue;
    CompensatedSum<double> sum;
    sum.add(-1);
    for (const FactorEntry& entry : matrix.row(i)) sum.add(entry.factor.value);
    most = std::max(most, std::fabs(sum.value()));
  }
  return most;
}

std::vector<PairEntry> entries_of(const PreparedScene3& prepared, const ElementTable3& table,
                                  const std::vector<PairSum3>& pairs, const ExchangeRequest& request,
                                  ExchangeReport3& report) {
  const Vertices3& vertices = prepared.occluders().vertices();
  const Rational unit = scaled_by_power_of_two(vertices.scale(), vertices.shift());
  const double told = to_double(unit * unit * square_metres_per_unit(prepared.scene));
  std::vector<PairEntry> entries;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double area = smaller_area(table, pairs[k]);
    const double visibility =
        request.wants_visibility ? visibility_of(table, pairs[k]) : std::numeric_limits<double>::quiet_NaN();
    entries.push_back({visibility, pairs[k].measure * told, is_enclosed(pairs[k], request.tolerance * area)});
    report.enclosed += entries.back().is_enclosed;
    report.max_error = std::max(report.max_error, pairs[k].error / area);
  }
  return entries;
}

// Areas are doubles in the unit of PairIntegrator3, where the scene is 2^53 large at most.
void require_areas(const ElementTable3& table) {
  constexpr double kLeastArea = 0x1p-900;
  for (std::uint32_t i = 0; i < table.count(); ++i)
    if (table.has_row(i) && !(table.extent(i).enclosure().lower >= kLeastArea))
      throw RequestError(fmt::format("{} is too small: surfaces may be 1e150 times smaller than the scene",
                                     quoted_name(table.elements()[i].name)));
}

}  // namespace

ExchangeRows3::ExchangeRows3(const PreparedScene3& prepared, const ExchangeRequest& request)
    : prepared_(prepared),
      request_(request),
      most_(most_pairs(element_counts(prepared.scene, request.granularity).all, request.memory)),
      table_(*prepared.elements(request.granularity)),
      is_chosen_(table_.count() + std::size_t{1}, 0),
      has_come_(is_chosen_),
      checks_(request.sky == SkyBy::kClosure ? checks_of_sky(table_) : std::vector<char>()) {
  HOTTEL_REQUIRE(request.tolerance > 0);
  Stopwatch watch;
  for (const std::uint32_t i : request.rows.labels(table_.elements())) is_chosen_[i] = 1;
  require_areas(table_);
  require_room_for_pairs(prepared, table_, is_chosen_, most_, request.memory);
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
                              .most_pairs = most_ - std::min<std::uint64_t>(most_, pairs_.size()),
                              .progress = progress,
                              .turn = &turn,
                              .shared = request_.granularity,
                              .sink = sink_,
                              .between = between_},
                             counts);
  const auto is_of_sky = [this](const FailedPair3& failure) { return failure.j == table_.sky(); };
  const auto of_others = std::stable_partition(sums.failures.begin(), sums.failures.end(), is_of_sky);
  require_measured(prepared_, table_, request_.tolerance, {of_others, sums.failures.end()});
  without_sky_.insert(without_sky_.end(), sums.failures.begin(), of_others);
  report_ = std::move(counts);
  report_.seconds["pairs"] += watch.lap();
  if (pairs_.empty())
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

// By closure, when all other pairs are there.
void ExchangeRows3::measure_skies() {
  if (!is_by_closure() || missing_ > 0 || has_skies_) return;
  const DefaultFloatingPoint arithmetic;
  std::vector<char> left = skies_to_integrate(table_, request_.tolerance, pairs_);
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
  return pair.is_zero() || !table_.has_row(from) ? 0 : factor_of(table_, pair, from, bounds_of(table_, pair, from));
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
  HOTTEL_REQUIRE(missing_ == 0);
  measure_skies();
  const DefaultFloatingPoint arithmetic;
  Stopwatch watch;
  std::erase_if(pairs_, [this](const PairSum3& pair) {
    return pair.is_zero() || (is_chosen_[pair.i] == 0 && is_chosen_[pair.j] == 0);
  });
  for (PairSum3& pair : pairs_) keep_within_areas(table_, pair);
  std::ranges::sort(pairs_, {}, [](const PairSum3& pair) { return std::pair(pair.i, pair.j); });
  if (!without_sky_.empty() || is_by_closure()) {
    std::ranges::sort(without_sky_, {}, &FailedPair3::i);
    PairSums3 sums{std::move(pairs_), std::move(without_sky_)};
    if (is_by_closure()) report_.sky = take_sky_by_closure(table_, request_.tolerance, sums, &is_chosen_);
    take_rest_for_sky(table_, request_.tolerance, sums);
    require_measured(prepared_, table_, request_.tolerance, sums.failures);
    pairs_ = std::move(sums.pairs);
  }
  enclose_sky(table_, pairs_);
  report_.surfaces = prepared_.scene.surfaces.size();
  report_.vertices = prepared_.occluders().vertices().size();
  report_.elements = table_.count();
  report_.pairs = pairs_.size();
  measure_alone();
  std::vector<PairEntry> entries = entries_of(prepared_, table_, pairs_, request_, report_);
  report_.seconds["visibility"] = watch.lap();
  ExchangeMatrix matrix = MatrixOfSums(table_, is_chosen_, pairs_, std::move(entries)).make(request_.wants_measures);
  report_.max_defect = closure_defect(matrix, is_chosen_);
  // The report has the defect of the rows as they were: it would be 0 afterwards.
  if (request_.proves && matrix.has_closed_rows()) {
    report_.proof.narrowed = narrow_by_rows(table_, pairs_);
    if (report_.proof.narrowed > 0) {
      report_.enclosed = 0;
      matrix = MatrixOfSums(table_, is_chosen_, pairs_, entries_of(prepared_, table_, pairs_, request_, report_))
                   .make(request_.wants_measures);
    }
  }
  report_.seconds["matrix"] = watch.lap();
  if (report != nullptr) *report = std::move(report_);
  return matrix;
}

}  // namespace hottel
