// The sum over edges that a measure is. Internal to geometry/space/exchange.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/exchange/pair_details.h"
#include "geometry/space/exchange/pair_result.h"
#include "geometry/space/exchange/stretch_map.h"

namespace hottel {

// Sums of moments times integrals over the pieces of all stretches, the worst ones halved until the sum is good enough.
class EdgeSum3 {
 public:
  EdgeSum3(const PairBodies3& bodies, const WeightedPoint3& origin, long shift)
      : bodies_(bodies), origin_(origin), shift_(shift) {}

  // False where a stretch could not be divided.
  bool add(const std::vector<PairStretch3>& stretches, PairMeasure3& result);

  bool is_empty() const { return pieces_.empty(); }

  // Halves the worst parts until the error is within the tolerance and that of the residual within its own, or as small
  // as rounding lets them be.
  void refine(double tolerance, double residual_tolerance);

  double value() const { return value_; }
  double error() const;
  const Direction3& residual() const { return residual_; }
  double residual_error() const;
  std::uint32_t nodes() const { return nodes_; }

  // Tells what it is the sum of. REQUIRES: the stretches are still there.
  void tell(PairDetails3& details) const;

 private:
  // A stretch along which something is seen.
  struct Seen {
    const PairStretch3* stretch;
    std::size_t first_piece;
    std::uint32_t relied;
  };
  // An interval of t within a piece, and what it adds.
  struct Part {
    std::uint32_t piece, stretch;
    double low, high;
    Direction3 value;
    double error, residual_error;  // what two quadratures differ by
    double rounding, residual_rounding;
  };

  // Divides until the rules see all that happens.
  void add_parts(std::uint32_t piece, std::uint32_t stretch, double low, double high);

  Part make_part(std::uint32_t piece, std::uint32_t stretch, double low, double high);

  // So short that nodes would fall on its ends: Lambda is less than pi anywhere.
  Part tiny_part(std::uint32_t piece, std::uint32_t stretch, double low, double high);

  void sum_up();

  const PairBodies3& bodies_;
  const WeightedPoint3& origin_;
  long shift_;
  std::vector<Seen> seen_;  // with ways_ and moments_
  std::vector<StretchPiece3> pieces_;
  std::vector<Direction3> ways_, moments_;
  std::vector<Part> parts_;
  double value_ = 0, error_ = 0, rounding_ = 0, residual_error_ = 0, residual_rounding_ = 0;
  Direction3 residual_;
  std::uint32_t nodes_ = 0;
};

}  // namespace hottel
