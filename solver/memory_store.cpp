#include "solver/memory_store.h"

#include <algorithm>
#include <mutex>
#include <unordered_map>

namespace hottel {
namespace {

class MemoryStore final : public FactorStore {
 public:
  explicit MemoryStore(std::uint64_t bytes) : most_(bytes) {}

  std::vector<CachedRows> read(const StoreTable& table, std::uint32_t what) override {
    const std::lock_guard lock(mutex_);
    std::vector<CachedRows> result;
    const auto kept = lists_.find(table.key);
    if (kept == lists_.end()) return result;
    std::unordered_map<std::string, std::uint32_t> place;
    for (std::uint32_t i = 0; i < table.elements.size(); ++i) place.emplace(table.elements[i], i);
    for (const List& list : kept->second) {
      if ((list.what & what) != what) continue;
      CachedRows& rows = result.emplace_back();
      for (const std::string& element : list.elements) {
        const auto found = place.find(element);
        rows.place.push_back(found == place.end() ? CachedRows::kNoPlace : found->second);
      }
      const bool is_same_list = list.elements == table.elements;
      rows.place.push_back(static_cast<std::uint32_t>(table.elements.size()));
      for (const CachedRow& row : list.rows) {
        const bool is_of_all = row.row == list.elements.size();  // what is kept of all rows together
        if (is_of_all ? is_same_list : rows.place[row.row] != CachedRows::kNoPlace) rows.rows.push_back(row);
      }
      if (rows.rows.empty()) result.pop_back();
    }
    return result;
  }

  void keep(const StoreTable& table, std::uint32_t what, std::span<const CachedRow> rows) override {
    const std::lock_guard lock(mutex_);
    List list{table.elements, what, {rows.begin(), rows.end()}, order_++, 0};
    for (const CachedRow& row : rows)
      list.bytes += row.numbers.size() + row.to.size() * sizeof(row.to[0]) + row.known.size() * sizeof(row.known[0]);
    bytes_ += list.bytes;
    lists_[table.key].push_back(std::move(list));
    while (bytes_ > most_ && give_up_oldest()) {
    }
  }

  void forget(const StoreTable& table) override {
    const std::lock_guard lock(mutex_);
    const auto kept = lists_.find(table.key);
    if (kept == lists_.end()) return;
    for (const List& list : kept->second) bytes_ -= list.bytes;
    lists_.erase(kept);
  }

  void add(std::uint64_t computed, std::uint64_t read) override {
    const std::lock_guard lock(mutex_);
    use_.computed += computed;
    use_.read += read;
  }

  StoreUse use() const override {
    const std::lock_guard lock(mutex_);
    return use_;
  }

 private:
  struct List {
    std::vector<std::string> elements;
    std::uint32_t what;
    std::vector<CachedRow> rows;
    std::uint64_t order, bytes;
  };

  // Lists of one key are in the order in which they were kept.
  bool give_up_oldest() {
    const auto oldest =
        std::ranges::min_element(lists_, {}, [](const auto& of_key) { return of_key.second.front().order; });
    if (oldest == lists_.end()) return false;
    bytes_ -= oldest->second.front().bytes;
    oldest->second.erase(oldest->second.begin());
    if (oldest->second.empty()) lists_.erase(oldest);
    return true;
  }

  mutable std::mutex mutex_;
  std::uint64_t most_, bytes_ = 0, order_ = 0;
  std::unordered_map<std::string, std::vector<List>> lists_;  // by key; none is empty
  StoreUse use_;
};

}  // namespace

std::shared_ptr<FactorStore> make_memory_store(std::uint64_t bytes) { return std::make_shared<MemoryStore>(bytes); }

}  // namespace hottel
