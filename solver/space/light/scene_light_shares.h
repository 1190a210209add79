// What the lights of a scene in space shine on first, and how much of their power arrives there.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "geometry/element.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/beam.h"
#include "solver/radiosity/direct_light.h"

namespace hottel {

// The beam of a light as it stands; of a sun, which has none, the one that holds all directions.
Beam3 beam_of(const Light& light, const LightPlace3& place);

// What a light sees as it stands.
ExactVisibilityMap3 exact_visibility_map_of(const PreparedScene3& prepared, const Light& light,
                                            const LightPlace3& place);

// Whether two lights shine on the same: they stand at one place, and their beams are the same; of suns, their
// directions. Neither power nor motion matters.
bool is_lit_alike_3(const Light& a, const LightPlace3& at, const Light& b, const LightPlace3& there);

// Returns the shares of each light as it stands: Phi_i / P. The elements are those of a matrix of that granularity.
//
//   (1) what is seen from the light is its exact map; shares are proven bounds (beam_shares)
//   (2) a face in whose plane the light lies, and one that the beam only touches, gets 0
//   (3) a light in a solid gives nothing to anybody (LightShares::solid)
//   (4) of a sun they are the areas across its rays of what it lights (sunlit_areas)
//
// REQUIRES a scene that validate() takes: no light lies on a polygon. COST: a map from each light, and balls for each
// piece that it sees. Nothing without lights.
std::vector<LightShares> light_shares(const PreparedScene3& prepared, Granularity granularity);

class ExactVisibilityMap3;

// The elements of a scene, to be asked for the shares of lights wherever these stand.
//
//   (1) shares(scene) are light_shares() of a scene that differs from the prepared one in its lights alone
//   (2) what is seen from a place is found once, for the kMostMaps places that were asked for last: a light that turns
//       where it stands costs no map
//   (3) nor are shares found again, of the kMostShares lights that were asked for last: what stands still, or comes
//       back, costs nothing
//
// For several threads at once. COST: that of ElementTable3.
class LitElements3 {
 public:
  LitElements3(std::shared_ptr<const PreparedScene3> prepared, Granularity granularity);

  std::vector<LightShares> shares(const Scene3& scene) const;

 private:
  static constexpr std::size_t kMostMaps = 16, kMostShares = 64;
  using MapPtr = std::shared_ptr<const ExactVisibilityMap3>;
  struct KnownShares {
    Light light;
    LightPlace3 place;
    LightShares shares;
  };
  // What was asked for last stands last.
  struct Known {
    std::mutex mutex;
    std::vector<MapPtr> maps;
    std::vector<std::shared_ptr<const KnownShares>> shares;
  };
  MapPtr map_from(const Point3& position) const;
  LightShares compute_sun(const Light& light, const LightPlace3& place) const;
  LightShares compute(const Scene3& scene, std::size_t light) const;

  std::shared_ptr<const PreparedScene3> prepared_;
  const ElementTable3& table_;  // of prepared_
  std::unique_ptr<Known> known_;
};

}  // namespace hottel
