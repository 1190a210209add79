// What the generators draw on: a fixed-point space. Internal to geometry/space/generate.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/generate/chance.h"
#include "geometry/generate/paint.h"
#include "geometry/space/generate/generator_request.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// A point, or a way, in fixed point.
struct Dot3 {
  std::int64_t x = 0, y = 0, z = 0;
  friend bool operator==(const Dot3&, const Dot3&) = default;
};

inline Dot3 operator+(const Dot3& a, const Dot3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Dot3 operator-(const Dot3& a, const Dot3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Dot3 operator*(std::int64_t s, const Dot3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline std::int64_t dot(const Dot3& a, const Dot3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Dot3 cross(const Dot3& a, const Dot3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// A box: a corner, and the three sides from there, perpendicular to each other.
//
// REQUIRES: u, v, w are right-handed: det(u, v, w) > 0.
struct Block3 {
  Dot3 corner, u, v, w;
};

// The box with sides along the axes. REQUIRES: low < high in all coordinates.
Block3 upright_block(const Dot3& low, const Dot3& high);

// The faces of a box: bottom (where w is 0), top, then where u is 0, where u is 1, where v is 0, where v is 1.
using Faces3 = std::array<std::array<Dot3, 4>, 6>;
// REQUIRES: u, v, w as Block3 says. The fronts are outward.
Faces3 faces_of(const Block3& block);

// The plane that holds a, b and c: equal for equal planes. REQUIRES: not all on one line, coordinates below 2^20
// in absolute value, differences below 2^13.
std::array<std::int64_t, 4> plane_of(const Dot3& a, const Dot3& b, const Dot3& c);

// A scene in the making. Generators think in units of 10^-decimals m.
class GeneratorCanvas3 {
 public:
  GeneratorCanvas3(const GeneratorRequest3& request, int decimals);

  // From now on each quad is drawn as two triangles.
  void draw_triangles() { draws_triangles_ = true; }

  // From now on each polygon is divided into elements x elements.
  void divide(std::uint32_t elements) { elements_ = elements; }

  // A group; polygons belong to the last one. Their names are name[0], name[1], ...
  void begin(std::string name);
  void add(const std::vector<Dot3>& points, Paint paint);

  // A group: the box, fronts outward.
  void add_block(std::string name, const Block3& block, Paint paint);
  // The same for a box that stands on something: it has no bottom where the request says so.
  void add_standing(std::string name, const Block3& block, Paint paint);
  // A group: the box with its fronts inward, each face with its own paint, in the order of faces_of.
  void add_inward(std::string name, const Block3& block, const std::array<Paint, 6>& paints);
  // A group "room": white walls from the origin to the opposite corner, one side red, the other blue; the ceiling is
  // the lamp.
  void add_room(const Dot3& size);

  // The picture is taken from eye to target, 60 degrees from the lower to the upper border.
  void look(const Dot3& eye, const Dot3& target);

  // Returns the scene, without the materials that nothing uses. REQUIRES: called once, after all the rest.
  Scene3 finish(bool closed);
  // The same under an open sky that emits.
  Scene3 finish_under_sky(const Spectrum& emission);

 private:
  Point3 point(const Dot3& dot) const;
  void add_faces(const Block3& block, Paint paint, std::size_t first);
  void add_quad(const std::array<Point3, 4>& corners, Paint paint);
  void add_polygon(Polygon3 polygon, Paint paint);

  bool has_bottoms_, draws_triangles_ = false;
  std::uint32_t elements_ = 1;
  Integer denominator_;
  std::size_t count_in_group_ = 0;
  Scene3 scene_;
};

}  // namespace hottel
