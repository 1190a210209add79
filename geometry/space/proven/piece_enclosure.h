// What the integral over a piece is, within proven bounds. Internal to geometry/space.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/space/proven/arcs_on_ellipse.h"
#include "geometry/space/proven/proof_counts.h"
#include "geometry/space/proven/proven_piece.h"

namespace hottel {

// What the rule of n nodes on [-1, 1] is off at most, n >= 2, for a function that is analytic within the ellipse of rho
// and no larger there than `largest`: (64 / 15) M rho^(-2n) / (1 - rho^-2), rounded up.
double error_of_rule_3(double largest, double rho, int n);

// Encloses integrals of moment . Lambda over intervals of t. By the rule of n nodes on each part, of half length h, and
// the ellipse with the ends of the part as foci and rho as the sum of its half axes, in half lengths: where the
// integrand is analytic in it and no larger than M, the rule is off by no more than h error_of_rule_3(M, rho, n).
// ArcsOnEllipse3 tells M. Where no ellipse will do the part is halved.
template <class Real>
class PieceEncloser3 {
 public:
  // What rules may be off for each unit of t. `most_seen`: no less than the integral of |w . m| over what is seen, for
  // any unit vector m; what cannot be proven is bounded by it.
  PieceEncloser3(const ProvenPiece3<Real>& piece, const ProvenMoment3<Real>& moment, double allowed, double most_seen,
                 ProofCounts3& counts);

  // The integral from one t to another one.
  Ball3<double> enclose(double low, double high);
  // What the integrand is at most, as the formula of its arcs, where enclose() went, in gaps of that length together on
  // both sides of which that is what is seen.
  double most_in_gaps(double gaps) const;

 private:
  // An ellipse, what the integrand is on it at most, and the nodes that it takes.
  struct Choice {
    double rho = 0, largest = 0;
    int nodes = 0;
  };

  Ball3<double> enclose(double low, double high, int halvings);
  std::optional<Ball3<double>> enclose_by_rule(double low, double high);
  std::optional<Choice> choose(ArcsOnEllipse3& arcs) const;

  const ProvenPiece3<Real>& piece_;
  const ProvenMoment3<Real>& moment_;
  LocalVector3<double> moment_in_doubles_;
  double moment_off_;
  double allowed_, most_seen_, largest_ = 0, steepest_ = 0;
  int halvings_left_;
  ProofCounts3& counts_;
};

}  // namespace hottel
