// What a window can show of a scene beside its shape, and what has to be computed for it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/face.h"
#include "geometry/plane/check/finding.h"
#include "geometry/plane/point.h"
#include "solver/radiosity/radiosity_options.h"
#include "viewer/picture/plane/scene_picture.h"
#include "viewer/picture/plane/visibility_picture.h"
#include "viewer/window/plane/live_scene.h"

namespace hottel {

enum class Look2 : unsigned char {
  kLight,       // the light in the rooms, through a tone curve
  kFloor,       // the colour of the floor times the light, cell by cell
  kBands,       // the radiosity of each element, as a band along its edge
  kVisibility,  // what the mouse sees
  kFactors,     // the view factors from a picked face
  kPair,        // two picked faces: critical lines, and all that is known of the pair
  kErrors,      // an approximate method against the exact one
  kCheck,       // what `check` finds
  kPlan,        // which effects are simulated, and why
  kSweeps,      // an iterative solver, sweep by sweep
};
inline constexpr int kLooks2 = 10;

// The word for it, as scripts have it: "light", "floor", "bands", "visibility", "factors", "pair", "errors", "check",
// "plan", "sweeps"; and back, nothing for other words.
const char* to_string(Look2 look);
std::optional<Look2> look_2(std::string_view word);

// What is looked at.
struct LookRequest2 {
  Look2 look = Look2::kLight;
  std::optional<Point2> mouse = {};  // where it is, for kVisibility, and for the value of kLight
  // By name (face_name), so that they are the same faces in every version, however it counts its surfaces.
  std::optional<std::string> face = {};   // picked
  std::optional<std::string> other = {};  // picked second, or under the mouse
  std::string method = "rays:1000";       // of kErrors
  Solver solver = Solver::kGaussSeidel;   // of kSweeps
  bool wants_closed_form = false;         // of kVisibility, kFactors and kPair
  friend bool operator==(const LookRequest2&, const LookRequest2&) = default;
};

// The face of that name; nothing where the scene has none, or none is asked for. COST: linear.
std::optional<Face> face_called(const Scene2& scene, const std::optional<std::string>& name);

// A place of a finding, and its number in the list.
struct FindingPlace2 {
  Point2 at;
  Severity severity = Severity::kNote;
  std::size_t number = 0;
};

// What was computed for a look. What a look does not need is empty.
struct LookResult2 {
  std::uint64_t version = 0;  // of the state it is of
  LookRequest2 request;
  std::vector<std::string> lines{};  // of text, for a panel
  std::string number{};              // what to copy: with all digits
  std::vector<double> at_mouse{};    // light there, by channel: mean irradiance
  std::optional<VisibilityDrawing2> sight{};
  std::optional<PairDrawing2> pair{};
  std::optional<ScenePicture2> plan{};          // of kErrors: faces and floors by error
  std::string times{};                          // of kErrors: what both methods took
  std::vector<FindingPlace2> findings{};        // of kCheck
  std::shared_ptr<const SolvedLight2> light{};  // of kSweeps: so far
  bool is_done = true;                          // false: more is coming
};

// Whether a look shows the light at the mouse.
bool shows_light_at_mouse(Look2 look);

// Whether a look needs more than the state: whether look_at() has anything to do.
bool needs_work(const LookRequest2& request);

// Computes what a look needs, of a state. tell: is called with what there is so far, where a look goes on for long.
// What cannot be had is told in the lines; throws Interrupted where it is stopped, and what progress throws.
//
//   (1) kSweeps: after k sweeps, k = 0, 1, ..., kMostSweeps, the light is that of `solve --solver S --iterations k` on
//       the grid of a coarse state. Each is told, no faster than ten a second
//   (2) kErrors: as `compare` has it; the seconds of the exact factors are those of one run
LookResult2 look_at(const LiveState2& state, const LookRequest2& request, const StageProgress& progress,
                    const std::function<void(LookResult2)>& tell = {});
inline constexpr int kMostSweeps = 50;

}  // namespace hottel
