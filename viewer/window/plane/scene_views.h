// What is shown of a scene while it is edited: its light, and the result for the view mode, computed in the background.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "viewer/picture/raster.h"
#include "viewer/window/background.h"
#include "viewer/window/plane/live_scene.h"
#include "viewer/window/plane/view_mode.h"
#include "viewer/window/plane/view_painter.h"

namespace hottel {

// Keeps up to date what is to be drawn. All functions are for the thread of the window; results are computed on other
// threads, and are there after a later collect().
//
//   (1) at rest, all that it returns belongs to the last scene and the last request
//   (2) texture() is that of lit() and tone; a few pixels a cell at first, finer ones follow at rest
class SceneViews2 {
 public:
  // changed: called on other threads when there is something to collect; must be quick.
  SceneViews2(SimulationRequest2 request, const std::function<void()>& changed);

  void set_scene(std::shared_ptr<const Scene2> scene, LiveDepth2 depth);
  void set_request(const ViewRequest2& request);
  // pixels_per_cell: how fine the texture should be at rest.
  void set_tone(const ToneChoice& tone, std::uint32_t pixels_per_cell);
  void compute_again();  // the result for the view mode, from the start

  // Takes what has come. True where something that is drawn has changed.
  bool collect();
  bool is_at_rest() const;
  // Collects until all is at rest, so many seconds at most. Returns whether it is.
  bool wait(double seconds);

  const LiveState2& state() const { return *state_; }  // the last that came
  // The last with light; may be null.
  std::shared_ptr<const LiveState2> lit() const { return texture_ ? texture_->state : nullptr; }
  const ViewRequest2& request() const { return request_; }
  const ToneChoice& tone() const { return tone_; }
  // For the last request, or null. It is of the state that came last unless is_behind().
  const ViewResult2* result() const { return result_ ? &*result_ : nullptr; }
  bool is_behind() const { return result_ && result_->version != state_->version; }
  const LightTexture2* texture() const { return texture_.get(); }  // of lit(); may be null

 private:
  void ask();
  void set_first_texture(std::shared_ptr<const LiveState2> state);
  void ask_for_fine_texture();

  LiveScene2 live_;
  std::shared_ptr<const LiveState2> state_;
  ViewRequest2 request_;
  ToneChoice tone_;
  std::uint32_t pixels_per_cell_ = 1;  // wanted
  std::optional<ViewResult2> result_;
  std::shared_ptr<const LightTexture2> texture_;
  bool is_changed_ = false;
  Background computing_, toning_;
};

}  // namespace hottel
