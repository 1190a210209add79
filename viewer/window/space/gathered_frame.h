// The light of a frame at rest, gathered point by point in the background.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/space/scene/scene.h"
#include "viewer/picture/raster.h"
#include "viewer/picture/space/gathered_view.h"
#include "viewer/picture/tone_curve.h"
#include "viewer/window/background.h"
#include "viewer/window/space/live_version.h"

namespace hottel {

// What is to be gathered: of one version with light, what a camera sees through a curve.
struct GatheredWish {
  LiveVersion3::Ptr version;
  Camera3 camera;
  Tone tone = kUsualTone3;
  double exposure = 1;
  friend bool operator==(const GatheredWish&, const GatheredWish&) = default;
};

// What light is made of, ready to be gathered: of one version.
struct GatheredLightOf3;

// Gathers what is wished for, in squares of pixels, those in the middle first. All functions are for one thread.
//
//   (1) the squares that have come are all of the last wish; those that are missing are left as they were
//   (2) all together they are what gathered_view_3 and add_direct_light_3 make of it: the picture of
//       `solve --shading gathered`
//   (3) nothing waits for it. It begins a fifth of a second after the wish
class GatheredFrame3 {
 public:
  // changed: called on other threads when there is something to collect; must be quick.
  explicit GatheredFrame3(std::function<void()> changed) : work_(std::move(changed)) {}

  // Another wish throws away what has come; nothing stops what runs. REQUIRES a version with light.
  void wish(const std::optional<GatheredWish>& wish);
  // Takes what has come. True where something has changed.
  bool collect() { return work_.collect(); }
  // True while something is to come.
  bool is_busy() const { return work_.is_busy(); }
  // Fraction of the frame that has come; 0 without a wish.
  double done() const { return wish_ ? done_ : 0; }
  // Draws what has come. REQUIRES a frame of the camera's size.
  void draw(const ToneCurve& tone, Raster& frame) const;

 private:
  Background::Work work_for(const GatheredWish& wish);
  void take(std::vector<PixelTile3> tiles, std::size_t pixels);

  std::optional<GatheredWish> wish_;
  std::shared_ptr<const GatheredLightOf3> light_;  // of the last version that was gathered
  std::vector<PixelTile3> tiles_;
  double done_ = 0;
  Background work_;
};

}  // namespace hottel
