#include "io/results/oriented_light_csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "io/results/csv_field.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// A normal as it was given; where doubles do not hold that, its largest coordinate is 1.
std::array<Rational, 3> written_normal(const std::array<Rational, 3>& normal) {
  const auto is_held = [](const Rational& x) { return x == 0 || (to_double(x) != 0 && std::isfinite(to_double(x))); };
  if (std::ranges::all_of(normal, is_held)) return normal;
  Rational largest;
  for (const Rational& x : normal) largest = std::max(largest, Rational(abs(x)));
  return {normal[0] / largest, normal[1] / largest, normal[2] / largest};
}

}  // namespace

OrientedLightCsv::OrientedLightCsv(int dimension, const std::vector<std::string>& channel_names,
                                   std::function<void(std::string_view)> sink)
    : dimension_(static_cast<std::size_t>(dimension)), sink_(std::move(sink)) {
  std::string head = dimension == 2 ? "point,x,y,nx,ny" : "point,x,y,z,nx,ny,nz";
  for (const std::string& channel : channel_names) head += channel == "all" ? ",irradiance" : ",irradiance_" + channel;
  sink_(head + ",sky_view_factor,mean_radiant_temperature\n");
}

void OrientedLightCsv::add(std::span<const OrientedPoint> points, std::span<const OrientedLight> lights) {
  HOTTEL_REQUIRE(points.size() == lights.size());
  std::string text;
  for (std::size_t k = 0; k < points.size(); ++k) {
    text += std::to_string(next_++);
    for (const auto& numbers : {points[k].point, written_normal(points[k].normal)})
      for (std::size_t a = 0; a < dimension_; ++a) text += "," + shortest(to_double(numbers[a]));
    for (const double value : lights[k].irradiance) text += "," + csv_number(value);
    text += "," + csv_number(lights[k].sky_view_factor) + "," +
            csv_number(mean_radiant_temperature(lights[k].mean_irradiance)) + "\n";
  }
  sink_(text);
}

}  // namespace hottel
