// What is wrong with a matrix of view factors that another program computed, in words.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/compare/fault.h"
#include "solver/compare/judged_pairs.h"
#include "solver/compare/method_report.h"

namespace hottel {

class JudgedScene;

// One fault, with its evidence.
struct FoundFault {
  Fault fault;                  // the first of `parts`
  std::vector<Fault> parts;     // what was done at once, to every pair
  std::string words;            // one sentence
  std::uint64_t explained = 0;  // pairs that are off, but agree once this fault is allowed for
  std::vector<JudgedPair> worst;
};

// What a matrix is allowed, and how its file was written.
struct VerdictOptions {
  double beyond = 1e-6;    // a pair is off when it is wrong by more than this and the digits left out together
  WrittenFactors written;  // has_column may be empty: all are there
};

// What is to be said of a matrix: how many pairs are off, which laws it breaks, and what would explain it.
struct Verdict {
  VerdictOptions options;
  std::uint64_t pairs = 0, off = 0;  // that were judged; that are off
  double max_error = 0;

  // Laws that hold for view factors, of the matrix by itself; violations beyond `beyond` and the digits left out.
  std::uint64_t unsymmetric = 0, rows_off = 0, negative = 0, above_one = 0;
  double reciprocity_defect = 0;  // max |A_i F_ij - A_j F_ji| / min(A_i, A_j)
  double row_defect = 0;          // max |row sum - exact sum of the row over the columns there are|
  double least = 0, most = 0;     // factors

  std::vector<FoundFault> findings;           // what explains most comes first; each pair is counted once
  bool has_unnamed = false;                   // some reading explained less than its share
  std::uint64_t unexplained = 0;              // off, and by no fault that is known
  std::vector<JudgedPair> worst_unexplained;  // at most kPairsNamed, the worst first
};

// Callbacks while a matrix is judged; each may be empty.
struct VerdictWatch {
  std::function<void(const Verdict&)> on_laws;  // before readings are looked for: without findings
  std::function<void(double)> progress;         // fraction of the readings that were looked for; may throw to stop
};

inline constexpr std::size_t kPairsNamed = 5;
inline constexpr double kLeastShare = 0.02;         // of the pairs off, that a reading explains to be named
inline constexpr double kLeastShareOfFitted = 0.2;  // the same of one with numbers that were fitted: a ratio, or many

// A reading is a candidate explanation of the numbers, a fault its kind; a finding is a reading that explains enough
// pairs.
//
// Holds a matrix against the exact one of a scene (solver/plane/compare/verdict.h takes a prepared scene of the plane).
//
//   (1) a pair is off iff every number that prints as the file has it is wrong by more than `beyond`: roundings to the
//       digits of the file are no errors
//   (2) findings are readings of the numbers, not proofs: each is backed by the number of pairs it explains, that is,
//       which agree within `beyond` and the digits left out once it is allowed for, and are at least twice as near as
//       before
//   (3) the findings and what is unexplained partition the pairs that are off
//   (4) a reading is a finding only where it explains kLeastShare of the pairs that are off, or more; a constant or a
//       ratio for each row kLeastShareOfFitted
//   (5) the scatter of rays (sampling_noise.h) is a reading like others; where the errors as a whole are no such
//       scatter, it is tried again on the pairs that the other readings leave; what is found then may be biased
// Rows and columns that the file does not have are not judged.
// REQUIRES: both matrices are over the elements of the scene; the exact one has visibilities.
// COST: a few passes over both matrices; when something is off, what the scene takes to answer (judged_scene.h).
Verdict judge(const JudgedScene& scene, const ExchangeMatrix& exact, const ExchangeMatrix& matrix,
              const VerdictOptions& options, const VerdictWatch& watch = {});

// The verdict as sentences, most important first: how many pairs are off, and which laws hold; then a sentence a
// finding, and one for what is left unexplained. They name at most kPairsNamed pairs each.
// REQUIRES the exact matrix of this verdict.
std::vector<std::string> law_sentences(const Verdict& verdict);
std::vector<std::string> finding_sentences(const Verdict& verdict, const ExchangeMatrix& exact);
std::vector<std::string> verdict_sentences(const Verdict& verdict, const ExchangeMatrix& exact);  // all of these

}  // namespace hottel
