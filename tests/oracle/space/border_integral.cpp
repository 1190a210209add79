#include "tests/oracle/space/border_integral.h"

namespace hottel::oracle {
template <class Real>
BorderIntegrand<Real>::BorderIntegrand(const PlaneFrame& frame, const SpaceSegment& f, const PlaneLines& lines,
                                       const std::vector<SeenBorder>& borders)
    : origin_(vector_of<Real>(frame.origin)),
      u_(vector_of<Real>(frame.u)),
      v_(vector_of<Real>(frame.v)),
      from_(vector_of<Real>(f.a)),
      way_(vector_of<Real>(f.b - f.a)),
      given_(lines) {
  for (const SeenBorder& border : borders)
    sides_.push_back({corner(border.line, border.from), corner(border.line, border.to), border.count});
  now_.resize(lines_.size());
  corners_.resize(meet_.size());
}

template <class Real>
std::size_t BorderIntegrand<Real>::used_line(std::size_t line) {
  const auto [found, is_new] = used_.emplace(line, lines_.size());
  if (is_new) {
    const PlaneLine& l = given_.all()[line];
    lines_.push_back({real<Real>(l.at_0[0]), real<Real>(l.at_0[1]), real<Real>(l.at_0[2]), real<Real>(l.slope[0]),
                      real<Real>(l.slope[1]), real<Real>(l.slope[2])});
  }
  return found->second;
}

template <class Real>
std::size_t BorderIntegrand<Real>::corner(std::size_t a, std::size_t b) {
  const auto [found, is_new] = number_.emplace(std::minmax(a, b), meet_.size());
  if (is_new) meet_.emplace_back(used_line(a), used_line(b));
  return found->second;
}

template <class Real>
void BorderIntegrand<Real>::move_to(const Real& t) {
  for (std::size_t k = 0; k < lines_.size(); ++k)
    for (std::size_t m = 0; m < 3; ++m) now_[k][m] = lines_[k][m] + t * lines_[k][m + 3];
  const VectorOf<Real> shift = origin_ - (from_ + t * way_);
  for (std::size_t k = 0; k < meet_.size(); ++k) {
    const auto &p = now_[meet_[k].first], &q = now_[meet_[k].second];
    const Real scale = 1 / (p[0] * q[1] - p[1] * q[0]);
    const Real alpha = (p[1] * q[2] - p[2] * q[1]) * scale, beta = (p[2] * q[0] - p[0] * q[2]) * scale;
    Corner& corner = corners_[k];
    corner.from_q = shift + alpha * u_ + beta * v_;
    corner.square = dot(corner.from_q, corner.from_q);
    corner.half_log = corner.square > 0 ? Real(log(corner.square) / 2) : Real(0);
  }
}

// With s along the side from where it is nearest, at the distance h: s ln r + h atan (s / h), without -s, as all sides
// together are closed.
template <class Real>
Real BorderIntegrand<Real>::along(const Side& side) const {
  const Corner &a = corners_[side.from], &b = corners_[side.to];
  const VectorOf<Real> way = b.from_q - a.from_q;
  const Real square = dot(way, way);
  if (square == 0) return 0;
  const Real length = sqrt(square);
  const VectorOf<Real> normal = cross(a.from_q, b.from_q);
  const Real doubled = sqrt(dot(normal, normal));
  const Real logs = dot(b.from_q, way) * b.half_log - dot(a.from_q, way) * a.half_log;
  const Real angle = doubled == 0 ? Real(0) : Real(atan2(doubled, dot(a.from_q, b.from_q)));
  return dot(way_, way) * (logs + doubled * angle) / square;
}

template <class Real>
Real BorderIntegrand<Real>::at(const Real& t) {
  move_to(t);
  Real sum = 0;
  for (const Side& side : sides_) sum -= side.count * along(side);
  return sum;
}

template class BorderIntegrand<RealOf<50>>;
template class BorderIntegrand<DeepReal>;

}  // namespace hottel::oracle
