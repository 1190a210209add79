// The pieces of a scene as Embree holds them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "geometry/space/arrangement/occluders.h"
#include "solver/space/methods/element_geometry.h"

namespace hottel {

// What a ray meets first.
struct RayHit3 {
  std::uint32_t piece;
  double distance;  // in the doubles of Vertices3
};

// The pieces of a scene, cut into triangles in single precision. For several threads at once.
class EmbreeScene3 {
 public:
  // Throws RequestError where Embree has no memory, or cannot run on this processor.
  explicit EmbreeScene3(const Occluders3& occluders);
  ~EmbreeScene3();

  // Returns what a ray meets first, another piece than its own; nothing where it meets none. way: of length 1.
  std::optional<RayHit3> first_hit(const Vector3d& from, const Vector3d& way, std::uint32_t own_piece) const;

 private:
  struct Held;
  std::unique_ptr<Held> held_;
};

}  // namespace hottel
