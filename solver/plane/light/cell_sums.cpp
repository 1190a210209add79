#include "solver/plane/light/cell_sums.h"

#include <algorithm>
#include <cmath>

#include "kernel/doubles.h"
#include "solver/plane/light/cells_near.h"

namespace hottel {
namespace {

constexpr double kCornerDoubt = 32 * kUnitRoundoff;  // of the corners of a part, in radii

}  // namespace

CellSums2::CellSums2(const CellFrame2& frame, std::uint32_t channels)
    : frame_(frame),
      integrals_(frame.height()),
      channels_(channels),
      nothing_(2 * std::size_t{channels}),
      sums_(std::size_t{frame.nx()} * frame.ny() * channels),
      errors_(std::size_t{frame.nx()} * frame.ny()) {}

void CellSums2::add(const LitWedges2& lit, std::uint32_t first_row, std::uint32_t end_row) {
  for (std::size_t w = 0; w < lit.wedges.size(); ++w) add_wedge(lit, w, first_row, end_row);
}

void CellSums2::add_wedge(const LitWedges2& lit, std::size_t w, std::uint32_t first_row, std::uint32_t end_row) {
  const LitWedge2& wedge = lit.wedges[w];
  const double slack = wedge.margin + 0x1p-40 * frame_.extent();
  for_each_cell_near(wedge.corners, slack, frame_, first_row, end_row, [&](std::uint32_t ix, std::uint32_t iy) {
    const FinePoint2 centre = frame_.centre(ix, iy);
    const Cell cell{std::size_t{iy} * frame_.nx() + ix, centre, rounded(centre)};
    if (is_within_quadrant(lit, wedge, cell) && is_before_end(wedge, cell))
      add_sector(lit, w, cell);
    else
      add_between(lit, wedge, cell);
  });
}

bool CellSums2::is_before_end(const LitWedge2& wedge, const Cell& cell) const {
  return !wedge.is_ended || wedge.end.side_of_cell(cell.rough) > 0;
}

bool CellSums2::is_within_quadrant(const LitWedges2& lit, const LitWedge2& wedge, const Cell& cell) const {
  const Vector2 z = cell.rough - rounded(lit.apex);
  return (wedge.axis.x > 0 ? z.x : -z.x) > 0.5 + lit.rough_doubt &&
         (wedge.axis.y > 0 ? z.y : -z.y) > frame_.height() / 2 + lit.rough_doubt;
}

// In a cell within the quadrant and before the end, the wedge is what lies right of its left ray less what lies right
// of its right one. Of two such wedges the one on the left sees to their ray, where only the difference counts.
void CellSums2::add_sector(const LitWedges2& lit, std::size_t w, const Cell& cell) {
  const LitWedge2& wedge = lit.wedges[w];
  const CutLine2 &right = lit.rays[wedge.right], &left = lit.rays[wedge.left];
  const int of_right = right.side_of_cell(cell.rough), of_left = left.side_of_cell(cell.rough);
  if (of_right < 0 || of_left > 0) return;
  const Vector2 z = rounded(cell.centre - lit.apex);
  const double *const own = &lit.coefficients[wedge.coefficients], *const none = nothing_.data();
  const bool is_next_joined =
      w + 1 < lit.wedges.size() && lit.wedges[w + 1].is_joined && is_before_end(lit.wedges[w + 1], cell);
  if (of_left < 0)
    add_cell(z, wedge.axis, cell, {own, none, wedge.doubt});
  else if (!is_next_joined)
    add_right_of(left, z, wedge.axis, cell, {own, none, wedge.doubt});
  if (of_right > 0) return;
  if (!wedge.is_joined || !is_before_end(lit.wedges[w - 1], cell)) {
    add_right_of(right, z, wedge.axis, cell, {none, own, wedge.doubt});
    return;
  }
  const LitWedge2& before = lit.wedges[w - 1];
  const double* const other = &lit.coefficients[before.coefficients];
  if (!std::equal(own, own + 2 * channels_, other))
    add_right_of(right, z, wedge.axis, cell, {other, own, wedge.doubt + before.doubt});
}

void CellSums2::add_cell(const Vector2& z, const Vector2& axis, const Cell& cell, const Weight& weight) {
  const double angle_doubt = integrals_.is_near(z) ? integrals_.angle_error(z) : 12 * frame_.height();
  deposit(integrals_.over_cell(z, axis), 0, kUnitRoundoff * angle_doubt, cell, weight);
}

void CellSums2::add_right_of(const CutLine2& ray, const Vector2& z, const Vector2& axis, const Cell& cell,
                             const Weight& weight) {
  CellPart2 rest(frame_.height());
  rest.cut(-ray.at(cell.centre), {-ray.gradient().x, -ray.gradient().y});
  add_part(rest, ray.doubt() + kCornerDoubt * integrals_.radius(), z, axis, cell, weight);
}

// The part of a cell between all lines of the wedge.
void CellSums2::add_between(const LitWedges2& lit, const LitWedge2& wedge, const Cell& cell) {
  CellPart2 rest(frame_.height());
  double doubt = 0;
  const auto cut = [&](const CutLine2& line, double sign) {  // false when nothing is left
    const int side = line.side_of_cell(cell.rough);
    if (side != 0) return side * sign > 0;
    const double at = sign * line.at(cell.centre), error = line.doubt() + kCornerDoubt * integrals_.radius();
    if (at > line.support() + error) return true;
    if (at < -line.support() - error) return false;
    rest.cut(at, sign * line.gradient());
    doubt += error;
    return true;
  };
  if (wedge.is_ended && !cut(wedge.end, 1)) return;
  if (!cut(lit.rays[wedge.right], 1) || !cut(lit.rays[wedge.left], -1)) return;
  add_part(rest, doubt, rounded(cell.centre - lit.apex), wedge.axis, cell,
           {&lit.coefficients[wedge.coefficients], nothing_.data(), wedge.doubt});
}

// doubt: the distances by which the lines that cut the part may be off, summed.
void CellSums2::add_part(const CellPart2& part, double doubt, const Vector2& z, const Vector2& axis, const Cell& cell,
                         const Weight& weight) {
  const double strips = doubt * 4 * integrals_.radius(), rounding = kUnitRoundoff * integrals_.area_error();
  deposit(part.size() < 3 ? AreaAndAngle2{} : integrals_.over(part, z, axis), strips + rounding,
          kUnitRoundoff * integrals_.angle_error(z), cell, weight);
}

void CellSums2::deposit(const AreaAndAngle2& part, double area_doubt, double angle_doubt, const Cell& cell,
                        const Weight& weight) {
  double largest_sum = 0, largest = 0, steepest = 0;
  double* const sums = &sums_[cell.index * channels_];
  for (std::uint32_t c = 0; c < channels_; ++c) {
    const double constant = weight.plus[2 * c] - weight.minus[2 * c];
    const double slope = weight.plus[2 * c + 1] - weight.minus[2 * c + 1];
    sums[c] += constant * part.area + slope * part.angle;
    largest_sum = std::max(largest_sum, std::fabs(sums[c]));
    largest = std::max(largest, std::fabs(constant) + std::fabs(slope));  // the angle stays below 1
    steepest = std::max(steepest, std::fabs(slope));
  }
  errors_[cell.index] += largest * (area_doubt + 8 * kUnitRoundoff * part.area) + steepest * angle_doubt +
                         weight.doubt * part.area + kUnitRoundoff * largest_sum;
}

}  // namespace hottel
