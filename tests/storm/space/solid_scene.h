// Scenes of space on a small lattice: closed bodies, rooms and sheets that touch, overlap and pierce each other.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/space/scene/scene.h"
#include "tests/oracle/space/place_owner.h"

namespace hottel::storm {

// A group: a closed mesh with fronts outward (kSolid) or inward (kRoom), or sheets by themselves.
struct SolidBody3 {
  struct Face {
    Polygon3 polygon;
    std::uint32_t material = 0;              // of kSolidMaterials
    std::optional<std::uint32_t> back = {};  // never of a closed mesh
    friend bool operator==(const Face&, const Face&) = default;
  };
  enum class Kind { kSolid, kRoom, kSheets };
  Kind kind = Kind::kSheets;
  bool is_open = false;  // "behind": "open"
  std::vector<Face> faces;
  friend bool operator==(const SolidBody3&, const SolidBody3&) = default;
};
inline constexpr std::uint32_t kSolidMaterials = 2;

using SolidBodies3 = std::vector<SolidBody3>;

// Returns a scene by its number: any number gives the same on every platform. One to four boxes, tetrahedra, prisms
// over an L, a U or a ring, boxes turned inside out, and sheets: rectangles, triangles, Ls, and rectangles with a hole,
// with and without a material on the back. In three of four around them, or half of them, is a room {0, ..., 4}^3, two
// rooms side by side, or a building with rooms. In one of eight there are two materials, so that claims may conflict.
SolidBodies3 solid_bodies_3(std::uint64_t number);

// Surface `0a` is face a of the first body, and so on; bodies are the groups, in order.
Scene3 to_scene_3(const SolidBodies3& bodies);
// The same for the oracle: face k is surface k.
oracle::Places to_places(const SolidBodies3& bodies);

// Is each polygon one, and each closed mesh turned as its kind says?
bool is_valid_3(const SolidBodies3& bodies);

// True iff all polygons are parallel to two axes, and all coordinates are whole.
bool is_boxy_3(const SolidBodies3& bodies);

// Leaves out bodies, and faces of sheets, and materials; makes all coordinates along an axis that have one value have
// that of their neighbour; and begins anew, as long as what is left is valid and still fails.
// REQUIRES fails(bodies).
SolidBodies3 shrunk_3(SolidBodies3 bodies, const std::function<bool(const SolidBodies3&)>& fails);

}  // namespace hottel::storm
