#include "solver/plane/methods/element_geometry.h"

#include <algorithm>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/exact_double.h"
#include "kernel/int128.h"

namespace hottel {
namespace {

constexpr double kShortest = 0x1p-500;

// value * 2^-exponent as a sum of two doubles.
void split(const Rational& value, int exponent, double& high, double& low) {
  const Rational local = scaled_by_power_of_two(value, -exponent);
  high = to_double(local);
  low = to_double(local - exact_value(high));
}

std::vector<LocalPoint2> places_of(const Vertices2& vertices) {
  const int exponent = vertices.exponent();
  const bool doubles_are_exact = vertices.approximation_error() == 0;
  std::vector<LocalPoint2> places(vertices.size());
  for (const VertexId v : vertices.ids()) {
    LocalPoint2& place = places[v.index()];
    if (doubles_are_exact) {
      place.x = std::ldexp(vertices.approximate(v).x, -exponent);
      place.y = std::ldexp(vertices.approximate(v).y, -exponent);
    } else {
      const Point2 exact = vertices.exact(v);
      split(exact.x, exponent, place.x, place.x_low);
      split(exact.y, exponent, place.y, place.y_low);
    }
  }
  return places;
}

// The exact difference b - a, rounded.
LocalVector2 span_of(const Vertices2& vertices, const std::vector<LocalPoint2>& places, const Segment2& ends) {
  if (vertices.approximation_error() == 0) return places[ends.b.index()] - places[ends.a.index()];
  const Point2 a = vertices.exact(ends.a), b = vertices.exact(ends.b);
  const int exponent = vertices.exponent();
  return {to_double(scaled_by_power_of_two(b.x - a.x, -exponent)),
          to_double(scaled_by_power_of_two(b.y - a.y, -exponent))};
}

double diagonal_of(const std::vector<LocalPoint2>& places) {
  double x0 = 0, x1 = 0, y0 = 0, y1 = 0;  // the first vertex
  for (const LocalPoint2& place : places) {
    x0 = std::min(x0, place.x);
    x1 = std::max(x1, place.x);
    y0 = std::min(y0, place.y);
    y1 = std::max(y1, place.y);
  }
  return std::hypot(x1 - x0, y1 - y0);
}

// place + step, for a step that is not longer than the unit.
LocalPoint2 moved(const LocalPoint2& place, double step_x, double step_y) {
  LocalPoint2 result;
  two_sum(place.x, step_x, result.x, result.x_low);
  two_sum(place.y, step_y, result.y, result.y_low);
  result.x_low += place.x_low;
  result.y_low += place.y_low;
  return result;
}

}  // namespace

LocalPoint2 ElementRun2::at(double t) const {
  // From the nearer end: both ends are met exactly.
  if (t <= 0.5) return moved(from, t * length * direction.x, t * length * direction.y);
  return moved(to, (t - 1) * length * direction.x, (t - 1) * length * direction.y);
}

ElementGeometry2::ElementGeometry2(const PreparedScene2& prepared) : table_(prepared.elements(Granularity::kElement)) {
  const Vertices2& vertices = prepared.arrangement.vertices();
  unit_ = scaled_by_power_of_two(vertices.scale(), vertices.exponent());
  place_ = places_of(vertices);
  diagonal_ = diagonal_of(place_);
  begin_.push_back(0);
  for (std::uint32_t element = 0; element < count(); ++element) {
    for (const Segment2& ends : table_->runs(element)) add_run(vertices, ends);
    double total = 0;
    for (std::size_t k = begin_.back(); k < runs_.size(); ++k) total += runs_[k].length;
    for (std::size_t k = begin_.back(); k < runs_.size(); ++k) runs_[k].share = runs_[k].length / total;
    length_.push_back(total);
    begin_.push_back(runs_.size());
  }
}

void ElementGeometry2::add_run(const Vertices2& vertices, const Segment2& ends) {
  const LocalVector2 span = span_of(vertices, place_, ends);
  ElementRun2 run;
  run.length = std::hypot(span.x, span.y);
  if (!(run.length >= kShortest)) return;
  run.ends = ends;
  run.from = place_[ends.a.index()];
  run.to = place_[ends.b.index()];
  run.direction = {span.x / run.length, span.y / run.length};
  run.centre = run.at(0.5);
  runs_.push_back(run);
}

}  // namespace hottel
