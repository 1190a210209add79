// View modes of a window in space: what it can show of a scene, and the computation of that.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/face.h"
#include "kernel/support/stage.h"
#include "solver/radiosity/radiosity_options.h"
#include "viewer/picture/shown_values.h"
#include "viewer/picture/space/element_paint.h"
#include "viewer/window/mode_texts.h"
#include "viewer/window/space/live_version.h"

namespace hottel {

enum class ViewMode3 : unsigned char {
  kLight,       // what the eye sees, through a tone curve
  kRadiosity,   // the radiosity of each element, on a scale
  kIrradiance,  // what it receives
  kFactors,     // the view factors from a picked polygon to each of the others
  kErrors,      // an approximate method against the exact one
  kPlan,        // which effects are simulated, and why
  kSweeps,      // an iterative solver, sweep by sweep
};
inline constexpr int kViewModes3 = 7;

// The word for it, as scripts have it: "light", "radiosity", "irradiance", "factors", "errors", "plan", "sweeps"; and
// back, nothing for other words.
const char* to_string(ViewMode3 mode);
std::optional<ViewMode3> view_mode_3(std::string_view word);

// What is to be shown.
struct ViewRequest3 {
  ViewMode3 mode = ViewMode3::kLight;
  std::optional<Face> face = {};         // picked
  std::string method = "points:2";       // of kErrors
  Solver solver = Solver::kGaussSeidel;  // of kSweeps
  friend bool operator==(const ViewRequest3&, const ViewRequest3&) = default;
};

// What was computed for a view mode, from one version. Members that the mode does not need are empty.
struct ViewResult3 {
  LiveVersion3::Ptr version;                               // that it is of
  std::vector<std::string> lines{};                        // of text, for a panel
  std::string number{};                                    // what to copy: with all digits
  std::optional<ShownValues> shown{};                      // by element, instead of the light
  std::shared_ptr<const RadiositySolution> radiosities{};  // of kSweeps: so far
};

// True iff a request needs more than the version has, so that compute_view_3() has anything to do.
bool needs_work(const ViewRequest3& request);

// Computes from a version what a request needs. tell: called with intermediate results if the computation takes
// long. If something cannot be computed, `lines` say why; throws Interrupted if it is stopped, and what progress
// throws.
//
//   (1) kFactors: the doubles of factors.csv, of whole polygons, all digits of them, largest first, and what is
//       guaranteed of each
//   (2) kErrors: as `compare` computes it
//   (3) kSweeps: after k sweeps, k = 0, 1, ..., kMostSweeps, the light is that of `solve --solver S --iterations k`.
//       tell gets each of them, at most ten a second
// REQUIRES a version with light.
ViewResult3 compute_view_3(const LiveVersion3::Ptr& version, const ViewRequest3& request, const StageProgress& progress,
                           const std::function<void(ViewResult3)>& tell = {});

// What a frame shows and the mouse points at: one version, and what was computed from it for the view mode. The version
// is always that of the result, so two versions are never shown together.
class ShownView3 {
 public:
  ShownView3() = default;  // nothing to be seen
  explicit ShownView3(LiveVersion3::Ptr version) : version_(std::move(version)) {}
  explicit ShownView3(std::shared_ptr<const ViewResult3> result)
      : version_(result->version), result_(std::move(result)) {}

  const LiveVersion3* version() const { return version_.get(); }  // null: nothing
  const ViewResult3* result() const { return result_.get(); }     // null: the light alone
  // Values on a scale in place of the light; null where light is shown.
  const ShownValues* values() const { return result_ && result_->shown ? &*result_->shown : nullptr; }
  // The light; in the mode kSweeps that of the sweep. REQUIRES a version.
  ElementPaint3 light() const;
  const RadiositySolution* radiosities() const;  // the same; null where there is none yet
  // The number that can be copied: the value that is shown of an element, else the light there; without an element, the
  // number of the result.
  std::string number(const std::optional<LiveElement3>& element) const;
  const char* name_of_number() const;  // "radiosity"

 private:
  LiveVersion3::Ptr version_;
  std::shared_ptr<const ViewResult3> result_;
};

// What is known of a picked polygon without computing anything: name, side, material and area; and of one of its
// elements, once there is light, radiosity and irradiance, with all digits.
std::vector<std::string> face_lines_3(const LiveVersion3& version, const Face& face,
                                      const std::optional<LiveElement3>& element);

}  // namespace hottel
