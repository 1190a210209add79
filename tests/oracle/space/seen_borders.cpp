#include "tests/oracle/space/seen_borders.h"

#include <algorithm>
#include <cmath>

namespace hottel::oracle {
namespace {

// Where points are tried, between two lines: middles would be special in scenes on a lattice.
constexpr double kAlong = 0.4271, kBeside = 0.3719;

}  // namespace

template <class Real>
BorderFinder<Real>::BorderFinder(const std::vector<PlanePolygon>& polygons, const SpaceSegment& f,
                                 const PlaneLines& lines, Real least)
    : given_(lines), ways_(polygons, f, least), least_(least) {
  const PlaneFrame frame(polygons[0].points);
  origin_ = vector_of<Real>(frame.origin);
  u_ = vector_of<Real>(frame.u);
  v_ = vector_of<Real>(frame.v);
  from_ = vector_of<Real>(f.a);
  way_ = vector_of<Real>(f.b - f.a);
}

template <class Real>
void BorderFinder<Real>::move_to(const Real& t) {
  using std::fabs;
  q_ = from_ + t * way_;
  lines_.clear();
  for (const PlaneLine& line : given_.all()) {
    const auto at = [&](std::size_t k) -> Real { return real<Real>(line.at_0[k]) + t * real<Real>(line.slope[k]); };
    const Real a = at(0), b = at(1), c = at(2), most = std::max(Real(fabs(a)), Real(fabs(b)));
    lines_.push_back({a / most, b / most, c / most});
  }
}

// Where others cross the line, in order, at (alpha, beta) = foot + s (b, -a), whether within the polygon or not.
template <class Real>
auto BorderFinder<Real>::crossings(std::size_t line) -> std::vector<Crossing> {
  using std::fabs;
  const Line& l = lines_[line];
  const Real square = l.a * l.a + l.b * l.b, alpha = -l.c * l.a / square, beta = -l.c * l.b / square;
  std::vector<Crossing> found;
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    const Real slope = lines_[k].a * l.b - lines_[k].b * l.a, value = lines_[k].value(alpha, beta);
    if (k == line) continue;
    if (fabs(slope) > least_)
      found.push_back({-value / slope, k});
    else if (!(fabs(value) > sqrt(least_)))
      is_in_doubt_ = true;  // else they meet far away, if at all
  }
  std::sort(found.begin(), found.end(), [](const Crossing& x, const Crossing& y) { return x.at < y.at; });
  return found;
}

// One of those that are always at one place: that of the least number.
template <class Real>
void BorderFinder<Real>::join(std::size_t line, std::vector<Crossing>& found) {
  std::size_t kept = 0;
  for (std::size_t k = 1; k < found.size(); ++k) {
    if (found[k].at - found[kept].at > least_) {
      found[++kept] = found[k];
      continue;
    }
    if (!given_.always_meet(line, found[kept].line, found[k].line)) is_in_doubt_ = true;
    found[kept].line = std::min(found[kept].line, found[k].line);
  }
  if (!found.empty()) found.resize(kept + 1);
}

// Leaves what is in polygon 0; false where nothing is.
template <class Real>
bool BorderFinder<Real>::clip(std::size_t line, std::vector<Crossing>& found) {
  const Line& l = lines_[line];
  const Real square = l.a * l.a + l.b * l.b, alpha = -l.c * l.a / square, beta = -l.c * l.b / square;
  std::erase_if(found, [&](const Crossing& crossing) {
    for (std::size_t k = 0; k < given_.sides(); ++k) {
      if (k == line) continue;
      if (lines_[k].value(alpha + crossing.at * l.b, beta - crossing.at * l.a) < -least_) return true;
    }
    return false;
  });
  return found.size() > 1;
}

// What FreeWays tells of a point beside the line, nearer to it than all other lines.
template <class Real>
int BorderFinder<Real>::seen_beside(std::size_t line, const Real& alpha, const Real& beta, int side) {
  const Real a = side * lines_[line].a, b = side * lines_[line].b;
  Real reach = 1;
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    const Real slope = lines_[k].a * a + lines_[k].b * b;
    if (k == line || slope == 0) continue;
    const Real there = -lines_[k].value(alpha, beta) / slope;
    if (there > 0) reach = std::min(reach, there);
  }
  if (!(reach > least_)) is_in_doubt_ = true;
  const Real x = alpha + kBeside * reach * a, y = beta + kBeside * reach * b;
  for (std::size_t k = 0; k < given_.sides(); ++k)
    if (lines_[k].value(x, y) < 0) return 0;
  const std::optional<int> seen = ways_.sides(origin_ + x * u_ + y * v_, q_);
  if (!seen) is_in_doubt_ = true;
  return seen.value_or(0);
}

template <class Real>
void BorderFinder<Real>::add_borders(std::size_t line, std::vector<SeenBorder>& borders) {
  std::vector<Crossing> found = crossings(line);
  if (is_in_doubt_ || !clip(line, found)) return;
  join(line, found);
  const Line& l = lines_[line];
  const Real square = l.a * l.a + l.b * l.b;
  const std::size_t first = borders.size();
  for (std::size_t k = 1; k < found.size() && !is_in_doubt_; ++k) {
    const Real at = found[k - 1].at + kAlong * (found[k].at - found[k - 1].at);
    const Real alpha = -l.c * l.a / square + at * l.b, beta = -l.c * l.b / square - at * l.a;
    const int count = seen_beside(line, alpha, beta, 1) - seen_beside(line, alpha, beta, -1);
    if (borders.size() > first && borders.back().to == found[k - 1].line && borders.back().count == count)
      borders.back().to = found[k].line;
    else if (count != 0)
      borders.push_back({line, found[k - 1].line, found[k].line, count});
  }
}

template <class Real>
std::optional<std::vector<SeenBorder>> BorderFinder<Real>::at(const Real& t) {
  is_in_doubt_ = false;
  move_to(t);
  std::vector<SeenBorder> borders;
  for (std::size_t line = 0; line < lines_.size() && !is_in_doubt_; ++line) add_borders(line, borders);
  if (is_in_doubt_) return std::nullopt;
  return borders;
}

template class BorderFinder<double>;
template class BorderFinder<RealOf<70>>;
template class BorderFinder<DeepReal>;

}  // namespace hottel::oracle
