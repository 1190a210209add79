// Light of a viewer in space that is gathered while it rests.
#include <fmt/format.h>

#include "viewer/window/space/viewer.h"

namespace hottel {

// Wishes for what is seen, where nothing moves and there is light to be seen.
void Viewer3::gather() {
  const bool rests = gathers_ && drag_ == Drag::kNone && !time_ && is_fitted_ && live_.is_at_rest() &&
                     state().is_lit() && state().problem.empty();
  if (!rests || request_.mode != ViewMode3::kLight || (legend_ && legend_->is_dark())) return gathered_.wish({});
  gathered_.wish(GatheredWish{state().version, camera_.camera(size_), tone_.tone, tone_.exposure});
}

// "gathered 43 %"; nothing where none is gathered.
std::string Viewer3::gathering_text() const {
  if (!gathered_.is_busy()) return gathered_.done() > 0 ? "   gathered" : "";
  return fmt::format("   gathering {:.0f} %", 100 * gathered_.done());
}

}  // namespace hottel
