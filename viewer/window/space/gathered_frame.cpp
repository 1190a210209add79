#include "viewer/window/space/gathered_frame.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <thread>
#include <utility>

#include "kernel/support/interrupt.h"
#include "kernel/support/stopwatch.h"
#include "viewer/picture/space/direct_view.h"
#include "viewer/picture/space/gathered_source.h"
#include "viewer/picture/space/seen_sides.h"

namespace hottel {

struct GatheredLightOf3 {
  LiveVersion3::Ptr version;
  std::shared_ptr<const PreparedScene3> prepared;
  std::shared_ptr<const RadiositySolution> solution;
  GatheredSource3 source;

  explicit GatheredLightOf3(LiveVersion3::Ptr of)
      : version(std::move(of)),
        prepared(version->of().simulation().prepared()),
        solution(version->radiosities()),
        source(*prepared, Granularity::kElement, *solution, light_responses_3(*solution),
               *version->of().simulation().light_shares()) {}
};

namespace {

constexpr double kRest = 0.2, kBetweenNews = 0.1;  // seconds
constexpr double kMostSteps = 1;                   // of 256, as a picture of `solve` has it

void rest() {
  Stopwatch watch;
  for (double rested = 0; rested < kRest; rested += watch.lap()) {
    throw_if_interrupted();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

// What lamps and suns add to each pixel.
PixelValues3 direct_light(const GatheredLightOf3& light, const Camera3& camera) {
  PixelValues3 result{camera.width, camera.height, light.source.responses().channels, {}};
  result.values.assign(std::size_t{camera.width} * camera.height * result.channels, 0);
  add_direct_light_3(*light.prepared, light.source.table(), *light.solution, camera,
                     seen_sides_3(*light.prepared, camera), result);
  return result;
}

void add(const PixelValues3& direct, PixelTile3& tile) {
  PixelValues3& pixels = tile.pixels;
  for (std::uint32_t y = 0; y < pixels.height; ++y)
    for (std::uint32_t x = 0; x < pixels.width; ++x) {
      const std::span<const double> more = direct.at(tile.left + x, tile.top + y);
      const std::size_t place = (std::size_t{y} * pixels.width + x) * pixels.channels;
      for (std::size_t c = 0; c < pixels.channels; ++c) pixels.values[place + c] += more[c];
    }
}

// Tells tiles, several at once where they come fast.
class TileNews {
 public:
  using Tell = std::function<void(std::vector<PixelTile3>)>;
  explicit TileNews(Tell tell) : tell_(std::move(tell)) {}

  void add(PixelTile3 tile) {
    tiles_.push_back(std::move(tile));
    since_ += watch_.lap();
    if (since_ >= kBetweenNews) tell();
  }
  void tell() {
    tell_(std::exchange(tiles_, {}));
    since_ = 0;
  }

 private:
  Tell tell_;
  std::vector<PixelTile3> tiles_;
  Stopwatch watch_;
  double since_ = 0;
};

void gather(const GatheredLightOf3& light, const GatheredWish& wish, TileNews& news) {
  const ElementPaint3& paint = wish.version->light();
  const ToneCurve tone(wish.tone, wish.exposure, paint.values, paint.channels);
  const auto steps = [&tone](std::span<const double> a, std::span<const double> b) {
    return steps_between_3(tone(a), tone(b));
  };
  const PixelValues3 direct = direct_light(light, wish.camera);
  gathered_tiles_3(light.source.scene(paint), wish.camera, steps, kMostSteps, [&](PixelTile3 tile) {
    throw_if_interrupted();
    add(direct, tile);
    news.add(std::move(tile));
  });
  news.tell();
}

}  // namespace

void GatheredFrame3::wish(const std::optional<GatheredWish>& wish) {
  if (wish == wish_) return;
  wish_ = wish;
  tiles_.clear();
  done_ = 0;
  if (!wish) return work_.cancel();
  if (light_ && light_->version != wish->version) light_.reset();
  work_.post(work_for(*wish));
}

Background::Work GatheredFrame3::work_for(const GatheredWish& wish) {
  return [this, wish, light = light_](const StageProgress&, const Background::Tell& tell) mutable -> Background::Apply {
    rest();
    if (!light) light = std::make_shared<const GatheredLightOf3>(wish.version);
    tell([this, light] { light_ = light; });
    const std::size_t pixels = std::size_t{wish.camera.width} * wish.camera.height;
    TileNews news([&](std::vector<PixelTile3> tiles) {
      tell([this, pixels, tiles = std::move(tiles)]() mutable { take(std::move(tiles), pixels); });
    });
    gather(*light, wish, news);
    return [] {};
  };
}

void GatheredFrame3::take(std::vector<PixelTile3> tiles, std::size_t pixels) {
  for (PixelTile3& tile : tiles) {
    done_ += static_cast<double>(std::size_t{tile.pixels.width} * tile.pixels.height) / static_cast<double>(pixels);
    tiles_.push_back(std::move(tile));
  }
}

void GatheredFrame3::draw(const ToneCurve& tone, Raster& frame) const {
  for (const PixelTile3& tile : tiles_)
    for (std::uint32_t y = 0; y < tile.pixels.height; ++y)
      for (std::uint32_t x = 0; x < tile.pixels.width; ++x)
        frame.pixels[std::size_t{tile.top + y} * frame.width + tile.left + x] =
            pixel_of_levels(tone.near_levels(tile.pixels.at(x, y)));
}

}  // namespace hottel
