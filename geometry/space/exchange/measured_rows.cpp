#include "geometry/space/exchange/measured_rows.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "geometry/space/exchange/require_measured.h"
#include "geometry/space/exchange/rest_for_sky.h"
#include "geometry/space/vectors/local_vector.h"
#include "geometry/unit_of_length.h"
#include "kernel/doubles.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

// No element sends or gets more than its area. So both factors of a pair are of one S, also where one of them is 1.
void keep_within_areas(const ElementTable3& table, PairSum3& pair) {
  for (const std::uint32_t label : {pair.i, pair.j}) {
    if (label == table.sky()) continue;
    const Rounded& area = table.extent(label);
    pair.measure = std::min(pair.measure, area.value);
    pair.bounds.upper = std::min(pair.bounds.upper, area.enclosure().upper);
  }
}

// S / S0 of a pair of which something hides a part, and something is seen.
double partial_visibility(double measure, double alone) {
  const double quotient = measure / alone;
  const double most = std::nextafter(1.0, 0.0);
  return quotient > 0 ? std::min(quotient, most) : quotient <= 0 ? std::numeric_limits<double>::denorm_min() : most;
}

double visibility_of(const ElementTable3& table, const PairSum3& pair) {
  return pair.j == table.sky() || pair.is_whole ? 1 : partial_visibility(pair.measure, pair.alone);
}

// The smaller of both areas, in the unit of PairIntegrator3. The sky has none.
double smaller_area(const ElementTable3& table, const PairSum3& pair) {
  const double area = table.extent(pair.i).enclosure().lower;
  return pair.j == table.sky() ? area : std::min(area, table.extent(pair.j).enclosure().lower);
}

double unit_of_measures(const PreparedScene3& prepared) {
  const Vertices3& vertices = prepared.occluders().vertices();
  const Rational unit = scaled_by_power_of_two(vertices.scale(), vertices.shift());
  return to_double(unit * unit * square_metres_per_unit(prepared.scene));
}

// Adds the counts and errors of further rows.
void add_told(const SkyByClosure& more, SkyByClosure& told) {
  told.told += more.told;
  told.checked += more.checked;
  told.integrated += more.integrated;
  told.beyond += more.beyond;
  told.max_error = std::max(told.max_error, more.max_error);
  told.within = std::max(told.within, more.within);
  if (more.max_difference > told.max_difference) told.farthest = more.farthest;
  told.max_difference = std::max(told.max_difference, more.max_difference);
}

}  // namespace

Enclosure factor_bounds_3(const ElementTable3& table, const PairSum3& pair, std::uint32_t from) {
  const Enclosure area = table.extent(from).enclosure();
  const double lower = pair.bounds.lower > 0 ? std::nextafter(pair.bounds.lower / area.upper, 0.0) : 0;
  const double upper = std::nextafter(pair.bounds.upper / area.lower, kInfinity);
  return {std::min(lower, 1.0), upper < 1 ? upper : 1.0};
}

// Within its bounds, and above 0.
double factor_of_3(const ElementTable3& table, const PairSum3& pair, std::uint32_t from, const Enclosure& bounds) {
  const double factor = pair.measure / table.extent(from).value;
  return std::clamp(factor > 0 ? factor : std::numeric_limits<double>::denorm_min(), bounds.lower, bounds.upper);
}

MeasuredRows3::MeasuredRows3(const PreparedScene3& prepared, const ElementTable3& table, const ExchangeRequest& request,
                             std::vector<char> is_chosen, PairSource3& pairs, std::vector<FailedPair3> without_sky,
                             ExchangeReport3& report)
    : prepared_(prepared),
      table_(table),
      request_(request),
      is_chosen_(std::move(is_chosen)),
      pairs_(pairs),
      without_sky_(std::move(without_sky)),
      told_(unit_of_measures(prepared)),
      begins_(table.count() + std::size_t{1}, 0),
      matrix_(table.elements(), Guarantee::kEstimated) {
  const DefaultFloatingPoint arithmetic;
  report.surfaces = prepared_.scene.surfaces.size();
  report.vertices = prepared_.occluders().vertices().size();
  report.elements = table_.count();
  if (request_.proves && has_all_rows()) narrowing_.emplace(table_);
  FirstReading reading;
  if (request_.sky == SkyBy::kClosure) reading.sky.emplace();
  for (std::size_t k = 0; k < pairs_.cuts().count(); ++k) {
    const Held& held = hold(k, &reading);
    count(held, report);
    if (narrowing_) narrowing_->add(held.rows, held.pairs);
  }
  require_measured(prepared_, table_, request_.tolerance, reading.failures);
  if (reading.sky) report.sky = std::move(reading.sky);
  for (std::size_t row = 1; row < begins_.size(); ++row) begins_[row] += begins_[row - 1];
  if (narrowing_) narrow(report);
  if (report.pairs > 0 && report.enclosed == report.pairs) guarantee_ = Guarantee::kEnclosed;
}

// Reads a range: pairs of chosen rows, with what follows from all pairs of a row.
MeasuredRows3::Held& MeasuredRows3::hold(std::size_t k, FirstReading* reading) {
  if (held_ && held_->number == k) return *held_;
  held_.reset();
  Held held{k, pairs_.cuts().range(k), pairs_.pairs(k)};
  std::erase_if(held.pairs, [this](const PairSum3& pair) {
    return pair.is_zero() || (is_chosen_[pair.i] == 0 && is_chosen_[pair.j] == 0);
  });
  for (PairSum3& pair : held.pairs) keep_within_areas(table_, pair);
  tell_skies(held, reading);
  enclose_sky(table_, held.pairs);
  return held_.emplace(std::move(held));
}

void MeasuredRows3::tell_skies(Held& held, FirstReading* reading) const {
  std::vector<FailedPair3> failures;
  std::ranges::copy_if(without_sky_, std::back_inserter(failures),
                       [&](const FailedPair3& failure) { return held.rows.has(failure.i); });
  const bool is_by_closure = request_.sky == SkyBy::kClosure;
  if (failures.empty() && !is_by_closure) return;
  PairSums3 sums{std::move(held.pairs), std::move(failures)};
  if (is_by_closure) {
    std::vector<char> is_here(is_chosen_.size(), 0);
    std::copy(is_chosen_.begin() + held.rows.first, is_chosen_.begin() + held.rows.end,
              is_here.begin() + held.rows.first);
    const SkyByClosure told = take_sky_by_closure(table_, request_.tolerance, sums, &is_here);
    if (reading != nullptr) add_told(told, *reading->sky);
  }
  take_rest_for_sky(table_, request_.tolerance, sums);
  if (reading != nullptr) reading->failures.insert(reading->failures.end(), sums.failures.begin(), sums.failures.end());
  held.pairs = std::move(sums.pairs);
}

// Calls visit(from, to, pair) for the entries of the range. Rows ascend, and so do columns in a row: pairs are sorted,
// the smaller number first.
template <class Visit>
void MeasuredRows3::for_each_entry(const Held& held, const Visit& visit) const {
  for (const PairSum3& pair : held.pairs) {
    if (held.rows.has(pair.i) && has_row(pair.i)) visit(pair.i, pair.j, pair);
    if (pair.j != pair.i && held.rows.has(pair.j) && has_row(pair.j)) visit(pair.j, pair.i, pair);
  }
}

bool MeasuredRows3::is_enclosed(const PairSum3& pair) const {
  const double most = request_.tolerance * smaller_area(table_, pair);
  return pair.bounds.upper - pair.measure <= most && pair.measure - pair.bounds.lower <= most &&
         pair.bounds.contains(pair.measure);
}

// Entries of rows, and of pairs, each where its smaller number is, what the report has of them.
void MeasuredRows3::count(const Held& held, ExchangeReport3& report) {
  for (const PairSum3& pair : held.pairs) {
    if (!held.rows.has(pair.i)) continue;
    ++report.pairs;
    report.enclosed += is_enclosed(pair);
    report.max_error = std::max(report.max_error, pair.error / smaller_area(table_, pair));
  }
  std::vector<CompensatedSum<double>> sums(held.rows.end - held.rows.first);
  for (CompensatedSum<double>& sum : sums) sum.add(-1);
  for_each_entry(held, [&](std::uint32_t from, std::uint32_t, const PairSum3& pair) {
    ++begins_[from + std::size_t{1}];
    sums[from - held.rows.first].add(factor_of_3(table_, pair, from, factor_bounds_3(table_, pair, from)));
  });
  for (std::uint32_t row = held.rows.first; row < held.rows.end; ++row)
    if (has_row(row)) report.max_defect = std::max(report.max_defect, std::fabs(sums[row - held.rows.first].value()));
}

// The report has the defect of the rows as they were: it would be 0 afterwards.
void MeasuredRows3::narrow(ExchangeReport3& report) {
  std::uint64_t enclosed = 0;
  for (std::size_t k = 0; k < pairs_.cuts().count(); ++k) {
    Held& held = hold(k);
    report.proof.narrowed += narrowing_->narrow(held.rows, held.pairs);
    held.is_narrowed = true;
    for (const PairSum3& pair : held.pairs) enclosed += held.rows.has(pair.i) && is_enclosed(pair);
  }
  report.enclosed = enclosed;
  if (report.proof.narrowed == 0) narrowing_.reset();
}

bool MeasuredRows3::has_all_rows() const {
  for (std::uint32_t label = 0; label < table_.count(); ++label)
    if (table_.has_row(label) && !has_row(label)) return false;
  return true;
}

RowRange MeasuredRows3::load(std::size_t k) {
  const DefaultFloatingPoint arithmetic;
  Held& held = hold(k);
  if (narrowing_ && !held.is_narrowed) {
    narrowing_->narrow(held.rows, held.pairs);
    held.is_narrowed = true;
  }
  const std::size_t first = begins_[held.rows.first], end = begins_[held.rows.end];
  std::vector<std::size_t> begin(begins_.size());
  for (std::size_t row = 0; row < begin.size(); ++row) begin[row] = std::clamp(begins_[row], first, end) - first;
  FactorEntries entries(end - first);
  std::vector<double> measures(request_.wants_measures ? entries.size() : 0);
  std::vector<Enclosure> bounds(entries.size());
  std::vector<Guarantee> guarantees(entries.size());
  std::vector<std::size_t> next = begin;
  for_each_entry(held, [&](std::uint32_t from, std::uint32_t to, const PairSum3& pair) {
    const std::size_t place = next[from]++;
    bounds[place] = factor_bounds_3(table_, pair, from);
    const double factor = factor_of_3(table_, pair, from, bounds[place]);
    const double visibility = to == table_.sky()          ? factor
                              : request_.wants_visibility ? visibility_of(table_, pair)
                                                          : std::numeric_limits<double>::quiet_NaN();
    entries.set(place, {to, {factor, 0}, visibility});
    guarantees[place] = is_enclosed(pair) ? Guarantee::kEnclosed : Guarantee::kEstimated;
    if (request_.wants_measures) measures[place] = pair.measure * told_;
  });
  matrix_.assign(std::move(begin), std::move(entries), std::move(measures), std::move(bounds), std::move(guarantees));
  if (has_all_rows()) matrix_.promise_closed_rows();
  return held.rows;
}

ExchangeMatrix MeasuredRows3::take_matrix() {
  held_.reset();
  return std::move(matrix_);
}

}  // namespace hottel
