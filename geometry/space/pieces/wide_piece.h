// A part of a stretch with more digits than doubles have. Internal to geometry/space/exchange.
#pragma once

#include <vector>

#include "geometry/space/pieces/arc_sum.h"
#include "geometry/space/pieces/stretch_piece.h"
#include "geometry/space/vectors/wide_vector.h"
#include "kernel/support/list_bytes.h"

namespace hottel {

// What StretchPiece3 is, in long doubles, LongerReal or WideReal: what is small against its distance, and needles, lose
// as many digits as they are small.
template <class Real>
struct WidePiece3 {
  double low = 0, high = 0;
  std::vector<WideVector3<Real>> planes, corners;
  std::vector<SeenArc3> arcs;
  std::vector<StretchPiece3::NearZero> near_zeros;

  // As StretchPiece3.
  std::size_t bytes() const { return bytes_of(planes) + bytes_of(corners) + bytes_of(arcs) + bytes_of(near_zeros); }
  void give_up_arcs() {
    give_back(arcs);
    give_back(planes);
    give_back(corners);
    give_back(near_zeros);
  }

  bool is_steep(double from, double to) const { return is_any_near(near_zeros, from, to); }

  LocalVector3<Real> lambda(double from, const Real& offset, double* rounding = nullptr) const {
    thread_local std::vector<LocalVector3<Real>> at;
    at.clear();
    for (const WideVector3<Real>& corner : corners) at.push_back(unit_or_zero<Real>(corner.at(from, offset)));
    return sum_of_arcs<Real>(
        arcs, at, [&](std::uint32_t plane) { return planes[plane].at(from, offset); }, rounding);
  }
};

}  // namespace hottel
