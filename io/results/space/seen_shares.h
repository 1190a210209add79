// The shares of what a point sees, as files number and measure them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/scene_names.h"
#include "io/results/space/seen_writer.h"

namespace hottel {

inline double solid_angle_of(double fraction) { return 4 * std::numbers::pi * fraction; }

// Calls take(face, fraction, bounds) for each face that is seen, by the order of faces, and last for the sky without a
// face; bounds: null where there are none.
template <class Take>
void for_each_seen(const SeenByPoint3& seen, const Take& take) {
  constexpr double kNothing = 1e-14;  // what rounding makes of a sky that is not seen
  const VisibilityMap3& map = seen.map;
  for (std::size_t k = 0; k < map.shares.size(); ++k)
    take(std::optional(map.shares[k].face), map.shares[k].fraction,
         seen.bounds ? &seen.bounds->shares[k].fraction : nullptr);
  if (map.sky_fraction > kNothing)
    take(std::optional<Face>(), map.sky_fraction, seen.bounds ? &seen.bounds->sky_fraction : nullptr);
}

// The fragments of a face; none of the sky.
inline std::span<const VisibilityMap3::Fragment> fragments_of(const VisibilityMap3& map,
                                                              const std::optional<Face>& face) {
  if (!face) return {};
  const auto [begin, end] = std::ranges::equal_range(map.fragments, *face, {}, &VisibilityMap3::Fragment::face);
  return {begin, end};
}

// Names and their numbers: every face by its own, then the sky, then "#in NAME" of each solid.
class SeenNames3 {
 public:
  explicit SeenNames3(const SeenFileOptions3& options)
      : scene_(options.scene), solids_(options.solids), sky_(static_cast<std::int32_t>(2 * scene_.surfaces.size())) {}

  std::int32_t of(const std::optional<Face>& face) const {
    return face ? static_cast<std::int32_t>(face->number()) : sky_;
  }
  std::int32_t of_solid(std::uint32_t mesh) const { return sky_ + 1 + static_cast<std::int32_t>(mesh); }

  std::vector<std::string> all() const {
    std::vector<std::string> names;
    for (std::int32_t k = 0; k < sky_; ++k) names.push_back(face_name(scene_, Face::of(static_cast<std::uint32_t>(k))));
    names.emplace_back("sky");
    for (const auto& mesh : solids_.meshes()) names.push_back("#in " + mesh.name);
    return names;
  }

 private:
  const Scene3& scene_;
  const Solids3& solids_;
  std::int32_t sky_;
};

}  // namespace hottel
