// What each stage of a simulation in the plane is made of, and how.
//
// A stage is kept while its input is equal to that of the version before (kernel/support/stage_node.h): what an input
// holds and does not compare must not change the value. Each make_... is a pure function of its input.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_request.h"
#include "geometry/plane/check/finding.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/stage_node.h"
#include "solver/dividing/dividing_estimate.h"
#include "solver/plan.h"
#include "solver/plane/check/scene_check.h"
#include "solver/plane/light/light_rows.h"
#include "solver/plane/light/solved_light.h"
#include "solver/plane/methods/computed_factors.h"
#include "solver/plane/methods/exchange_method.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/radiosity/radiosity_solver.h"
#include "solver/stage_inputs.h"

namespace hottel {

class FactorStore;

using MethodPtr2 = std::shared_ptr<const ExchangeMethod2>;
using ScenePtr2 = std::shared_ptr<const Scene2>;

struct ArrangementInput2 {
  ScenePtr2 scene;
  friend bool operator==(const ArrangementInput2& a, const ArrangementInput2& b);
};
PreparedScene2 make_arrangement(const ArrangementInput2& input, const StageProgress&);

// The same arrangement with its surfaces cut into elements.
struct DivisionInput2 {
  StagePtr<PreparedScene2> arrangement;
  ScenePtr2 scene;  // of the shape that is arranged
  friend bool operator==(const DivisionInput2& a, const DivisionInput2& b) {
    return a.arrangement == b.arrangement &&
           (a.scene == b.scene || std::ranges::equal(a.scene->surfaces, b.scene->surfaces, &Surface::is_divided_alike));
  }
};
PreparedScene2 make_divided(const DivisionInput2& input, const StageProgress& progress);

// The scene of a version, with an arrangement that was made for another.
struct PreparedInput2 {
  StagePtr<PreparedScene2> arrangement;
  ScenePtr2 scene;
  friend bool operator==(const PreparedInput2&, const PreparedInput2&) = default;
};
PreparedScene2 make_prepared(const PreparedInput2& input, const StageProgress& progress);

struct FactorsInput2 {
  StagePtr<PreparedScene2> arrangement;
  ScenePtr2 scene;  // of the version that it is made for; not compared: what matters of it is arranged
  MethodPtr2 method;
  Granularity granularity = Granularity::kFace;
  RowChoice rows = {};
  bool wants_visibility = false, wants_measures = false, everything = false;
  std::uint64_t memory = 0;
  std::shared_ptr<FactorStore> store = nullptr;  // no number depends on it
  friend bool operator==(const FactorsInput2& a, const FactorsInput2& b) {
    return a.arrangement == b.arrangement && a.method == b.method && a.granularity == b.granularity &&
           a.rows == b.rows && a.wants_visibility == b.wants_visibility && a.wants_measures == b.wants_measures &&
           a.everything == b.everything && a.memory == b.memory && a.store == b.store;
  }
};
ComputedFactors2 make_factors(const FactorsInput2& input, const StageProgress& progress);

struct SystemInput2 {
  StagePtr<ComputedFactors2> factors;
  RowChoice rows;  // of factors
  Spectra reflectivities;
  RadiosityOptions options;
  std::string file;  // of the scene, for messages
  friend bool operator==(const SystemInput2&, const SystemInput2&) = default;
};
RadiositySolver make_system(const SystemInput2& input, const StageProgress& progress);

// What the lights shine on first. Their power is no part of it.
struct LightSharesInput2 {
  StagePtr<PreparedScene2> arrangement;
  StagePtr<PreparedScene2> prepared;  // of the version that it is made for; not compared: what matters of it follows
  Granularity granularity = Granularity::kFace;
  std::vector<Light> lights;  // without power
  std::vector<LightPlace2> places;
  LightTest test = LightTest::kExact;
  friend bool operator==(const LightSharesInput2& a, const LightSharesInput2& b) {
    return a.arrangement == b.arrangement && a.granularity == b.granularity && a.lights == b.lights &&
           a.places == b.places && a.test == b.test;
  }
};
std::vector<LightShares> make_shares(const LightSharesInput2& input, const StageProgress& progress);

struct RadiositiesInput2 {
  StagePtr<RadiositySolver> system;
  StagePtr<ComputedFactors2> factors;
  MethodPtr2 method;                  // of the factors
  StagePtr<PreparedScene2> prepared;  // of the version that it is made for; not compared: what matters of it follows
  Spectra emissions;
  StagePtr<std::vector<LightShares>> shares;  // of the power of the lights; null: there are none
  Spectra powers;
  bool closed = false;
  StagePtr<PreparedScene2> divided;  // for the promise
  std::uint64_t memory = 0;
  friend bool operator==(const RadiositiesInput2& a, const RadiositiesInput2& b) {
    return a.system == b.system && a.emissions == b.emissions && a.shares == b.shares && a.powers == b.powers &&
           a.closed == b.closed;
  }
};
RadiositySolution make_radiosities(const RadiositiesInput2& input, const StageProgress& progress);

// What dividing once more would change, estimated.
struct DividingInput2 {
  StagePtr<RadiositySolution> radiosities;
  StagePtr<ComputedFactors2> factors;
  MethodPtr2 method;               // of the factors
  StagePtr<PreparedScene2> whole;  // undivided, of the version that it is made for; not compared
  StagePtr<std::vector<LightShares>> shares;
  LightTest test = LightTest::kExact;
  std::uint64_t memory = 0;
  friend bool operator==(const DividingInput2& a, const DividingInput2& b) {
    return a.radiosities == b.radiosities && a.memory == b.memory;
  }
};
DividingEstimate make_dividing(const DividingInput2& input, const StageProgress& progress);

struct RowsInput2 {
  StagePtr<PreparedScene2> arrangement;
  Granularity granularity = Granularity::kFace;
  Grid2 grid;
  std::uint64_t memory = 0;
  friend bool operator==(const RowsInput2&, const RowsInput2&) = default;
};
LightRows2 make_rows(const RowsInput2& input, const StageProgress& progress);

struct LightInput2 {
  StagePtr<RadiositySolution> radiosities;
  StagePtr<PreparedScene2> prepared;  // not compared, as before
  Granularity granularity = Granularity::kFace;
  Grid2 grid;
  LightKind2 kind = LightKind2::kPoint;
  StagePtr<LightRows2> rows;  // null: not kept. Not compared: light is the same, bit for bit
  friend bool operator==(const LightInput2& a, const LightInput2& b) {
    return a.radiosities == b.radiosities && a.granularity == b.granularity && a.grid == b.grid && a.kind == b.kind;
  }
};
SolvedLight2 make_light(const LightInput2& input, const StageProgress& progress);

struct PlanInput2 {
  StagePtr<PreparedScene2> prepared;
  PlanRequest request;
  friend bool operator==(const PlanInput2&, const PlanInput2&) = default;
};
Plan make_plan(const PlanInput2& input, const StageProgress& progress);

struct LostLightInput2 {
  StagePtr<PreparedScene2> prepared;
  StagePtr<ComputedFactors2> factors;
  friend bool operator==(const LostLightInput2&, const LostLightInput2&) = default;
};
Findings2 make_lost_light(const LostLightInput2& input, const StageProgress& progress);

struct CheckInput2 {
  ScenePtr2 scene;
  StagePtr<PreparedScene2> whole;  // undivided
  StagePtr<ComputedFactors2> exact_factors;
  StagePtr<std::vector<LightShares>> shares;  // of the elements of these
  friend bool operator==(const CheckInput2&, const CheckInput2&) = default;
};
SceneCheck2 make_check(const CheckInput2& input, const StageProgress& progress);

}  // namespace hottel
