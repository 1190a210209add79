#include "geometry/space/pieces/stretch_piece.h"

#include <algorithm>
#include <cmath>

#include "kernel/support/list_bytes.h"

namespace hottel {
namespace {

// The sine of an angle of nearly half a turn from which doubles tell its sign.
constexpr double kSureSine = 1e-12;
// Cosines above this are surely positive.
constexpr double kSureCosine = 1e-10;

Direction3 unit_at(const MovingVector3& vector, double from, double offset) {
  return unit_or_zero<double>(vector.at(from, offset));
}

}  // namespace

std::size_t StretchPiece3::bytes() const {
  return bytes_of(signature) + bytes_of(packed_signature) + bytes_of(planes) + bytes_of(corners) + bytes_of(arcs) +
         bytes_of(near_zeros);
}

void StretchPiece3::give_up_arcs() {
  packed_signature = packed_ends_3(signature);
  give_back(signature);
  give_back(planes);
  give_back(corners);
  give_back(arcs);
  give_back(near_zeros);
}

void StretchPiece3::unpack_signature() {
  if (packed_signature.empty()) return;
  signature = unpacked_ends_3(packed_signature);
  give_back(packed_signature);
}

// Where an arc is nearly half a turn doubles may not tell its sign: that is taken where they tell it best. Returns the
// arcs where they tell it nowhere.
std::vector<std::uint32_t> StretchPiece3::find_turns() {
  thread_local std::vector<double> most, squares;
  thread_local std::vector<char> is_half;
  thread_local std::vector<Direction3> at;
  most.assign(arcs.size(), 0);
  is_half.assign(arcs.size(), 0);
  at.resize(corners.size());
  squares.resize(corners.size());
  // Whether two corners are surely less than a right angle from each other: told without roots.
  const auto is_acute = [](const Arc& arc) {
    const double product = dot(at[arc.begin], at[arc.end]);
    return product > 0 && product * product > kSureCosine * kSureCosine * (squares[arc.begin] * squares[arc.end]);
  };
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const double offset = share * (high - low);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      at[k] = corners[k].at(low, offset);
      squares[k] = dot(at[k], at[k]);
    }
    if (std::ranges::all_of(arcs, is_acute)) continue;
    for (std::size_t k = 0; k < corners.size(); ++k) at[k] = unit_or_zero<double>(at[k]);
    for (std::size_t k = 0; k < arcs.size(); ++k) {
      Arc& arc = arcs[k];
      const Direction3 &b = at[arc.begin], &e = at[arc.end];
      if (dot(b, e) >= 0) continue;
      is_half[k] = 1;
      const double sine = ArcShape3<double>(planes[arc.plane].at(low, offset), b, e).sine;
      if (!(std::fabs(sine) > most[k])) continue;
      most[k] = std::fabs(sine);
      arc.turn = sine > 0 ? 1 : -1;
    }
  }
  std::vector<std::uint32_t> unsure;
  for (std::uint32_t k = 0; k < arcs.size(); ++k)
    if (is_half[k] != 0 && most[k] < kSureSine) unsure.push_back(k);
  return unsure;
}

bool StretchPiece3::is_steep(double from, double to) const { return is_any_near(near_zeros, from, to); }

// The ellipse with the ends of the interval as foci and 1.3 as the sum of its half axes, in half lengths.
bool is_any_near(const std::vector<StretchPiece3::NearZero>& near_zeros, double from, double to) {
  constexpr double kSum = 1.3;
  constexpr double kLong = (kSum + 1 / kSum) / 2, kShort = (kSum - 1 / kSum) / 2;
  const double middle = (from + to) / 2, half = (to - from) / 2;
  return std::any_of(near_zeros.begin(), near_zeros.end(), [&](const StretchPiece3::NearZero& zero) {
    const double x = (zero.at - middle) / (kLong * half), y = zero.width / (kShort * half);
    return x * x + y * y < 1;
  });
}

Direction3 StretchPiece3::lambda(double from, double offset, double* rounding) const {
  thread_local std::vector<Direction3> at;
  at.clear();
  for (const MovingVector3& corner : corners) at.push_back(unit_at(corner, from, offset));
  return sum_of_arcs<double>(
      arcs, at, [&](std::uint32_t plane) { return planes[plane].at(from, offset); }, rounding);
}

}  // namespace hottel
