// The sum over edges that a measure is. Internal to geometry/space/exchange.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/space/integrals/edge_integral.h"
#include "geometry/space/integrals/moment_origin.h"
#include "geometry/space/pairs/pair_details.h"
#include "geometry/space/pieces/stretch_map.h"
#include "geometry/space/unobstructed/pair_result.h"
#include "kernel/wide_real.h"

namespace hottel {

// Sums of moments times integrals over the pieces of all stretches, the worst ones halved until the sum is good enough:
// in doubles, and in more digits where these do not suffice.
class EdgeSum3 {
 public:
  // REQUIRES: both outlive this. Where it proves, what EdgeEnclosure3 asks for is kept of all stretches.
  EdgeSum3(const PairGeometry3& bodies, const MomentOrigin3& origin, long shift,
           std::size_t most_bytes = kMostBytesOfArcs3, bool proves = false);
  EdgeSum3(const EdgeSum3&) = delete;  // the mapper knows where its parts are
  EdgeSum3& operator=(const EdgeSum3&) = delete;

  // False where a stretch could not be divided. REQUIRES: the stretches outlive this.
  bool add(const std::vector<PairStretch3>& stretches, PairResult3& result);

  bool is_empty() const { return seen_.empty(); }
  // How far from the origin a stretch reaches along which something is seen, about.
  double reach() const { return reach_; }

  // As EdgeIntegral3 does.
  void refine(double tolerance, double residual_tolerance);
  const EdgeValues3& values() const { return values_; }
  // Begins anew, in long doubles, then in LongerReal, then in WideReal. False where there are no more. COST: of a node
  // some 10 times as much as in doubles, then some hundred times, then some four hundred.
  bool take_more_digits();
  std::uint32_t nodes() const;

  // What the sum may be off as the ends of pieces are not told to the last digit: part of its error from the beginning.
  double jumps() const { return jumps_; }
  // What the sum may lack, about, where something is seen only from less of a stretch than its parts are told by.
  double may_lack() const { return may_lack_; }
  // The stretches along which something is seen, a short one cut out around each end of a piece that matters more than
  // `most`: there ends are told to the digits of the short one.
  std::vector<PairStretch3> cut_at_jumps(double most) const;
  // All stretches, short ones cut out around all ends, of pieces and of stretches, at which what is too short to be
  // told could add more than `most` to the residual.
  std::vector<PairStretch3> cut_at_ends(double most) const;

  // What is proven to be seen along each stretch. REQUIRES that it proves.
  const std::vector<SureStretch3>& sure_stretches() const { return sure_; }
  StretchMapper3& mapper() { return mapper_; }

  // Tells what it is the sum of.
  void tell(PairDetails3& details);

 private:
  bool divide(const PairStretch3& stretch, std::vector<StretchPiece3>& pieces);
  bool is_of_patches_alone(std::uint32_t point) const;
  std::vector<PairDetails3::Corner> told_corners(const PairStretch3& stretch, const StretchPiece3& piece);
  // A stretch along which something is seen.
  struct Seen {
    const PairStretch3* stretch;
    std::size_t first_piece;
    std::uint32_t relied;
  };

  struct Jump {
    std::size_t stretch;  // its place among all
    double t, size;
  };
  struct End {
    std::size_t stretch;
    double t;
  };
  // A patch in doubles of the bodies: its first corner, how far others are from it, its area. Of a cone of the sky it
  // has no place.
  struct Extent {
    Direction3 first;
    double reach, area;
  };

  const std::vector<StretchPiece3>& pieces_in_doubles() const { return doubles_.pieces(); }
  std::size_t end_of_pieces(std::size_t seen) const;
  // The stretch that a piece is of.
  const Seen& stretch_of(std::uint32_t piece) const;
  // Adds what the ends of piece k of a stretch may be off, times what is no more, or not yet, seen there. REQUIRES that
  // it has its arcs, and so does the one before.
  void add_jumps(const std::vector<StretchPiece3>& pieces, std::size_t k, const Direction3& moment);
  Extent extent(std::uint32_t patch) const;
  // How much of directions a stretch sees at most, about.
  double most_seen(const PairStretch3& stretch) const;
  static void cut(const PairStretch3& stretch, const std::vector<double>& ends, std::vector<PairStretch3>& result);
  // What visit makes of the sum with the most digits that there is.
  template <class Visit>
  auto of_most_digits(const Visit& visit);
  template <class Real>
  std::uint32_t add_stretch(const Stretch3& s, const IntegerVector& way_to, EdgeIntegral3<Real>& integral) const;
  template <class Real>
  void set_expected_residual(EdgeIntegral3<Real>& integral) const;
  template <class Real>
  WidePiece3<Real> widened(std::uint32_t piece);
  template <class Real>
  void widen(std::optional<EdgeIntegral3<Real>>& integral);

  const PairGeometry3& bodies_;
  const MomentOrigin3& origin_;
  long shift_;
  std::size_t most_bytes_;
  StretchMapper3 mapper_;
  std::vector<Seen> seen_;
  EdgeIntegral3<double> doubles_;
  std::optional<EdgeIntegral3<long double>> long_doubles_;
  std::optional<EdgeIntegral3<LongerReal>> longer_;
  std::optional<EdgeIntegral3<WideReal>> wide_;
  EdgeValues3 values_;
  const std::vector<PairStretch3>* stretches_ = nullptr;
  bool proves_;
  std::vector<SureStretch3> sure_;
  std::array<Extent, 2> extents_;
  std::vector<Jump> jump_list_;
  std::vector<End> ends_;
  double reach_ = 0, jumps_ = 0, may_lack_ = 0;
};

}  // namespace hottel
