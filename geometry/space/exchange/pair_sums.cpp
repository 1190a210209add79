#include "geometry/space/exchange/pair_sums.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <random>
#include <utility>

#include "geometry/space/arrangement/closed_hull.h"
#include "geometry/space/exchange/facing.h"
#include "geometry/space/exchange/unobstructed.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "kernel/support/progress_count.h"

namespace hottel {
namespace {

using Part = ElementTable3::Part;

// So few pairs that the most expensive ones do not come at the end of much.
constexpr std::size_t kPairsOfATask = 16;

// One patch, and some of those after it.
struct Task {
  std::size_t patch, begin, end;
};

// The work in pieces: first each patch that has a row with the sky, which is often the most expensive one; then each
// patch with those after it, a few at a time.
class Tasks {
 public:
  explicit Tasks(const ElementTable3& table) : table_(table), sky_begin_(table.parts().size() - sky_size()) {
    for (std::size_t a = 0; a < sky_begin_; ++a)
      if (table.has_row(table.parts()[a].label)) with_sky_.push_back(a);
    first_.push_back(with_sky_.size());
    for (std::size_t a = 0; a < sky_begin_; ++a)
      first_.push_back(first_.back() + (sky_begin_ - a - 1 + kPairsOfATask - 1) / kPairsOfATask);
  }

  std::size_t count() const { return first_.back(); }
  Task operator[](std::size_t task) const {
    if (task < with_sky_.size()) return {with_sky_[task], sky_begin_, table_.parts().size()};
    const auto after = std::upper_bound(first_.begin(), first_.end(), task);
    const auto a = static_cast<std::size_t>(after - first_.begin()) - 1;
    const std::size_t begin = a + 1 + (task - first_[a]) * kPairsOfATask;
    return {a, begin, std::min(begin + kPairsOfATask, sky_begin_)};
  }
  // Of one patch that is no sky and another one after it.
  bool is_asked(const Part& a, const Part& b) const { return table_.has_row(a.label) || table_.has_row(b.label); }

 private:
  std::size_t sky_size() const { return table_.parts(table_.sky()).size(); }

  const ElementTable3& table_;
  std::size_t sky_begin_;
  std::vector<std::size_t> with_sky_;
  std::vector<std::size_t> first_;  // the first task of each patch
};

// What one task found, in the order of the patches.
struct Found {
  std::vector<PairSum3> pairs;
  std::vector<FailedPair3> failures;
};

class Measuring {
 public:
  Measuring(const PreparedScene3& prepared, const ElementTable3& table, const PairSumRequest3& request)
      : prepared_(prepared), table_(table), request_(request), tasks_(table), hull_(prepared.blockers()) {}

  const Tasks& tasks() const { return tasks_; }

  void run(const Task& task, Found& found, ExchangeReport3& counts) const {
    const Part& a = table_.parts()[task.patch];
    if (table_.parts()[task.begin].patch.is_sky() && !has_turn(a, table_.parts()[task.begin])) return;
    if (table_.parts()[task.begin].patch.is_sky() && hull_.sees_no_sky(a.patch.surface, a.is_back)) {
      counts.hidden += task.end - task.begin;
      return;
    }
    const Part* before = nullptr;  // the last one whose face was asked about
    bool do_face = false;
    for (std::size_t k = task.begin; k < task.end; ++k) {
      const Part& b = table_.parts()[k];
      throw_if_interrupted();
      if (!b.patch.is_sky()) {
        if (a.patch.surface == b.patch.surface || !tasks_.is_asked(a, b) || !has_turn(a, b)) continue;
        if (before == nullptr || before->patch.surface != b.patch.surface || before->is_back != b.is_back)
          do_face = surfaces_face_each_other(prepared_.blockers(), a, b);
        before = &b;
        if (!do_face) {
          ++counts.hidden;
          continue;
        }
      }
      measure_free(a, b, found, counts);
    }
  }

 private:
  bool has_turn(const Part& a, const Part& b) const {
    return request_.turn == nullptr || request_.turn->has(a.label, b.label);
  }

  // What is covered of both may see each other within a solid.
  void measure_free(const Part& a, const Part& b, Found& found, ExchangeReport3& counts) const {
    if (b.patch.is_sky() || !table_.is_partly_covered(a.label) || !table_.is_partly_covered(b.label))
      return measure(a, b, found, counts);
    for (const Part& free : table_.free_parts(b.label))
      if (free.patch.surface == b.patch.surface && free.is_back == b.is_back) measure(a, free, found, counts);
  }

  void measure(const Part& a, const Part& b, Found& found, ExchangeReport3& counts) const {
    const PairMeasure3 pair = prepared_.measurer().measure(a.patch, b.patch, {.tolerance = request_.tolerance});
    ++(pair.sight == Sight3::kHidden ? counts.hidden : pair.sight == Sight3::kClear ? counts.clear : counts.mixed);
    counts.maps += pair.maps;
    counts.pieces += pair.pieces;
    counts.nodes += pair.nodes;
    counts.signs += pair.signs;
    if (!pair.problem.empty()) {
      found.failures.push_back({a.label, b.label, pair.problem});
      return;
    }
    const bool is_zero = pair.bounds.upper == 0;
    PairSum3 sum{.i = a.label, .j = b.label, .is_whole = !is_zero && pair.is_whole};
    if (!is_zero) {
      sum.measure = pair.measure;
      sum.error = pair.error;
      sum.bounds = pair.bounds;
    } else if (!stands_for_what_is_hidden(a, b)) {
      return;
    }
    if (request_.wants_visibility && !b.patch.is_sky() && !sum.is_whole && !is_of_groups(a, b))
      sum.alone = unobstructed_measure(prepared_.blockers().vertices(), a.patch, b.patch, request_.tolerance).measure;
    found.pairs.push_back(sum);
  }

  bool is_of_groups(const Part& a, const Part& b) const {
    return !table_.is_one_patch(a.label) || !table_.is_one_patch(b.label);
  }

  // Whether a pair that exchanges nothing is kept, so that the sum of two groups knows of it.
  bool stands_for_what_is_hidden(const Part& a, const Part& b) const {
    return request_.wants_visibility && !b.patch.is_sky() && is_of_groups(a, b) &&
           face_each_other(prepared_.blockers(), a, b);
  }

  const PreparedScene3& prepared_;
  const ElementTable3& table_;
  const PairSumRequest3& request_;
  const Tasks tasks_;
  const ClosedHull3 hull_;
};

void add_counts(ExchangeReport3& report, const ExchangeReport3& some) {
  report.hidden += some.hidden;
  report.clear += some.clear;
  report.mixed += some.mixed;
  report.maps += some.maps;
  report.pieces += some.pieces;
  report.nodes += some.nodes;
  report.signs += some.signs;
}

void add_to(PairSum3& sum, const PairSum3& other) {
  sum.measure += other.measure;
  sum.error += other.error;
  sum.bounds = sum_of_nonnegative(sum.bounds, other.bounds);
  sum.alone += other.alone;
  sum.is_whole = sum.is_whole && other.is_whole;
}

// Sums what stands for one pair of elements, in the order of the list.
std::vector<PairSum3> by_elements(std::vector<PairSum3> pairs) {
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const PairSum3& a, const PairSum3& b) { return std::pair(a.i, a.j) < std::pair(b.i, b.j); });
  std::size_t count = 0;
  for (const PairSum3& pair : pairs) {
    if (count > 0 && pairs[count - 1].i == pair.i && pairs[count - 1].j == pair.j)
      add_to(pairs[count - 1], pair);
    else
      pairs[count++] = pair;
  }
  pairs.resize(count);
  for (PairSum3& pair : pairs)
    if (pair.i == pair.j) add_to(pair, PairSum3(pair));
  return pairs;
}

}  // namespace

PairSums3 sum_pairs(const PreparedScene3& prepared, const ElementTable3& table, const PairSumRequest3& request,
                    ExchangeReport3& report) {
  const Measuring measuring(prepared, table, request);
  const Tasks& tasks = measuring.tasks();
  std::vector<Found> found(tasks.count());
  ProgressCount progress(request.progress, tasks.count());
  std::atomic<std::uint64_t> found_pairs{0};
  std::mutex together;
  parallel_ranges(tasks.count(), 1, [&](std::size_t begin, std::size_t end) {
    ExchangeReport3 counts;
    for (std::size_t t = begin; t < end; ++t) {
      measuring.run(tasks[t], found[t], counts);
      found[t].pairs.shrink_to_fit();
      const std::size_t more = found[t].pairs.size();
      if (found_pairs.fetch_add(more, std::memory_order_relaxed) + more > request.most_pairs)
        throw RequestError("more than " + std::to_string(request.most_pairs) +
                           " pairs see each other: they need more memory than is allowed");
      progress.add();
    }
    const std::lock_guard lock(together);
    add_counts(report, counts);
  });

  PairSums3 result;
  result.pairs.reserve(found_pairs);
  for (Found& some : found) {
    result.pairs.insert(result.pairs.end(), some.pairs.begin(), some.pairs.end());
    result.failures.insert(result.failures.end(), some.failures.begin(), some.failures.end());
    some = {};
  }
  for (const ElementTable3::Contact& contact : table.contacts()) {
    const std::uint32_t i = std::min(contact.mask, contact.base), j = std::max(contact.mask, contact.base);
    if (request.turn != nullptr && !request.turn->has(i, j)) continue;
    const double area = contact.extent.value;
    const bool are_patches = table.is_one_patch(i) && table.is_one_patch(j);
    result.pairs.push_back(
        {.i = i, .j = j, .measure = area, .bounds = contact.extent.enclosure(), .alone = are_patches ? area : 0});
  }
  result.pairs = by_elements(std::move(result.pairs));
  std::stable_sort(result.failures.begin(), result.failures.end(), [](const FailedPair3& a, const FailedPair3& b) {
    return std::pair(a.i, a.j) < std::pair(b.i, b.j);
  });
  return result;
}

void take_rest_for_sky(const ElementTable3& table, double tolerance, PairSums3& sums) {
  constexpr double kRounding = 0x1p-48;
  std::vector<char> has_other_failure(table.count(), 0), wants(table.count(), 0);
  for (const FailedPair3& failure : sums.failures) {
    if (failure.j == table.sky()) {
      wants[failure.i] = 1;
      continue;
    }
    has_other_failure[failure.i] = has_other_failure[failure.j] = 1;
  }
  if (std::find(wants.begin(), wants.end(), 1) == wants.end()) return;
  std::vector<PairSum3> rest(table.count());
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    const Rounded& area = table.extent(i);
    rest[i] = {.i = i, .j = table.sky(), .measure = area.value, .error = kRounding * area.value};
    rest[i].bounds = area.enclosure();
  }
  const auto take = [](PairSum3& left, const PairSum3& pair) {
    left.measure -= pair.measure;
    left.error += pair.error;
    left.bounds = {std::nextafter(left.bounds.lower - pair.bounds.upper, -1.0),
                   std::nextafter(left.bounds.upper - pair.bounds.lower, 2 * left.bounds.upper)};
  };
  for (const PairSum3& pair : sums.pairs) {
    if (pair.j == table.sky()) continue;
    take(rest[pair.i], pair);
    if (pair.j != pair.i) take(rest[pair.j], pair);
  }
  const auto is_known = [&](std::uint32_t i) {
    const PairSum3& left = rest[i];
    return wants[i] != 0 && has_other_failure[i] == 0 && left.measure > left.error &&
           left.error <= tolerance * table.extent(i).value;
  };
  std::erase_if(sums.failures, [&](const FailedPair3& f) { return f.j == table.sky() && is_known(f.i); });
  std::erase_if(sums.pairs, [&](const PairSum3& pair) { return pair.j == table.sky() && is_known(pair.i); });
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (!is_known(i)) continue;
    rest[i].bounds.lower = std::max(0.0, rest[i].bounds.lower);
    const auto place = std::upper_bound(
        sums.pairs.begin(), sums.pairs.end(), rest[i],
        [](const PairSum3& a, const PairSum3& b) { return std::pair(a.i, a.j) < std::pair(b.i, b.j); });
    sums.pairs.insert(place, rest[i]);
  }
}

std::uint64_t estimated_pairs(const PreparedScene3& prepared, const ElementTable3& table) {
  constexpr std::size_t kSample = 512;
  const PairSumRequest3 request;
  const Measuring measuring(prepared, table, request);
  std::vector<Task> single;
  std::mt19937_64 random(1);
  const std::size_t sky_begin = table.parts().size() - table.parts(table.sky()).size();
  if (sky_begin < 2) return 0;
  for (std::size_t k = 0; k < kSample; ++k) {
    const std::size_t a = random() % sky_begin, b = random() % (sky_begin - 1);
    const std::size_t other = b < a ? b : b + 1;
    single.push_back({std::min(a, other), std::max(a, other), std::max(a, other) + 1});
  }
  std::atomic<std::uint64_t> visible{0};
  parallel_for(single.size(), [&](std::size_t k) {
    Found found;
    ExchangeReport3 ignored;
    measuring.run(single[k], found, ignored);
    visible += found.pairs.size();
  });
  const double all = static_cast<double>(sky_begin) * static_cast<double>(sky_begin - 1) / 2;
  return static_cast<std::uint64_t>(all * static_cast<double>(visible) / kSample);
}

}  // namespace hottel
