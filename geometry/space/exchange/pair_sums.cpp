#include "geometry/space/exchange/pair_sums.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "geometry/space/exchange/facing.h"
#include "geometry/space/exchange/pair_crew.h"
#include "geometry/space/exchange/pair_handover.h"
#include "geometry/space/exchange/pair_shares.h"
#include "geometry/space/exchange/pair_tasks.h"
#include "geometry/space/unobstructed/unobstructed.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "kernel/support/progress_count.h"

namespace hottel {
namespace {

using Part = ElementTable3::Part;

using Task = PairTask3;
using Tasks = PairTasks3;
using Found = FoundPairs3;
using OpenPair = OpenPair3;

// Rows of patches, to be taken by one thread at a time: what is known of a patch serves its next task.
class RowsAtHand {
 public:
  explicit RowsAtHand(const PairIntegrator3& measurer) : measurer_(measurer) {}

  struct Row {
    const Part* part;
    PairRow3 row;
  };
  // One of this patch if there is one.
  Row take(const Part& part) {
    const std::lock_guard lock(together_);
    const auto known = std::ranges::find(idle_, &part, &Row::part);
    if (known == idle_.end()) return {&part, PairRow3(measurer_, part.patch)};
    Row row = std::move(*known);
    idle_.erase(known);
    return row;
  }
  // Keeps the last ones.
  void give_back(Row row) {
    constexpr std::size_t kMostIdle = 64;
    const std::lock_guard lock(together_);
    if (idle_.size() == kMostIdle) idle_.erase(idle_.begin());
    idle_.push_back(std::move(row));
  }

 private:
  const PairIntegrator3& measurer_;
  std::mutex together_;
  std::vector<Row> idle_;
};

// What is known of the patches of a table, each made when it is first asked for. For several threads at once.
class PatchesAtHand {
 public:
  PatchesAtHand(const PairIntegrator3& measurer, const std::vector<Part>& parts)
      : measurer_(measurer), parts_(parts), known_(std::min(parts.size(), kMost)) {}
  ~PatchesAtHand() {
    for (const std::atomic<const PairPatch3*>& one : known_) delete one.load(std::memory_order_relaxed);
  }
  PatchesAtHand(const PatchesAtHand&) = delete;
  PatchesAtHand& operator=(const PatchesAtHand&) = delete;

  // Visits that of a part; of one that is not of the table, or behind the first ones, it is made for this alone.
  template <class Visit>
  auto with(const Part& part, const Visit& visit) {
    const bool is_listed = !std::less<>()(&part, parts_.data()) && std::less<>()(&part, parts_.data() + known_.size());
    if (!is_listed) return visit(PairPatch3(measurer_, part.patch));
    std::atomic<const PairPatch3*>& place = known_[static_cast<std::size_t>(&part - parts_.data())];
    const PairPatch3* known = place.load(std::memory_order_acquire);
    if (known == nullptr) {
      auto made = std::make_unique<const PairPatch3>(measurer_, part.patch);
      if (place.compare_exchange_strong(known, made.get(), std::memory_order_acq_rel)) known = made.release();
    }
    return visit(*known);
  }

 private:
  static constexpr std::size_t kMost = 1 << 14;  // some 20 megabytes

  const PairIntegrator3& measurer_;
  const std::vector<Part>& parts_;
  std::vector<std::atomic<const PairPatch3*>> known_;
};

// Adds what was looked at for a pair, or for those of a report.
template <class Counts>
void add_work(const Counts& some, ExchangeReport3& report) {
  report.maps += some.maps;
  report.pieces += some.pieces;
  report.nodes += some.nodes;
  report.proof.parts += some.proof.parts;
  report.proof.halvings += some.proof.halvings;
  report.proof.redone += some.proof.redone;
  report.proof.failures += some.proof.failures;
  report.signs += some.signs;
}

class Measuring {
 public:
  Measuring(const PreparedScene3& prepared, const ElementTable3& table, const PairSumRequest3& request)
      : prepared_(prepared),
        table_(table),
        request_(request),
        tasks_(table),
        rows_(prepared.measurer()),
        patches_(prepared.measurer(), table.parts()),
        shares_(table, prepared.occluders().vertices(), request.tolerance) {}

  const Tasks& tasks() const { return tasks_; }
  const PairShares3& shares() const { return shares_; }
  double tolerance() const { return request_.tolerance; }

  void run(const Task& task, Found& found, ExchangeReport3& counts) const {
    const Part& a = table_.parts()[task.patch];
    if (table_.parts()[task.begin].patch.is_sky() && !has_turn(a, table_.parts()[task.begin])) return;
    RowsAtHand::Row row = rows_.take(a);
    const Part* before = nullptr;  // the last one whose face was asked about
    bool do_face = false;
    for (std::size_t k = task.begin; k < task.end; ++k) {
      const Part& b = table_.parts()[k];
      throw_if_interrupted();
      if (!b.patch.is_sky()) {
        if (a.patch.surface == b.patch.surface || !tasks_.is_asked(a, b) || !has_turn(a, b)) continue;
        if (before == nullptr || before->patch.surface != b.patch.surface || before->is_back != b.is_back)
          do_face = surfaces_face_each_other(prepared_.occluders(), a, b);
        before = &b;
        if (!do_face) {
          ++counts.hidden;
          continue;
        }
      }
      measure_free(row.row, a, b, found, counts);
    }
    rows_.give_back(std::move(row));
  }

 private:
  bool has_turn(const Part& a, const Part& b) const {
    return request_.turn == nullptr || request_.turn->has(a.label, b.label);
  }

  // What is covered of both may see each other within a solid.
  void measure_free(PairRow3& row, const Part& a, const Part& b, Found& found, ExchangeReport3& counts) const {
    if (b.patch.is_sky() || !table_.is_partly_covered(a.label) || !table_.is_partly_covered(b.label))
      return measure(row, a, b, found, counts);
    const auto is_of_one_side = [&](const Part& part) {
      return part.patch.surface == b.patch.surface && part.is_back == b.is_back;
    };
    // All that is free of a side, once.
    if (&*std::ranges::find_if(table_.parts(b.label), is_of_one_side) != &b) return;
    for (const Part& free : table_.free_parts(b.label))
      if (is_of_one_side(free)) measure(row, a, free, found, counts);
  }

  void measure(PairRow3& row, const Part& a, const Part& b, Found& found, ExchangeReport3& counts) const {
    const PairResult3 pair = patches_.with(
        b, [&](const PairPatch3& known) { return row.measure(known, request_of(a, b, Effort3::kUsual)); });
    ++(pair.sight == PairVisibility3::kHidden  ? counts.hidden
       : pair.sight == PairVisibility3::kClear ? counts.clear
                                               : counts.mixed);
    add_work(pair, counts);
    const bool is_zero = pair.bounds.upper == 0;
    if (is_zero && !stands_for_what_is_hidden(a, b)) return;
    const PairSum3 sum = sum_of(a, b, pair);
    if (pair.problem.empty())
      found.pairs.push_back(sum);
    else
      found.open.push_back({sum, &a, &b, pair.is_undecided, pair.problem});
  }

 public:
  // Tries more.
  void measure_again(OpenPair& open, ExchangeReport3& counts) const {
    const PairResult3 pair =
        prepared_.measurer().measure(open.a->patch, open.b->patch, request_of(*open.a, *open.b, Effort3::kAll));
    add_work(pair, counts);
    open.sum = sum_of(*open.a, *open.b, pair);
    open.is_undecided = pair.is_undecided;
    open.problem = pair.problem;
  }

 private:
  PairRequest3 request_of(const Part& a, const Part& b, Effort3 effort) const {
    return {.share = shares_.share(a, b), .effort = effort, .proves = request_.proves};
  }

  PairSum3 sum_of(const Part& a, const Part& b, const PairResult3& pair) const {
    const bool is_zero = pair.bounds.upper == 0;
    PairSum3 sum{.i = a.holder, .j = b.holder, .is_whole = !is_zero && pair.is_whole};
    if (!is_zero) {
      sum.measure = pair.measure;
      sum.error = pair.error;
      sum.bounds = pair.bounds;
    }
    if (request_.wants_visibility && !b.patch.is_sky() && !is_zero && !sum.is_whole && !is_of_groups(a, b))
      sum.alone = pair.alone > 0 ? pair.alone : measure_alone(a, b);
    return sum;
  }

  double measure_alone(const Part& a, const Part& b) const {
    return unobstructed_measure(prepared_.occluders().vertices(), a.patch, b.patch, request_.tolerance).measure;
  }

  bool is_of_groups(const Part& a, const Part& b) const {
    return !table_.is_one_patch(a.label) || !table_.is_one_patch(b.label);
  }

  // Whether a pair that exchanges nothing is kept, so that the sum of two groups knows of it.
  bool stands_for_what_is_hidden(const Part& a, const Part& b) const {
    return request_.wants_visibility && !b.patch.is_sky() && is_of_groups(a, b) &&
           face_each_other(prepared_.occluders(), a, b);
  }

  const PreparedScene3& prepared_;
  const ElementTable3& table_;
  const PairSumRequest3& request_;
  const Tasks tasks_;
  mutable RowsAtHand rows_;
  mutable PatchesAtHand patches_;
  const PairShares3 shares_;
};

void add_counts(ExchangeReport3& report, const ExchangeReport3& some) {
  report.hidden += some.hidden;
  report.clear += some.clear;
  report.mixed += some.mixed;
  add_work(some, report);
}

void add_to(PairSum3& sum, const PairSum3& other) {
  sum.measure += other.measure;
  sum.error += other.error;
  sum.bounds = sum_of_nonnegative(sum.bounds, other.bounds);
  sum.alone += other.alone;
  sum.is_whole = sum.is_whole && other.is_whole;
}

std::pair<std::uint32_t, std::uint32_t> key_of(const PairSum3& pair) { return {pair.i, pair.j}; }

// Sums what has the same numbers, in the order of the list.
void sum_equal(std::vector<PairSum3>& pairs) {
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const PairSum3& a, const PairSum3& b) { return key_of(a) < key_of(b); });
  std::size_t count = 0;
  for (const PairSum3& pair : pairs) {
    if (count > 0 && key_of(pairs[count - 1]) == key_of(pair))
      add_to(pairs[count - 1], pair);
    else
      pairs[count++] = pair;
  }
  pairs.resize(count);
}

// Tries more for pairs of patches that are not within their shares, where what all patches of their holders may be off
// together is not within the tolerance. Puts them among `pairs`, which are summed by holders, or tells that they
// failed.
void settle(const Measuring& measuring, std::vector<OpenPair>& open, std::vector<PairSum3>& pairs,
            std::vector<FailedPair3>& failures, ExchangeReport3& report) {
  if (open.empty()) return;
  std::stable_sort(open.begin(), open.end(),
                   [](const OpenPair& a, const OpenPair& b) { return key_of(a.sum) < key_of(b.sum); });
  std::vector<std::span<OpenPair>> of_holders;
  for (std::size_t k = 0, end; k < open.size(); k = end) {
    for (end = k + 1; end < open.size() && key_of(open[end].sum) == key_of(open[k].sum);) ++end;
    of_holders.emplace_back(open.data() + k, open.data() + end);
  }
  // What the holders' measure may be off, over the smaller of their areas.
  const auto reached = [&](std::span<const OpenPair> some) {
    const auto [i, j] = key_of(some.front().sum);
    const auto others = std::lower_bound(pairs.begin(), pairs.end(), some.front().sum,
                                         [](const PairSum3& a, const PairSum3& b) { return key_of(a) < key_of(b); });
    double error = others != pairs.end() && key_of(*others) == std::pair(i, j) ? others->error : 0;
    for (const OpenPair& one : some) error += one.sum.error;
    return (i == j ? 2 : 1) * error / measuring.shares().least_area(i, j);
  };
  const auto is_done = [&](std::span<const OpenPair> some) {
    return reached(some) <= measuring.tolerance() &&
           std::none_of(some.begin(), some.end(), [](const OpenPair& one) { return one.is_undecided; });
  };
  std::vector<OpenPair*> again;
  for (const std::span<OpenPair> some : of_holders)
    if (!is_done(some))
      for (OpenPair& one : some) again.push_back(&one);
  std::mutex together;
  parallel_ranges(again.size(), 1, [&](std::size_t begin, std::size_t end) {
    ExchangeReport3 counts;
    for (std::size_t k = begin; k < end; ++k) {
      throw_if_interrupted();
      measuring.measure_again(*again[k], counts);
    }
    const std::lock_guard lock(together);
    add_counts(report, counts);
  });
  std::vector<PairSum3> more;
  for (const std::span<const OpenPair> some : of_holders) {
    if (is_done(some)) {
      for (const OpenPair& one : some) more.push_back(one.sum);
      continue;
    }
    const auto why = std::max_element(some.begin(), some.end(), [](const OpenPair& a, const OpenPair& b) {
      const auto key = [](const OpenPair& one) {
        return std::tuple(one.is_undecided, !one.problem.empty(), one.sum.error);
      };
      return key(a) < key(b);
    });
    failures.push_back({some.front().a->label, some.front().b->label, reached(some), why->is_undecided, why->problem});
  }
  pairs.insert(pairs.end(), more.begin(), more.end());
}

// Of two failures of one pair of elements the worse.
void keep_worst(std::vector<FailedPair3>& failures) {
  const auto key = [](const FailedPair3& failure) { return std::pair(failure.i, failure.j); };
  std::stable_sort(failures.begin(), failures.end(), [&](const FailedPair3& a, const FailedPair3& b) {
    return std::tuple(key(a), !a.is_undecided, -a.reached) < std::tuple(key(b), !b.is_undecided, -b.reached);
  });
  failures.erase(std::unique(failures.begin(), failures.end(),
                             [&](const FailedPair3& a, const FailedPair3& b) { return key(a) == key(b); }),
                 failures.end());
}

// Here alone, or with others.
std::unique_ptr<PairWork3> begin_work(const PreparedScene3& prepared, const ElementTable3& table,
                                      const PairSumRequest3& request, const Tasks& tasks) {
  constexpr std::size_t kMostAtATime = 4096;  // what is found of them is some megabytes
  const WorkSizes sizes{.count = tasks.count(), .dear = tasks.with_sky(), .most = kMostAtATime};
  if (request.shared) return begin_shared<DoneTasks3>(PairJob3{prepared, *request.shared, table, request, sizes});
  return std::make_unique<OwnWork<DoneTasks3>>(sizes, static_cast<std::size_t>(threads_allowed()));
}

// Before a failure, which is told whatever comes of it.
void hand_over_before(PairHandover3& handover) {
  try {
    handover.hand_over();
  } catch (const std::exception&) {
  }
}

}  // namespace

std::vector<std::uint32_t> labels_of_holders(const ElementTable3& table) {
  std::vector<std::uint32_t> labels;
  if (!table.is_by_group()) return labels;
  labels.resize(table.holders() + std::size_t{1}, 0);
  for (const Part& part : table.parts()) labels[part.holder] = part.label;
  return labels;
}

std::vector<PairSum3> by_elements(const std::vector<std::uint32_t>& labels, std::vector<PairSum3> pairs,
                                  std::span<const PairSum3> contacts) {
  sum_equal(pairs);
  if (!labels.empty())
    for (PairSum3& pair : pairs) {
      pair.i = labels[pair.i];
      pair.j = labels[pair.j];
      if (pair.i > pair.j) std::swap(pair.i, pair.j);
    }
  pairs.insert(pairs.end(), contacts.begin(), contacts.end());
  sum_equal(pairs);
  for (PairSum3& pair : pairs)
    if (pair.i == pair.j) add_to(pair, PairSum3(pair));
  return pairs;
}

PairSum3 contact_pair(const ElementTable3& table, const ElementTable3::Contact& contact) {
  const std::uint32_t i = std::min(contact.mask, contact.base), j = std::max(contact.mask, contact.base);
  const double area = contact.extent.value;
  const bool are_patches = table.is_one_patch(i) && table.is_one_patch(j);
  return {.i = i, .j = j, .measure = area, .bounds = contact.extent.enclosure(), .alone = are_patches ? area : 0};
}

PairSums3 sum_pairs(const PreparedScene3& prepared, const ElementTable3& table, const PairSumRequest3& request,
                    ExchangeReport3& report) {
  const Measuring measuring(prepared, table, request);
  const Tasks& tasks = measuring.tasks();
  const std::vector<std::uint32_t> labels = labels_of_holders(table);
  FoundOfTasks3 found;
  ProgressCount progress(request.progress, tasks.count());
  std::atomic<std::uint64_t> found_pairs{0};
  std::mutex together;
  std::optional<PairHandover3> handover;
  if (request.sink) handover.emplace(table, labels, tasks, request, found);
  const std::unique_ptr<PairWork3> work = begin_work(prepared, table, request, tasks);
  const auto have = [&](std::size_t t, Found some) {
    some.pairs.shrink_to_fit();
    some.open.shrink_to_fit();
    const std::size_t more = some.pairs.size() + some.open.size();
    found.put(t, std::move(some));
    if (handover) handover->has_done(t);
    if (found_pairs.fetch_add(more, std::memory_order_relaxed) + more > request.most_pairs)
      throw RequestError("more than " + std::to_string(request.most_pairs) +
                         " pairs see each other: they need more memory than is allowed");
    progress.add();
  };
  const auto measure_some = [&](WorkTurn<DoneTasks3> turn) {
    ExchangeReport3 counts;
    if (turn.there) {
      counts = turn.there->counts;
      auto some = turn.there->found.begin();
      const auto end = turn.there->found.end();
      for (std::size_t t = turn.there->tasks.begin; t < turn.there->tasks.end; ++t)
        have(t, some != end && some->first == t ? std::move((some++)->second) : Found());
    } else {
      for (std::size_t t = turn.here.begin; t < turn.here.end; ++t) {
        Found some;
        measuring.run(tasks[t], some, counts);
        have(t, std::move(some));
      }
    }
    const std::lock_guard lock(together);
    add_counts(report, counts);
  };
  try {
    take_all_turns(*work, tasks.count(), threads_allowed(), measure_some);
  } catch (const ContractViolation&) {
    throw;  // what was found may be counted twice
  } catch (...) {
    if (handover) hand_over_before(*handover);
    throw;
  }
  if (handover) handover->hand_over();

  // What has not been handed over: everything, or pairs that are open.
  std::vector<PairSum3> of_holders;
  std::vector<OpenPair> open;
  found.take_each([&](Found& some) {
    of_holders.insert(of_holders.end(), some.pairs.begin(), some.pairs.end());
    std::move(some.open.begin(), some.open.end(), std::back_inserter(open));
  });
  std::set<std::pair<std::uint32_t, std::uint32_t>> are_open;
  for (const OpenPair& one : open) are_open.emplace(one.a->label, one.b->label);
  sum_equal(of_holders);
  PairSums3 result;
  settle(measuring, open, of_holders, result.failures, report);
  keep_worst(result.failures);
  std::vector<PairSum3> contacts;
  for (const ElementTable3::Contact& contact : table.contacts()) {
    const PairSum3 pair = contact_pair(table, contact);
    const bool is_asked = request.turn == nullptr || request.turn->has(pair.i, pair.j);
    if (is_asked && (!handover || are_open.contains(key_of(pair)))) contacts.push_back(pair);
  }
  result.pairs = by_elements(labels, std::move(of_holders), contacts);
  if (!handover) return result;
  handover->hand_over_settled(result.pairs, result.failures);
  std::vector<PairSum3> handed = handover->take();
  const auto middle = handed.insert(handed.end(), result.pairs.begin(), result.pairs.end());
  std::inplace_merge(handed.begin(), middle, handed.end(),
                     [](const PairSum3& a, const PairSum3& b) { return key_of(a) < key_of(b); });
  result.pairs = std::move(handed);
  return result;
}

struct PairHelper3::Inside {
  PairSumRequest3 request;
  Measuring measuring;

  Inside(const PreparedScene3& prepared, const ElementTable3& table, const PairSumRequest3& its)
      : request(its), measuring(prepared, table, request) {}
};

PairHelper3::PairHelper3(const PreparedScene3& prepared, const ElementTable3& table, const PairSumRequest3& request)
    : inside_(std::make_unique<const Inside>(prepared, table, request)) {}
PairHelper3::~PairHelper3() = default;

std::size_t PairHelper3::tasks() const { return inside_->measuring.tasks().count(); }

DoneTasks3 PairHelper3::measure(const WorkRange& tasks) const {
  HOTTEL_REQUIRE(tasks.begin <= tasks.end && tasks.end <= this->tasks());
  const Measuring& measuring = inside_->measuring;
  std::vector<Found> found(tasks.size());
  DoneTasks3 done{.tasks = tasks, .found = {}};
  std::mutex together;
  parallel_ranges(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
    ExchangeReport3 counts;
    for (std::size_t k = begin; k < end; ++k) measuring.run(measuring.tasks()[tasks.begin + k], found[k], counts);
    const std::lock_guard lock(together);
    add_counts(done.counts, counts);
  });
  for (std::size_t k = 0; k < found.size(); ++k)
    if (!found[k].pairs.empty() || !found[k].open.empty())
      done.found.emplace_back(tasks.begin + k, std::move(found[k]));
  return done;
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
    visible += found.pairs.size() + found.open.size();
  });
  const double all = static_cast<double>(sky_begin) * static_cast<double>(sky_begin - 1) / 2;
  return static_cast<std::uint64_t>(all * static_cast<double>(visible) / kSample);
}

}  // namespace hottel
