// Lights that are no surfaces: points that shine all around, spots that shine in a beam, and suns.
#pragma once

#include <string>
#include <vector>

#include "geometry/material.h"
#include "kernel/rational.h"

namespace hottel {

// The largest falloff: the beam is then narrower than a tenth of a degree.
inline constexpr int kMaxFalloff = 1'000'000;

enum class LightType : unsigned char { kPoint, kSpot, kSun };

// A light, but for where it is. It has no area, hides nothing and is never a face.
//
//   intensity  I(t) = I0 cos^n t for t <= f, else 0,  t the angle from the axis of the beam
//   in the plane  I0 = P / (2 C_n),  C_n = integral of cos^n t over 0..f                              [W/m per radian]
//   in space      I0 = P (n + 1) / (2 pi (1 - cos^(n+1) f))                                               [W/sr]
//
//   (1) the power P is what leaves the beam in all: to narrow it brightens it
//   (2) a point light has focus 180 and falloff 0: the same in all directions
//   (3) where the falloff is above 0 nothing leaves at more than 90 degrees from the axis: half_angle()
//   (4) a sun is infinitely far away: its rays are parallel, and what of an element it lights gets its irradiance times
//       the cosine. It has focus 180 and falloff 0 as it has neither, and its place says where it shines, not where it
//       is
struct Light {
  std::string name;
  LightType type = LightType::kPoint;
  Rational focus = 180;     // f, the half angle of the beam in degrees, 0 < f <= 180
  Rational falloff = 0;     // n >= 0
  Spectrum power;           // P >= 0 [W; in the plane W per metre of depth]; of a sun the irradiance of what faces it,
                            // E >= 0 [W/m²]
  bool is_thermal = false;  // where there are two bands: of the thermal one
  int line = 0;             // where it stands in the file, 0 if nowhere

  // The angle from the axis, in degrees, up to which something is sent out.
  Rational half_angle() const { return falloff > 0 && focus > 90 ? Rational(90) : focus; }
  // True where the intensity is the same in all directions.
  bool is_round() const { return !is_sun() && falloff == 0 && focus == 180; }
  bool is_sun() const { return type == LightType::kSun; }

  friend bool operator==(const Light&, const Light&) = default;
};

// Returns what is wrong with a light, as the end of a sentence ("focus must be greater than 0 and at most 180
// degrees"); empty when nothing is: (2), and the ranges above.
std::string light_problem(const Light& light);

}  // namespace hottel
