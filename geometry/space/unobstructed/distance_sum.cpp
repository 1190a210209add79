// Plain loops in which no step needs the one before: the compiler makes vectors of them, of whatever length the
// processor has, and none of their results depends on that. Sums are made afterwards.
#include "geometry/space/unobstructed/distance_sum.h"

#include <algorithm>

#include "geometry/space/unobstructed/local_outline.h"
#include "kernel/support/each_processor.h"

namespace hottel {
namespace {

constexpr std::size_t kMostNodes = kMaxLegendreNodes<double> * kMaxLegendreNodes<double>;
using Column = std::array<double, kMostNodes>;

// The nodes of two rules in the unit square: the shares of corners, and the products of weights.
struct SquareNodes {
  std::array<Column, 4> share;
  Column weight;
  std::size_t count = 0;

  SquareNodes(const LegendreRule<double>& along, const LegendreRule<double>& across) {
    for (std::size_t a = 0; a < along.node.size(); ++a)
      for (std::size_t b = 0; b < across.node.size(); ++b, ++count) {
        const std::array<double, 4> of_corners = shares_of_corners(along.node, a, across.node, b);
        for (std::size_t c = 0; c < 4; ++c) share[c][count] = of_corners[c];
        weight[count] = along.weight[a] * across.weight[b];
      }
  }
};

}  // namespace

HOTTEL_FOR_EACH_PROCESSOR
static void make_points(const WeightedCell3& of, const SquareNodes& nodes, double* x, double* y, double* z,
                        double* weight, double* off) {
  const WeightedCell3 cell = of;
  for (std::size_t k = 0; k < nodes.count; ++k) {
    const std::array<double, 4> share{nodes.share[0][k], nodes.share[1][k], nodes.share[2][k], nodes.share[3][k]};
    LocalVector3<double> at;
    for (std::size_t c = 0; c < 4; ++c) at = at + share[c] * cell.corner[c];
    const Approximation<double> height = mixed(share, cell.height), density = mixed(share, cell.density);
    x[k] = at.x;
    y[k] = at.y;
    z[k] = at.z;
    weight[k] = nodes.weight[k] * (height.value * density.value);
    off[k] = nodes.weight[k] * (height.value * density.error + (density.value + density.error) * height.error) +
             6 * kRoundoff<double> * weight[k];
  }
}

void WeightedPoints3::add(const WeightedCell3& cell, const LegendreRule<double>& along,
                          const LegendreRule<double>& across, double& off) {
  const SquareNodes nodes(along, across);
  const std::size_t first = size();
  for (std::vector<double>* column : {&x, &y, &z, &weight}) column->resize(first + nodes.count);
  Column offs;
  make_points(cell, nodes, &x[first], &y[first], &z[first], &weight[first], offs.data());
  for (std::size_t k = 0; k < nodes.count; ++k) off += offs[k];
}

HOTTEL_FOR_EACH_PROCESSOR
static void make_terms(double from_x, double from_y, double from_z, const double* x, const double* y, const double* z,
                       const double* weight, std::size_t count, double* __restrict terms) {
  for (std::size_t k = 0; k < count; ++k) {
    const double dx = from_x - x[k], dy = from_y - y[k], dz = from_z - z[k];
    const double r2 = dx * dx + dy * dy + dz * dz;
    terms[k] = weight[k] / (r2 * r2);
  }
}

double sum_over_fourth_powers(const LocalVector3<double>& from, const WeightedPoints3& points) {
  constexpr std::size_t kRows = 4, kBlock = 128;
  std::array<double, kBlock> terms;
  double rows[kRows] = {0, 0, 0, 0};
  for (std::size_t first = 0; first < points.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, points.size() - first);
    make_terms(from.x, from.y, from.z, &points.x[first], &points.y[first], &points.z[first], &points.weight[first],
               count, terms.data());
    std::size_t k = 0;
    for (; k + kRows <= count; k += kRows)
      for (std::size_t row = 0; row < kRows; ++row) rows[row] += terms[k + row];
    for (; k < count; ++k) rows[0] += terms[k];
  }
  return (rows[0] + rows[1]) + (rows[2] + rows[3]);
}

}  // namespace hottel
