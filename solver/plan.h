// Which effects a scene calls for, which stages therefore run, and what they will cost.
#pragma once

#include <string>
#include <vector>

#include "geometry/scene_table.h"

namespace hottel {

// One effect, used or not, and why, in words for people.
struct PlannedEffect {
  std::string effect;
  bool used = false;
  std::string reason;
  double seconds_estimate = 0;  // on one core; 0 when not used
};

// What is asked beyond the scene itself.
struct PlanRequest {
  bool everything = false;       // --simulate everything: every effect is used, whatever the scene says
  std::uint64_t grid_cells = 0;  // cells of the illumination grid; 0: none is wanted
  friend bool operator==(const PlanRequest&, const PlanRequest&) = default;
};

// What a scene's shape says, and what its surfaces are called.
struct PlannedShape {
  bool is_convex_room = false;  // one closed convex room, fronts inside, no back with a material
  std::string noun;             // "edge"
};

// True iff some surface is divided: then rows are those of elements.
bool is_divided(const SceneTable& scene);

// The effects in the order in which they are simulated.
//
//   (1) an effect is left out only where it cannot change any number: with everything used the results are the same,
//       bit for bit where exact, within enclosures elsewhere
//   (2) the names are those below, each once
//   (3) seconds_estimate is 0 for an effect that is not used
// COST: O(n) exact operations; nothing is computed of the light itself.
class Plan {
 public:
  // The plan of a scene. An effect that only `everything` asks for has a reason that says so and why the scene does
  // not need it. Seconds are rough: from the showcase scenes, by the number of surfaces. Lights are never used:
  // they are not simulated.
  Plan(const SceneTable& scene, const PlannedShape& shape, const PlanRequest& request);

  const std::vector<PlannedEffect>& effects() const { return effects_; }
  // Whether an effect is used; throws ContractViolation for a name that is none of those below.
  bool uses(const std::string& effect) const;  // REQUIRES one of the names

  static constexpr const char* kOcclusion = "occlusion";
  static constexpr const char* kBackFaces = "back faces";
  static constexpr const char* kSky = "sky";
  static constexpr const char* kSubdivision = "subdivision";
  static constexpr const char* kChannels = "channels";
  static constexpr const char* kInterreflection = "interreflection";
  static constexpr const char* kUnreachable = "unreachable components";
  static constexpr const char* kIllumination = "illumination";
  static constexpr const char* kLights = "lights";

 private:
  std::vector<PlannedEffect> effects_;
};

}  // namespace hottel
