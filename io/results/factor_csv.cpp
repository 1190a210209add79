// View factors as a list in csv: the file that most others read.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "io/results/factor_files.h"
#include "io/results/listed_factors.h"
#include "io/results/short_digits.h"
#include "io/results/text_buffer.h"
#include "kernel/support/parallel.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

// Ends of blocks of rows from `first` up to `end` with about as many entries each; the last one is `end`.
std::vector<std::uint32_t> ends_of_blocks(const ExchangeMatrix& matrix, std::uint32_t first, std::uint32_t end) {
  constexpr std::size_t kEntries = 1 << 12;
  std::vector<std::uint32_t> ends;
  std::size_t entries = 0;
  for (std::uint32_t i = first; i < end; ++i) {
    entries += matrix.row(i).size() + 1;
    if (entries < kEntries && i + 1 < end) continue;
    ends.push_back(i + 1);
    entries = 0;
  }
  return ends;
}

// Hands on what write(first, end, text) writes of these rows, in their order; it is called for blocks of rows on all
// threads. While some blocks are written the ones before them are handed on, by one thread at a time.
template <class Write>
void write_in_blocks(const ExchangeMatrix& matrix, std::uint32_t first_row, std::uint32_t end_row, const Sink& sink,
                     const Write& write) {
  constexpr std::size_t kAtOnce = 32;
  const std::vector<std::uint32_t> ends = ends_of_blocks(matrix, first_row, end_row);
  std::vector<TextBuffer> texts(std::min(kAtOnce, ends.size()), TextBuffer(sink, std::string::npos)), ready = texts;
  for (std::size_t begin = 0; begin < ends.size() + texts.size(); begin += texts.size()) {
    const std::size_t count = begin < ends.size() ? std::min(texts.size(), ends.size() - begin) : 0;
    parallel_for(count + 1, [&](std::size_t k) {
      if (k == 0) {
        for (TextBuffer& text : ready) text.flush();
        return;
      }
      const std::size_t block = begin + k - 1;
      write(block == 0 ? first_row : ends[block - 1], ends[block], texts[k - 1]);
    });
    texts.swap(ready);
  }
}

// `factor,lower,upper,visibility`, as many digits as tell the doubles.
void write_whole_numbers(const FactorEntry& entry, const Enclosure& bounds, TextBuffer& out) {
  const Digits factor(entry.factor.value);
  const auto write_bound = [&](double bound) {
    if (bound == entry.factor.value)
      out << factor.text();
    else
      out << bound;
    out << ',';
  };
  out << factor.text() << ',';
  write_bound(bounds.lower);
  write_bound(bounds.upper);
  if (entry.visibility == 1)
    out << '1';
  else if (!std::isnan(entry.visibility))
    out << entry.visibility;
}

void write_numbers(const FactorEntry& entry, const Enclosure& bounds, std::optional<int> digits, TextBuffer& out) {
  if (!digits) return write_whole_numbers(entry, bounds, out);
  out << short_digits(entry.factor.value, digits) << ',' << short_digits(bounds.lower, digits, RoundedTo::kBelow) << ','
      << short_digits(bounds.upper, digits, RoundedTo::kAbove) << ',';
  if (!std::isnan(entry.visibility)) out << short_visibility(entry.visibility, digits);
}

}  // namespace

void write_factors_csv(const FactorTable& table, const Sink& sink) {
  const ExchangeMatrix& matrix = table.matrix;
  const std::vector<std::string> names = csv_names(matrix);
  sink(table.has_areas ? "from,to,factor,lower,upper,visibility,guarantee,from_area,to_area\n"
                       : "from,to,factor,lower,upper,visibility,guarantee\n");
  const auto write_area = [&](std::uint32_t i, TextBuffer& out) {
    out << ',';
    if (i == matrix.sky()) return;
    out << short_digits(required_double(matrix.elements()[i].area, area_of(matrix, i)), table.digits);
  };
  const auto write_rows = [&](std::uint32_t first, std::uint32_t end, TextBuffer& out) {
    const auto write = [&](std::uint32_t from, const FactorEntry& entry, const Enclosure& bounds, Guarantee guarantee) {
      out << names[from] << ',' << names[entry.to] << ',';
      write_numbers(entry, bounds, table.digits, out);
      out << ',' << to_string(guarantee);
      if (table.has_areas) {
        write_area(from, out);
        write_area(entry.to, out);
      }
      out << '\n';
    };
    for_each_listed(table, first, end, write);
  };
  for_each_range(
      table, [&](std::uint32_t first, std::uint32_t end) { write_in_blocks(matrix, first, end, sink, write_rows); });
}

}  // namespace hottel
