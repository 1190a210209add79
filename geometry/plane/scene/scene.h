// A scene in the plane, exactly as it was typed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/material.h"
#include "kernel/rational.h"
#include "kernel/support/failure.h"

namespace hottel {

struct Point2 {
  Rational x, y;
  friend bool operator==(const Point2&, const Point2&) = default;
};

// One straight edge of the input: an entry of "edges", or one piece of a polyline. Its front is the right side of
// from -> to. A back without a material is opaque and black and makes no claim on an overlap.
struct Surface2 {
  std::string name;
  Point2 from, to;
  std::uint32_t material = 0;         // of the front; index into Scene2::materials
  std::optional<std::uint32_t> back;  // of the back
  std::uint32_t elements = 1;         // equal parts the edge is divided into
  std::uint32_t group = 0;            // index into Scene2::groups
  int line = 0;                       // where it stands in the file, 0 if nowhere
};

// What is behind the backs of a group.
enum class Behind : unsigned char {
  kByOutline,  // nothing is said: a solid where the group is a closed outline with its fronts outward
  kSolid,      // the bounded regions that its black backs look into are solid
  kOpen,       // the group makes nothing solid
};

// An edge of its own, or a polyline.
struct Group2 {
  std::string name;
  Behind behind = Behind::kByOutline;

  Group2(std::string n, Behind b = Behind::kByOutline) : name(std::move(n)), behind(b) {}
  Group2(const char* n) : name(n) {}
  friend bool operator==(const Group2&, const Group2&) = default;
};

struct Grid2 {
  Point2 min, max;
  std::uint32_t nx = 0, ny = 0;
};

// An expectation that a scene file carries about itself: what a stranger can check, and why it holds.
struct Expectation {
  std::string name;             // of the reference value, e.g. "strip_parallel_h1"; may be empty
  std::string kind;             // "exact", "rounded", "limit", "point", ...
  std::string quantity;         // "factor", "radiosity", ...
  std::vector<std::string> of;  // names the quantity is about, e.g. {from, to}
  std::string at;               // of a point quantity: t in [0,1] from the first to the second point of of[0]
  std::string value;            // p/q or decimal where exact, otherwise at least 21 significant digits
  std::string form;             // closed form for people, e.g. "-1 + 1*sqrt(2)"
  std::string derivation;
  int line = 0;
};

// The scene, in the order of the file: edges, then polylines.
//
//   (1) names are not empty, unique after expansion, none is "sky"; see docs/scene_format.md
//   (2) from != to for every surface
//   (3) every material and group index is valid
struct Scene2 {
  std::string file;  // for messages; may be a description when the scene was not read from a file
  std::string about;
  std::vector<Material> materials;
  std::vector<Surface2> surfaces;
  std::vector<Group2> groups;
  Spectrum sky_emission;
  bool closed = false;
  std::optional<Grid2> grid;
  std::vector<Expectation> expect;

  // Returns the index of the surface of that name, or nothing.
  std::optional<std::uint32_t> find(const std::string& name) const;
};

// Throws InputError naming file, line and surface unless the numbered properties hold.
void validate(const Scene2& scene);

// True iff the scene is one closed convex polygon, fronts inside, and no back has a material: nothing hides anything.
bool is_convex_room(const Scene2& scene);

}  // namespace hottel
