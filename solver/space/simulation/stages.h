// What each stage of a simulation in space is made of, and how.
//
// A stage is kept while its input is equal to that of the version before (kernel/support/stage_node.h): what an input
// holds and does not compare must not change the value. Each make_... is a pure function of its input.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/stage_node.h"
#include "solver/dividing/dividing_estimate.h"
#include "solver/plan.h"
#include "solver/radiosity/radiosity_solver.h"
#include "solver/space/light/illumination_grid.h"
#include "solver/space/light/scene_light_shares.h"
#include "solver/space/methods/computed_factors.h"
#include "solver/stage_inputs.h"

namespace hottel {

using ScenePtr3 = std::shared_ptr<const Scene3>;

// All of a scene that its arrangement comes from but for its materials.
bool is_same_shape(const Scene3& a, const Scene3& b);

bool is_divided_alike(const Scene3& a, const Scene3& b);

struct ArrangementInput3 {
  ScenePtr3 scene;
  friend bool operator==(const ArrangementInput3& a, const ArrangementInput3& b);
};
PreparedScene3 make_arrangement(const ArrangementInput3& input, const StageProgress&);

// The scene of a version, with an arrangement that was made for another.
struct PreparedInput3 {
  StagePtr<PreparedScene3> arrangement;
  ScenePtr3 scene;
  friend bool operator==(const PreparedInput3&, const PreparedInput3&) = default;
};
PreparedScene3 make_prepared(const PreparedInput3& input, const StageProgress& progress);

struct PlanInput3 {
  StagePtr<PreparedScene3> prepared;
  PlanRequest request;
  SkyBy sky = SkyBy::kIntegral;
  friend bool operator==(const PlanInput3&, const PlanInput3&) = default;
};
Plan make_plan(const PlanInput3& input, const StageProgress& progress);

struct FactorsInput3 {
  StagePtr<PreparedScene3> arrangement;
  ScenePtr3 scene;  // compared in how its surfaces are divided
  // Of the version that it is made for; not compared: what matters of it is arranged.
  StagePtr<PreparedScene3> prepared;
  FactorsRequest3 request;
  // Of a scene of the same shape and division, in which other materials act alike; not compared. This scene is refused,
  // or arranged as that one.
  StagePtr<ComputedFactors3> measured;
  friend bool operator==(const FactorsInput3& a, const FactorsInput3& b);
};
ComputedFactors3 make_factors(const FactorsInput3& input, const StageProgress& progress);

struct HiddenInput3 {
  StagePtr<ComputedFactors3> factors;
  StagePtr<PreparedScene3> prepared;  // not compared, as before
  Granularity granularity = Granularity::kFace;
  RowChoice rows;
  friend bool operator==(const HiddenInput3& a, const HiddenInput3& b) { return a.factors == b.factors; }
};
std::vector<ElementPair> make_hidden(const HiddenInput3& input, const StageProgress& progress);

// What lights could shine on, without the lights.
struct LitInput3 {
  StagePtr<PreparedScene3> arrangement;
  ScenePtr3 scene;                    // compared in how its surfaces are divided
  StagePtr<PreparedScene3> prepared;  // not compared, as before
  Granularity granularity = Granularity::kFace;
  friend bool operator==(const LitInput3& a, const LitInput3& b);
};
LitElements3 make_lit(const LitInput3& input, const StageProgress& progress);

struct LightSharesInput3 {
  StagePtr<LitElements3> lit;
  ScenePtr3 scene;                    // compared in its lights
  StagePtr<PreparedScene3> prepared;  // not compared, as before
  Granularity granularity = Granularity::kFace;
  LightTest test = LightTest::kExact;
  friend bool operator==(const LightSharesInput3& a, const LightSharesInput3& b);
};
std::vector<LightShares> make_shares(const LightSharesInput3& input, const StageProgress& progress);

struct SystemInput3 {
  StagePtr<ComputedFactors3> factors;
  FactorsRequest3 asked;              // of them; not compared
  StagePtr<PreparedScene3> prepared;  // not compared, as before
  ScenePtr3 scene;                    // compared in its promise `closed`
  Spectra reflectivities;
  RadiosityOptions options;
  friend bool operator==(const SystemInput3& a, const SystemInput3& b) {
    return a.factors == b.factors && a.reflectivities == b.reflectivities && a.scene->closed == b.scene->closed &&
           a.options == b.options;
  }
};
RadiositySolver make_system(const SystemInput3& input, const StageProgress& progress);

struct RadiositiesInput3 {
  StagePtr<RadiositySolver> system;
  StagePtr<ComputedFactors3> factors;  // of the system
  ScenePtr3 scene;                     // compared in what follows
  Spectra emissions;
  StagePtr<std::vector<LightShares>> shares;  // of the power of the lights
  Spectra powers;
  friend bool operator==(const RadiositiesInput3& a, const RadiositiesInput3& b) {
    return a.system == b.system && a.emissions == b.emissions && a.shares == b.shares && a.powers == b.powers;
  }
};
RadiositySolution make_radiosities(const RadiositiesInput3& input, const StageProgress& progress);

// What dividing once more would change, estimated.
struct DividingInput3 {
  StagePtr<RadiositySolution> radiosities;
  StagePtr<ComputedFactors3> factors;
  StagePtr<PreparedScene3> prepared;
  StagePtr<std::vector<LightShares>> shares;
  FactorsRequest3 asked;
  LightTest test = LightTest::kExact;
  friend bool operator==(const DividingInput3& a, const DividingInput3& b) { return a.radiosities == b.radiosities; }
};
DividingEstimate make_dividing(const DividingInput3& input, const StageProgress& progress);

struct LightInput3 {
  StagePtr<RadiositySolution> radiosities;
  StagePtr<PreparedScene3> prepared;  // not compared, as before
  std::optional<Grid3> grid;          // nothing: there is no light to ask for
  FactorsRequest3 asked;              // not compared: the radiosities come from them
  bool is_average = false;
  friend bool operator==(const LightInput3& a, const LightInput3& b) {
    return a.radiosities == b.radiosities && a.grid == b.grid && a.is_average == b.is_average;
  }
};
IlluminationGrid3 make_light(const LightInput3& input, const StageProgress& progress);

}  // namespace hottel
