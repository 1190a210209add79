#include "viewer/picture/space/camera_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/space/exchange/element_table.h"
#include "geometry/space/exchange/prepared_scene.h"
#include "geometry/space/visibility/point_map.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "geometry/space/visibility/convex_cut.h"

namespace hottel {
namespace {

using Polygon = std::vector<Pixel>;

Direction3 rounded_way(const Point3& from, const Point3& to) {
  const Vector3 way = to - from;
  return {to_double(way.x), to_double(way.y), to_double(way.z)};
}

Pixel on_the_way(const Pixel& a, const Pixel& b, double t) { return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; }

template <class Height>
Polygon cut(const Polygon& polygon, const Height& height) {
  return cut_convex(polygon, height, on_the_way);
}

// Twice the area, negative where it goes around clockwise.
double doubled_area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const Pixel &o = polygon[0], &a = polygon[k - 1], &b = polygon[k];
    sum += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  }
  return sum;
}

// The part of a convex polygon inside another one, whichever way that goes around.
Polygon common(Polygon polygon, const Polygon& other) {
  const double sign = doubled_area(other) < 0 ? -1 : 1;
  for (std::size_t k = 0; k < other.size() && polygon.size() > 2; ++k) {
    const Pixel &a = other[k], &b = other[k + 1 == other.size() ? 0 : k + 1];
    polygon =
        cut(polygon, [&](const Pixel& p) { return sign * ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)); });
  }
  return polygon;
}

// How a camera maps directions to its picture.
class Projection {
 public:
  explicit Projection(const Camera3& camera) : width_(camera.width), height_(camera.height) {
    forward_ = unit(rounded_way(camera.eye, camera.target));
    const Direction3 up{to_double(camera.up.x), to_double(camera.up.y), to_double(camera.up.z)};
    right_ = unit(cross(forward_, up));
    up_ = cross(right_, forward_);
    half_height_ = std::tan(to_double(camera.field_of_view) * (std::numbers::pi / 360));
    half_width_ = half_height_ * width_ / height_;
  }

  // The picture of a convex cone, as far as it is in the picture; nothing where none is.
  Polygon picture(std::vector<Direction3> corners) const {
    const std::array<Direction3, 5> inside{forward_, half_width_ * forward_ + right_, half_width_ * forward_ - right_,
                                           half_height_ * forward_ + up_, half_height_ * forward_ - up_};
    for (const Direction3& normal : inside) {
      corners = cut_convex(
          corners, [&](const Direction3& d) { return dot(d, normal); },
          [](const Direction3& a, const Direction3& b, double t) { return a + t * (b - a); });
      if (corners.size() < 3) return {};
    }
    Polygon result;
    for (const Direction3& d : corners) {
      const double out = dot(d, forward_);
      if (!(out > 0)) return {};  // seen from the side
      result.push_back({(dot(d, right_) / out / half_width_ + 1) * width_ / 2,
                        (1 - dot(d, up_) / out / half_height_) * height_ / 2});
    }
    return result;
  }

 private:
  double width_, height_, half_width_ = 1, half_height_ = 1;
  Direction3 forward_, right_, up_;
};

// What a part of a side of a piece shows.
struct ShownPart {
  std::vector<double> radiosity;  // by channel; and 0
  Polygon outline;                // in the picture
  bool is_all = false;            // of that side: then there is no outline
};

// What the sides of pieces show to a camera.
class Light {
 public:
  Light(const PreparedScene3& prepared, const ElementTable3& table, const RadiositySolution& solution,
        const Point3& eye, const Projection& projection)
      : vertices_(prepared.blockers().vertices()),
        table_(table),
        solution_(solution),
        eye_(eye),
        projection_(projection),
        parts_(2 * prepared.blockers().size()) {
    for (const ElementTable3::Part& part : table.parts())
      if (!part.patch.is_sky() && table.has_row(part.label))
        parts_[Face{part.patch.surface, part.is_back}.number()].push_back(&part);
  }

  // COST: that of the parts where another face was asked for before; else nothing.
  const std::vector<ShownPart>& of(const Face& face) {
    if (face == shown_face_) return shown_;
    shown_face_ = face;
    shown_.clear();
    for (const ElementTable3::Part* part : parts_[face.number()]) {
      ShownPart shown;
      shown.is_all = parts_[face.number()].size() == 1 && table_.is_one_patch(part->label) &&
                     table_.elements()[part->label].parts == 1;
      if (!shown.is_all) shown.outline = picture_of(*part);
      if (!shown.is_all && shown.outline.size() < 3) continue;
      for (const ChannelSolution& channel : solution_.channels)
        shown.radiosity.push_back(channel.elements[part->label].radiosity);
      shown.radiosity.push_back(0);
      shown_.push_back(std::move(shown));
    }
    return shown_;
  }

 private:
  Polygon picture_of(const ElementTable3::Part& part) const {
    std::vector<Direction3> outline;
    for (const Point3& p : corners_of(vertices_, part.patch)) outline.push_back(rounded_way(eye_, p));
    return projection_.picture(std::move(outline));
  }

  const Vertices3& vertices_;
  const ElementTable3& table_;
  const RadiositySolution& solution_;
  const Point3& eye_;
  const Projection& projection_;
  std::vector<std::vector<const ElementTable3::Part*>> parts_;  // by side of a piece
  std::optional<Face> shown_face_;
  std::vector<ShownPart> shown_;
};

// The part of a row of pixels within a convex polygon; from where to where pixels are covered wholly.
struct Strip {
  Polygon polygon;
  double left = std::numeric_limits<double>::infinity(), right = -left;
  double full_left = -left, full_right = left;

  Strip(const Polygon& whole, double top) {
    polygon = cut(cut(whole, [&](const Pixel& p) { return p.y - top; }), [&](const Pixel& p) { return top + 1 - p.y; });
    if (polygon.size() < 3) return;
    double at_top[2] = {left, right}, at_bottom[2] = {left, right};
    for (const Pixel& p : polygon) {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
      const auto note = [&](double(&span)[2]) {
        span[0] = std::min(span[0], p.x);
        span[1] = std::max(span[1], p.x);
      };
      if (p.y <= top) note(at_top);
      if (p.y >= top + 1) note(at_bottom);
    }
    full_left = std::max(at_top[0], at_bottom[0]);
    full_right = std::min(at_top[1], at_bottom[1]);
  }
};

}  // namespace

void add_polygon(std::span<const Pixel> corners, std::span<const double> value, PixelValues3& pixels) {
  const Polygon polygon(corners.begin(), corners.end());
  const auto [low, high] =
      std::minmax_element(polygon.begin(), polygon.end(), [](const Pixel& a, const Pixel& b) { return a.y < b.y; });
  const auto clamped = [](double place, std::uint32_t most) {
    return static_cast<std::uint32_t>(std::clamp(std::floor(place), 0.0, static_cast<double>(most)));
  };
  for (std::uint32_t y = clamped(low->y, pixels.height); y < pixels.height && y < high->y; ++y) {
    const Strip strip(polygon, y);
    if (strip.polygon.size() < 3) continue;
    for (std::uint32_t x = clamped(strip.left, pixels.width); x < pixels.width && x < strip.right; ++x) {
      double covered = 1;
      if (!(x >= strip.full_left && x + 1.0 <= strip.full_right))
        covered = std::fabs(doubled_area(cut(cut(strip.polygon, [&](const Pixel& p) { return p.x - x; }),
                                             [&](const Pixel& p) { return x + 1.0 - p.x; }))) /
                  2;
      double* pixel = pixels.values.data() + (std::size_t{y} * pixels.width + x) * pixels.channels;
      for (std::size_t c = 0; c < pixels.channels; ++c) pixel[c] += covered * value[c];
    }
  }
}

PixelValues3 camera_view_3(const PreparedScene3& prepared, Granularity granularity, const RadiositySolution& solution,
                           const Camera3& camera) {
  if (const auto mesh = prepared.arrangement().solids().around(camera.eye))
    throw RequestError("the camera's eye is in the solid '" +
                       prepared.scene.groups[prepared.arrangement().solids().meshes()[*mesh].group].name + "'");
  const Vector3 forward = camera.target - camera.eye;
  const PointMap3 map =
      map_from(prepared.blockers(), {.eye = camera.eye, .normal = Point3{forward.x, forward.y, forward.z}});
  const ElementTable3 table(prepared.scene, prepared.arrangement(), prepared.blockers(), granularity);
  const Projection projection(camera);
  Light light(prepared, table, solution, camera.eye, projection);
  const std::size_t channels = solution.channels.size();

  // The last channel is what is covered; what is not is the sky.
  PixelValues3 pixels{camera.width, camera.height, channels + 1, {}};
  pixels.values.assign(std::size_t{camera.width} * camera.height * (channels + 1), 0);
  std::vector<double> covered(channels + 1, 0);
  covered.back() = 1;
  for (const PointMap3::Fragment& fragment : map.fragments) {  // those of a face follow each other
    throw_if_interrupted();
    std::vector<Direction3> corners;
    for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) corners.push_back(map.corners[c].direction);
    const Polygon seen = projection.picture(std::move(corners));
    if (seen.size() < 3) continue;
    add_polygon(seen, covered, pixels);
    for (const ShownPart& part : light.of(fragment.face)) {
      const Polygon polygon = part.is_all ? seen : common(seen, part.outline);
      if (polygon.size() > 2) add_polygon(polygon, part.radiosity, pixels);
    }
  }

  PixelValues3 result{camera.width, camera.height, channels, {}};
  result.values.reserve(pixels.values.size());
  for (std::size_t k = 0; k < pixels.values.size(); k += channels + 1) {
    const double sky = std::max(0.0, 1 - pixels.values[k + channels]);
    for (std::size_t c = 0; c < channels; ++c)
      result.values.push_back(pixels.values[k + c] + sky * to_double(prepared.scene.sky_emission.value[c]));
  }
  return result;
}

Camera3 default_camera_3(const PreparedScene3& prepared) {
  Camera3 camera;
  if (prepared.scene.polygons.empty()) {
    camera.target = {0, 1, 0};
    return camera;
  }
  Point3 low = prepared.scene.polygons[0].points[0], high = low;
  for (const Polygon3& polygon : prepared.scene.polygons)
    for (const Point3& p : polygon.points)
      for (Rational Point3::*axis : {&Point3::x, &Point3::y, &Point3::z}) {
        low.*axis = std::min(low.*axis, p.*axis);
        high.*axis = std::max(high.*axis, p.*axis);
      }
  const auto between = [&](const Rational& x, const Rational& y, const Rational& z) {
    return Point3{low.x + x * (high.x - low.x), low.y + y * (high.y - low.y), low.z + z * (high.z - low.z)};
  };
  const Rational half(1, 2);
  const Solids3& solids = prepared.arrangement().solids();
  const Point3 middle = between(half, half, half);
  if (!solids.around(middle) && map_from(prepared.blockers(), {.eye = middle, .normal = {}}).sky_fraction < 0.5) {
    camera.field_of_view = 75;
    camera.target = between(half, half, Rational(2, 5));
    for (const Rational& y : {Rational(1, 33), Rational(1, 9), Rational(1, 5), Rational(1, 3)}) {
      camera.eye = between(Rational(4, 9), y, Rational(3, 5));
      if (!solids.around(camera.eye)) break;
    }
    return camera;
  }
  Rational size;
  for (const Rational& side : {Rational(high.x - low.x), Rational(high.y - low.y), Rational(high.z - low.z)})
    size = std::max(size, side);
  camera.target = middle;
  camera.eye = {middle.x - size * Rational(4, 5), middle.y - size * Rational(3, 2), middle.z + size * Rational(6, 5)};
  return camera;
}

}  // namespace hottel
