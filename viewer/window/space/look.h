// What a window can show of a scene in space beside its light, and what has to be computed for it.
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
#include "viewer/window/space/live_version.h"

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

// What was computed for a look, of one version. What a look does not need is empty.
struct LookResult3 {
  LiveVersion3::Ptr version;                               // that it is of
  std::vector<std::string> lines{};                        // of text, for a panel
  std::string number{};                                    // what to copy: with all digits
  std::optional<ShownValues> shown{};                      // by element, instead of the light
  std::shared_ptr<const RadiositySolution> radiosities{};  // of kSweeps: so far
};

// Whether a look needs more than the version: whether look_at_3() has anything to do.
bool needs_work(const LookRequest3& request);

// Computes what a look needs, of a version. tell: is called with what there is so far, where a look goes on
// for long. What cannot be had is told in the lines; throws Interrupted where it is stopped, and what progress throws.
//
//   (1) kFactors: the doubles of factors.csv, of whole polygons, all digits of them, largest first, and what is
//       guaranteed of each
//   (2) kErrors: as `compare` has it
//   (3) kSweeps: after k sweeps, k = 0, 1, ..., kMostSweeps3, the light is that of `solve --solver S --iterations k`.
//       Each is told, no faster than ten a second
// REQUIRES a version with light.
LookResult3 look_at_3(const LiveVersion3::Ptr& version, const LookRequest3& request, const StageProgress& progress,
                      const std::function<void(LookResult3)>& tell = {});
inline constexpr int kMostSweeps3 = 50;

// What a frame shows, and what lies under the mouse is asked of: one version, and what was computed of that for the
// look. What is of a result is of the result's version, so nothing of another can be shown with it.
class ShownLook3 {
 public:
  ShownLook3() = default;  // nothing to be seen
  explicit ShownLook3(LiveVersion3::Ptr version) : version_(std::move(version)) {}
  explicit ShownLook3(std::shared_ptr<const LookResult3> result)
      : version_(result->version), result_(std::move(result)) {}

  const LiveVersion3* version() const { return version_.get(); }  // null: nothing
  const LookResult3* result() const { return result_.get(); }     // null: the light alone
  // Values on a scale in place of the light; null where light is shown.
  const ShownValues* values() const { return result_ && result_->shown ? &*result_->shown : nullptr; }
  // The light: of the sweeps, where the look is those. REQUIRES a version.
  ElementPaint3 light() const;
  const RadiositySolution* radiosities() const;  // the same; null where there is none yet
  // The number that can be copied: that of what is shown of an element, else the light there; where nothing is pointed
  // at, what is looked at.
  std::string number(const std::optional<LiveElement3>& element) const;
  const char* name_of_number() const;  // "radiosity"

 private:
  LiveVersion3::Ptr version_;
  std::shared_ptr<const LookResult3> result_;
};

// What is known of a picked polygon without computing anything: name, side, material and area; and of one of its
// elements, once there is light, radiosity and irradiance, with all digits.
std::vector<std::string> face_lines_3(const LiveVersion3& version, const Face& face,
                                      const std::optional<LiveElement3>& element);

}  // namespace hottel
