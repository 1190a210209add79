// What borders of points that see past an edge add to an exchange.
#pragma once

#include <map>
#include <vector>

#include "tests/oracle/space/seen_borders.h"

namespace hottel::oracle {

// The sum over borders of count times the integral of -ln |x - y(t)| y'(t) . dx, for the borders between two events.
template <class Real>
class BorderIntegrand {
 public:
  BorderIntegrand(const PlaneFrame& frame, const SpaceSegment& f, const PlaneLines& lines,
                  const std::vector<SeenBorder>& borders);

  Real at(const Real& t);

 private:
  struct Corner {
    VectorOf<Real> from_q;
    Real half_log;  // of its length
    Real square;
  };
  struct Side {
    std::size_t from, to;
    int count;
  };
  std::size_t corner(std::size_t a, std::size_t b);
  std::size_t used_line(std::size_t line);
  void move_to(const Real& t);
  Real along(const Side& side) const;

  VectorOf<Real> origin_, u_, v_, from_, way_;
  std::map<std::size_t, std::size_t> used_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> number_;
  std::vector<std::array<Real, 6>> lines_;  // at 0, slope
  std::vector<std::pair<std::size_t, std::size_t>> meet_;
  std::vector<Side> sides_;
  std::vector<std::array<Real, 3>> now_;
  std::vector<Corner> corners_;
  const PlaneLines& given_;
};

}  // namespace hottel::oracle
