#include "solver/plane/light/point_lights.h"

#include <span>
#include <utility>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"

namespace hottel {
namespace {

// Writes the mean irradiance at the eye by channel: the row of the point times what is sent out.
// REQUIRES: location and view are those of the eye; columns and what is sent out are of one table.
void mean_irradiance(const Vertices2& vertices, const LightColumns2& columns, const SentOut2& sent_out, const Eye2& eye,
                     const Location2& location, const View2& view, std::span<double> result) {
  LightRowFinder2 finder;
  finder.begin(vertices, columns, Blacks2::kLeftOut);
  finder.add(eye, location, view);
  finder.measure();
  sent_out.light(finder.row(0), result);
}

}  // namespace

PointLights2::PointLights2(std::shared_ptr<const PreparedScene2> prepared, Granularity granularity,
                           const RadiositySolution& solution)
    : PointLights2(prepared, *prepared->elements(granularity), solution) {}

PointLights2::PointLights2(std::shared_ptr<const PreparedScene2> prepared, const ElementTable2& table,
                           const RadiositySolution& solution)
    : prepared_(std::move(prepared)),
      channel_names_(solution.channel_names),
      columns_(prepared_->arrangement, table),
      sent_out_(sent_out_2(table, solution, prepared_->scene)),
      lit_(std::make_shared<const LitRegions2>(*prepared_)) {}

std::vector<double> PointLights2::at(const Eye2& eye, const Location2& location, const View2& view) const {
  std::vector<double> result(sent_out_.channels());
  mean_irradiance(prepared_->arrangement.vertices(), columns_, sent_out_, eye, location, view, result);
  lit_->add(eye, result);
  return result;
}

std::vector<double> PointLights2::at(const PointLocation2& location, const Point2& point) const {
  const Vertices2& vertices = prepared_->arrangement.vertices();
  const Eye2 eye(vertices, vertices.from_scene(point));
  View2 view;
  const Location2 place = location.look_around(eye, view);
  return at(eye, place, view);
}

}  // namespace hottel
