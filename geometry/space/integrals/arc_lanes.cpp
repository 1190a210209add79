// Plain loops over lanes, one operation after the other as in arc_sum.h: the compiler makes vectors of them, of
// whatever length the processor has, and none of its results depends on that.
#include "geometry/space/integrals/arc_lanes.h"

#include <algorithm>
#include <cmath>

#include "geometry/space/pieces/arc_angle.h"
#include "kernel/support/each_processor.h"

namespace hottel {
namespace {

constexpr int kTerms = (std::numeric_limits<double>::digits + 3) / 4;

// As detail::angle_over_sine_less_one() has them.
constexpr std::array<double, kTerms> kFactors = [] {
  std::array<double, kTerms> result{};
  for (int k = 0; k < kTerms; ++k) result[static_cast<std::size_t>(k)] = (2.0 * k + 2) / (2.0 * k + 3);
  return result;
}();

}  // namespace

// The unit vectors along a vector; no numbers where it is zero. Lowers what the squares of lengths are at least.
HOTTEL_FOR_EACH_PROCESSOR
static void set_units(const MovingVector3& vector, double from, const Lanes3& offsets, VectorLanes3& units,
                      Lanes3& least) {
  const double base = from - vector.base;
  const double x0 = vector.first.x, y0 = vector.first.y, z0 = vector.first.z;
  const Direction3 one = vector.second, two = vector.third;
  for (std::size_t k = 0; k < kLanes3; ++k) {
    const double s = base + offsets[k];
    const double x = x0 + s * (one.x + s * two.x), y = y0 + s * (one.y + s * two.y), z = z0 + s * (one.z + s * two.z);
    const double square = x * x + y * y + z * z;
    const double scale = 1 / std::sqrt(square);
    least[k] = square < least[k] ? square : least[k];
    units.x[k] = scale * x;
    units.y[k] = scale * y;
    units.z[k] = scale * z;
  }
}

// Raises what the squares of distances are at most.
HOTTEL_FOR_EACH_PROCESSOR
static void raise_spread(const VectorLanes3& corner, const VectorLanes3& first, Lanes3& spread) {
  for (std::size_t k = 0; k < kLanes3; ++k) {
    const double x = corner.x[k] - first.x[k], y = corner.y[k] - first.y[k], z = corner.z[k] - first.z[k];
    const double square = x * x + y * y + z * z;
    spread[k] = square > spread[k] ? square : spread[k];
  }
}

HOTTEL_FOR_EACH_PROCESSOR
static void add_arc(double half, const VectorLanes3& begin, const VectorLanes3& end, const VectorLanes3& centre,
                    VectorLanes3& sums) {
  for (std::size_t k = 0; k < kLanes3; ++k) {
    const double bx = begin.x[k], by = begin.y[k], bz = begin.z[k];
    const double x = end.x[k] - bx, y = end.y[k] - by, z = end.z[k] - bz;
    const double q = (x * x + y * y + z * z) / 4;
    double series = 1;
    for (std::size_t n = kTerms - 1; n > 0; --n) series = 1 + kFactors[n] * q * series;
    const double more = kFactors[0] * q * series;
    const double cx = bx - centre.x[k], cy = by - centre.y[k], cz = bz - centre.z[k];
    sums.x[k] += half * ((cy * z - cz * y) + more * (by * z - bz * y));
    sums.y[k] += half * ((cz * x - cx * z) + more * (bz * x - bx * z));
    sums.z[k] += half * ((cx * y - cy * x) + more * (bx * y - by * x));
  }
}

// Where corners are not close to each other.
HOTTEL_FOR_EACH_PROCESSOR
static void add_wide_arc(double count, int turn, const VectorLanes3& begin, const VectorLanes3& end,
                         const VectorLanes3& normal, VectorLanes3& sums) {
  for (std::size_t k = 0; k < kLanes3; ++k) {
    const double bx = begin.x[k], by = begin.y[k], bz = begin.z[k];
    const double ex = end.x[k], ey = end.y[k], ez = end.z[k];
    const double x = ex - bx, y = ey - by, z = ez - bz;
    const double sine =
        normal.x[k] * (by * z - bz * y) + normal.y[k] * (bz * x - bx * z) + normal.z[k] * (bx * y - by * x);
    const double angle = count * arc_angle(sine, bx * ex + by * ey + bz * ez, turn) / 2;
    sums.x[k] += angle * normal.x[k];
    sums.y[k] += angle * normal.y[k];
    sums.z[k] += angle * normal.z[k];
  }
}

namespace {

// Sets the unit vectors along vectors; false where one is zero.
bool set_all_units(std::span<const MovingVector3> vectors, double from, const Lanes3& offsets,
                   std::vector<VectorLanes3>& units) {
  units.resize(vectors.size());
  Lanes3 least;
  least.fill(1);
  for (std::size_t v = 0; v < vectors.size(); ++v) set_units(vectors[v], from, offsets, units[v], least);
  return std::ranges::all_of(least, [](double square) { return square > 0; });
}

}  // namespace

bool sum_of_arcs_in_lanes(std::span<const SeenArc3> arcs, std::span<const MovingVector3> corners,
                          std::span<const MovingVector3> planes, double from, const Lanes3& offsets, VectorLanes3& sums,
                          Lanes3& rounding) {
  thread_local std::vector<VectorLanes3> at, normals;
  if (!set_all_units(corners, from, offsets, at)) return false;
  Lanes3 spread{};
  for (const VectorLanes3& corner : at) raise_spread(corner, at[0], spread);
  const auto is_close = [](double square) { return square < detail::kCloseCorners * detail::kCloseCorners; };
  const bool are_close = std::ranges::all_of(spread, is_close), are_wide = std::ranges::none_of(spread, is_close);
  if (!are_close && !set_all_units(planes, from, offsets, normals)) return false;
  const auto add_all = [&](bool by_differences, VectorLanes3& sum) {
    sum = {};
    for (const SeenArc3& arc : arcs)
      if (by_differences)
        add_arc(arc.count / 2, at[arc.begin], at[arc.end], at[0], sum);
      else
        add_wide_arc(arc.count, arc.turn, at[arc.begin], at[arc.end], normals[arc.plane], sum);
  };
  add_all(are_close, sums);
  if (!are_close && !are_wide) {
    VectorLanes3 by_differences;
    add_all(true, by_differences);
    for (std::size_t k = 0; k < kLanes3; ++k) {
      if (!is_close(spread[k])) continue;
      sums.x[k] = by_differences.x[k];
      sums.y[k] = by_differences.y[k];
      sums.z[k] = by_differences.z[k];
    }
  }
  const double all = detail::kArcRounding<double> * static_cast<double>(arcs.size());
  for (std::size_t k = 0; k < kLanes3; ++k) rounding[k] = all * (is_close(spread[k]) ? std::sqrt(spread[k]) : 1.0);
  return true;
}

}  // namespace hottel
