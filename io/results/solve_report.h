// What `solve` plans and what it came to, as JSON and as text for people.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/exchange_report.h"
#include "io/results/planned_lists.h"
#include "io/results/planned_on_disk.h"
#include "io/results/radiosity_files.h"
#include "io/results/store_report.h"
#include "io/results/temperature_files.h"
#include "solver/dividing/dividing_estimate.h"
#include "solver/memory_estimate.h"
#include "solver/plan.h"

namespace hottel {

// What the memory of a plan is held against, and why it does not suffice; empty where it does.
struct PlannedMemory {
  MemoryEstimate estimate;
  MemoryLimits limits;
  std::string problem;
};

// Returns a plan as text for people, a line an effect or a stage of memory, and as the head of a report: one JSON
// object. What is null is left out: of the object the list of effects is empty then.
std::string plan_text(const Plan* plan, const PlannedMemory* memory, const PlannedLists* lists = nullptr,
                      const PlannedOnDisk* on_disk = nullptr);
std::string plan_json(const std::string& scene, const Plan* plan, const PlannedMemory* memory,
                      const PlannedLists* lists = nullptr, const PlannedOnDisk* on_disk = nullptr);
inline std::string plan_text(const Plan& plan) { return plan_text(&plan, nullptr); }

// What is told of the view factors that a solution rests on, whatever the dimension: which means settled how many
// numbers or signs, in the order of their cost.
struct FactorCounts {
  std::uint64_t surfaces = 0, elements = 0, vertices = 0, pairs = 0;
  std::vector<std::pair<const char*, std::uint64_t>> tiers{};
  bool closure_is_exact = false;
  std::optional<SkyByClosure> sky{};  // where it is told by closure
};
FactorCounts factor_counts(const ExchangeReport& report);

// The range of what a picture shows, and the ends of its colour bar.
struct PictureRange {
  std::string grid{};  // the name of the grid whose picture it is, where that has one
  std::string quantity, unit;
  double lower = 0, upper = 0;  // the least and the greatest value
  double bar_lower = 0, bar_upper = 0;
};

// How the light of a picture became colours.
struct PictureLight {
  std::string grid{};              // the name of the grid whose picture it is, where that has one
  double scale = 1;                // what light was multiplied by before the tone curve
  std::string tone;                // its name
  double exposure = 1;             // the one that was asked for
  std::vector<double> contours{};  // the levels of lines of equal light
};

// From where a picture of a scene in space is seen.
struct PictureView {
  std::array<double, 3> eye{}, target{}, up{};
  double field_of_view = 0;  // degrees, across the picture's height
  bool is_chosen = false;    // the scene has no camera
};

// Everything that is said about one run of `solve`. REQUIRES that none of the pointers is null when it is written.
struct SolveReport {
  std::string scene;
  const Plan* plan = nullptr;
  FactorCounts factors{};
  const RadiositySolution* solution = nullptr;
  const NetFluxes* fluxes = nullptr;
  std::map<std::string, double> seconds{};         // of stages that ran, and of no others
  std::vector<PictureLight> picture_lights{};      // of pictures of light
  std::vector<PictureRange> picture_ranges{};      // of pictures that show something else than light
  std::optional<PictureView> picture_view{};       // of a picture of space
  std::optional<double> illumination_max_error{};  // of the averages over cells, where asked for
  std::vector<FoundTemperatures> insulated{};      // in the order of radiosity.csv
  std::vector<FoundTemperatures> given_flux{};     // in the same order
  std::string unit{};                              // of lengths; empty where the scene does not say
  std::optional<StoreReport> store{};              // where factors were kept
  const DividingEstimate* dividing = nullptr;      // what dividing once more would change; null: not estimated
  std::vector<std::string> warnings{};             // first of the notes of the JSON object; not in the text
};

// What is estimated of dividing, as text: "estimate: dividing once more ..." and what it does not see.
std::string dividing_text(const DividingEstimate& estimate);

// Returns the report as one JSON object (the contract's report.json) and a final newline, and as text for people:
// sizes, solver, energy, the six largest net fluxes, up to six insulated groups, and six of given net flux, how light
// became a picture, notes, seconds. The fluxes are not in the JSON object.
std::string solve_json(const SolveReport& report);
std::string solve_text(const SolveReport& report);

// Returns the factor matrix and the radiosities in full where the scene fits on a screen: at most kFacesOnAScreen
// surfaces and twice as many elements. Else nothing.
inline constexpr std::size_t kFacesOnAScreen = 12;
std::string small_scene_text(const SceneTable& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution);

}  // namespace hottel
