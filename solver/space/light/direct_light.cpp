#include "solver/space/light/direct_light.h"

#include <cmath>
#include <limits>

#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/direction.h"

namespace hottel {
namespace {

// A vector in doubles that neither overflows nor underflows in squares, and its unit.
struct ScaledWay {
  Direction3 way;
  int exponent = 0;
};

ScaledWay scaled(const Vector3& way) {
  const Direction3 d{to_double(way.x), to_double(way.y), to_double(way.z)};
  const double size = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  if (!(size > 0) || !std::isfinite(size)) return {d, 0};
  const int exponent = std::ilogb(size);
  return {{std::ldexp(d.x, -exponent), std::ldexp(d.y, -exponent), std::ldexp(d.z, -exponent)}, exponent};
}

// 1 / r^2
double inverse_square(const ScaledWay& way) { return std::ldexp(1 / dot(way.way, way.way), -2 * way.exponent); }

}  // namespace

DirectLight3::DirectLight3(const PreparedScene3& prepared, const Point3& position, const Beam3& beam)
    : prepared_(prepared),
      map_(prepared.occluders(), position),
      finder_(map_),
      beam_(beam),
      is_in_solid_(prepared.arrangement().solids().around(position).has_value()) {}

DirectLight3::DirectLight3(const PreparedScene3& prepared, const Vector3& sun)
    : prepared_(prepared),
      map_(ExactVisibilityMap3::of_sun(prepared.occluders(), sun)),
      finder_(map_),
      beam_(Beam3{}),
      sun_(sun) {}

double DirectLight3::intensity_to(const Point3& point) const {
  if (is_in_solid_) return 0;
  if (point == map_.eye()) return std::numeric_limits<double>::infinity();
  const double intensity = beam_.intensity(map_.toward(point));
  return intensity > 0 && finder_.sees(point) ? intensity : 0;
}

double DirectLight3::mean_irradiance(const Point3& point) const {
  if (sun_) return finder_.sees(point) ? 0.25 : 0;
  const double intensity = intensity_to(point);
  if (!(intensity > 0) || std::isinf(intensity)) return intensity;
  return intensity / 4 * inverse_square(scaled(point - map_.eye()));
}

double DirectLight3::irradiance(const Point3& point, const Vector3& normal) const {
  if (sun_) {
    if (dot(normal, *sun_) >= 0 || !finder_.sees(point)) return 0;
    return -dot(unit(scaled(*sun_).way), unit(scaled(normal).way));
  }
  const Vector3 way = map_.eye() - point;
  if (!way.is_zero() && dot(normal, way) <= 0) return 0;
  const double intensity = intensity_to(point);
  if (!(intensity > 0) || std::isinf(intensity)) return intensity;
  const ScaledWay to_light = scaled(way);
  return intensity * dot(unit(to_light.way), unit(scaled(normal).way)) * inverse_square(to_light);
}

std::vector<LitPart3> DirectLight3::lit_parts() const {
  std::vector<LitPart3> result;
  if (is_in_solid_) return result;
  for (std::size_t k = 0; k < map_.size(); ++k) {
    const BeamPower3::Meets meets = beam_.meets(map_.cone(k));
    if (meets == BeamPower3::Meets::kNothing) continue;
    const Face side = map_.map().fragments[k].face;
    result.push_back({side, prepared_.arrangement().owner(side.surface, side.is_back), map_.corners_on_face(k),
                      meets == BeamPower3::Meets::kAll ? LitPart3::Beam::kAll : LitPart3::Beam::kPart});
  }
  return result;
}

}  // namespace hottel
