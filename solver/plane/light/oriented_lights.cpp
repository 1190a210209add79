#include "solver/plane/light/oriented_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

using std::numbers::pi;

// A direction by its angle from the normal, from -pi to pi, and its sine.
struct Slant {
  double angle, sine;
};

Slant slant_of(double x, double y, const std::array<double, 2>& normal) {
  const double length = std::hypot(x, y);
  const double sine = (normal[0] * y - normal[1] * x) / length, cosine = (normal[0] * x + normal[1] * y) / length;
  return {same_bits::atan2(sine, cosine), sine};
}

// Half the integral of the cosine, where that is above 0, from the back of the area to a direction: 0 to 1.
double factor_up_to(const Slant& slant) {
  if (slant.angle <= -pi / 2) return 0;
  return slant.angle >= pi / 2 ? 1 : (1 + slant.sine) / 2;
}

// The factor of the directions from one to another, counter-clockwise; turn: the sign of their angle, + below half a
// turn.
double factor_between(const Slant& from, const Slant& to, int turn) {
  const double ahead = to.angle - from.angle;
  const bool passes_back = turn > 0 ? ahead < -pi / 2 : ahead < pi / 2;
  return std::max(0.0, factor_up_to(to) - factor_up_to(from) + (passes_back ? 1 : 0));
}

// Of length 1. The larger coordinate is 1 before, so that doubles tell it.
std::array<double, 2> unit_normal(const Point2& normal) {
  const Rational largest = std::max(Rational(abs(normal.x)), Rational(abs(normal.y)));
  HOTTEL_REQUIRE(largest > 0);
  const double x = to_double(normal.x / largest), y = to_double(normal.y / largest), length = std::hypot(x, y);
  return {x / length, y / length};
}

}  // namespace

OrientedLights2::OrientedLights2(std::shared_ptr<const PreparedScene2> prepared, Granularity granularity,
                                 const RadiositySolution& solution)
    : around_(std::move(prepared), granularity, solution),
      location_(around_.prepared().arrangement.vertices(), around_.prepared().arrangement.triangulation()) {}

OrientedLight OrientedLights2::at(const Point2& point, const Point2& normal) const {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const Vertices2& vertices = around_.prepared().arrangement.vertices();
  const Point2 place = vertices.from_scene(point);
  const Eye2 eye(vertices, place);
  View2 view;
  const Location2 location = location_.look_around(eye, view);
  OrientedLight light{std::vector(around_.sent_out().channels(), kNaN), around_.at(eye, location, view), kNaN};
  if (std::isnan(light.mean_irradiance[0])) return light;
  const std::array<double, 2> unit = unit_normal(normal);
  see(eye, view, unit, light);
  around_.lit().add_facing(eye, unit, light.irradiance);
  return light;
}

void OrientedLights2::see(const Eye2& eye, const View2& view, const std::array<double, 2>& normal,
                          OrientedLight& light) const {
  const Vertices2& vertices = around_.prepared().arrangement.vertices();
  std::ranges::fill(light.irradiance, 0.0);
  light.sky_view_factor = 0;
  const auto add = [&](PieceSideId side, double factor) {
    if (side == kSky) light.sky_view_factor += factor;
    const LightColumns2::Code code = around_.columns().of(side);
    if (code.is_black()) return;
    for (std::uint32_t c = 0; c < around_.sent_out().channels(); ++c)
      light.irradiance[c] += factor * around_.sent_out().of(code.column(), c);
  };
  const auto& seen = view.seen;
  if (seen.size() < 2) return add(seen.empty() ? kSky : seen[0].behind, 1);
  const auto slant = [&](std::size_t k) {
    const auto& p = vertices.approximate(seen[k].vertex);
    return slant_of(p.x - eye.x(), p.y - eye.y(), normal);
  };
  Slant from = slant(0);
  const Slant first = from;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const std::size_t next = k + 1 == seen.size() ? 0 : k + 1;
    const Slant to = next == 0 ? first : slant(next);
    const int turn = seen[k].behind == kSky ? eye.orientation(seen[k].vertex, seen[next].vertex) : 1;
    add(seen[k].behind, factor_between(from, to, turn));
    from = to;
  }
}

std::vector<OrientedLight> lights_around_cells(const PreparedScene2& prepared, const IlluminationGrid2& light,
                                               const std::function<void(double)>& progress) {
  const ElementTable2& table = *prepared.elements(Granularity::kFace);
  const std::vector<double> dark(table.count(), 0.0), bright{1.0};  // faces, and the sky
  const IlluminationGrid2 sky = illuminate_points(prepared, light.grid, table, SentOut2(table, dark, bright), progress);
  std::vector<OrientedLight> result;
  for (std::uint32_t iy = 0; iy < light.grid.ny; ++iy)
    for (std::uint32_t ix = 0; ix < light.grid.nx; ++ix) {
      OrientedLight cell;
      for (std::uint32_t c = 0; c < light.channels; ++c) cell.mean_irradiance.push_back(light.at(ix, iy, c));
      cell.irradiance = cell.mean_irradiance;
      cell.sky_view_factor = sky.at(ix, iy);
      result.push_back(std::move(cell));
    }
  return result;
}

}  // namespace hottel
