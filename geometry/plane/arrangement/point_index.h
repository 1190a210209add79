// Exact points, each once.
#pragma once

#include <unordered_map>
#include <vector>

#include "geometry/plane/predicates/vertices.h"

namespace hottel {

// A hash of the numerators and denominators. Equal points have equal hashes because rationals are canonical: lowest
// terms, denominator positive.                                                COST: linear in the digits.
struct PointHash2 {
  std::size_t operator()(const Point2& p) const {
    std::size_t hash = 0x9e3779b97f4a7c15ull;
    const auto mix = [&hash](mpz_srcptr z) {
      hash = (hash ^ static_cast<std::size_t>(mpz_sgn(z) + 1)) * 0xff51afd7ed558ccdull;
      const std::size_t limbs = mpz_size(z);
      for (std::size_t k = 0; k < limbs; ++k) {
        hash = (hash ^ mpz_getlimbn(z, static_cast<mp_size_t>(k))) * 0xff51afd7ed558ccdull;
        hash ^= hash >> 32;
      }
    };
    mix(p.x.get_num_mpz_t());
    mix(p.x.get_den_mpz_t());
    mix(p.y.get_num_mpz_t());
    mix(p.y.get_den_mpz_t());
    return hash;
  }
};

// Gives every distinct point a number.
//
//   (1) numbers are 0, 1, 2, ... in the order of first insertion; a point that comes again gets the one it has
//   (2) points are told apart exactly, whatever their distance: points()[insert(p).index()] == p
//   (3) points() has each point once; its size is the number of distinct points inserted
//
// COST: a hash and a comparison for each insertion; each point is held twice.
class PointIndex2 {
 public:
  PointIndex2() = default;
  explicit PointIndex2(const std::vector<Point2>& points) {
    for (const Point2& p : points) insert(p);
  }

  // Returns the number of a point, a new one where it has none.
  VertexId insert(const Point2& point) {
    const auto [place, is_new] = number_.try_emplace(point, points_.size());
    if (is_new) points_.push_back(point);
    return place->second;
  }

  // The points by number.
  const std::vector<Point2>& points() const { return points_; }

 private:
  std::unordered_map<Point2, VertexId, PointHash2> number_;
  std::vector<Point2> points_;
};

}  // namespace hottel
