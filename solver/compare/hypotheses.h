// Ways to read the numbers that are off: each says which pairs it explains.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solver/compare/fault.h"
#include "solver/compare/judged_pairs.h"

namespace hottel {

// One hypothesis about all pairs at once: what the file would hold if one fault had been made.
//
//   (1) explains[k] is 1 only where pair k is off; it is 0 elsewhere
//   (2) the value of an explained pair agrees with what the fault would have put there (JudgedPairs::agrees); kBehind
//       alone predicts no value
//   (3) `words` may be empty where nothing is explained, and are not to be printed then
struct Hypothesis {
  Fault fault;
  std::vector<char> explains;  // by place in JudgedPairs::pairs(); only of pairs that are off
  std::string words;
  std::vector<Fault> parts = {};  // of several faults at once (composed_readings.h); empty: the one

  // How many pairs it explains. COST: one pass over them.
  std::uint64_t count() const;
};

// Returns the hypothesis of this fault that explains no pair, without words.
Hypothesis explains_nothing(Fault fault, const JudgedPairs& judged);

// What follows from the numbers of both matrices alone: the scene is not asked. COST of each, unless it says otherwise:
// one pass over the pairs, with a search in a row for each where another entry is looked up.
//
// F(j, i) stands for F(i, j). Where this explains all pairs off between faces with a row, and three at least, the empty
// columns of faces without a row are explained with them.
Hypothesis suppose_transposed(const JudgedPairs& judged);
// All factors times one ratio. Tried are those that the largest 24 factors off have, the best of them fitted to what it
// explains, and the names of named_factors.h; of equally many explained pairs a name is preferred.
//
//   (1) a ratio without a name counts only where it explains three different factors
//   (2) a pair whose exact factor is 0 is not explained
Hypothesis suppose_constant_factor(const JudgedPairs& judged);
// The factors of a row times one ratio other than 0, fitted without the sky. The words tell rows that are normalised
// and areas that are exchanged apart.
//
//   (1) rows count only where all their factors, the sky's left aside, agree with the ratio
//   (2) nothing is explained where each such row has only one factor that is off: any number is a multiple of another
Hypothesis suppose_row_factor(const JudgedPairs& judged);
// The faces with a row in another order: value(i, j) is exact(p(i), p(j)), one p for all. Backs without a row
// and the sky stay.
//
// Nothing is explained with fewer than two pairs off, nor beyond 500 faces. COST: a search that takes back what does
// not fit, and gives up after 20 million comparisons; memory for the square of the number of faces.
Hypothesis suppose_permuted(const JudgedPairs& judged);
// Rows, columns or both shifted by one to three places over all elements and the sky, over all elements, or over those
// with a row: value(i, j) is exact(i + s, j + t) with (s, t) = (s, s), (s, 0) or (0, s), going round. Explains nothing
// unless it does for nine tenths of the pairs off, and for three factors that are not 0.
Hypothesis suppose_shifted(const JudgedPairs& judged);
// Only the rows in another order: each row that is off holds the numbers of another one; and the same of columns.
// Nothing is explained unless all do, with fewer than two rows, nor beyond 500 faces. COST: all pairs of rows.
Hypothesis suppose_rows_permuted(const JudgedPairs& judged);
Hypothesis suppose_columns_permuted(const JudgedPairs& judged);
// Factors to the sky that are 0.
Hypothesis suppose_sky_missing(const JudgedPairs& judged);
// Factors to the sky that are what the other factors of the row lack of 1.
Hypothesis suppose_sky_is_rest(const JudgedPairs& judged);
// Factors of any column that are 0, though the exact ones are not. The words tell where one triangle of the matrix is
// all there is.
Hypothesis suppose_missing(const JudgedPairs& judged);

}  // namespace hottel
