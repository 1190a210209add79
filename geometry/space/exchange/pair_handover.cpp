#include "geometry/space/exchange/pair_handover.h"

#include <algorithm>
#include <utility>

namespace hottel {
namespace {

std::vector<ColumnRange> in_both(const std::vector<ColumnRange>& a, const std::vector<ColumnRange>& b) {
  std::vector<ColumnRange> result;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size(); a[i].end < b[j].end ? ++i : ++j) {
    const ColumnRange common{std::max(a[i].begin, b[j].begin), std::min(a[i].end, b[j].end)};
    if (common.begin < common.end) result.push_back(common);
  }
  return result;
}

}  // namespace

PairHandover3::PairHandover3(const ElementTable3& table, const std::vector<std::uint32_t>& labels,
                             const PairTasks3& tasks, const PairSumRequest3& request, FoundOfTasks3& found)
    : table_(table),
      labels_(labels),
      tasks_(tasks),
      request_(request),
      found_(found),
      done_(std::make_unique<std::atomic<std::uint64_t>[]>(tasks.count() / kBits + 1)),
      next_((Clock::now() + std::chrono::duration_cast<Clock::duration>(request.between)).time_since_epoch().count()),
      seen_(table.count()) {}

void PairHandover3::has_done(std::size_t task) {
  done_[task / kBits].fetch_or(std::uint64_t{1} << (task % kBits), std::memory_order_release);
  if (Clock::now().time_since_epoch().count() < next_.load(std::memory_order_relaxed)) return;
  // Whoever has it does it for all. A task that begins while this one waits for others may come back to here.
  if (is_busy_.test_and_set(std::memory_order_acquire)) return;
  struct Leave {
    std::atomic_flag& flag;
    ~Leave() { flag.clear(std::memory_order_release); }
  } const leave{is_busy_};
  hand_over();
}

void PairHandover3::hand_over_settled(std::vector<PairSum3>& pairs, const std::vector<FailedPair3>& failures) {
  const auto has_failed = [&](const PairSum3& pair) {
    return std::ranges::any_of(failures, [&](const FailedPair3& f) { return f.i == pair.i && f.j == pair.j; });
  };
  std::vector<PairSum3> settled;
  PairRanges known(table_.count());
  for (const PairSum3& pair : pairs) {
    if (has_failed(pair)) continue;
    settled.push_back(pair);
    known.add(pair.i, {pair.j, pair.j + 1});
  }
  if (settled.empty()) return;
  std::erase_if(pairs, [&](const PairSum3& pair) { return known.has(pair.i, pair.j); });
  request_.sink(settled, known);
  if (!request_.has_sink_alone) handed_.insert(handed_.end(), settled.begin(), settled.end());
}

std::vector<PairSum3> PairHandover3::take() {
  std::ranges::sort(handed_, {}, [](const PairSum3& pair) { return std::pair(pair.i, pair.j); });
  return std::move(handed_);
}

void PairHandover3::hand_over() {
  PairRanges known(table_.count());
  std::vector<PairSum3> pairs;
  bool is_any = false;
  for (std::uint32_t i = 0; i < table_.count(); ++i) {
    const std::vector<ColumnRange> left = seen_.missing(i);
    if (left.empty()) continue;
    const std::vector<ColumnRange> columns = in_both(left, complete_columns(i));
    for (const ColumnRange& range : columns) seen_.add(i, range);
    add_row(i, columns, known, pairs);
    is_any = is_any || !known.ranges(i).empty();
  }
  if (is_any) {
    request_.sink(pairs, known);
    if (!request_.has_sink_alone) handed_.insert(handed_.end(), pairs.begin(), pairs.end());
  }
  next_.store((Clock::now() + std::chrono::duration_cast<Clock::duration>(request_.between)).time_since_epoch().count(),
              std::memory_order_relaxed);
}

// Columns with which all patches of the element have been measured.
std::vector<ColumnRange> PairHandover3::complete_columns(std::uint32_t label) const {
  std::vector<ColumnRange> result{{label, table_.count() + 1}};
  const std::size_t begin = static_cast<std::size_t>(table_.parts(label).data() - table_.parts().data());
  for (std::size_t a = begin; a < begin + table_.parts(label).size() && !result.empty(); ++a)
    result = in_both(result, columns_of(a, label));
  return result;
}

// Columns with which this one has been. Elements that have no patch are among them as their neighbours are.
std::vector<ColumnRange> PairHandover3::columns_of(std::size_t patch, std::uint32_t label) const {
  const std::vector<ElementTable3::Part>& parts = table_.parts();
  std::vector<ColumnRange> result;
  const auto add = [&result](std::uint32_t begin, std::uint32_t end) {
    if (begin >= end) return;
    if (!result.empty() && result.back().end == begin)
      result.back().end = end;
    else
      result.push_back({begin, end});
  };
  const auto [first, last] = tasks_.tasks(patch);
  if (first == last) add(label, table_.count());
  for (std::size_t task = first; task < last;) {
    if (!is_done(task)) {
      ++task;
      continue;
    }
    const std::size_t begin = tasks_[task].begin;
    std::size_t end = begin;
    for (; task < last && is_done(task); ++task) end = tasks_[task].end;
    const bool cuts_first = begin > patch + 1 && parts[begin - 1].label == parts[begin].label;
    add(begin == patch + 1 ? label : parts[begin].label + (cuts_first ? 1 : 0),
        end == tasks_.sky_begin() ? table_.count() : parts[end].label);
  }
  const std::size_t with_sky = tasks_.sky_task(patch);
  if (with_sky == PairTasks3::kNoTask || is_done(with_sky)) add(table_.sky(), table_.sky() + 1);
  return result;
}

bool PairHandover3::is_ours(std::uint32_t i, std::uint32_t j) const {
  if (request_.turn == nullptr || request_.turn->has(i, j)) return true;
  return !request_.turn->is_of_sky_alone && !table_.has_row(i) && !table_.has_row(j) &&
         (request_.turn->known == nullptr || !request_.turn->known->has(i, j));
}

// Moves the pairs of a row and these columns out of the tasks.
void PairHandover3::add_row(std::uint32_t label, const std::vector<ColumnRange>& columns, PairRanges& known,
                            std::vector<PairSum3>& pairs) {
  if (columns.empty()) return;
  const std::size_t begin = static_cast<std::size_t>(table_.parts(label).data() - table_.parts().data());
  std::vector<std::pair<std::size_t, FoundPairs3*>> of_tasks;
  const auto add_tasks = [&](std::size_t first, std::size_t last) {
    for (const auto& found : found_.among(first, last))
      if (is_done(found.first)) of_tasks.push_back(found);
  };
  for (std::size_t a = begin; a < begin + table_.parts(label).size(); ++a) {
    if (tasks_.sky_task(a) != PairTasks3::kNoTask) add_tasks(tasks_.sky_task(a), tasks_.sky_task(a) + 1);
    add_tasks(tasks_.tasks(a).first, tasks_.tasks(a).second);
  }
  std::vector<std::uint32_t> are_open;
  for (const auto& [task, found] : of_tasks)
    for (const OpenPair3& open : found->open) are_open.push_back(open.b->label);
  for (const ColumnRange& range : columns)
    for (std::uint32_t j = range.begin; j < range.end;) {
      std::uint32_t end = j;
      while (end < range.end && is_ours(label, end) && std::ranges::find(are_open, end) == are_open.end()) ++end;
      if (end > j) known.add(label, {j, end});
      j = end + 1;
    }
  const auto is_now = [&](const PairSum3& pair) {
    return known.has(label, labels_.empty() ? pair.j : labels_[pair.j]);
  };
  std::vector<PairSum3> of_row, contacts;
  for (const auto& [task, found] : of_tasks) {
    std::ranges::copy_if(found->pairs, std::back_inserter(of_row), is_now);
    std::erase_if(found->pairs, is_now);
    if (found->pairs.empty() && found->open.empty()) found_.drop(task);
  }
  for (const ElementTable3::Contact& contact : table_.contacts()) {
    const PairSum3 pair = contact_pair(table_, contact);
    const bool is_asked = request_.turn == nullptr || table_.has_row(pair.i) || table_.has_row(pair.j);
    if (pair.i == label && is_asked && known.has(label, pair.j)) contacts.push_back(pair);
  }
  of_row = by_elements(labels_, std::move(of_row), contacts);
  pairs.insert(pairs.end(), of_row.begin(), of_row.end());
}

}  // namespace hottel
