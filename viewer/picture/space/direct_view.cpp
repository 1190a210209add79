#include "viewer/picture/space/direct_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/space/visibility/convex_cut.h"
#include "kernel/plain_functions.h"
#include "solver/space/light/scene_lights.h"
#include "viewer/picture/space/gathered_view.h"
#include "viewer/picture/space/projection.h"
#include "viewer/picture/space/side_plane.h"

namespace hottel {
namespace {

// What a pixel has of the border of a beam: that border is taken as straight in parts of it that are so small that it
// bends by less than kMostBend of what lies between its corners.
constexpr double kMostBend = 0.01;
constexpr int kMostHalvings = 10;

// The integral over what of a convex polygon is in a beam. within: how far a place is within its border.
template <class Within, class Irradiance>
double in_beam(const PixelPolygon& polygon, const Within& within, const Irradiance& irradiance, int halvings) {
  if (polygon.size() < 3) return 0;
  Pixel low = polygon[0], high = low;
  double least = std::numeric_limits<double>::infinity(), most = -least, sum = 0;
  for (const Pixel& p : polygon) {
    const double at = within(p);
    least = std::min(least, at);
    most = std::max(most, at);
    sum += at;
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double bend = std::fabs(within(middle_of_corners_3(polygon)) - sum / static_cast<double>(polygon.size()));
  if (most < -bend) return 0;
  const bool has_border = least < bend;
  if (has_border && bend > kMostBend * (most - least) && halvings < kMostHalvings) {
    const bool is_wide = high.x - low.x > high.y - low.y;
    const auto half = [&](double sign) {
      return cut_convex(
          polygon,
          [&](const Pixel& p) { return sign * (is_wide ? p.x - (low.x + high.x) / 2 : p.y - (low.y + high.y) / 2); },
          place_between_3);
    };
    return in_beam(half(-1), within, irradiance, halvings + 1) + in_beam(half(1), within, irradiance, halvings + 1);
  }
  const PixelPolygon lit = has_border ? cut_convex(polygon, within, place_between_3) : polygon;
  double result = 0;
  for (std::size_t k = 2; k < lit.size(); ++k) {
    const PixelPolygon triangle{lit[0], lit[k - 1], lit[k]};
    result += std::fabs(pixel_area_doubled_3(triangle)) / 2 * irradiance(middle_of_corners_3(triangle));
  }
  return result;
}

PixelPolygon square_of(const PixelCover3& cover) {
  const double x = cover.x, y = cover.y;
  return {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
}

// What a lamp or a sun sends to places that it reaches, in doubles; for the power 1.
class Sender {
 public:
  Sender(const DirectLight3& light, const LightPlace3& place, bool is_sun, const Point3& eye) {
    if (is_sun) {
      sun_ = unit_of_3(place.direction);
      return;
    }
    const Beam3& beam = light.beam().beam();
    place_ = rounded_way(eye, place.position);
    axis_ = unit_of_3(beam.axis);
    falloff_ = to_double(beam.falloff);
    reach_ = to_double(beam.reach()) * (std::numbers::pi / 180);
    const Point3 on_axis{place.position.x + beam.axis.x, place.position.y + beam.axis.y,
                         place.position.z + beam.axis.z};
    axial_ = light.beam().uncut_intensity(light.map().toward(on_axis));
  }

  // The irradiance of a surface at the end of a way from the eye, as if the beam had no border.
  double irradiance(const Direction3& way, const Direction3& normal) const {
    if (sun_) return std::max(0.0, -dot(*sun_, normal));
    const Direction3 to_light = place_ - way;
    const double squared = dot(to_light, to_light), distance = std::sqrt(squared);
    const double intensity =
        falloff_ > 0 ? axial_ * same_bits::pow(std::max(0.0, -dot(to_light, axis_) / distance), falloff_) : axial_;
    return intensity * std::max(0.0, dot(to_light, normal)) / (squared * distance);
  }

  // How far within the border of the beam a place is. [radians]
  double within(const Direction3& way) const {
    const Direction3 out = way - place_;
    return reach_ - same_bits::atan2(length(cross(out, axis_)), dot(out, axis_));
  }

 private:
  std::optional<Direction3> sun_;
  Direction3 place_, axis_;  // the way from the eye
  double falloff_ = 0, reach_ = 0, axial_ = 0;
};

// What a lamp adds to pixels.
class DirectView {
 public:
  DirectView(const Camera3& camera, const Responses3& responses, PixelValues3& pixels)
      : camera_(camera), projection_(camera), responses_(responses), pixels_(pixels) {}

  // Of a part of a side that is lit, within what is seen of it.
  void add(const SeenSide3& seen, const LitPart3& lit, const SidePlane3& plane, const Sender& sender,
           std::span<const double> reflected) {
    std::vector<Direction3> corners;
    for (const Point3& corner : lit.corners) corners.push_back(rounded_way(camera_.eye, corner));
    const PixelPolygon picture = projection_.picture(std::move(corners));
    if (picture.size() < 3) return;
    const PixelPolygon both = common_polygon_3(seen.outline, picture);
    const auto way = [&](const Pixel& p) { return plane.way(projection_.direction(p)); };
    const auto within = [&](const Pixel& p) { return sender.within(way(p)); };
    const auto irradiance_at = [&](const Pixel& p) { return sender.irradiance(way(p), plane.normal()); };
    for_each_covered_pixel(both, pixels_.width, pixels_.height, [&](const PixelCover3& cover) {
      if (!(cover.part > 0)) return;
      const bool is_cut = lit.beam == LitPart3::Beam::kPart;
      const double irradiance =
          !is_cut ? cover.part * irradiance_at(cover.middle)
                  : in_beam(cover.part == 1 ? square_of(cover) : common_polygon_3(square_of(cover), both), within,
                            irradiance_at, 0);
      if (!(irradiance > 0)) return;
      double* pixel = pixels_.values.data() + (std::size_t{cover.y} * pixels_.width + cover.x) * pixels_.channels;
      for (std::size_t c = 0; c < pixels_.channels; ++c) pixel[c] += irradiance * reflected[c];
    });
  }

  // What an element reflects of a light of so much power, by channel.
  std::vector<double> reflected(std::uint32_t element, const std::array<double, 3>& power) const {
    std::vector<double> result(responses_.channels);
    for (std::size_t c = 0; c < result.size(); ++c)
      for (std::size_t k = 0; k < responses_.of_light; ++k)
        result[c] +=
            responses_.per_irradiance[(element * responses_.channels + c) * responses_.of_light + k] * power[k];
    return result;
  }

 private:
  const Camera3& camera_;
  Projection3 projection_;
  const Responses3& responses_;
  PixelValues3& pixels_;
};

}  // namespace

std::vector<double> direct_irradiances_3(const SceneTable& scene, const ElementTable3& table, std::size_t channels,
                                         std::span<const LightShares> shares) {
  std::vector<double> result(table.count() * channels);
  for (std::size_t k = 0; k < shares.size(); ++k)
    for (std::uint32_t i = 0; i < table.count(); ++i) {
      const Enclosure& share = shares[k].of_element[i];
      if (share.upper == 0 || !table.has_row(i)) continue;
      const double per_power = (share.lower + share.upper) / 2 / table.elements()[i].area.value;
      for (std::size_t c = 0; c < channels; ++c)
        result[i * channels + c] += per_power * to_double(scene.lights[k].power.value[c]);
    }
  return result;
}

ElementPaint3 reflected_paint_3(const PreparedScene3& prepared, const ElementTable3& table,
                                const RadiositySolution& solution, std::span<const LightShares> shares) {
  ElementPaint3 paint = light_paint_3(prepared.scene, solution);
  const std::vector<double> direct = direct_irradiances_3(prepared.scene, table, paint.channels, shares);
  for (std::uint32_t i = 0; i < table.count(); ++i)
    for (std::size_t c = 0; c < paint.channels; ++c) {
      double& value = paint.values[i * paint.channels + c];
      value = std::max(0.0, value - solution.channels[c].elements[i].reflectivity * direct[i * paint.channels + c]);
    }
  return paint;
}

void add_direct_light_3(const PreparedScene3& prepared, const ElementTable3& table, const RadiositySolution& solution,
                        const Camera3& camera, std::span<const SeenSide3> seen, PixelValues3& pixels) {
  if (prepared.scene.lights.empty()) return;
  const SceneLights3 lights(prepared);
  const Responses3 responses = light_responses_3(solution);
  const std::vector<std::optional<std::uint32_t>> element = elements_of_sides_3(prepared, table);
  DirectView view(camera, responses, pixels);
  for (std::size_t k = 0; k < lights.lamps().size(); ++k) {
    const SceneLights3::Lamp& lamp = lights.lamps()[k];
    const Sender sender(*lamp.light, prepared.scene.light_places[k], prepared.scene.lights[k].is_sun(), camera.eye);
    std::map<std::uint32_t, std::vector<LitPart3>> lit;
    for (LitPart3& part : lamp.light->lit_parts()) lit[part.side.number()].push_back(std::move(part));
    for (const SeenSide3& side : seen) {
      const auto here = lit.find(side.side.number());
      if (here == lit.end() || !element[side.side.number()]) continue;
      const SidePlane3 plane(prepared, side.side, camera.eye);
      const std::vector<double> reflected = view.reflected(*element[side.side.number()], lamp.power);
      for (const LitPart3& part : here->second) view.add(side, part, plane, sender, reflected);
    }
  }
}

}  // namespace hottel
