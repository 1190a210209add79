// Which effects a scene calls for, which stages therefore run, and what they will cost.
#pragma once

#include <cstdint>
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
  bool is_simulated = true;     // else this release of hottel cannot simulate it, and it is never used
};

// What is asked beyond the scene itself.
struct PlanRequest {
  bool everything = false;        // --simulate everything: every effect that hottel can simulate is used
  std::uint64_t grid_cells = 0;   // cells of the illumination grids; 0: none is wanted
  std::uint64_t grid_pixels = 0;  // in the plane: of the pictures of these grids in all; 0: of a square one
  bool is_average = false;        // the illumination is that of cells, not of their centres
  bool is_gathered = false;       // in space: the light of the picture is gathered
  std::uint64_t texels = 0;       // in space: of the lightmaps that are asked for, in all
  bool has_picture = true;        // a picture is drawn: in the plane of light if grid_cells > 0, else of faces
  friend bool operator==(const PlanRequest&, const PlanRequest&) = default;
};

// The effects in the order in which they are simulated.
//
//   (1) an effect that hottel can simulate is left out only where it makes no difference: with everything used exact
//       results are the same bit for bit, and others differ only within their enclosures
//   (2) the names are those below, each once at most; plans of scenes in the plane do not list kExchange and kGroups
//   (3) seconds_estimate is 0 for an effect that is not used
class Plan {
 public:
  explicit Plan(std::vector<PlannedEffect> effects) : effects_(std::move(effects)) {}

  const std::vector<PlannedEffect>& effects() const { return effects_; }
  // Whether an effect is used; throws ContractViolation for a name that is none of the plan's.
  bool uses(const std::string& effect) const;

  static constexpr const char* kExchange = "exchange";
  static constexpr const char* kOcclusion = "occlusion";
  static constexpr const char* kBackFaces = "back faces";
  static constexpr const char* kSky = "sky";
  static constexpr const char* kSubdivision = "subdivision";
  static constexpr const char* kGroups = "groups";
  static constexpr const char* kChannels = "channels";
  static constexpr const char* kInterreflection = "interreflection";
  static constexpr const char* kUnreachable = "unreachable components";
  static constexpr const char* kDividing = "dividing";
  static constexpr const char* kIllumination = "illumination";
  static constexpr const char* kPicture = "picture";
  static constexpr const char* kTexels = "texels";  // where they are asked for
  static constexpr const char* kLights = "lights";
  static constexpr const char* kBeams = "beams";
  static constexpr const char* kMovement = "movement";

 private:
  std::vector<PlannedEffect> effects_;
};

}  // namespace hottel
