// The pairs of patches of a scene in pieces of work, and what each of these finds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/exchange/pair_sum.h"
#include "geometry/space/prepared/element_table.h"

namespace hottel {

// One patch, and some of those after it.
struct PairTask3 {
  std::size_t patch, begin, end;
};

// All pairs: first each patch that has a row with the sky, which is often the most expensive one; then each patch with
// those after it, a few at a time.
class PairTasks3 {
 public:
  explicit PairTasks3(const ElementTable3& table) : table_(table), sky_begin_(table.parts().size() - sky_size()) {
    sky_task_.assign(sky_begin_, kNoTask);
    for (std::size_t a = 0; a < sky_begin_; ++a) {
      if (!table.has_row(table.parts()[a].label)) continue;
      sky_task_[a] = with_sky_.size();
      with_sky_.push_back(a);
    }
    first_.push_back(with_sky_.size());
    for (std::size_t a = 0; a < sky_begin_; ++a)
      first_.push_back(first_.back() + (sky_begin_ - a - 1 + kPairsOfATask - 1) / kPairsOfATask);
  }

  std::size_t count() const { return first_.back(); }
  // How many of them, the first ones, are of patches with the sky.
  std::size_t with_sky() const { return with_sky_.size(); }
  PairTask3 operator[](std::size_t task) const {
    if (task < with_sky_.size()) return {with_sky_[task], sky_begin_, table_.parts().size()};
    const auto after = std::upper_bound(first_.begin(), first_.end(), task);
    const auto a = static_cast<std::size_t>(after - first_.begin()) - 1;
    const std::size_t begin = a + 1 + (task - first_[a]) * kPairsOfATask;
    return {a, begin, std::min(begin + kPairsOfATask, sky_begin_)};
  }
  // Of one patch that is no sky and another one after it.
  bool is_asked(const ElementTable3::Part& a, const ElementTable3::Part& b) const {
    return table_.has_row(a.label) || table_.has_row(b.label);
  }

  // The numbers of patches from here on are those of the sky.
  std::size_t sky_begin() const { return sky_begin_; }
  // The task of a patch with the sky; kNoTask where it has no row.
  static constexpr std::size_t kNoTask = static_cast<std::size_t>(-1);
  std::size_t sky_task(std::size_t patch) const { return sky_task_[patch]; }
  // Its tasks with those after it, [first, second).
  std::pair<std::size_t, std::size_t> tasks(std::size_t patch) const { return {first_[patch], first_[patch + 1]}; }

 private:
  // So few pairs that the most expensive ones do not come at the end of much.
  static constexpr std::size_t kPairsOfATask = 16;

  std::size_t sky_size() const { return table_.parts(table_.sky()).size(); }

  const ElementTable3& table_;
  std::size_t sky_begin_;
  std::vector<std::size_t> with_sky_, sky_task_;
  std::vector<std::size_t> first_;  // the first task of each patch
};

// Two patches that could not be measured within their share.
struct OpenPair3 {
  PairSum3 sum;  // i, j: holders
  const ElementTable3::Part *a, *b;
  bool is_undecided;
  std::string problem;
};

// What one task found, in the order of the patches, by holders.
struct FoundPairs3 {
  std::vector<PairSum3> pairs;
  std::vector<OpenPair3> open;
};

// What all tasks found: of those that found nothing there is nothing. For several threads at once.
class FoundOfTasks3 {
 public:
  // Of a task that is done. REQUIRES: once a task.
  void put(std::size_t task, FoundPairs3 found) {
    if (found.pairs.empty() && found.open.empty()) return;
    const std::lock_guard lock(mutex_);
    found_.emplace(task, std::move(found));
  }
  // Of those from `first` to before `last` that found something and are done, as they are numbered; with their numbers.
  std::vector<std::pair<std::size_t, FoundPairs3*>> among(std::size_t first, std::size_t last) {
    const std::lock_guard lock(mutex_);
    std::vector<std::pair<std::size_t, FoundPairs3*>> result;
    for (auto place = found_.lower_bound(first); place != found_.end() && place->first < last; ++place)
      result.emplace_back(place->first, &place->second);
    return result;
  }
  void drop(std::size_t task) {
    const std::lock_guard lock(mutex_);
    found_.erase(task);
  }
  // Calls it for each, as they are numbered, and drops it. REQUIRES that no task runs.
  template <class Visit>
  void take_each(const Visit& visit) {
    for (auto place = found_.begin(); place != found_.end(); place = found_.erase(place)) visit(place->second);
  }

 private:
  std::mutex mutex_;
  std::map<std::size_t, FoundPairs3> found_;
};

// The element of each holder, where groups are elements; else empty: they are the same.
std::vector<std::uint32_t> labels_of_holders(const ElementTable3& table);
// Sums what stands for one pair of holders, then what stands for one pair of elements, contacts among them, in the
// order of the lists. A pair of one element with itself counts both directions.
std::vector<PairSum3> by_elements(const std::vector<std::uint32_t>& labels, std::vector<PairSum3> pairs,
                                  std::span<const PairSum3> contacts);
// What a mask and its base exchange where they touch.
PairSum3 contact_pair(const ElementTable3& table, const ElementTable3::Contact& contact);

}  // namespace hottel
