#include "benchmarks/reports/space/gathered_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <span>

#include "kernel/support/stopwatch.h"
#include "solver/space/light/scene_lights.h"
#include "viewer/picture/space/gathered_source.h"
#include "viewer/picture/space/render_picture.h"

namespace hottel {
namespace {

// Points across a pixel, of gathered and of direct light.
struct Across {
  std::uint32_t points, of_lights;
};
constexpr Across kPlain{1, 4}, kWithBorder{3, 16}, kAgain{6, 16}, kLightsAgain{6, 64};
constexpr double kStepsAgain = 0.5, kPartAgain = 0.002;
constexpr double kDark = 1e-6;  // of the largest radiosity: what is less counts as that

// So many different numbers of 0, 1, ..., in ascending order; all, where there are no more.
std::vector<std::uint32_t> drawn(std::vector<std::uint32_t> from, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (std::size_t k = 0; k < std::min(count, from.size()); ++k)
    std::swap(from[k], from[k + random() % (from.size() - k)]);
  from.resize(std::min(count, from.size()));
  std::ranges::sort(from);
  return from;
}

class Checker {
 public:
  Checker(const Simulation3& simulation, const GatheredSample3& sample)
      : sample_(sample),
        solution_(simulation.radiosities()),
        prepared_(simulation.prepared()),
        shares_(simulation.light_shares()),
        paint_(light_paint_3(prepared_->scene, *solution_)),
        source_(*prepared_, simulation.request().factors.granularity, *solution_, light_responses_3(*solution_),
                *shares_),
        lights_(*prepared_),
        granularity_(simulation.request().factors.granularity),
        full_(source_.scene(paint_, &lights_), camera_of_scene(*prepared_, sample.width)) {}

  GatheredCheck3 run() {
    GatheredCheck3 result;
    Stopwatch watch;
    const RenderedView3 picture = view(false);
    result.seconds_of_picture = watch.lap();
    const RenderedView3 numbers = view(true);
    result.picture = picture.pixels();
    watch.lap();
    borders_ = full_.borders(*solution_, kPlain.of_lights);
    choose(result);
    const auto is_off = [](const GatheredPixel3& pixel) {
      return pixel.steps > kStepsAgain || pixel.part > kPartAgain;
    };
    add(result, picture, numbers, kPlain, [](const GatheredPixel3& pixel) { return !pixel.borders.any(); });
    add(result, picture, numbers, kWithBorder, [](const GatheredPixel3& pixel) { return pixel.borders.any(); });
    add(result, picture, numbers, kAgain, is_off);
    if (!lights_.lamps().empty())
      add(result, picture, numbers, kLightsAgain,
          [](const GatheredPixel3& pixel) { return pixel.steps > kStepsAgain; });
    result.seconds_of_sampling = watch.lap();
    return result;
  }

 private:
  RenderedView3 view(bool is_for_numbers) const {
    RenderOptions3 options;
    options.wanted_width = sample_.width;
    options.shading = Shading::kGathered;
    options.light_shares = shares_;
    options.is_for_numbers = is_for_numbers;
    return {*prepared_, granularity_, *solution_, options};
  }

  void choose(GatheredCheck3& result) const {
    std::vector<std::uint32_t> all, with_border;
    for (std::uint32_t k = 0; k < borders_.size(); ++k) {
      all.push_back(k);
      if (borders_[k].any()) with_border.push_back(k);
    }
    result.all_borders = with_border.size();
    const std::vector<std::uint32_t> of_all = drawn(all, sample_.pixels, sample_.seed);
    const std::vector<std::uint32_t> of_borders = drawn(with_border, sample_.borders, sample_.seed + 1);
    std::vector<std::uint32_t> both;
    std::ranges::set_union(of_all, of_borders, std::back_inserter(both));
    const std::uint32_t width = full_.camera().width;
    for (const std::uint32_t k : both)
      result.pixels.push_back({k % width, k / width, std::ranges::binary_search(of_all, k), borders_[k], 0, 0});
  }

  // Samples those of the pixels that are meant.
  template <class IsMeant>
  void add(GatheredCheck3& result, const RenderedView3& picture, const RenderedView3& numbers, const Across& across,
           const IsMeant& is_meant) const {
    std::vector<GatheredPixel3*> meant;
    std::vector<std::uint32_t> places;
    for (GatheredPixel3& pixel : result.pixels) {
      if (!is_meant(pixel)) continue;
      meant.push_back(&pixel);
      places.push_back(pixel.y * full_.camera().width + pixel.x);
    }
    const std::vector<double> values = full_.values(places, across.points, across.of_lights);
    const std::size_t channels = paint_.shown_channels();
    for (std::size_t k = 0; k < meant.size(); ++k)
      compare(*meant[k], picture, numbers, std::span(values).subspan(k * channels, channels));
  }

  void compare(GatheredPixel3& pixel, const RenderedView3& picture, const RenderedView3& numbers,
               std::span<const double> value) const {
    pixel.steps = steps_between_3(picture.tone()(picture.pixels().at(pixel.x, pixel.y)), picture.tone()(value));
    pixel.part = 0;
    const std::span<const double> number = numbers.pixels().at(pixel.x, pixel.y);
    const double least = std::max(kDark * largest_radiosity(*solution_), std::numeric_limits<double>::min());
    for (std::size_t c = 0; c < value.size(); ++c)
      pixel.part = std::max(pixel.part, std::fabs(number[c] - value[c]) / std::max({number[c], value[c], least}));
  }

  GatheredSample3 sample_;
  std::shared_ptr<const RadiositySolution> solution_;
  std::shared_ptr<const PreparedScene3> prepared_;
  std::shared_ptr<const std::vector<LightShares>> shares_;
  ElementPaint3 paint_;
  GatheredSource3 source_;
  SceneLights3 lights_;
  Granularity granularity_;
  FullSampling3 full_;
  std::vector<PixelBorders3> borders_;
};

}  // namespace

GatheredCheck3 check_gathered_3(const Simulation3& simulation, const GatheredSample3& sample) {
  return Checker(simulation, sample).run();
}

}  // namespace hottel
