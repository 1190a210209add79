#include "geometry/plane/visibility/sun_view.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "kernel/coprime_integers.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// Above what a product of a direction and a place in doubles is off, relative to the place.
constexpr double kRounding = 0x1p-49;

}  // namespace

// Of pieces that are met by one ray which of them is met first. They have no inner point in common, so that it is the
// same for all rays.
struct SunView2::IsNearer {
  const SunView2* view;

  bool operator()(const Crossed& s, const Crossed& t) const {
    if (s.piece == t.piece) return false;
    return view->compare(s.low, t.low) >= 0 ? begins_nearer(s, t) : !begins_nearer(t, s);
  }
  // Where s does not begin before t.
  bool begins_nearer(const Crossed& s, const Crossed& t) const {
    const Vertices2& vertices = view->arrangement_.vertices();
    if (const int side = vertices.orientation(t.low, t.high, s.low); side != 0) return side > 0;
    // s begins on t, in a common vertex.
    if (view->compare(s.high, t.high) <= 0) return vertices.orientation(t.low, t.high, s.high) > 0;
    return vertices.orientation(s.low, s.high, t.high) < 0;
  }
};

SunView2::SunView2(const Arrangement2& arrangement, const Point2& direction) : arrangement_(arrangement) {
  HOTTEL_REQUIRE(direction.x != 0 || direction.y != 0);
  const auto [x, y] = coprime_integers<2>({direction.x, direction.y});
  direction_ = {Rational(x), Rational(y)};
  const Rational size = std::max<Rational>(abs(direction_.x), abs(direction_.y));
  x_ = to_double(direction_.x / size);
  y_ = to_double(direction_.y / size);
  const Vertices2& vertices = arrangement.vertices();
  double largest = 0;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const Vertices2::Approximate& p = vertices.approximate(VertexId(k));
    across_.push_back(x_ * p.y - y_ * p.x);
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  }
  error_ = kRounding * largest + 4 * vertices.approximation_error();

  const std::vector<Segment2>& pieces = arrangement.pieces();
  std::vector<std::vector<Crossed>> begin(vertices.size());
  std::vector<std::vector<std::uint32_t>> end(vertices.size());
  for (std::uint32_t p = 0; p < pieces.size(); ++p) {
    const int order = compare(pieces[p].a, pieces[p].b);
    if (order == 0) continue;
    const Crossed crossed = order < 0 ? Crossed{pieces[p].a, pieces[p].b, p} : Crossed{pieces[p].b, pieces[p].a, p};
    begin[crossed.low.index()].push_back(crossed);
    end[crossed.high.index()].push_back(p);
  }
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, [this](std::uint32_t v, std::uint32_t w) { return compare(VertexId(v), VertexId(w)) < 0; });

  using Active = std::set<Crossed, IsNearer>;
  Active active(IsNearer{this});
  std::vector<Active::iterator> place(pieces.size(), active.end());
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    const VertexId here(order[first]);
    while (last < order.size() && compare(here, VertexId(order[last])) == 0) ++last;
    for (std::size_t k = first; k < last; ++k)
      for (const std::uint32_t piece : end[order[k]]) active.erase(place[piece]);
    for (std::size_t k = first; k < last; ++k)
      for (const Crossed& crossed : begin[order[k]]) place[crossed.piece] = active.insert(crossed).first;
    if (last == order.size() || active.empty()) continue;
    const VertexId next(order[last]);
    const Crossed& met = *active.begin();
    const PieceSideId side = pieces[met.piece].a == met.low ? left_side(met.piece) : right_side(met.piece);
    if (!strips_.empty() && strips_.back().side == side && compare(strips_.back().to, here) == 0)
      strips_.back().to = next;
    else
      strips_.push_back({here, next, side});
  }
}

int SunView2::compare(VertexId v, VertexId w) const {
  const double apart = across_[v.index()] - across_[w.index()];
  if (std::fabs(apart) > 2 * error_) return apart > 0 ? 1 : -1;
  return v == w ? 0 : sgn(Rational(across(v) - across(w)));
}

int SunView2::compare(VertexId v, const Eye2& point) const {
  const double size = std::max(std::fabs(point.x()), std::fabs(point.y()));
  const double apart = across_[v.index()] - (x_ * point.y() - y_ * point.x());
  const double error = error_ + kRounding * (size + 1) + 4 * arrangement_.vertices().approximation_error();
  if (std::fabs(apart) > error) return apart > 0 ? 1 : -1;
  return sgn(Rational(across(v) - across(point.exact())));
}

bool SunView2::is_behind(const Strip& strip, const Eye2& point) const {
  const Segment2& piece = arrangement_.piece(strip.side);
  const int side = point.orientation(piece.a, piece.b);
  return is_right(strip.side) ? side > 0 : side < 0;
}

bool SunView2::reaches(const Eye2& point) const {
  // The first strip that does not end before the point.
  const auto strip = std::ranges::partition_point(strips_, [&](const Strip& s) { return compare(s.to, point) < 0; });
  if (strip == strips_.end() || compare(strip->from, point) >= 0) return true;
  if (!is_behind(*strip, point)) return true;
  if (compare(strip->to, point) > 0) return false;
  const auto next = strip + 1;
  return next == strips_.end() || compare(next->from, strip->to) != 0 || !is_behind(*next, point);
}

}  // namespace hottel
