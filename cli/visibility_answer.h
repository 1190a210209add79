// What `hottel visibility` answers.
#pragma once

#include <array>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "geometry/plane/arrangement/prepared_scene.h"
#include "geometry/plane/visibility/visibility_polygon.h"
#include "kernel/rounding.h"
#include "viewer/picture/cairo_canvas.h"

namespace hottel {

// One answer in three forms.
struct Answer {
  nlohmann::ordered_json json;
  std::string text;
  std::function<std::string(PictureFormat)> draw;
};

// What a point sees: the visibility polygon, the angles, and on demand the mean irradiance. In a solid: which, and
// nothing else; on the border of solids the directions into them are told apart, as fractions of the full turn.
Answer from_point(const PreparedScene2& prepared, const ExactPoint2& eye, bool wants_light);

std::array<double, 2> rounded(const ExactPoint2& p);

nlohmann::ordered_json json_of(const Rational& value);
nlohmann::ordered_json json_of(const ExactPoint2& p);
nlohmann::ordered_json json_of(const Rounded& number);

// "(1.5, 0.3333333333333333)", with "= (3/2, 1/3)" where a decimal would not say all.
std::string text_of(const ExactPoint2& p);

// "wall:back"; "sky". REQUIRES a side that is not covered.
std::string name_of(const Scene2& scene, const Arrangement2& arrangement, PieceSideId side);

// "the solid 'box'"
std::string solid_text(const Scene2& scene, std::uint32_t group);

}  // namespace hottel
