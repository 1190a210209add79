#include "solver/illumination/lit_wedge_2.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hottel {
namespace {

constexpr double kUnit = 0x1p-53;

double size_of(const FinePoint2& p) { return std::fabs(p.x.hi) + std::fabs(p.y.hi); }

Vector2 normalized(const Vector2& a) { return (1 / std::hypot(a.x, a.y)) * a; }

}  // namespace

void LitWedges2::clear() {
  wedges.clear();
  coefficients.clear();
  lost = 0;
}

FinePoint2 WedgeLighting2::direction(VertexId v, const VertexRay2& ray, double& size) const {
  constexpr Vector2 kAxes[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  size = 0;
  if (ray.kind == VertexRay2::Kind::kAxis) {
    const Vector2& axis = kAxes[ray.index % 4];
    return {{axis.x, 0}, {axis.y, 0}};
  }
  const FinePoint2 &here = frame_.vertex(v), &there = frame_.vertex(ray.index);
  size = size_of(here) + size_of(there);
  return ray.kind == VertexRay2::Kind::kTowards ? there - here : here - there;
}

// The line of the piece that ends the wedge, and the corners on it.
bool WedgeLighting2::place_end(VertexId v, const Wedge2& wedge, LitWedge2& lit) const {
  const Segment2& piece = arrangement_.pieces()[static_cast<std::size_t>(wedge.behind / 2)];
  const bool seen_from_left = wedge.behind % 2 == 0;
  const VertexId first = seen_from_left ? piece.a : piece.b, second = seen_from_left ? piece.b : piece.a;
  const FinePoint2 &p = frame_.vertex(first), &q = frame_.vertex(second);
  const FinePoint2 along = q - p;
  const double reach = frame_.extent();
  lit.lines[2] = CutLine2(p, along, size_of(p) + size_of(q), reach);
  const Vector2 from = rounded(p - lit.apex), step = rounded(along);
  const double length = std::hypot(step.x, step.y), far = size_of(lit.apex) + size_of(p) + size_of(q) + reach;
  for (int side = 0; side < 2; ++side) {
    const VertexRay2& ray = side == 0 ? wedge.right : wedge.left;
    Vector2& corner = lit.corners[side + 1];
    if (ray.kind == VertexRay2::Kind::kTowards && (ray.index == first || ray.index == second)) {
      corner = rounded(frame_.vertex(ray.index));
      continue;
    }
    double size;
    const Vector2 way = normalized(rounded(direction(v, ray, size)));
    const double turn = cross(way, step);
    const double t = turn == 0 ? 0 : std::clamp(-cross(way, from) / turn, 0.0, 1.0);
    corner = rounded(p) + t * step;
    lit.margin =
        std::max(lit.margin, turn == 0 ? length : std::min(length, 64 * kUnit * far * length / std::fabs(turn)));
  }
  lit.margin += 16 * kUnit * far;
  return lit.lines[2].doubt() < 0.25;
}

// False when the lines of the wedge are not known within a quarter of a cell.
bool WedgeLighting2::place(VertexId v, const Wedge2& wedge, LitWedge2& lit) const {
  lit.apex = frame_.vertex(v);
  if (!(size_of(lit.apex) < 0x1p200 && frame_.extent() < 0x1p200)) return false;
  double right_size, left_size;
  const FinePoint2 right = direction(v, wedge.right, right_size), left = direction(v, wedge.left, left_size);
  lit.lines[0] = CutLine2(lit.apex, right, right_size, frame_.extent());
  lit.lines[1] = CutLine2(lit.apex, -left, left_size, frame_.extent());
  if (!(lit.lines[0].doubt() < 0.25 && lit.lines[1].doubt() < 0.25)) return false;
  const Vector2 right_way = normalized(rounded(right)), left_way = normalized(rounded(left));
  lit.axis = normalized(right_way + left_way);
  lit.corners[0] = rounded(lit.apex);
  if (wedge.behind != kSky) return place_end(v, wedge, lit);
  const double reach = size_of(lit.apex) + frame_.extent();
  lit.line_count = 2;
  lit.corners[1] = lit.corners[0] + 4 * reach * right_way;
  lit.corners[2] = lit.corners[0] + 4 * reach * left_way;
  lit.margin = 0x1p-40 * reach;
  return true;
}

// The angle from the piece, its front on the right, to the direction from the axis to the apex: in [0, pi].
double WedgeLighting2::angle_to_axis(PieceSideId side, const Vector2& axis, double& doubt) const {
  const Segment2& piece = arrangement_.pieces()[static_cast<std::size_t>(side / 2)];
  const FinePoint2 &a = frame_.vertex(piece.a), &b = frame_.vertex(piece.b);
  const Vector2 along = rounded(side % 2 == 0 ? a - b : b - a);
  doubt += 8 * kUnit * std::numbers::pi + 8 * kFine * (size_of(a) + size_of(b)) / std::hypot(along.x, along.y);
  return std::atan2(std::max(-cross(along, axis), 0.0), -dot(along, axis));
}

void WedgeLighting2::shade(const Wedge2& wedge, LitWedge2& lit, std::vector<double>& coefficients) const {
  const double half_angle = std::numbers::pi / 4 + 0x1p-20;
  lit.coefficients = static_cast<std::uint32_t>(coefficients.size());
  double left_angle = 0, right_angle = 0;
  if (!sends_like_the_sky(wedge.seen_left)) left_angle = angle_to_axis(wedge.seen_left, lit.axis, lit.angle_doubt);
  if (!sends_like_the_sky(wedge.seen_right)) right_angle = angle_to_axis(wedge.seen_right, lit.axis, lit.angle_doubt);
  const auto left = radiosity_.of(wedge.seen_left), right = radiosity_.of(wedge.seen_right), sky = radiosity_.of(kSky);
  for (std::size_t c = 0; c < sky.size(); ++c) {
    const double from_left = left[c] - sky[c], from_right = right[c] - sky[c];
    const double constant = from_right * right_angle - from_left * left_angle, slope = from_right - from_left;
    coefficients.push_back(constant);
    coefficients.push_back(slope);
    lit.largest = std::max(lit.largest, std::fabs(constant) + std::fabs(slope) * half_angle);
    lit.largest_slope = std::max(lit.largest_slope, std::fabs(slope));
    lit.sources = std::max(lit.sources, std::fabs(from_left) + std::fabs(from_right));
  }
}

void WedgeLighting2::append(VertexId v, LitWedges2& result) const {
  thread_local View2 view;
  thread_local std::vector<Wedge2> wedges;
  look_around(arrangement_.vertices(), arrangement_.triangulation(), v, view);
  wedges.clear();
  append_wedges(arrangement_.vertices(), v, view, wedges);
  for (const Wedge2& wedge : wedges) {
    if (sends_like_the_sky(wedge.seen_left) && sends_like_the_sky(wedge.seen_right)) continue;
    LitWedge2 lit;
    if (place(v, wedge, lit)) {
      shade(wedge, lit, result.coefficients);
      result.wedges.push_back(lit);
    } else {
      const auto left = radiosity_.of(wedge.seen_left), right = radiosity_.of(wedge.seen_right),
                 sky = radiosity_.of(kSky);
      double most = 0;
      for (std::size_t c = 0; c < sky.size(); ++c)
        most = std::max(most, std::fabs(left[c] - sky[c]) + std::fabs(right[c] - sky[c]));
      result.lost += most * std::numbers::pi;
    }
  }
}

}  // namespace hottel
