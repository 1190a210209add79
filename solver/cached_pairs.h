// Rows of a store, as pairs of the elements that are asked about.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/pair_ranges.h"
#include "solver/store.h"

namespace hottel {

// Numbers as they are kept: little-endian, doubles by their bits.
class NumberWriter {
 public:
  explicit NumberWriter(std::string& out) : out_(out) {}
  void byte(std::uint8_t value) { out_ += static_cast<char>(value); }
  void word(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) byte(static_cast<std::uint8_t>(value >> shift));
  }
  void number(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int shift = 0; shift < 64; shift += 8) byte(static_cast<std::uint8_t>(bits >> shift));
  }

 private:
  std::string& out_;
};

// Reads them again. Beyond the end it reads zeros, and is_whole() is false.
class NumberReader {
 public:
  explicit NumberReader(std::string_view text) : text_(text) {}
  std::uint8_t byte() {
    if (text_.empty()) {
      is_whole_ = false;
      return 0;
    }
    const auto value = static_cast<std::uint8_t>(text_.front());
    text_.remove_prefix(1);
    return value;
  }
  std::uint32_t word() {
    std::uint32_t value = 0;
    for (int shift = 0; shift < 32; shift += 8) value |= std::uint32_t{byte()} << shift;
    return value;
  }
  double number() {
    std::uint64_t bits = 0;
    for (int shift = 0; shift < 64; shift += 8) bits |= std::uint64_t{byte()} << shift;
    return std::bit_cast<double>(bits);
  }
  bool is_whole() const { return is_whole_; }
  bool is_at_end() const { return text_.empty(); }
  std::string_view rest() const { return text_; }

 private:
  std::string_view text_;
  bool is_whole_ = true;
};

// The columns of a kept row that are columns of the table that asks, as ranges there; none where its element, or their
// order, is another.
std::vector<ColumnRange> known_columns(const CachedRows& kept, const CachedRow& row, std::uint32_t elements);

// Adds all kept rows to what is known, and their entries to the list: `read` reads the numbers of one. A pair that was
// known before stays as it was. Rows whose numbers do not end with their entries are not taken.
template <class Entry>
void take_pairs(const std::vector<CachedRows>& kept, PairRanges& known, std::vector<Entry>& entries,
                Entry (*read)(NumberReader&)) {
  const std::uint32_t elements = known.elements();
  for (const CachedRows& some : kept)
    for (const CachedRow& row : some.rows) {
      const std::vector<ColumnRange> columns = known_columns(some, row, elements);
      if (columns.empty()) continue;
      const std::uint32_t i = some.place[row.row];
      NumberReader reader(row.numbers);
      std::vector<Entry> taken;
      for (const std::uint32_t to : row.to) {
        Entry entry = read(reader);
        const std::uint32_t j = some.place[to];
        if (j == CachedRows::kNoPlace || known.has(i, j)) continue;
        entry.i = i;
        entry.j = j;
        taken.push_back(entry);
      }
      if (!reader.is_whole() || !reader.is_at_end()) continue;
      entries.insert(entries.end(), taken.begin(), taken.end());
      for (const ColumnRange& range : columns) known.add(i, range);
    }
}

// Both factors of a pair as a matrix has them.
struct CachedFactors {
  std::uint32_t i = 0, j = 0;
  bool has_forth = false, has_back = false;
  Rounded forth, back;
  double visibility = 0, measure = 0;
};

// Bits of what is kept of a matrix.
inline constexpr std::uint32_t kKeptVisibilities = 1, kKeptMeasures = 2;

// Gives the pairs of a matrix that are not known, as rows to keep, some after the other; half of them by symmetry: 22
// bytes a pair where the double of one factor follows from that of the other within 127 units in the last place, 7 more
// where it does not; 8 less where the visibility is 1 or there is none. Not all of a matrix with bounds of its own, or
// of which the visibility of a pair is not the same both ways: then it returns false.
bool keep_matrix(const ExchangeMatrix& matrix, const PairRanges& known,
                 const std::function<void(std::span<const CachedRow>)>& keep);

// Returns the matrix of kept rows, or nothing where a pair is missing.
//
//   (1) it is that which was kept, bit for bit: visibilities are NaN where they are not wanted, but those of the sky,
//       measures are there where they are wanted
std::optional<ExchangeMatrix> cached_matrix(const std::vector<CachedRows>& kept, const std::vector<Element>& elements,
                                            Guarantee guarantee, std::uint32_t what, PairRanges& known);

}  // namespace hottel
