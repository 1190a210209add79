#include "solver/plane/light/lit_wedge.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "kernel/doubles.h"
#include "kernel/plain_functions.h"

namespace hottel {
namespace {

constexpr double kLost = 0.25;  // lines that are known less well than this, in cells, are of no use

Vector2 normalized(const Vector2& a) { return (1 / std::hypot(a.x, a.y)) * a; }

bool same_ray(const VertexRay2& a, const VertexRay2& b) { return a.kind == b.kind && a.index == b.index; }

// The diagonal of the quadrant of two directions.
Vector2 diagonal(const Vector2& right, const Vector2& left) {
  const double half = std::sqrt(0.5);
  return {right.x + left.x > 0 ? half : -half, right.y + left.y > 0 ? half : -half};
}

// The product, with the rounding of its leading part.
DoubleDouble product(const DoubleDouble& a, const DoubleDouble& b) {
  double p, e;
  two_product(a.hi, b.hi, p, e);
  return {p, e + (a.hi * b.lo + a.lo * b.hi)};
}

}  // namespace

CutLine2::CutLine2(const FinePoint2& point, const FinePoint2& direction, const CellFrame2& frame)
    : point_(point), direction_(direction) {
  inverse_length_ = 1 / std::hypot(direction.x.hi, direction.y.hi);
  gradient_ = {-direction.y.hi * inverse_length_, direction.x.hi * inverse_length_};
  const double far = frame.extent() + size_of(point);
  doubt_ = 2 * (kDirection + 4 * kFine) * far;
  support_ = (std::fabs(gradient_.x) + frame.height() * std::fabs(gradient_.y)) / 2;
  rough_support_ = support_ + doubt_ + 0x1p-49 * far;
}

double CutLine2::at(const FinePoint2& place) const {
  const FinePoint2 from = place - point_;
  const DoubleDouble left = product(direction_.x, from.y), right = product(direction_.y, from.x);
  double s, e;
  two_sum(left.hi, -right.hi, s, e);
  return (s + (e + (left.lo - right.lo))) * inverse_length_;
}

FinePoint2 WedgeLighting2::direction(VertexId v, const VertexRay2& ray) const {
  constexpr Vector2 kAxes[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  if (ray.kind == VertexRay2::Kind::kAxis) return {{kAxes[ray.index % 4].x, 0}, {kAxes[ray.index % 4].y, 0}};
  const FinePoint2 way = frame_.direction(v, ray.vertex());
  return ray.kind == VertexRay2::Kind::kTowards ? way : -way;
}

std::uint32_t WedgeLighting2::add_ray(VertexId v, const VertexRay2& ray, LitWedges2& result) const {
  result.rays.push_back(CutLine2(result.apex, direction(v, ray), frame_));
  return static_cast<std::uint32_t>(result.rays.size() - 1);
}

// The line of the piece that ends the wedge, and the corners on it.
void WedgeLighting2::place_end(VertexId v, const Wedge2& wedge, LitWedge2& lit) const {
  const auto [second, first] = arrangement_.turned_piece(wedge.behind);
  const FinePoint2 &apex = frame_.vertex(v), &p = frame_.vertex(first), &q = frame_.vertex(second);
  lit.end = CutLine2(p, frame_.direction(first, second), frame_);
  const Vector2 from = rounded(p - apex), step = rounded(q - p);
  const double length = std::hypot(step.x, step.y);
  const double far = size_of(apex) + size_of(p) + size_of(q) + frame_.extent();
  for (int side = 0; side < 2; ++side) {
    const VertexRay2& ray = side == 0 ? wedge.right : wedge.left;
    Vector2& corner = lit.corners[side + 1];
    if (ray.kind == VertexRay2::Kind::kTowards && (ray.vertex() == first || ray.vertex() == second)) {
      corner = rounded(frame_.vertex(ray.vertex()));
      continue;
    }
    const Vector2 way = normalized(rounded(direction(v, ray)));
    const double turn = cross(way, step);
    const double t = turn == 0 ? 0 : std::clamp(-cross(way, from) / turn, 0.0, 1.0);
    corner = rounded(p) + t * step;
    const double slide = turn == 0 ? length : std::min(length, 64 * kUnitRoundoff * far * length / std::fabs(turn));
    lit.margin = std::max(lit.margin, slide);
  }
  lit.margin += 0x1p-46 * far;
}

void WedgeLighting2::place_without_end(VertexId v, const Wedge2& wedge, LitWedge2& lit) const {
  const double far = size_of(frame_.vertex(v)) + frame_.extent();
  lit.is_ended = false;
  lit.corners[1] = lit.corners[0] + 4 * far * normalized(rounded(direction(v, wedge.right)));
  lit.corners[2] = lit.corners[0] + 4 * far * normalized(rounded(direction(v, wedge.left)));
  lit.margin = 0x1p-46 * far;
}

// The angle from the piece, its front on the right, to the direction from the axis to the apex. From any point of the
// wedge the apex is seen between 0 and pi, and less than pi/4 from the axis.
double WedgeLighting2::angle_to_axis(PieceSideId side, const Vector2& axis, double& doubt) const {
  const Segment2 piece = arrangement_.turned_piece(side);
  const Vector2 along = rounded(frame_.direction(piece.a, piece.b));
  doubt += 9 * kUnitRoundoff * std::numbers::pi;
  const double angle = same_bits::atan2(-cross(along, axis), -dot(along, axis));
  return angle < -std::numbers::pi / 2 ? angle + 2 * std::numbers::pi : angle;
}

void WedgeLighting2::shade(const Wedge2& wedge, LitWedge2& lit, std::vector<double>& coefficients) const {
  lit.coefficients = static_cast<std::uint32_t>(coefficients.size());
  double left_angle = 0, right_angle = 0, angle_doubt = 0, sources = 0;
  if (!sends_like_the_sky(wedge.seen_left)) left_angle = angle_to_axis(wedge.seen_left, lit.axis, angle_doubt);
  if (!sends_like_the_sky(wedge.seen_right)) right_angle = angle_to_axis(wedge.seen_right, lit.axis, angle_doubt);
  const auto left = radiosity_.of(wedge.seen_left), right = radiosity_.of(wedge.seen_right), sky = radiosity_.of(kSky);
  for (std::size_t c = 0; c < sky.size(); ++c) {
    const double from_left = left[c] - sky[c], from_right = right[c] - sky[c];
    coefficients.push_back(from_right * right_angle - from_left * left_angle);
    coefficients.push_back(from_right - from_left);
    sources = std::max(sources, std::fabs(from_left) + std::fabs(from_right));
  }
  lit.doubt = angle_doubt * sources;
}

double WedgeLighting2::largest_value(const Wedge2& wedge) const {
  const auto left = radiosity_.of(wedge.seen_left), right = radiosity_.of(wedge.seen_right), sky = radiosity_.of(kSky);
  double most = 0;
  for (std::size_t c = 0; c < sky.size(); ++c)
    most = std::max(most, std::fabs(left[c] - sky[c]) + std::fabs(right[c] - sky[c]));
  return most * std::numbers::pi;
}

void WedgeLighting2::find(VertexId v, LitWedges2& result) const {
  thread_local View2 view;
  thread_local std::vector<Wedge2> wedges;
  look_around(arrangement_.vertices(), arrangement_.triangulation(), v, view);
  wedges.clear();
  append_wedges(arrangement_.vertices(), v, view, wedges);

  result.apex = frame_.vertex(v);
  result.rough_doubt = 0x1p-49 * (size_of(result.apex) + frame_.extent());
  result.rays.clear();
  result.wedges.clear();
  result.coefficients.clear();
  result.lost = 0;
  const bool is_in_range = size_of(result.apex) < 0x1p200 && frame_.extent() < 0x1p200;
  const Wedge2* before = nullptr;  // if it was placed
  for (const Wedge2& wedge : wedges) {
    const Wedge2* const last = std::exchange(before, nullptr);
    if (radiosity_.is_covered(wedge.seen_left)) continue;  // it lies in a solid
    if (sends_like_the_sky(wedge.seen_left) && sends_like_the_sky(wedge.seen_right)) continue;
    LitWedge2 lit;
    lit.is_joined = last != nullptr && wedge.right.kind != VertexRay2::Kind::kAxis && same_ray(last->left, wedge.right);
    lit.right = lit.is_joined ? result.wedges.back().left : add_ray(v, wedge.right, result);
    lit.left = add_ray(v, wedge.left, result);
    lit.corners[0] = rounded(result.apex);
    if (is_in_range && wedge.behind != kSky) place_end(v, wedge, lit);
    if (is_in_range && wedge.behind == kSky) place_without_end(v, wedge, lit);
    const CutLine2 &right = result.rays[lit.right], &left = result.rays[lit.left];
    const bool is_placed =
        is_in_range && right.doubt() < kLost && left.doubt() < kLost && (!lit.is_ended || lit.end.doubt() < kLost);
    if (!is_placed) {
      result.lost += largest_value(wedge);
      continue;
    }
    lit.axis = diagonal({right.gradient().y, -right.gradient().x}, {left.gradient().y, -left.gradient().x});
    shade(wedge, lit, result.coefficients);
    result.wedges.push_back(lit);
    before = &wedge;
  }
}

}  // namespace hottel
