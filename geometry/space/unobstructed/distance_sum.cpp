// A plain loop over lanes: the compiler makes vectors of them, of whatever length the processor has, and none of its
// results depends on that.
#include "geometry/space/unobstructed/distance_sum.h"

#include "kernel/support/each_processor.h"

namespace hottel {

void WeightedPoints3::reserve(std::size_t count) {
  for (std::vector<double>* column : {&x, &y, &z, &weight}) column->reserve(count);
}

void WeightedPoints3::add(const LocalVector3<double>& at, double w) {
  x.push_back(at.x);
  y.push_back(at.y);
  z.push_back(at.z);
  weight.push_back(w);
}

HOTTEL_FOR_EACH_PROCESSOR
static double fourth_powers(double from_x, double from_y, double from_z, const double* x, const double* y,
                            const double* z, const double* weight, std::size_t count) {
  constexpr std::size_t kRows = 4;
  double rows[kRows] = {0, 0, 0, 0};
  const auto term = [&](std::size_t k) {
    const double dx = from_x - x[k], dy = from_y - y[k], dz = from_z - z[k];
    const double r2 = dx * dx + dy * dy + dz * dz;
    return weight[k] / (r2 * r2);
  };
  std::size_t k = 0;
  for (; k + kRows <= count; k += kRows)
    for (std::size_t row = 0; row < kRows; ++row) rows[row] += term(k + row);
  for (; k < count; ++k) rows[0] += term(k);
  return (rows[0] + rows[1]) + (rows[2] + rows[3]);
}

double sum_over_fourth_powers(const LocalVector3<double>& from, const WeightedPoints3& points) {
  return fourth_powers(from.x, from.y, from.z, points.x.data(), points.y.data(), points.z.data(), points.weight.data(),
                       points.weight.size());
}

}  // namespace hottel
