// Plain loops over lanes, one operation after the other as in arc_sum.h: the compiler makes vectors of them, of
// whatever length the processor has, and none of its results depends on that.
#include "geometry/space/integrals/arc_lanes.h"

#include <cmath>

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

bool sum_of_close_arcs(std::span<const SeenArc3> arcs, std::span<const MovingVector3> corners, double from,
                       const Lanes3& offsets, VectorLanes3& sums, Lanes3& rounding) {
  thread_local std::vector<VectorLanes3> at;
  at.resize(corners.size());
  Lanes3 spread{}, least;
  least.fill(1);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    set_units(corners[c], from, offsets, at[c], least);
    raise_spread(at[c], at[0], spread);
  }
  for (std::size_t k = 0; k < kLanes3; ++k)
    if (!(least[k] > 0 && spread[k] < detail::kCloseCorners * detail::kCloseCorners)) return false;
  sums = {};
  for (const SeenArc3& arc : arcs) add_arc(arc.count / 2, at[arc.begin], at[arc.end], at[0], sums);
  for (std::size_t k = 0; k < kLanes3; ++k)
    rounding[k] = detail::kArcRounding<double> * static_cast<double>(arcs.size()) * std::sqrt(spread[k]);
  return true;
}

}  // namespace hottel
