// How one radiosity system is solved: by what, and how its bounds come about.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "kernel/support/stopwatch.h"
#include "solver/radiosity/cached_inverses.h"
#include "solver/radiosity/certificate.h"
#include "solver/radiosity/high_precision_elimination.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/row_crew.h"

namespace hottel {

// A system with all that is kept of it from one solution to the next.
struct CachedSystem {
  RadiositySystem system;
  HighPrecisionElimination wide;
  CachedInverses inverses;

  CachedSystem(const ExchangeMatrix& matrix, const std::vector<Rational>& reflectivity)
      : system(matrix, reflectivity), wide(system), inverses(system) {}
  CachedSystem(const CachedSystem&) = delete;
  CachedSystem& operator=(const CachedSystem&) = delete;
};

// Seconds of stages, of several systems one after the other.
struct StageTimes {
  std::map<std::string, double> seconds;
  Stopwatch watch;

  void lap(const char* stage) { seconds[stage] += watch.lap(); }
};

// Solves a system for sources that shine on some of its components.
//
//   (1) which solver is used follows from the options and from the largest component that is wanted, or, where rows do
//       not sum to 1, from the size of the system
//   (2) every result is certified alike, whichever solver that is
//   (3) where it iterates, other processes take part in it if there is a crew (RowCrew); an elimination is done here
// REQUIRES that the system and the options outlive this.
class SystemSolver {
 public:
  // Throws RequestError where the solver that was asked for needs a symmetric matrix and this is none, and, unless
  // bounds may be open, where light may not die out.
  SystemSolver(const CachedSystem& kept, std::vector<char> is_wanted, const RadiosityOptions& options, bool may_be_open,
               StageTimes& times);

  Solver used() const { return used_; }
  // Whether solutions are refined until they are as good as their factors.
  bool is_refined() const;
  // Who else has rows of the system; null: nobody.
  SharedRows* others() const { return others_.get(); }

  // Bounds of all unknowns; what was done is added to `history` and `notes`. REQUIRES sources that shine on wanted
  // components alone.
  CertifiedBounds solve(const Sources& sources, const ErrorTerms& terms, std::vector<double>& history,
                        std::set<std::string>& notes, StageTimes& times) const;

 private:
  void prepare_symmetric();
  void prepare_any(bool may_be_open);
  void share_rows();
  void run_as_named(const Sources& sources, SplitVector& x, std::vector<double>& history,
                    std::set<std::string>& notes) const;

  const CachedSystem& kept_;
  std::vector<char> is_wanted_;
  const RadiosityOptions& options_;
  std::unique_ptr<SharedRows> others_;
  std::shared_ptr<const ApproximateInverse> inverse_;  // it may use the others
  Solver used_ = Solver::kAuto;
};

}  // namespace hottel
