// Pieces whose vectors enclose theirs. Internal to geometry/space.
#pragma once

#include <vector>

#include "geometry/space/pieces/sure_part.h"
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
    planes.reserve(piece.planes.size());
    corners.reserve(piece.corners.size());
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

}  // namespace hottel
