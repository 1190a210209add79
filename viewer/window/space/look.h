// What a window can show of a scene in space beside its light, and what has to be computed for it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/face.h"
#include "kernel/support/stage.h"
#include "solver/radiosity/radiosity_options.h"
#include "viewer/picture/shown_values.h"
#include "viewer/window/space/live_scene.h"

namespace hottel {

enum class LookKind3 : unsigned char {
  kLight,       // what the eye sees, through a tone curve
  kRadiosity,   // the radiosity of each element, on a scale
  kIrradiance,  // what it receives
  kFactors,     // the view factors from a picked polygon to each of the others
  kErrors,      // an approximate method against the exact one
  kPlan,        // which effects are simulated, and why
  kSweeps,      // an iterative solver, sweep by sweep
};
inline constexpr int kLooks3 = 7;

// The word for it, as scripts have it: "light", "radiosity", "irradiance", "factors", "errors", "plan", "sweeps"; and
// back, nothing for other words.
const char* to_string(LookKind3 look);
std::optional<LookKind3> look_3(std::string_view word);

// What is looked at.
struct LookRequest3 {
  LookKind3 look = LookKind3::kLight;
  std::optional<Face> face = {};         // picked
  std::string method = "points:2";       // of kErrors
  Solver solver = Solver::kGaussSeidel;  // of kSweeps
  friend bool operator==(const LookRequest3&, const LookRequest3&) = default;
};

// What was computed for a look. What a look does not need is empty.
struct LookResult3 {
  std::vector<std::string> lines{};                        // of text, for a panel
  std::string number{};                                    // what to copy: with all digits
  std::optional<ShownValues> shown{};                      // by element, instead of the light
  std::shared_ptr<const RadiositySolution> radiosities{};  // of kSweeps: so far
};

// Whether a look needs more than the state: whether look_at_3() has anything to do.
bool needs_work(const LookRequest3& request);

// Computes what a look needs, of a state with light. tell: is called with what there is so far, where a look goes on
// for long. What cannot be had is told in the lines; throws Interrupted where it is stopped, and what progress throws.
//
//   (1) kFactors: the doubles of factors.csv, of whole polygons, all digits of them, largest first, and what is
//       guaranteed of each
//   (2) kErrors: as `compare` has it
//   (3) kSweeps: after k sweeps, k = 0, 1, ..., kMostSweeps3, the light is that of `solve --solver S --iterations k`.
//       Each is told, no faster than ten a second
LookResult3 look_at_3(const LiveState3& state, const LookRequest3& request, const StageProgress& progress,
                      const std::function<void(LookResult3)>& tell = {});
inline constexpr int kMostSweeps3 = 50;

// What is known of a picked polygon without computing anything: name, side, material and area; and of one of its
// elements, once there is light, radiosity and irradiance, with all digits.
std::vector<std::string> face_lines_3(const Scene3& scene, const LiveState3& state, const Face& face,
                                      std::optional<std::uint32_t> element);

}  // namespace hottel
