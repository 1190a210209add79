// View modes of a window in the plane: what it can show of a scene beside its shape, and the computation of that.
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
#include "viewer/window/mode_texts.h"
#include "viewer/window/plane/live_scene.h"

namespace hottel {

enum class ViewMode2 : unsigned char {
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
inline constexpr int kViewModes2 = 10;

// The word for it, as scripts have it: "light", "floor", "bands", "visibility", "factors", "pair", "errors", "check",
// "plan", "sweeps"; and back, nothing for other words.
const char* to_string(ViewMode2 mode);
std::optional<ViewMode2> view_mode_2(std::string_view word);

// What is to be shown.
struct ViewRequest2 {
  ViewMode2 mode = ViewMode2::kLight;
  std::optional<Point2> mouse = {};  // where it is, for kVisibility, and for the value of kLight
  // By name (face_name), so that they are the same faces in every version, however it counts its surfaces.
  std::optional<std::string> face = {};   // picked
  std::optional<std::string> other = {};  // picked second, or under the mouse
  std::string method = "rays:1000";       // of kErrors
  Solver solver = Solver::kGaussSeidel;   // of kSweeps
  bool wants_closed_form = false;         // of kVisibility, kFactors and kPair
  friend bool operator==(const ViewRequest2&, const ViewRequest2&) = default;
};

// The face of that name; nothing where the scene has none, or none is asked for. COST: linear.
std::optional<Face> face_called(const Scene2& scene, const std::optional<std::string>& name);

// A place of a finding, and its number in the list.
struct FindingPlace2 {
  Point2 at;
  Severity severity = Severity::kNote;
  std::size_t number = 0;
};

// What was computed for a view mode. Members that the mode does not need are empty.
struct ViewResult2 {
  std::uint64_t version = 0;  // of the state it is of
  ViewRequest2 request;
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

// True iff a view mode shows the light at the mouse.
bool shows_light_at_mouse(ViewMode2 mode);

// True iff a request needs more than the state has, so that compute_view() has anything to do.
bool needs_work(const ViewRequest2& request);

// Computes from a state what a request needs. tell: called with intermediate results if the computation takes long.
// If something cannot be computed, `lines` say why; throws Interrupted if it is stopped, and what progress throws.
//
//   (1) kSweeps: after k sweeps, k = 0, 1, ..., kMostSweeps, the light is that of `solve --solver S --iterations k` on
//       the grid of a coarse state. tell gets each of them, at most ten a second
//   (2) kErrors: as `compare` computes it; the seconds of the exact factors are those of one run
ViewResult2 compute_view(const LiveState2& state, const ViewRequest2& request, const StageProgress& progress,
                         const std::function<void(ViewResult2)>& tell = {});

}  // namespace hottel
