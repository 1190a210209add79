// What the sum over edges that a measure is lies between. Internal to geometry/space.
#pragma once

#include <array>
#include <vector>

#include "geometry/space/integrals/moment_origin.h"
#include "geometry/space/pieces/stretch_map.h"
#include "geometry/space/proven/piece_enclosure.h"
#include "kernel/enclosure.h"

namespace hottel {

// Encloses the measure of a pair as the sum over its edges of moments times integrals of Lambda.
//
//   (1) what is seen is proven on each part of a stretch (StretchMapper3::divide_surely), and so is what the rule of
//       its integral may be off (PieceEncloser3)
//   (2) what is not proven, and the gaps between parts, count with all that could be seen there
//   (3) the bounds hold whatever fails: then they are wide
//
// See docs/design/space/proven.md. For one thread.
class EdgeEnclosure3 {
 public:
  // REQUIRES: all outlive this.
  EdgeEnclosure3(const PairGeometry3& bodies, const MomentOrigin3& origin, long shift, StretchMapper3& mapper);

  // Of the stretches of a pair, which the mapper has divided; `sure`: what is proven of each. `allowed`: half of how
  // wide it should be; it is not wider than it must for that.
  Enclosure enclose(const std::vector<PairStretch3>& stretches, const std::vector<SureStretch3>& sure, double allowed);

  // Of what is in the enclosure.
  const ProofCounts3& counts() const { return counts_; }

 private:
  // A patch in doubles: its first corner, how far others are from it at most, no less than its area.
  struct Extent {
    Direction3 first;
    double reach, area;
  };

  Extent extent(std::uint32_t patch) const;
  double most_seen(const PairStretch3& stretch) const;
  template <class Real>
  ProvenMoment3<Real> moment_of(const Stretch3& s) const;
  Ball3<double> enclose(const PairStretch3& stretch, const SureStretch3& sure, double allowed);
  template <class Real>
  Ball3<double> enclose(const PairStretch3& stretch, const SurePart3& part, const ProvenMoment3<Real>& moment,
                        double allowed, double most);

  const PairGeometry3& bodies_;
  const MomentOrigin3& origin_;
  long shift_;
  StretchMapper3& mapper_;
  std::array<Extent, 2> extents_;
  bool takes_more_digits_ = false;
  ProofCounts3 counts_;
};

}  // namespace hottel
