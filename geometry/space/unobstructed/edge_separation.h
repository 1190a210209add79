// How far two straight edges are from each other, as errors of quadrature see it.
//
// Quadrature. Let E be the error of the rule of Gauss with n nodes for a mean over [0, 1].
//
//   Lemma 1. For ln |s - z|, z complex, |E| <= (1/n) (1 + 1/(4n^2 - 1)) rho^-2n / (1 - rho^-2), where (rho + 1/rho)/2 =
//   |z - 0| + |z - 1|. With [-1, 1] for [0, 1], w = z + sqrt(z^2 - 1) and |w| = rho, ln(z - s) = ln(w/2) - the sum over
//   k >= 1 of (2/k) w^-k T_k(s); the rule is exact for T_k, k < 2n, and for odd k, and off by at most 2 + 2/(k^2 - 1)
//   for the others.
//
// For a point q of space, |e(s) - q| = |u| |s - z| for real s, with z = the foot of q on the line of e + i (its
// distance from that line) / |u|; and |z - 0| = |q - e(0)| / |u|, |z - 1| = |q - e(1)| / |u|. So ln |e(s) - q| is off
// by what lemma 1 says with (rho + 1/rho)/2 = (|q - e(0)| + |q - e(1)|) / |e(1) - e(0)|, the "sum" of q in what
// follows. Averages over points q of f are off by no more than the worst of them: that with the smallest sum, a convex
// function on f, which has its least value on the line of f where both distances make the same angle with it.
//
//   Lemma 2. A function that continues to the ellipse of rho, with |values| <= M there, is off by at most
//   (32/15) M rho^-2n / (1 - rho^-2), n >= 2 (Trefethen, Approximation theory and practice, chapter 19).
//
//   Lemma 3. The mean of ln |p - f(t)| over t is, but for a constant, pi delta(p) / |v|, delta being the distance from
//   the line of f, less what the line of f beyond both ends of f makes. delta is the root of a quadratic in s whose
//   zeros z have |z - 0| + |z - 1| = (delta_0 + delta_1) / |u x v| * |v|, and not more than delta_0 + delta_1 in the
//   ellipse through them: lemma 2. Where the feet of both ends of e are within f, points y beyond an end of f have sums
//   of at least A, that of the end, and at least 2y / |u|: lemma 1, integrated over y, gives at most its bound
//   for A times 2n / (2n - 1) A |u| / |v|.
//
// Lemma 3 is good where f comes near e between its ends, and lemma 1 where it does not.
#pragma once

#include "geometry/space/unobstructed/edge_pair.h"

namespace hottel {

// The four differences of ends, f(b) - e(a), and what they tell of the sums.
template <class Real>
class EdgeEnds3 {
 public:
  explicit EdgeEnds3(const EdgePair3<Real>& pair);

  const LocalVector3<Real>& at(int a, int b) const { return at_[a][b]; }
  double size(int a, int b) const { return static_cast<double>(size_[a][b]); }
  double farthest() const { return farthest_; }
  // Of edge 0, which is e, or 1, which is f.
  double length_of(int edge) const { return static_cast<double>(length_[edge]); }
  // Above what rounding makes of any of these.
  double blur() const { return blur_; }

  // The least sum of a point of f, for edge 0, or of one of e, for edge 1: at least what is returned.
  double least_sum(int edge) const;
  // The distance of end k of an edge from the line of the other one.
  Real height(int edge, int k) const;

 private:
  LocalVector3<Real> at_[2][2];
  Real size_[2][2], length_[2];
  LocalVector3<Real> u_, v_;
  double farthest_ = 0, blur_ = 0;
};

// What the sums of the points of two edges tell: the ellipses of lemma 1 for rules along e and f, and the least and the
// largest distance.
struct Reach3 {
  double rho_e, rho_f, nearest, farthest;

  template <class Real>
  explicit Reach3(const EdgeEnds3<Real>& ends);
  // The largest |ln| of a distance.
  double largest_log() const;
};

// The bound of lemma 1. REQUIRES n >= 2 and rho > 1.
double log_error_3(int n, double rho);
// The least even n for which that is within the tolerance, or 0 where it is above `most`.
int nodes_for_logs_3(double rho, double tolerance, int most);

// The error of a rule of n nodes along e for the mean over f, by lemma 3 or by lemma 1.
class RowError3 {
 public:
  template <class Real>
  RowError3(const EdgePair3<Real>& pair, const EdgeEnds3<Real>& ends);

  double operator()(int n) const;
  // The least even number of nodes, up to `most`, whose error is within the tolerance, or 0.
  int nodes_for(double tolerance, int most) const;

 private:
  double rho_;
  bool has_line_ = false;  // is lemma 3 better?
  double heights_ = 0, rho_line_ = 1, rho_end_[2] = {1, 1}, scale_[2] = {0, 0};
};

}  // namespace hottel
