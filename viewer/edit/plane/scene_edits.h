// What a hand does to a scene: a scene goes in, another one comes out.
//
// Of every function here:
//
//   (1) the scene that comes out is in the order of a file (in_file_order): what is saved is what is seen. Its groups
//       and the order of its surfaces are those that reading its saved text gives
//   (2) a polyline that no longer is one falls apart into edges, which keep their names and stand after all other edges
//   (3) what comes out may be invalid, as where an edge gets length zero or claims conflict: nothing is thrown for that
//   (4) expectations are about the scene that went in: the one that comes out has none
//   (5) all else is as it was, file and lines too; but a surface with a two-sided material on its front and none on its
//       back has it there too, if it is no patch
//   (10) patches go with what they lie on (carry_patches): moved, turned round, erased and copied with it. One that is
//       moved alone slides along that. They name what they lie on by its name now (rename_bases)
//
// REQUIRES: a scene that is valid but for (3); points in lowest terms. Throws ContractViolation for an index out of
// range. A surface that is listed twice is listed once. COST: linear, and a copy of the scene.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/face.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

struct PointMove2 {
  Point2 from, to;
};

// Moves every end that lies exactly at moves[k].from to moves[k].to, all at once: what met there goes on meeting, so
// that a polyline stays one. Of several moves from one point the first counts.
Scene2 move_points(const Scene2& scene, std::span<const PointMove2> moves);

// Moves one end of one surface, and nothing that meets it.
Scene2 move_end(const Scene2& scene, std::uint32_t surface, bool is_last, const Point2& to);

// Moves these surfaces, which part from all others.
Scene2 move_surfaces(const Scene2& scene, std::span<const std::uint32_t> surfaces, const Rational& dx,
                     const Rational& dy);

// Turns these surfaces counter-clockwise around a point.
//
//   (6) by multiples of 90 degrees exactly
//   (7) otherwise every end is rounded to `decimals` decimals, the same point always to the same one
Scene2 rotate_surfaces(const Scene2& scene, std::span<const std::uint32_t> surfaces, const Point2& centre,
                       const Rational& degrees, int decimals);

// Exchanges the ends of these surfaces: front and back change sides, and take their materials along.
//
//   (8) of a polyline that is listed as a whole, piece k is then where the k-th last one was: it stays a polyline
//   (9) done twice, the scene is as before, but for polylines of which a part was listed
Scene2 reverse_surfaces(const Scene2& scene, std::span<const std::uint32_t> surfaces);

// Takes these surfaces out. Materials stay. A polyline without its last pieces is one still.
Scene2 erase_surfaces(const Scene2& scene, std::span<const std::uint32_t> surfaces);

// A scene, and the surfaces that it has and the one before had not, ascending.
struct AddedSurfaces2 {
  Scene2 scene;
  std::vector<std::uint32_t> surfaces;
};

// Copies these surfaces to another place. A polyline that is listed as a whole comes out as one, any other surface as
// an edge. They are called "NAME copy", "NAME copy 2", ... (FreeNames), and say the same of what is behind their backs;
// a piece of a polyline says nothing of that.
AddedSurfaces2 duplicate_surfaces(const Scene2& scene, std::span<const std::uint32_t> surfaces, const Rational& dx,
                                  const Rational& dy);

// Adds an edge, called "edge 1", "edge 2", ..., with a black back. `material`: of its front.
AddedSurfaces2 add_edge(const Scene2& scene, const Edge2& edge, std::uint32_t material);

// Adds a polyline, called "polyline 1", "polyline 2", ..., with black backs. `closed` joins the last point to the
// first. REQUIRES: at least two points.
AddedSurfaces2 add_polyline(const Scene2& scene, std::span<const Point2> points, bool closed, std::uint32_t material);

// Adds a square with fronts outward, called "lamp 1", "lamp 2", .... Its material is the first of "lamp", "lamp 2", ...
// that emits or is not there yet; then it is made, with reflectivity 0 and emission 1. REQUIRES: half_size > 0.
AddedSurfaces2 add_lamp(const Scene2& scene, const Point2& centre, const Rational& half_size);

// Returns the material of a face, nothing for a back without one.
std::optional<std::uint32_t> material_of(const Scene2& scene, const Face& face);

// Gives a material other values, for all that have it. Its name stays.
Scene2 set_material(const Scene2& scene, std::uint32_t material, const Material& values);

// A scene, and a material that was added to it.
struct AddedMaterial2 {
  Scene2 scene;
  std::uint32_t material = 0;
};

// Copies the material of a face as "NAME copy", for the face and all that shares its group, its side and its material:
// set_material changes these alone from now on. Nothing for a back without a material.
std::optional<AddedMaterial2> copy_material(const Scene2& scene, const Face& face);

}  // namespace hottel
