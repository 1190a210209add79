#include "geometry/space/proven/edge_enclosure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "geometry/space/vectors/integer_reals.h"
#include "kernel/wide_real.h"

namespace hottel {
namespace {

using namespace ball_arithmetic_3;
using integer_reals::quotient;

// Lengths in doubles are right to this part of what they are made of, by far.
constexpr double kSlack = 1e-9;
// Differences of places, of how far these are.
constexpr double kOfPlace = 0x1p-45;
// Quotients of integers as doubles, and their products.
constexpr double kOfQuotient = 0x1p-50;
// Rules are to be no further off than this part of what is allowed, and need not be nearer than this part of the
// moment.
constexpr double kOfRules = 0x1p-11, kOfMoment = 0x1p-56;
// Doubles are to leave no more than this part of what is allowed of all; else more digits are asked where they leave
// more than that part of what is allowed there.
constexpr double kOfAll = 0.5, kOfDoubles = 0.125;

// The quotient by 2 pi of what a ball holds.
Enclosure over_full_turn(const Ball3<double>& sum) {
  constexpr double kFull = 2 * std::numbers::pi, kRoundings = 0x1p-50;
  const double middle = sum.mid / kFull, radius = up(sum.rad / kFull + kRoundings * std::fabs(middle));
  return {std::nextafter(middle - radius, -kNothingKnown), std::nextafter(middle + radius, kNothingKnown)};
}

}  // namespace

EdgeEnclosure3::EdgeEnclosure3(const PairGeometry3& bodies, const MomentOrigin3& origin, long shift,
                               StretchMapper3& mapper)
    : bodies_(bodies), origin_(origin), shift_(shift), mapper_(mapper), extents_{extent(0), extent(1)} {}

EdgeEnclosure3::Extent EdgeEnclosure3::extent(std::uint32_t patch) const {
  if (bodies_.is_far(patch)) return {};
  const std::vector<std::uint32_t>& corners = bodies_.bodies[patch].corners;
  Extent result{bodies_.place(corners.front()), 0, 0};
  double place = 0;
  for (const std::uint32_t corner : corners) place = std::max(place, length(bodies_.place(corner)));
  const double slack = kOfPlace * place;
  double sizes = 0;
  Direction3 before{}, sum{};
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const Direction3 side = bodies_.place(corners[k]) - result.first;
    result.reach = std::max(result.reach, length(side));
    sizes += kSlack * length(before) * length(side) + slack * (length(before) + length(side) + slack);
    sum = sum + cross(before, side);
    before = side;
  }
  result.reach = result.reach * (1 + kSlack) + slack;
  result.area = length(sum) / 2 + sizes;
  return result;
}

// Directions to a patch are less than a half space, over which |w . m| has the integral pi; and they are no more than
// its area over the square of its distance.
double EdgeEnclosure3::most_seen(const PairStretch3& stretch) const {
  const Stretch3& s = stretch.line();
  const Direction3 from = quotient<Direction3>(s.from, s.weight, bodies_.shift());
  const Direction3 way = quotient<Direction3>(s.way, s.weight, bodies_.shift());
  const double square = dot(way, way);
  double most = std::numbers::pi * (1 + kSlack);
  for (std::uint32_t patch = 0; patch < 2; ++patch) {
    if (bodies_.is_far(patch) || (stretch.role != StretchRole3::kOutline && patch == stretch.own)) continue;
    const Extent& extent = extents_[patch];
    const Direction3 offset = extent.first - from;
    const double t = square > 0 ? std::clamp(dot(offset, way) / square, 0.0, 1.0) : 0;
    const double slack = kSlack * (length(extent.first) + length(from) + length(way));
    const double distance = length(offset - t * way) - extent.reach - slack;
    if (distance > 0) most = std::min(most, extent.area / (distance * distance) * (1 + kSlack));
  }
  return most;
}

template <class Real>
ProvenMoment3<Real> EdgeEnclosure3::moment_of(const Stretch3& s) const {
  const auto [moment, weight] = origin_.moment_of(s);
  ProvenMoment3<Real> result{quotient<LocalVector3<Real>>(moment, weight, 2 * shift_), 0, 0};
  const auto about = quotient<LocalVector3<double>>(moment, weight, 2 * shift_);
  const double length = std::sqrt(dot(about, about));
  result.size = up(length * (1 + kOfQuotient));
  result.error = std::is_same_v<Real, double> ? kOfQuotient * result.size : 4 * kRoundoff<Real> * result.size;
  return result;
}

template <class Real>
Ball3<double> EdgeEnclosure3::enclose(const PairStretch3& stretch, const SurePart3& part,
                                      const ProvenMoment3<Real>& moment, double allowed, double most) {
  const ProvenPiece3<Real> piece(mapper_.whole_piece<Real>(stretch, part.piece));
  PieceEncloser3<Real> encloser(piece, moment, std::max(allowed, kOfMoment * moment.size * most), most, counts_);
  Ball3<double> result = encloser.enclose(part.piece.low, part.piece.high);
  // In its gaps something else may be seen.
  result.rad = up(result.rad + part.gaps * (moment.size * most + encloser.most_in_gaps(part.gaps)));
  return result;
}

Ball3<double> EdgeEnclosure3::enclose(const PairStretch3& stretch, const SureStretch3& sure, double allowed) {
  const ProvenMoment3<double> moment = moment_of<double>(stretch.line());
  const double most = most_seen(stretch), whole = up(moment.size * most);
  if (moment.size <= 2 * kTiny) return {0, whole};  // it is on a line through the origin
  if (sure.sees_nothing) return {};
  double end = stretch.low, gaps = 0;
  Ball3<double> sum;
  for (SurePart3 part : sure.parts) {
    part.piece.unpack_signature();
    gaps = up(gaps + std::max(0.0, part.piece.low - end) + 0x1p-53);
    end = part.piece.high;
    if (part.piece.signature.empty()) {
      sum.rad = up(sum.rad + part.gaps * whole);
      continue;
    }
    Ball3<double> found = enclose(stretch, part, moment, allowed * kOfRules, most);
    const double width = part.piece.high - part.piece.low;
    if (takes_more_digits_ && found.rad > kOfDoubles * allowed * width + part.gaps * whole) {
      ++counts_.redone;
      if (const Ball3<double> finer =
              enclose(stretch, part, moment_of<WideReal>(stretch.line()), allowed * kOfRules, most);
          finer.rad < found.rad)
        found = finer;
    }
    sum = sum + found;
  }
  gaps = up(gaps + std::max(0.0, stretch.high - end) + 0x1p-53);
  sum.rad = up(sum.rad + gaps * whole);
  return sum;
}

Enclosure EdgeEnclosure3::enclose(const std::vector<PairStretch3>& stretches, const std::vector<SureStretch3>& sure,
                                  double allowed) {
  const double all = 2 * std::numbers::pi * allowed;
  const double of_each = all / static_cast<double>(std::max<std::size_t>(1, stretches.size()));
  Ball3<double> sum;
  for (const bool takes_more_digits : {false, true}) {
    takes_more_digits_ = takes_more_digits;
    sum = {};
    counts_ = {};
    for (std::size_t k = 0; k < stretches.size(); ++k) sum = sum + enclose(stretches[k], sure[k], of_each);
    if (sum.rad <= kOfAll * all) break;
  }
  return over_full_turn(sum);
}

}  // namespace hottel
