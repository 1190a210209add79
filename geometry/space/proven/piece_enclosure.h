// What the integral over a piece is, within proven bounds. Internal to geometry/space.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/space/pieces/arc_sum.h"
#include "geometry/space/pieces/sure_part.h"
#include "geometry/space/proven/proof_counts.h"
#include "geometry/space/proven/proven_vector.h"

namespace hottel {

// A part of a stretch along which what is seen is bounded by the same arcs, as StretchPiece3, with vectors that enclose
// theirs.
template <class Real>
struct ProvenPiece3 {
  std::vector<ProvenVector3<Real>> planes, corners;
  std::vector<SeenArc3> arcs;

  ProvenPiece3() = default;
  explicit ProvenPiece3(const WholePiece3<Real>& piece) : arcs(piece.arcs) {
    for (const auto& plane : piece.planes) planes.push_back(proven_vector_3(plane));
    for (const auto& corner : piece.corners) corners.push_back(proven_vector_3(corner));
  }
};

// The moment of a stretch, each component within `error`.
template <class Real>
struct ProvenMoment3 {
  LocalVector3<Real> value;
  double error = 0;
  double size = 0;  // no less than its length
};

// What the rule of n nodes on [-1, 1] is off at most, n >= 2, for a function that is analytic within the ellipse of rho
// and no larger there than `largest`: (64 / 15) M rho^(-2n) / (1 - rho^-2), rounded up.
double error_of_rule_3(double largest, double rho, int n);

// Encloses integrals of moment . Lambda over intervals of t. By the rule of n nodes on each part, of half length h, and
// the ellipse with the ends of the part as foci and rho as the sum of its half axes, in half lengths: where the
// integrand is analytic in it and no larger than M, the rule is off by no more than h error_of_rule_3(M, rho, n).
// The upper half of the ellipse is covered by discs. Where one of them may hold a singular point it is divided, where
// that does not help the ellipse shrinks, then the part is halved.
template <class Real>
class PieceEncloser3 {
 public:
  // What rules may be off for each unit of t. `most_seen`: no less than the integral of |w . m| over what is seen, for
  // any unit vector m; what cannot be proven is bounded by it.
  PieceEncloser3(const ProvenPiece3<Real>& piece, const ProvenMoment3<Real>& moment, double allowed, double most_seen,
                 ProofCounts3& counts);

  // The integral from one t to another one.
  Ball3<double> enclose(double low, double high);
  // What the integrand is at most, as the formula of its arcs, where enclose() went.
  double largest() const { return largest_; }

 private:
  // How the angle of an arc is taken: 0: as 2 atan(X / (R + Y)); else sign pi - 2 atan(X / (R - Y)).
  using Turn = signed char;

  Ball3<double> enclose(double low, double high, int halvings);
  std::optional<Ball3<double>> enclose_by_rule(double low, double high);
  bool find_turns(double middle);
  double nearest_singularity(double middle, double half) const;
  std::optional<double> largest_on_ellipse(double middle, double half, double rho);
  template <class Number, class Of>
  Number integrand(const ProvenPiece3<Of>& piece, const ProvenMoment3<Of>& moment, double from, const Number& offset);
  template <class Number>
  Number angle(const SeenArc3& arc, Turn turn, const ProvenPoint3<Number>& normal, const Number& over_length,
               const std::vector<ProvenPoint3<Number>>& corners, const std::vector<Number>& lengths) const;

  const ProvenPiece3<Real>& piece_;
  const ProvenMoment3<Real>& moment_;
  ProvenPiece3<double> in_doubles_;
  ProvenMoment3<double> moment_in_doubles_;
  double allowed_, most_seen_, largest_ = 0;
  int halvings_left_;
  std::vector<Turn> turns_;
  ProofCounts3& counts_;
};

}  // namespace hottel
