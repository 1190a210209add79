// Exact points, each once.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "geometry/pair_table.h"
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
// COST: a hash and a comparison for each insertion; each point is held once, with 16 to 24 bytes beside it.
class PointIndex2 {
 public:
  PointIndex2() = default;
  explicit PointIndex2(const std::vector<Point2>& points) {
    reserve(points.size());
    for (const Point2& p : points) insert(p);
  }

  // Makes room for so many points.
  void reserve(std::size_t count) {
    points_.reserve(count);
    hashes_.reserve(count);
    while (3 * slots_.size() < 4 * count) grow();
  }

  // Returns the number of a point, a new one where it has none.
  VertexId insert(const Point2& point) {
    if (4 * (points_.size() + 1) > 3 * slots_.size()) grow();
    const std::uint64_t hash = PointHash2()(point);
    std::size_t place = slot_of(hash);
    for (; slots_[place] != kEmpty; place = next(place)) {
      const std::size_t k = slots_[place];
      if (hashes_[k] == hash && points_[k] == point) return VertexId(k);
    }
    slots_[place] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(point);
    hashes_.push_back(hash);
    return VertexId(points_.size() - 1);
  }

  // The points by number.
  const std::vector<Point2>& points() const { return points_; }

 private:
  static constexpr std::uint32_t kEmpty = ~std::uint32_t{0};

  std::size_t slot_of(std::uint64_t hash) const { return spread_key(hash, shift_); }
  std::size_t next(std::size_t place) const { return (place + 1) & (slots_.size() - 1); }
  void grow() {
    slots_.assign(slots_.empty() ? 16 : 2 * slots_.size(), kEmpty);
    shift_ = 64 - std::countr_zero(slots_.size());
    for (std::size_t k = 0; k < hashes_.size(); ++k) {
      std::size_t place = slot_of(hashes_[k]);
      while (slots_[place] != kEmpty) place = next(place);
      slots_[place] = static_cast<std::uint32_t>(k);
    }
  }

  std::vector<Point2> points_;
  std::vector<std::uint64_t> hashes_;  // of the points
  std::vector<std::uint32_t> slots_;   // numbers, at most three quarters of them taken
  int shift_ = 60;
};

}  // namespace hottel
