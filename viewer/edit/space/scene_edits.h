// What a hand does to the polygons of a scene in space: a scene goes in, another one comes out.
//
// Of every function here:
//
//   (1) groups are numbered by their first surfaces, and none is empty: what is saved is what is seen
//   (2) what comes out may be no scene (edit_problem), as where a polygon is not plane any more: nothing is thrown for
//       that
//   (3) expectations are about the scene that went in: the one that comes out has none
//   (4) all else is as it was, file and lines too
//   (5) patches go with what they lie on: what is moved, turned, erased or copied takes those along that lie on it
//       (patches_on), each as a whole
//
// REQUIRES a valid scene. Throws ContractViolation for an index out of range. COST: linear, and a copy of the scene.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/space/scene/scene.h"

namespace hottel {

// Some corners of a scene: those that lie exactly at some points, whatever polygon they are of, and all corners of some
// surfaces.
struct Corners3 {
  std::vector<Point3> points;
  std::vector<std::uint32_t> surfaces;
};

// Moves corners, all at once: polygons that have others too stretch.
Scene3 move_corners(const Scene3& scene, const Corners3& corners, const Vector3& way);

// Moves the corners of one surface that lie there, and nothing that meets them.
Scene3 move_corner(const Scene3& scene, std::uint32_t surface, const Point3& corner, const Vector3& way);

// The normals of planes in which those corners have to stay, so that all polygons stay plane and patches stay in the
// planes of what they lie on: each way along all of them is one that move_corners may take.
std::vector<Vector3> planes_to_keep(const Scene3& scene, const Corners3& corners);

// Turns these surfaces about an axis of x, y or z (0, 1, 2) through a point, counter-clockwise as seen from its end.
//
//   (6) by multiples of 90 degrees exactly
//   (7) otherwise corners are rounded to `decimals` decimals, the same point always to the same one, where all polygons
//       stay plane; else all of them are turned exactly, by an angle off by a millionth of a degree at most whose sine
//       and cosine are fractions
Scene3 rotate_surfaces(const Scene3& scene, std::span<const std::uint32_t> surfaces, const Point3& centre, int axis,
                       const Rational& degrees, int decimals);

// Turns the fronts of these surfaces to where their backs were.
Scene3 reverse_surfaces(const Scene3& scene, std::span<const std::uint32_t> surfaces);

// Takes these surfaces out, masks on them or of them too. Materials stay.
Scene3 erase_surfaces(const Scene3& scene, std::span<const std::uint32_t> surfaces);

// A scene, and the surfaces that it has and the one before had not, ascending.
struct AddedSurfaces3 {
  Scene3 scene;
  std::vector<std::uint32_t> surfaces;
};

// Copies these surfaces to another place, as the last ones. A group that is listed as a whole comes out as one, and may
// be a solid again; any other surface is alone. They are called "NAME copy", "NAME copy 2", ... (FreeNames). A patch
// whose base is not copied lies on that base.
AddedSurfaces3 duplicate_surfaces(const Scene3& scene, std::span<const std::uint32_t> surfaces, const Vector3& way);

// Adds a box along the axes, called "box 1", ..., with fronts outward: a solid, undivided. Its faces are
// "box 1.bottom", ".top", ".front", ".rear", ".left", ".right". REQUIRES low < high in each coordinate.
AddedSurfaces3 add_box(const Scene3& scene, const Point3& low, const Point3& high, std::uint32_t material);

// Adds a rectangle between two opposite corners that have one coordinate in common, called "rectangle 1", .... Its
// front looks along that axis, or, with looks_back, against it. Where it lies within the front or the back of a polygon
// that looks the same way, it is a patch on that. REQUIRES exactly one common coordinate.
AddedSurfaces3 add_rectangle(const Scene3& scene, const Point3& corner, const Point3& opposite, bool looks_back,
                             std::uint32_t material);

// Returns why an edited scene is none, as a sentence: a polygon that is not one (polygon_problem), a light on a
// surface, a patch that leaves its base; empty where it is one (validate). before: the valid scene that was edited;
// polygons that it has too are not asked again.
std::string edit_problem(const Scene3& before, const Scene3& edited);

}  // namespace hottel
