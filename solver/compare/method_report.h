// What methods of computing view factors say of themselves and of a run, and what is known of numbers that were read
// from a file: how finely they were written, and which were there.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_report.h"
#include "kernel/enclosure.h"

namespace hottel {

class ExchangeMatrix;

// What a method says of itself before it has run.
struct MethodInfo {
  std::string name;      // in full, variant and parameter included: "gauss:4:normalised"
  std::string family;    // what a sweep of the parameter belongs to: "gauss"
  double parameter = 0;  // points, pixels, rays; 0 when there is none
  Guarantee guarantee = Guarantee::kEstimated;
  std::string reference;  // who described it, and where
};

// How many digits a file spends on its numbers. A number that was printed stands for an interval: half a unit of the
// last place to each side. Shortest decimals drop zeros at the end, so the digits are those of the file as a whole, not
// of one number; and since "%.6f" keeps decimals and "%.6g" significant digits, the coarser of the two counts.
//
//   (1) a number correctly rounded to the file's digits differs from what was meant by no more than rounding(value)
struct WrittenDigits {
  int decimals = 0;     // the most places after the point
  int significant = 0;  // the most significant digits; 0: nothing was printed, rounding(v) is relative * |v|
  double relative = 0;  // of a binary format: 2^-24 for single, 2^-53 for double precision

  // Returns how far a number that prints as `value` may be from it: half a unit of the last place written. Fewer than
  // three places or digits are taken for three. [unit of the value]
  double rounding(double value) const;
};

// What a file of factors tells besides its numbers, laid out as the elements of a scene.
struct WrittenFactors {
  WrittenDigits digits;
  std::vector<char> has_column;  // by element, the sky last: the file has a place for what goes there; empty: all are
  std::vector<char> has_row;     // by element: the file has numbers of what leaves it; empty: all are there

  bool has_place(std::uint32_t from, std::uint32_t to) const {
    return (has_row.empty() || has_row[from]) && (has_column.empty() || has_column[to]);
  }
  bool is_whole() const {
    const auto has_all = [](const std::vector<char>& has) { return std::find(has.begin(), has.end(), 0) == has.end(); };
    return has_all(has_row) && has_all(has_column);
  }
};

// How a matrix came about: what a method tells of one run.
struct MethodReport {
  ExchangeReport counts;                  // of the scene and the matrix; tiers and gaps where the method has any
  double row_defect = 0;                  // max |sum_j F_ij - 1| as computed, before any normalisation
  std::optional<double> standard_error;   // of the worst factor, where the method is random
  std::optional<double> seconds;          // where the method knows better than who called it (an outside command)
  std::optional<WrittenFactors> written;  // where the factors were read from a file
  std::vector<std::string> notes;         // e.g. the seed
  std::vector<std::string> gaps;  // those of the notes that tell of columns a file has not, be there light or not
};

// What is said first of the factors of a method that is not exact: what is guaranteed of them, and of which elements
// with a row a file has none.
std::string method_sentence(const MethodInfo& info, const ExchangeMatrix& matrix, const MethodReport& report);

// Seconds of wall-clock time.
struct Timing {
  double median = 0, fastest = 0, slowest = 0;
  int runs = 0;  // that were counted
};

}  // namespace hottel
