#include "solver/space/light/sent_out.h"

#include <algorithm>

#include "kernel/rational.h"

namespace hottel {

SentOut3::SentOut3(const PreparedScene3& prepared, Granularity granularity, const RadiositySolution& solution)
    : seen_(prepared, *prepared.elements(granularity), Blacks3::kLeftOut), solution_(solution) {
  for (const Rational& emission : prepared.scene.sky_emission.value) sky_.push_back(to_double(emission));
}

SeenElements3::Take SentOut3::adding_to(std::span<double> result) const {
  return [this, result](std::uint32_t label, double fraction) {
    for (std::size_t c = 0; c < result.size(); ++c)
      result[c] += fraction * solution_.channels[c].elements[label].radiosity;
  };
}

void SentOut3::mean(const Point3& eye, std::span<double> result) const {
  std::vector<double> sum(result.size(), 0.0);
  const auto sky = seen_.around(eye, adding_to(sum));
  if (!sky) return;
  for (std::size_t c = 0; c < result.size(); ++c) result[c] = sum[c] + *sky * sky_[c];
}

double SentOut3::irradiance(const Point3& eye, const Vector3& normal, std::span<double> result) const {
  std::fill(result.begin(), result.end(), 0.0);
  const double sky = seen_.toward(eye, normal, adding_to(result));
  for (std::size_t c = 0; c < result.size(); ++c) result[c] += sky * sky_[c];
  return sky;
}

}  // namespace hottel
