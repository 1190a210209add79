// View factors one after the other, each number in an array of its own.
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "kernel/enclosure.h"
#include "kernel/support/folder_memory.h"

namespace hottel {

// One view factor, as seen from its row.
struct FactorEntry {
  std::uint32_t to = 0;
  Rounded factor;
  double visibility = 1;  // Vis = S / S0, or NaN: ExchangeMatrix::visibilities() says where
};

// Some entries that stand one after the other in arrays. It is as cheap to copy as a span, and is valid as long as one.
//
// An entry is put together when it is asked for: `const FactorEntry& entry = row[k]` is a copy of its own.
class FactorRow {
 public:
  class Iterator;

  FactorRow() = default;
  // sides: null where all are 0.
  FactorRow(const std::uint32_t* columns, const double* factors, const signed char* sides, const double* visibilities,
            std::size_t size)
      : columns_(columns), factors_(factors), sides_(sides), visibilities_(visibilities), size_(size) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  FactorEntry operator[](std::size_t k) const {
    return {columns_[k], {factors_[k], sides_ == nullptr ? static_cast<signed char>(0) : sides_[k]}, visibilities_[k]};
  }
  FactorEntry front() const { return (*this)[0]; }
  FactorEntry back() const { return (*this)[size_ - 1]; }
  Iterator begin() const;
  Iterator end() const;

  // Where the entry of a column stands, if there is one. REQUIRES that columns ascend. COST: O(log n).
  std::optional<std::size_t> place_of(std::uint32_t to) const {
    const auto place = std::ranges::lower_bound(columns(), to);
    return place != columns().end() && *place == to ? std::optional(static_cast<std::size_t>(place - columns().begin()))
                                                    : std::nullopt;
  }
  std::optional<FactorEntry> find(std::uint32_t to) const {
    const auto place = place_of(to);
    return place ? std::optional((*this)[*place]) : std::nullopt;
  }

  std::span<const std::uint32_t> columns() const { return {columns_, size_}; }
  std::span<const double> factors() const { return {factors_, size_}; }

 private:
  const std::uint32_t* columns_ = nullptr;
  const double* factors_ = nullptr;
  const signed char* sides_ = nullptr;
  const double* visibilities_ = nullptr;
  std::size_t size_ = 0;
};

class FactorRow::Iterator {
 public:
  using value_type = FactorEntry;
  using reference = FactorEntry;
  using difference_type = std::ptrdiff_t;
  using iterator_category = std::random_access_iterator_tag;
  struct pointer {
    FactorEntry entry;
    const FactorEntry* operator->() const { return &entry; }
  };

  Iterator() = default;
  Iterator(const FactorRow& row, std::size_t place) : row_(row), place_(static_cast<difference_type>(place)) {}

  FactorEntry operator*() const { return row_[static_cast<std::size_t>(place_)]; }
  pointer operator->() const { return {**this}; }
  FactorEntry operator[](difference_type k) const { return *(*this + k); }

  Iterator& operator+=(difference_type k) {
    place_ += k;
    return *this;
  }
  Iterator& operator-=(difference_type k) { return *this += -k; }
  Iterator& operator++() { return *this += 1; }
  Iterator& operator--() { return *this -= 1; }
  Iterator operator++(int) {
    Iterator before = *this;
    ++*this;
    return before;
  }
  Iterator operator--(int) {
    Iterator before = *this;
    --*this;
    return before;
  }
  friend Iterator operator+(Iterator it, difference_type k) { return it += k; }
  friend Iterator operator+(difference_type k, Iterator it) { return it += k; }
  friend Iterator operator-(Iterator it, difference_type k) { return it -= k; }
  friend difference_type operator-(const Iterator& a, const Iterator& b) { return a.place_ - b.place_; }
  // REQUIRES of all comparisons: the same row.
  friend bool operator==(const Iterator& a, const Iterator& b) { return a.place_ == b.place_; }
  friend std::strong_ordering operator<=>(const Iterator& a, const Iterator& b) { return a.place_ <=> b.place_; }

 private:
  FactorRow row_;
  difference_type place_ = 0;
};

inline FactorRow::Iterator FactorRow::begin() const { return {*this, 0}; }
inline FactorRow::Iterator FactorRow::end() const { return {*this, size_}; }

// Entries that can be added and set. Different ones may be set by several threads at once.
class FactorEntries {
 public:
  FactorEntries() = default;
  // Without entries; they are to stand in files. `memory`: null for the heap.
  explicit FactorEntries(const std::shared_ptr<const FolderMemory>& memory)
      : columns_(PlacingAllocator<std::uint32_t>(memory)),
        factors_(PlacingAllocator<double>(memory)),
        sides_(PlacingAllocator<signed char>(memory)),
        visibilities_(PlacingAllocator<double>(memory)) {}
  explicit FactorEntries(std::size_t size) { resize(size); }
  FactorEntries(std::initializer_list<FactorEntry> entries) { append(entries); }
  FactorEntries(const std::vector<FactorEntry>& entries) { append(entries); }

  std::size_t size() const { return columns_.size(); }
  bool empty() const { return columns_.empty(); }
  void reserve(std::size_t size) {
    columns_.reserve(size);
    factors_.reserve(size);
    sides_.reserve(size);
    visibilities_.reserve(size);
  }
  void resize(std::size_t size) {
    columns_.resize(size);
    factors_.resize(size);
    sides_.resize(size);
    visibilities_.resize(size, 1);
  }
  void push_back(const FactorEntry& entry) {
    columns_.push_back(entry.to);
    factors_.push_back(entry.factor.value);
    sides_.push_back(entry.factor.side);
    visibilities_.push_back(entry.visibility);
  }
  template <class Range>
  void append(const Range& entries) {
    for (const FactorEntry& entry : entries) push_back(entry);
  }

  FactorEntry operator[](std::size_t k) const { return {columns_[k], {factors_[k], sides_[k]}, visibilities_[k]}; }
  void set(std::size_t k, const FactorEntry& entry) {
    columns_[k] = entry.to;
    factors_[k] = entry.factor.value;
    sides_[k] = entry.factor.side;
    visibilities_[k] = entry.visibility;
  }

 private:
  friend class ExchangeMatrix;

  PlacedArray<std::uint32_t> columns_;
  PlacedArray<double> factors_;
  PlacedArray<signed char> sides_;
  PlacedArray<double> visibilities_;
};

}  // namespace hottel
