// What the integral over a piece is, within proven bounds. Internal to geometry/space.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/space/pieces/arc_sum.h"
#include "geometry/space/pieces/sure_part.h"
#include "geometry/space/proven/proof_counts.h"
#include "geometry/space/proven/proven_polynomial.h"
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
// The upper half of the ellipse is covered by discs; over each the squares and products of vectors, which are
// polynomials of t, are enclosed, and from them roots and angles. Where one of them may hold a singular point it is
// divided, where that does not help the ellipse shrinks, then the part is halved.
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
  std::optional<double> largest_on_ellipse(double half, double rho);
  // The integrand at a t, and over a disc of u = t - middle. REQUIRES: the turns are found.
  Ball3<Real> at_node(double from, const Ball3<Real>& offset);
  Disc3 over_disc(const Disc3& offset);
  void find_polynomials(double middle);

  // What the integrand is made of.
  template <class Number>
  struct Parts {
    std::vector<Number> corner_squares;          // of the directions to corners
    std::vector<Number> plane_squares, moments;  // of normals, and their products with the moment
    std::vector<Number> sines, cosines;          // n . (b x e) and b . e of arcs
  };
  template <class Number>
  void find_parts(const std::vector<ProvenPoint3<Number>>& corners, const std::vector<ProvenPoint3<Number>>& normals,
                  const ProvenPoint3<Number>& moment, Parts<Number>& parts) const;
  // The sum over arcs of count / 2 (moment . normal) / |normal| times the angle.
  template <class Number>
  Number integrand(const Parts<Number>& parts) const;

  const ProvenPiece3<Real>& piece_;
  const ProvenMoment3<Real>& moment_;
  ProvenPiece3<double> in_doubles_;
  Parts<ProvenPolynomial3> polynomials_;  // of u, for the part at hand
  ProvenMoment3<double> moment_in_doubles_;
  double allowed_, most_seen_, largest_ = 0;
  int halvings_left_;
  std::vector<Turn> turns_;
  ProofCounts3& counts_;
};

}  // namespace hottel
