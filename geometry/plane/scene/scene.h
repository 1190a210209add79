// A scene in the plane, exactly as it was typed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/plane/point.h"
#include "geometry/scene_table.h"

namespace hottel {

// A straight edge. Its front is the right side of from -> to.
struct Edge2 {
  Point2 from, to;
  friend bool operator==(const Edge2&, const Edge2&) = default;
};

// A path along which a light moves from point to point at constant speed, once in `seconds`; then it stays at the last
// point. A closed path leads back to its first point within `seconds`, and begins anew.
struct LightPath2 {
  std::vector<Point2> points;  // two at least, not all the same
  Rational seconds = 1;        // above 0
  bool closed = false;
  friend bool operator==(const LightPath2&, const LightPath2&) = default;
};

// Where a light of a scene is, where it points, and how it moves. Light has its other properties.
struct LightPlace2 {
  Point2 position;  // of no meaning for a sun
  // Turned by `turned` degrees counter-clockwise it is the axis of a spot's beam, or the way of a sun's rays, at time
  // 0. Of any length, not zero.
  Point2 direction{1, 0};
  Rational turned = 0;
  Rational rotation = 0;                // how fast that turns, in degrees a second, counter-clockwise
  std::optional<LightPath2> path = {};  // what the position follows when time passes
  friend bool operator==(const LightPlace2&, const LightPlace2&) = default;
};

// The most cells of a grid along one axis.
inline constexpr std::uint32_t kMaxGridCells = 16384;

// A grid of nx times ny equal cells over the region from min to max, in scene coordinates: where light is asked for.
// Where there are several grids each has a name; one alone may have one. Names of files with results contain it: it is
// UTF-8 of 100 bytes at most, without control characters and / \ : * ? " < > |, and two differ in more than case.
struct Grid2 {
  Point2 min, max;
  std::uint32_t nx = 0, ny = 0;
  std::string name{};

  std::uint64_t cells() const { return std::uint64_t{nx} * ny; }
  friend bool operator==(const Grid2&, const Grid2&) = default;
};

// Returns what is wrong with a grid, as the end of a sentence ("max must be greater than min in both coordinates");
// empty when nothing is: max > min, and cells from 1 to kMaxGridCells.
std::string grid_problem(const Grid2& grid);

// The scene, in the order of the file: edges, then the pieces of polylines.
//
//   (1) edges[s] is the geometry of surfaces[s]; both lists are equally long
//   (2) from != to for every edge; coordinates are in lowest terms
//   (3) the table is valid (SceneTable)
//   (4) light_places[k] is the place of lights[k]; no light lies on an edge, and directions are not zero
//   (5) a patch lies exactly on its base, the surface that it covers a part of, faces the same way, and stays within it
//       (validate_patches)
struct Scene2 : SceneTable {
  std::vector<Edge2> edges;
  std::vector<LightPlace2> light_places;
  std::vector<Grid2> grids;  // one alone may be without a name; else names differ

  // Puts a surface after all others.
  void add(Surface surface, Edge2 edge) {
    surfaces.push_back(std::move(surface));
    edges.push_back(std::move(edge));
  }
  // Puts a light after all others.
  void add_light(Light light, LightPlace2 place) {
    lights.push_back(std::move(light));
    light_places.push_back(std::move(place));
  }
  // Keeps these surfaces, in this order, and no others. Materials and groups stay, used or not. REQUIRES:
  // indices of surfaces.
  void keep(const std::vector<std::uint32_t>& which);
};

// Throws InputError naming file, line and surface or light unless (2) to (5) hold and the grids are valid
// (validate_grids). Throws ContractViolation unless (1) holds, each light has one place, and the trees of elements are
// whole (are_whole). COST: linear in the scene, and that again for each light.
void validate(const Scene2& scene);

// A scene that is known to be valid. Only validation makes one, and the functions that change one keep it valid. A
// Scene2 converts to it, which validates the scene. It converts back to a Scene2, which may be changed freely.
//
//   (1) validate() holds for it
class ValidScene2 {
 public:
  ValidScene2() = default;  // without surfaces
  // Throws as validate() does. COST: that of validate().
  ValidScene2(Scene2 scene) : scene_(std::move(scene)) { validate(scene_); }

  const Scene2& operator*() const { return scene_; }
  const Scene2* operator->() const { return &scene_; }
  operator Scene2() const& { return scene_; }
  operator Scene2() && { return std::move(scene_); }
  operator SceneTable() const& = delete;  // that would be the scene without its shape
  operator SceneTable() && = delete;

  // Puts these grids in place of its own. Throws InputError naming the file unless they are valid.
  void set_grids(std::vector<Grid2> grids);

 private:
  friend void divide_into(ValidScene2& scene, std::uint32_t n);
  friend std::optional<std::uint32_t> divide_by_length(ValidScene2& scene, const Rational& h, std::uint32_t most);

  Scene2 scene_;
};

// The point at t of the way from the first to the second point of an edge, exactly; t = 0 and t = 1 are its ends.
Point2 point_at(const Edge2& edge, const Rational& t);

// True iff the scene is one closed convex polygon, fronts inside, and no back has a material: nothing hides anything.
//
//   (1) its edges follow each other in the order of the scene, clockwise; two that follow each other may lie
//       on one line
//   (2) false for fewer than three edges, and where all lie on one line
//
// Exact. COST: linear.
bool is_convex_room(const Scene2& scene);

}  // namespace hottel
