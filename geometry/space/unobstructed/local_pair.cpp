#include "geometry/space/unobstructed/local_pair.h"

#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>

namespace hottel {
namespace {

constexpr long kSmallBits = 52;
constexpr long kLongBits = 62;
constexpr long kFractionBits = 128;  // of a cut corner in units of local coordinates

std::strong_ordering order(const Integer& a, const Integer& b) { return cmp(a, b) <=> 0; }

std::strong_ordering order(const IntegerVector& a, const IntegerVector& b) {
  if (const auto x = order(a.x, b.x); x != 0) return x;
  if (const auto y = order(a.y, b.y); y != 0) return y;
  return order(a.z, b.z);
}

bool comes_first(std::span<const IntegerVector> a, std::span<const IntegerVector> b) {
  if (a.size() != b.size()) return a.size() < b.size();
  for (std::size_t k = 0; k < a.size(); ++k)
    if (const auto c = order(a[k], b[k]); c != 0) return c < 0;
  return true;
}

IntegerVector times(const Integer& factor, const IntegerVector& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}

// Three corners of a convex polygon without straight angles, far from each other: never on one line.
std::array<std::size_t, 3> spread(std::size_t count) { return {0, count / 3, 2 * count / 3}; }

// Sets result to a - b, and the bits of `all` to those that are set in it or were before, where both are below 2^61 and
// their difference is below 2^52.
bool set_difference(double& result, std::uint64_t& all, const Integer& a, const Integer& b) {
  constexpr long kMost = 1L << kSmallBits, kFits = 1L << (kLongBits - 1);
  if (!a.fits_slong_p() || !b.fits_slong_p()) return false;
  const long p = a.get_si(), q = b.get_si();
  if (p < -kFits || p > kFits || q < -kFits || q > kFits) return false;
  result = static_cast<double>(p - q);
  all |= static_cast<std::uint64_t>(p - q);
  return -kMost < p - q && p - q < kMost;
}

}  // namespace

BoundedVector bounded_difference_3(const BoundedVector& a, const BoundedVector& b) {
  BoundedVector d{a.x - b.x, a.y - b.y, a.z - b.z};
  d.size = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  if (a.error != 0 || b.error != 0) d.error = 1.001 * (a.error + b.error + 0x1p-53 * d.size);
  return d;
}

LocalPair3::LocalPair3(const Patch3& i, const Patch3& j) {
  std::array<const Patch3*, 2> patch{&i, &j};
  weight_ = i.weight;
  for (int s = 0; s < 2; ++s) sides_[s].exact = patch[s]->corners;
  if (i.weight != j.weight) {
    const Integer common = gcd(i.weight, j.weight);
    weight_ = i.weight / common * j.weight;
    for (int s = 0; s < 2; ++s) {
      const Integer factor = patch[1 - s]->weight / common;
      for (const IntegerVector& corner : patch[s]->corners) sides_[s].scaled.push_back(times(factor, corner));
      sides_[s].exact = sides_[s].scaled;
    }
  }
  if (!comes_first(sides_[0].exact, sides_[1].exact)) std::swap(sides_[0], sides_[1]);

  make_small();
  if (!is_small_) make_large();
  find_extent();
  for (Side& side : sides_) {
    const auto [a, b, c] = spread(side.local.size());
    side.normal = hottel::cross(bounded_difference_3(side.local[b], side.local[a]),
                                bounded_difference_3(side.local[c], side.local[a]));
  }
  face_each_other_ = has_front(0) && has_front(1);
  if (!face_each_other_) return;
  for (int s = 0; s < 2; ++s) cut(s);
}

void LocalPair3::make_small() {
  origin_ = sides_[0].exact[0];
  std::uint64_t all = 0;
  for (Side& side : sides_) {
    side.local.clear();
    for (const IntegerVector& corner : side.exact) {
      BoundedVector d;
      if (!set_difference(d.x, all, corner.x, origin_.x) || !set_difference(d.y, all, corner.y, origin_.y) ||
          !set_difference(d.z, all, corner.z, origin_.z))
        return;
      side.local.push_back(d);
    }
  }
  shift_ = std::countr_zero(all);
  const double unit = std::ldexp(1, static_cast<int>(-shift_));
  for (Side& side : sides_)
    for (BoundedVector& d : side.local) {
      d = {unit * d.x, unit * d.y, unit * d.z};
      d.size = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
    }
  is_small_ = is_long_ = true;
}

// As above: differences are divided by the power of two that they have in common. Where they do not fit even so, the
// origin is a corner of the smaller patch, whose coordinates then have small errors.
void LocalPair3::make_large() {
  std::array<std::vector<IntegerVector>, 2> moved;
  long top = move_to_origin(moved);
  if (top > kSmallBits) {
    std::array<long, 2> reach{0, 0};
    for (int s = 0; s < 2; ++s)
      for (const IntegerVector& corner : sides_[s].exact)
        reach[s] = std::max(reach[s], bits(difference(corner, sides_[s].exact[0])));
    origin_ = sides_[reach[0] <= reach[1] ? 0 : 1].exact[0];
    top = move_to_origin(moved);
  }
  is_small_ = top <= kSmallBits;
  is_long_ = top <= kLongBits;
  const long rest = std::max(0L, top - kSmallBits);
  for (int s = 0; s < 2; ++s) {
    sides_[s].local.clear();
    for (const IntegerVector& corner : moved[s]) sides_[s].local.push_back(rounded(corner, rest));
  }
  shift_ += rest;
}

// Sets the integers that are left of the differences to the origin without their common power of two, 2^shift_; returns
// the bits of the largest.
long LocalPair3::move_to_origin(std::array<std::vector<IntegerVector>, 2>& moved) {
  long top = 0;
  mp_bitcnt_t common = std::numeric_limits<mp_bitcnt_t>::max();
  for (int s = 0; s < 2; ++s) {
    moved[s].clear();
    for (const IntegerVector& corner : sides_[s].exact) {
      moved[s].push_back(difference(corner, origin_));
      const IntegerVector& d = moved[s].back();
      for (const Integer* part : {&d.x, &d.y, &d.z})
        if (*part != 0) common = std::min(common, mpz_scan1(part->get_mpz_t(), 0));
    }
  }
  for (auto& side : moved)
    for (IntegerVector& d : side) {
      d = {d.x >> common, d.y >> common, d.z >> common};
      top = std::max(top, bits(d));
    }
  shift_ = static_cast<long>(common);
  return top;
}

void LocalPair3::find_extent() {
  BoundedVector low = sides_[0].local[0], high = low;
  for (const Side& side : sides_)
    for (const BoundedVector& p : side.local) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  extent_ = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

IntegerVector LocalPair3::exact_normal(int side) const {
  const auto& corners = sides_[side].exact;
  const auto [a, b, c] = spread(corners.size());
  return hottel::cross(difference(corners[b], corners[a]), difference(corners[c], corners[a]));
}

// Finds the signs of its corners at the plane of the other one, and whether one of them is in front of it.
bool LocalPair3::has_front(int side) {
  Side& own = sides_[side];
  const Side& other = sides_[1 - side];
  bool has_positive = false;
  for (std::size_t k = 0; k < own.local.size(); ++k) {
    int sign = filtered_sign(other.normal, bounded_difference_3(own.local[k], other.local[0]));
    if (sign == kUndecided) sign = sgn(dot(exact_normal(1 - side), difference(own.exact[k], other.exact[0])));
    own.signs.push_back(sign);
    has_positive |= sign > 0;
    own.is_cut |= sign < 0;
  }
  return has_positive;
}

// Some corner is in front; where others are behind, the outline changes sides twice, at a corner or within a side.
void LocalPair3::cut(int side) {
  Side& own = sides_[side];
  const std::size_t count = own.local.size();
  const IntegerVector normal = own.is_cut ? exact_normal(1 - side) : IntegerVector{};
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t next = k + 1 == count ? 0 : k + 1;
    const int here = own.signs[k], there = own.signs[next];
    if (here >= 0) {
      const bool stays = here > 0 || there >= 0;
      own.outline.push_back({own.local[k], static_cast<int>(k), stays ? static_cast<int>(k) : Corner::kCut, {}, {}});
    }
    if (here * there >= 0) continue;
    own.outline.push_back(cut_corner(side, k, next, normal));
    if (here < 0) own.outline.back().edge = static_cast<int>(k);
    has_inexact_cut_ |= own.outline.back().position.error != 0;
  }
}

LocalPair3::Corner LocalPair3::cut_corner(int side, std::size_t from, std::size_t to,
                                          const IntegerVector& normal) const {
  const IntegerVector &a = sides_[side].exact[from], &b = sides_[side].exact[to];
  const IntegerVector& base = sides_[1 - side].exact[0];
  const Integer over_a = dot(normal, difference(a, base)), over_b = dot(normal, difference(b, base));
  Corner corner;
  corner.denominator = over_a - over_b;
  corner.numerator = difference(times(over_a, b), times(over_b, a));
  if (corner.denominator < 0) {
    corner.denominator = -corner.denominator;
    corner.numerator = times(-1, corner.numerator);
  }
  const IntegerVector top = difference(corner.numerator, times(corner.denominator, origin_));
  // Where all else is integer, this may be so too.
  bool is_integer = is_small_;
  const Integer unit = is_small_ ? Integer(corner.denominator << shift_) : Integer(0);
  const auto quotient = [&](const Integer& part) -> double {
    is_integer = is_integer && mpz_divisible_p(part.get_mpz_t(), unit.get_mpz_t());
    const Integer whole = (part << kFractionBits) / corner.denominator;
    long exponent;
    const double mantissa = mpz_get_d_2exp(&exponent, whole.get_mpz_t());
    return mantissa == 0 ? 0 : std::ldexp(mantissa, static_cast<int>(exponent - kFractionBits - shift_));
  };
  BoundedVector& p = corner.position;
  p.x = quotient(top.x);
  p.y = quotient(top.y);
  p.z = quotient(top.z);
  p.size = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  if (!is_integer) p.error = 0x1p-51 * p.size + 0x1p-120 * extent_;
  return corner;
}

std::pair<IntegerVector, Integer> LocalPair3::exact_position(int side, const Corner& corner) const {
  if (corner.corner == Corner::kCut)
    return {difference(corner.numerator, times(corner.denominator, origin_)), corner.denominator};
  return {difference(sides_[side].exact[static_cast<std::size_t>(corner.corner)], origin_), 1};
}

IntegerVector LocalPair3::direction(int side, const Corner& corner) const {
  if (corner.edge == Corner::kCut) return hottel::cross(exact_normal(0), exact_normal(1));
  const auto& corners = sides_[side].exact;
  const auto k = static_cast<std::size_t>(corner.edge);
  return difference(corners[k + 1 == corners.size() ? 0 : k + 1], corners[k]);
}

bool LocalPair3::are_parallel(std::size_t k, std::size_t m) const {
  const auto &a = sides_[0].outline, &b = sides_[1].outline;
  const auto vector = [](const std::vector<Corner>& outline, std::size_t at) {
    return bounded_difference_3(outline[at + 1 == outline.size() ? 0 : at + 1].position, outline[at].position);
  };
  const BoundedVector n = hottel::cross(vector(a, k), vector(b, m));
  if (n.size > n.error) return false;
  return is_zero(hottel::cross(direction(0, a[k]), direction(1, b[m])));
}

bool LocalPair3::are_same(std::size_t k, std::size_t m) const {
  const Corner &a = sides_[0].outline[k], &b = sides_[1].outline[m];
  const BoundedVector d = bounded_difference_3(a.position, b.position);
  if (d.size > d.error) return false;
  if (d.error == 0) return true;
  return is_zero(exact_difference(0, a, 1, b));
}

bool LocalPair3::is_on(int side, std::size_t k, std::size_t m) const {
  const auto& outline = sides_[1 - side].outline;
  const Corner &p = sides_[side].outline[k], &a = outline[m], &b = outline[m + 1 == outline.size() ? 0 : m + 1];
  const BoundedVector n =
      hottel::cross(bounded_difference_3(p.position, a.position), bounded_difference_3(b.position, a.position));
  if (n.size > n.error) return false;
  const IntegerVector along = direction(1 - side, a), from_a = exact_difference(side, p, 1 - side, a),
                      to_b = exact_difference(1 - side, b, side, p);
  const int sign = sgn(dot(from_a, along));
  return is_zero(hottel::cross(from_a, along)) && sign != 0 && sgn(dot(to_b, along)) == sign;
}

const IntegerVector& LocalPair3::numerator(int side, const Corner& corner) const {
  return corner.corner == Corner::kCut ? corner.numerator : sides_[side].exact[static_cast<std::size_t>(corner.corner)];
}

IntegerVector LocalPair3::exact_difference(int side_a, const Corner& a, int side_b, const Corner& b) const {
  return difference(times(denominator(b), numerator(side_a, a)), times(denominator(a), numerator(side_b, b)));
}

}  // namespace hottel
