// Where factors are kept from one run to the next: what a store does for whoever computes them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "geometry/element.h"
#include "geometry/pair_ranges.h"

namespace hottel {

// What kept factors belong to. Two runs with the same table may take each other's factors.
//
//   (1) `key` is all that a pair's numbers depend on beside its two elements: the exact geometry, the method with its
//       variant and seed, the tolerance, and how numbers are written down. Colours are none of it
//   (2) `elements` tells each element from all others that this scene may ever be divided into (element_id); their
//       order is that of the rows. They are no part of the key: what was kept of other elements of the same scene
//       serves those that are in both
struct StoreTable {
  std::string key;
  std::string about;  // for people: scene and method
  std::vector<std::string> elements;
};

// The id of an element: its name, and of a part of a divided face how many parts there are: "wall", "wall:back",
// "wall#2 of 4".
std::string element_id(const Element& element);
std::vector<std::string> element_ids(const std::vector<Element>& elements);

// Pairs of one element with others, itself, or the sky. Half of a table: the pair (i, j), i <= j, is in row i.
//
//   (1) all pairs with the columns of `known` are known; those that have no entry exchange nothing
//   (2) `to` ascends and lies in `known`; `numbers` has what is kept of each entry, one after the other, as whoever
//       wrote it reads it
//   (3) the row of the sky, which has no pairs, holds what is kept of all rows together, if anything
struct CachedRow {
  std::uint32_t row = 0;
  std::vector<ColumnRange> known;
  std::vector<std::uint32_t> to;
  std::string numbers;
  friend bool operator==(const CachedRow&, const CachedRow&) = default;
};

// Rows of elements of this table or another one of the same key.
struct CachedRows {
  std::vector<std::uint32_t> place;  // of each kept element, then of the sky, in the table that asks, or kNoPlace
  std::vector<CachedRow> rows;       // row and columns are indices into `place`
  static constexpr std::uint32_t kNoPlace = 0xffffffff;
};

// What runs took from a store, and gave to it: pairs that exchange light, and records that were found damaged.
struct StoreUse {
  std::uint64_t computed = 0, read = 0, damaged = 0;
};

// Kept factors.
//
//   (1) what is read is what was kept, bit for bit, or is not there
//   (2) what does not match its checksum is not returned; it is counted, and gone with the next keep()
//   (3) keep() is of one run among others: readers see a row whole or not at all, a second writer waits
// The functions throw InputError naming the file where it is damaged, OutputError where it cannot be written.
class FactorStore {
 public:
  virtual ~FactorStore() = default;

  // Returns all rows kept under the key for some element of the table that have at least the bits of `what`, whose
  // meaning is up to whoever keeps factors.
  virtual std::vector<CachedRows> read(const StoreTable& table, std::uint32_t what) = 0;
  // Keeps rows of the elements of the table. What there is no room for is not kept.
  virtual void keep(const StoreTable& table, std::uint32_t what, std::span<const CachedRow> rows) = 0;
  // Takes out all that is kept of the key.
  virtual void forget(const StoreTable& table) = 0;

  // Counts of this object. add() is for whoever computes; damaged records are counted here.
  virtual void add(std::uint64_t computed, std::uint64_t read) = 0;
  virtual StoreUse use() const = 0;
};

}  // namespace hottel
