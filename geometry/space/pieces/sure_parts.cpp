// Proven parts of stretches (StretchMapper3).
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/space/pieces/stretch_map.h"
#include "kernel/wide_real.h"

namespace hottel {
namespace {

// What is further apart is not joined.
constexpr double kMostGap = 0x1p-40;

// The difference of two numbers from 0 to 1, no less than it is.
double at_least(double high, double low) { return high > low ? std::nextafter(high - low, 2.0) : 0; }

// Where one part begins before the one before it ends, as no root between them is told so well, it begins there.
void keep_apart(std::vector<SurePart3>& parts) {
  double end = 0;
  for (SurePart3& part : parts) {
    part.piece.low = std::max(part.piece.low, end);
    part.piece.high = std::max(part.piece.high, part.piece.low);
    end = part.piece.high;
  }
  std::erase_if(parts, [](const SurePart3& part) { return !(part.piece.low < part.piece.high); });
}

// Neighbours with the same arcs are one part: what is between them is a gap.
void join(std::vector<SurePart3>& parts) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    SurePart3& part = parts[k];
    const double gap = kept > 0 ? at_least(part.piece.low, parts[kept - 1].piece.high) : 0;
    if (kept > 0 && gap < kMostGap && parts[kept - 1].piece.signature == part.piece.signature) {
      parts[kept - 1].piece.high = part.piece.high;
      parts[kept - 1].gaps = std::nextafter(parts[kept - 1].gaps + gap, 2.0);
    } else {
      if (kept != k) parts[kept] = std::move(part);
      ++kept;
    }
  }
  parts.resize(kept);
}

}  // namespace

void StretchMapper3::begin_sure_parts(std::vector<SurePart3>& parts) {
  parts.clear();
  planes_.keep_signs();
}

// What was looked at last, as far as it is proven.
void StretchMapper3::add_sure_part(const StretchPiece3& piece, std::vector<SurePart3>& parts) {
  const std::optional<MovingPlanes3::ProvenInterval> proven = planes_.prove_signs(planes_.left(), planes_.right());
  if (!proven) return;
  SurePart3& part = parts.emplace_back(SurePart3{piece, 0});
  part.piece.low = proven->low;
  part.piece.high = proven->high;
}

void StretchMapper3::end_sure_parts(std::vector<SurePart3>& parts) {
  std::sort(parts.begin(), parts.end(),
            [](const SurePart3& a, const SurePart3& b) { return a.piece.base < b.piece.base; });
  keep_apart(parts);
  join(parts);
}

bool StretchMapper3::divide_surely(const PairStretch3& stretch, std::vector<SurePart3>& parts) {
  std::vector<StretchPiece3> pieces;
  begin_sure_parts(parts);
  if (!walk(stretch, pieces, &parts)) return false;
  end_sure_parts(parts);
  return true;
}

template <class Real>
WholePiece3<Real> StretchMapper3::whole_piece(const PairStretch3& stretch, const StretchPiece3& piece) {
  take(stretch);
  planes_.move_to(piece.base, 0, 0);
  WholePiece3<Real> result;
  list_arcs(piece.signature, result.arcs);
  for (const std::uint64_t label : labels_)
    result.corners.push_back(planes_.whole_direction<Real>(corner_of(label), piece.low, piece.high));
  for (const PlaneId3 plane : planes_of_arcs_)
    result.planes.push_back(planes_.whole_normal<Real>(plane, piece.low, piece.high));
  return result;
}

template WholePiece3<double> StretchMapper3::whole_piece(const PairStretch3&, const StretchPiece3&);
template WholePiece3<WideReal> StretchMapper3::whole_piece(const PairStretch3&, const StretchPiece3&);

}  // namespace hottel
