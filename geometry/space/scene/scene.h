// A scene in space, exactly as it was typed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/scene_table.h"
#include "geometry/space/point.h"
#include "geometry/space/scene/polygon.h"

namespace hottel {

// The most pixels of a picture along one side.
inline constexpr std::uint32_t kMaxPixels = 16384;

// Where a picture of the scene is taken from: the eye looks at the target, and `up` points to the upper border. What
// is seen from the lower to the upper border is an angle of field_of_view degrees.
struct Camera3 {
  Point3 eye, target;
  Vector3 up{0, 0, 1};
  Rational field_of_view = 40;
  std::uint32_t width = 800, height = 600;
  friend bool operator==(const Camera3&, const Camera3&) = default;
};

// Returns what is wrong with a camera, as the end of a sentence ("eye and target are one point"); empty when nothing
// is: `up` is not parallel to the direction of view, 0 < field_of_view < 180, and pixels from 1 to kMaxPixels.
std::string camera_problem(const Camera3& camera);

// A surface whose front lies on the front of another one, its base, at no distance. Where it lies these two see each
// other, all of them, and nothing else. Its back is as any other.
struct Mask3 {
  std::uint32_t surface = 0, base = 0;  // indices into SceneTable::surfaces
  friend bool operator==(const Mask3&, const Mask3&) = default;
};

// A way through points at constant speed, once in so many seconds; a closed one leads back to its first point, and is
// walked over and over.
struct LightPath3 {
  std::vector<Point3> points;  // two at least, not all the same
  Rational seconds = 1;        // above 0
  bool closed = false;
  friend bool operator==(const LightPath3&, const LightPath3&) = default;
};

// One light of a scene: what Light leaves open.
struct LightPlace3 {
  Point3 position;              // of no meaning for a sun
  Vector3 direction{0, 0, -1};  // of a spot: along the axis of its beam; of a sun: of its rays; of any length, not zero
  Vector3 rotation;             // of the axis: Rz Ry Rx, each angle in degrees a second
  std::optional<LightPath3> path = {};  // what the position follows when time passes
  friend bool operator==(const LightPlace3&, const LightPlace3&) = default;
};

// The most cells of a grid along one of its sides.
inline constexpr std::uint32_t kMaxGridCells3 = 16384;

// Where light is asked for: nu times nv equal cells of the parallelogram from `origin` along u and along v; with w a
// volume, nu times nv times nw cells of the parallelepiped. Of several grids each has a name, which is part of the
// names of its files.
struct Grid3 {
  Point3 origin;
  Vector3 u, v;
  std::uint32_t nu = 1, nv = 1;
  std::string name{};
  std::optional<Vector3> w{};
  std::uint32_t nw = 1;  // 1 without w

  bool is_volume() const { return w.has_value(); }
  std::uint64_t cells() const { return std::uint64_t{nu} * nv * nw; }
  friend bool operator==(const Grid3&, const Grid3&) = default;
};

// Returns what is wrong with a grid, as the end of a sentence ("u and v are parallel, or one is zero"); empty when
// nothing is: u and v span a plane, w leaves it, and there are 1 to kMaxGridCells3 cells along each.
std::string grid_problem(const Grid3& grid);

// Returns the place s along u, t along v and, of a volume, r along w: the origin at 0, 0, 0.
Point3 place_in(const Grid3& grid, const Rational& s, const Rational& t, const Rational& r = 0);

// The scene, in the order of the file: polygons, then the faces of meshes.
//
//   (1) polygons[s] is where surfaces[s] of the table lies: as many of one as of the other
//   (2) every polygon is one (polygon_problem): exactly plane, or nearly so, of positive area
//   (3) the table is valid (SceneTable), and neither camera nor grids have a problem
//   (4) masks ascend by surface; a mask and its base have materials, and lie in one plane, facing each other; a base is
//       no mask, and neither is a patch. That masks lie within their bases, and beside each other, is required by
//       Arrangement3
//   (5) light_places[k] is where lights[k] of the table is; no light lies on a polygon, and directions are not zero
//   (6) patches lie on their bases exactly, look as these do there, and leave them nowhere (validate_patches)
//
// Polygons may touch, overlap and pierce each other anyhow: what that means is told by Arrangement3.
struct Scene3 : SceneTable {
  std::vector<Polygon3> polygons;
  std::vector<Mask3> masks;
  std::vector<LightPlace3> light_places;
  std::optional<Camera3> camera;
  std::vector<Grid3> grids;  // one alone may be without a name; else names differ

  // Puts a surface after all others.
  void add(Surface surface, Polygon3 polygon) {
    surfaces.push_back(std::move(surface));
    polygons.push_back(std::move(polygon));
  }
  // Puts a light after all others.
  void add_light(Light light, LightPlace3 place) {
    lights.push_back(std::move(light));
    light_places.push_back(std::move(place));
  }
};

// Throws InputError naming file, line and surface or light unless (2) to (6) hold; ContractViolation unless (1) does
// and there are as many places as lights. COST: that of polygon_problem, and linear for each light.
void validate(const Scene3& scene);

// A scene that is known to be valid: validation alone makes one, and what can be changed of it leaves it so. A Scene3
// becomes one where it is asked for. It becomes a Scene3 again, which may be changed at will, where that is asked for.
//
//   (1) validate() holds for it
class ValidScene3 {
 public:
  ValidScene3() = default;  // without surfaces
  // Throws as validate() does. COST: that of validate().
  ValidScene3(Scene3 scene) : scene_(std::move(scene)) { validate(scene_); }

  const Scene3& operator*() const { return scene_; }
  const Scene3* operator->() const { return &scene_; }
  operator Scene3() const& { return scene_; }
  operator Scene3() && { return std::move(scene_); }
  operator SceneTable() const& = delete;  // that would be the scene without its shape
  operator SceneTable() && = delete;

  // Puts these grids in place of its own. Throws InputError naming the file unless they are valid.
  void set_grids(std::vector<Grid3> grids);

 private:
  friend void divide_into(ValidScene3& scene, std::uint32_t n);
  friend std::optional<std::uint32_t> divide_by_length(ValidScene3& scene, const Rational& h, std::uint32_t most);

  Scene3 scene_;
};

}  // namespace hottel
