#include "geometry/plane/predicates/eye_tile.h"

#include <algorithm>
#include <bit>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

// Room for the roundings of a sum of a few positive terms.
constexpr double kUp = 1 + 0x1p-48;

// That of the two products of a determinant and their difference (Vertices2::orientation), with the same room.
constexpr double kRounding = 3 * kUp * 0x1p-53;

}  // namespace

EyeTile2::EyeTile2(const Vertices2& vertices, std::span<const EyeCoordinate2> columns,
                   std::span<const EyeCoordinate2> rows)
    : approximate_(vertices.approximate_.data()), error_(vertices.input_error_ * kUp), columns_(columns.size()) {
  HOTTEL_REQUIRE(!columns.empty() && columns.size() <= kSide && !rows.empty() && rows.size() <= kSide);
  double extent = std::ldexp(1.0, vertices.coordinate_bits_ - vertices.approximation_shift_);
  const auto copy = [&](std::span<const EyeCoordinate2> coordinates, std::array<double, kSide>& approximate) {
    approximate.fill(0);
    for (std::size_t k = 0; k < coordinates.size(); ++k) {
      approximate[k] = coordinates[k].approximate_;
      error_of_eyes_ = std::max(error_of_eyes_, coordinates[k].error_ * kUp);
      extent = std::max(extent, std::fabs(approximate[k]));
    }
  };
  copy(columns, x_);
  copy(rows, y_);
  // No coordinate of a vertex as seen from the middle of a box exceeds `largest`, and the radii of a box do not
  // together. 6 u for the determinant, 2 u for the differences that are multiplied by the radii.
  const double largest = 2 * (extent + error_ + error_of_eyes_);
  error_anywhere_ = (8 * 0x1p-53 * largest * largest + error_ * (8 * largest + 2 * error_)) * kUp;
  eyes_.reserve(columns.size() * rows.size());
  for (const EyeCoordinate2& y : rows)
    for (const EyeCoordinate2& x : columns) eyes_.emplace_back(vertices, x, y);
}

EyeTile2::Group EyeTile2::group(Set eyes) const {
  Set columns = eyes | eyes >> 32;
  columns |= columns >> 16;
  columns = (columns | columns >> 8) & 0xff;
  const auto box = [this](double low, double high, double& middle, double& radius) {
    middle = low + (high - low) / 2;
    radius = (std::max(high - middle, middle - low) + error_of_eyes_) * kUp;
  };
  Group result{eyes, 0, 0, 0, 0};
  box(x_[std::countr_zero(columns)], x_[std::bit_width(columns >> 1)], result.x, result.radius_x);
  box(y_[std::countr_zero(eyes) / kSide], y_[std::bit_width(eyes >> 1) / kSide], result.y, result.radius_y);
  return result;
}

// Seen from (x + u, y + v) the determinant is larger by v dx - u dy than from (x, y).
EyeTile2::Set EyeTile2::seeing_left_turn_each(const Group& group, VertexId j, VertexId k) const {
  const Vertices2::Approximate &q = approximate_[j.index()], &r = approximate_[k.index()];
  const double ax = q.x - group.x, ay = q.y - group.y, bx = r.x - group.x, by = r.y - group.y;
  const double left = ax * by, right = ay * bx, determinant = left - right, dx = bx - ax, dy = by - ay;
  // Of the determinant, and of dx and dy as far as it matters in the box.
  double bound = (kRounding * (std::fabs(left) + std::fabs(right)) +
                  error_ * (std::fabs(ax) + std::fabs(ay) + std::fabs(bx) + std::fabs(by) +
                            2 * (group.radius_x + group.radius_y + error_)) +
                  0x1p-52 * (group.radius_x * (std::fabs(ay) + std::fabs(by)) +
                             group.radius_y * (std::fabs(ax) + std::fabs(bx)))) *
                 kUp;
  const double across = group.radius_x * std::fabs(dy) + group.radius_y * std::fabs(dx);
  if (std::fabs(determinant) > (bound + across) * kUp) return determinant > 0 ? group.eyes : 0;
  bound =
      (bound + error_of_eyes_ * (std::fabs(dx) + std::fabs(dy)) + 0x1p-50 * (across + std::fabs(determinant))) * kUp;
  Set result = 0;
  double smallest = HUGE_VAL;
  for (Set rest = group.eyes; rest != 0; rest &= rest - 1) {
    const auto one = static_cast<std::size_t>(std::countr_zero(rest));
    const double there = determinant + ((y_[one / kSide] - group.y) * dx - (x_[one % kSide] - group.x) * dy);
    result |= Set{there > 0} << one;
    smallest = std::min(smallest, std::fabs(there));
  }
  if (smallest > bound) return result;
  result = 0;
  for (Set rest = group.eyes; rest != 0; rest &= rest - 1)
    if (eye(static_cast<std::size_t>(std::countr_zero(rest))).orientation(j, k) > 0) result |= rest & -rest;
  return result;
}

}  // namespace hottel
