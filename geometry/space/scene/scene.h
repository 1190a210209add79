// A scene in space, exactly as it was typed.
#pragma once

#include <cstddef>
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

// Where a picture of the scene is taken from: the eye looks at the target, and `up` points to the upper border.
// field_of_view is the angle from the lower to the upper border, in degrees.
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

// A surface that lies on another one, its base, and faces it, front to front, at no distance. Where they coincide, the
// two fronts see each other completely, and nothing else; others see the back of the mask there, an ordinary back. The
// base keeps its area. (A patch, Surface::on, faces as its base does and takes its place.)
struct Mask3 {
  std::uint32_t surface = 0, base = 0;  // indices into SceneTable::surfaces
  friend bool operator==(const Mask3&, const Mask3&) = default;
};

// A path along which a light moves from point to point at constant speed, once in `seconds`; then it stays at the last
// point. A closed path leads back to its first point within `seconds`, and begins anew.
struct LightPath3 {
  std::vector<Point3> points;  // two at least, not all the same
  Rational seconds = 1;        // above 0
  bool closed = false;
  friend bool operator==(const LightPath3&, const LightPath3&) = default;
};

// Where a light of a scene is, where it points, and how it moves. Light has its other properties.
struct LightPlace3 {
  Point3 position;              // of no meaning for a sun
  Vector3 direction{0, 0, -1};  // of a spot: along the axis of its beam; of a sun: of its rays; of any length, not zero
  Vector3 rotation;             // of the axis, about x, y and z, in degrees a second: first about x, last about z
  std::optional<LightPath3> path = {};  // what the position follows when time passes
  friend bool operator==(const LightPlace3&, const LightPlace3&) = default;
};

// The most cells of a grid along one of its sides.
inline constexpr std::uint32_t kMaxGridCells3 = 16384;

// Where light is asked for: nu times nv equal cells of the parallelogram from `origin` along u and along v; with w a
// volume, nu times nv times nw cells of the parallelepiped.
// Where there are several grids each has a name; one alone may have one. Names of files with results contain it: it is
// UTF-8 of 100 bytes at most, without control characters and / \ : * ? " < > |, and two differ in more than case.
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

// Returns origin + s u + t v, and + r w in a volume.
Point3 place_in(const Grid3& grid, const Rational& s, const Rational& t, const Rational& r = 0);

// Returns the centre of a cell, exactly. Cell 0 is the one at the origin; those along u follow each other, then those
// along v, then those along w.
Point3 cell_centre(const Grid3& grid, std::size_t cell);

// The scene, in the order of the file: polygons, then the faces of meshes.
//
//   (1) polygons[s] is the geometry of surfaces[s]; both lists are equally long
//   (2) every polygon is valid (polygon_problem): plane, exactly or as nearly as that function asks, of positive area
//   (3) the table is valid (SceneTable), and neither camera nor grids have a problem
//   (4) masks ascend by surface; a mask and its base have materials, and lie exactly in one plane, facing each other;
//       neither is a patch, and no base is a mask. Arrangement3 requires besides that masks lie within their bases and
//       do not overlap
//   (5) light_places[k] is the place of lights[k]; no light lies on a polygon, and directions are not zero
//   (6) a patch lies exactly on its base, the surface that it covers a part of, faces the same way, and stays within it
//       (validate_patches)
//
// Polygons may touch, overlap and pierce each other in any way. Arrangement3 says what that means.
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

// Throws InputError unless (2) to (6) hold: it names the file, and line, surface or light where one is at fault. Throws
// ContractViolation unless (1) holds, each light has one place, and masks ascend and are of surfaces that are there.
// Trees of elements are not looked at. COST: that of polygon_problem, and linear for each light.
void validate(const Scene3& scene);

// A scene that is known to be valid. Only validation makes one, and the functions that change one keep it valid. A
// Scene3 converts to it, which validates the scene. It converts back to a Scene3, which may be changed freely.
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
