#include "viewer/picture/space/gathered_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/space/visibility/convex_cut.h"
#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "viewer/picture/space/pixel_painter.h"
#include "viewer/picture/space/projection.h"
#include "viewer/picture/space/seen_sides.h"
#include "viewer/picture/space/side_plane.h"

namespace hottel {
namespace {

constexpr double kFirstCell = 16, kLeastCell = 1;  // pixels
// How far points around and in the middle of a cell may be off, of what a picture may be: halfway between them it is a
// quarter of that where light bends evenly. Points there are asked whether it is.
constexpr double kMostAround = 2, kMostBetween = 0.5;
constexpr double kInward = 1e-4;  // how far points are moved to the middle of what is seen, off edges of the scene
constexpr double kSamePlace = 0x1p-20;  // pixels

// A side that is seen, ready to be asked for points of it.
struct SeenPlane {
  PixelPolygon outline;
  Pixel middle;
  Face side;
  std::optional<std::uint32_t> element;  // whose response its points have; nothing: it is black
  SidePlane3 plane;
};

std::vector<SeenPlane> seen_of(const GatheredScene3& scene, const Camera3& camera) {
  const std::vector<std::optional<std::uint32_t>> element = elements_of_sides_3(scene.prepared, scene.table);
  std::vector<SeenPlane> result;
  for (SeenSide3& seen : seen_sides_3(scene.prepared, camera)) {
    const Pixel middle = middle_of_corners_3(seen.outline);
    result.push_back({std::move(seen.outline), middle, seen.side, element[seen.side.number()],
                      SidePlane3(scene.prepared, seen.side, camera.eye)});
  }
  return result;
}

// Points of sides, each asked for once.
class GatheredPoints {
 public:
  GatheredPoints(const GatheredScene3& scene, const std::vector<SeenPlane>& seen, const Projection3& projection)
      : scene_(scene), seen_(seen), projection_(projection), channels_(scene.responses.channels) {}

  // The number of the point of a side that is seen at a place.
  std::uint32_t at(std::uint32_t seen, const Pixel& place) {
    const Key key{seen, std::llround(place.x / kSamePlace), std::llround(place.y / kSamePlace)};
    const auto [known, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(places_.size()));
    if (is_new) places_.push_back({seen, place});
    return known->second;
  }

  // Gathers at those that are new.
  void gather() {
    const std::size_t first = ways_.size();
    ways_.resize(places_.size());
    values_.resize(places_.size() * channels_);
    parallel_for(
        places_.size() - first, [&](std::size_t k) { gather(first + k); }, 4);
  }

  std::size_t size() const { return places_.size(); }
  const Pixel& place(std::uint32_t point) const { return places_[point].at; }
  const Direction3& way(std::uint32_t point) const { return ways_[point]; }
  std::span<const double> value(std::uint32_t point) const {
    return std::span(values_).subspan(point * channels_, channels_);
  }

 private:
  using Key = std::array<std::int64_t, 3>;
  struct Place {
    std::uint32_t seen;
    Pixel at;
  };

  void gather(std::size_t k) {
    throw_if_interrupted();
    const SeenPlane& seen = seen_[places_[k].seen];
    const Pixel inner = place_between_3(places_[k].at, seen.middle, kInward);
    ways_[k] = seen.plane.way(projection_.direction(places_[k].at));
    std::vector<double> irradiance(scene_.light.channels());
    const Point3 point = seen.plane.point(seen.plane.way(projection_.direction(inner)));
    scene_.light.irradiance(point, seen.side, irradiance);
    if (scene_.lights != nullptr)
      scene_.lights->add(point, normal_of_side_3(scene_.prepared.occluders(), seen.side), irradiance);
    scene_.responses.value(*seen.element, irradiance, std::span(values_).subspan(k * channels_, channels_));
  }

  const GatheredScene3& scene_;
  const std::vector<SeenPlane>& seen_;
  const Projection3& projection_;
  std::size_t channels_;
  std::map<Key, std::uint32_t> known_;
  std::vector<Place> places_;
  std::vector<Direction3> ways_;
  std::vector<double> values_;
};

// A part of a side that is seen, within a rectangle of pixels.
struct SeenCell {
  std::uint32_t seen;
  PixelPolygon outline;
  Pixel low, high;

  bool is_wide() const { return high.x - low.x > high.y - low.y; }
  double longer() const { return std::max(high.x - low.x, high.y - low.y); }
  // How far a place is beyond the line that halves the rectangle.
  double beyond(const Pixel& p) const { return is_wide() ? p.x - (low.x + high.x) / 2 : p.y - (low.y + high.y) / 2; }

  SeenCell half(bool is_beyond) const {
    SeenCell result = *this;
    const double sign = is_beyond ? 1 : -1;
    result.outline = cut_convex(
        outline, [&](const Pixel& p) { return sign * beyond(p); }, place_between_3);
    if (is_wide())
      (is_beyond ? result.low : result.high).x = (low.x + high.x) / 2;
    else
      (is_beyond ? result.low : result.high).y = (low.y + high.y) / 2;
    return result;
  }
};

// The points of a cell: around it, each corner followed by a point on the side that begins there, and one in the
// middle.
struct Fan {
  std::vector<std::uint32_t> ring;
  std::optional<std::array<std::size_t, 2>> ends;  // of the line that halves the cell, in the ring: its middle is that
  std::uint32_t middle = 0;
  std::vector<std::uint32_t> spokes;  // halfway between the middle and each corner; none where the cell is not wide
};

class GatheredView {
 public:
  GatheredView(const GatheredScene3& scene, const Camera3& camera, const StepsBetween3& steps_between,
               double most_steps)
      : scene_(scene),
        camera_(camera),
        steps_between_(steps_between),
        most_steps_(most_steps),
        projection_(camera),
        seen_(seen_of(scene, camera)),
        points_(scene, seen_, projection_),
        painter_(scene.paint, camera) {}

  Gathering3 run(const std::function<void(double)>& progress) {
    double done = 0, share = 0.5;  // each round takes about half of what is left
    for (std::vector<SeenCell> cells = first_cells(); !cells.empty(); share /= 2) {
      cells = refine(std::move(cells));
      done += share;
      if (progress) progress(done);
    }
    return {painter_.finished(), points_.size()};
  }

  void run_tiles(const std::function<void(PixelTile3)>& take) {
    std::vector<std::vector<SeenCell>> tiles(std::size_t{tiles_across()} * tiles_down());
    for (SeenCell& cell : first_cells()) tiles[tile_of(cell)].push_back(std::move(cell));
    for (const std::size_t tile : tiles_from_the_middle()) {
      for (std::vector<SeenCell> cells = std::move(tiles[tile]); !cells.empty();) cells = refine(std::move(cells));
      const std::uint32_t left = static_cast<std::uint32_t>(tile % tiles_across()) * kTileSide;
      const std::uint32_t top = static_cast<std::uint32_t>(tile / tiles_across()) * kTileSide;
      take({left, top, painter_.finished(left, top, kTileSide)});
    }
  }

 private:
  static constexpr std::uint32_t kTileSide = 64;  // a multiple of the side of a first cell

  std::uint32_t tiles_across() const { return (camera_.width + kTileSide - 1) / kTileSide; }
  std::uint32_t tiles_down() const { return (camera_.height + kTileSide - 1) / kTileSide; }

  std::size_t tile_of(const SeenCell& cell) const {
    const auto x = static_cast<std::uint32_t>(cell.low.x) / kTileSide;
    const auto y = static_cast<std::uint32_t>(cell.low.y) / kTileSide;
    return std::size_t{std::min(y, tiles_down() - 1)} * tiles_across() + std::min(x, tiles_across() - 1);
  }

  std::vector<std::size_t> tiles_from_the_middle() const {
    std::vector<std::pair<double, std::size_t>> far;
    for (std::size_t k = 0; k < std::size_t{tiles_across()} * tiles_down(); ++k) {
      const double x = static_cast<double>(k % tiles_across()), y = static_cast<double>(k / tiles_across());
      far.emplace_back(std::hypot(x - (tiles_across() - 1) / 2.0, y - (tiles_down() - 1) / 2.0), k);
    }
    std::ranges::sort(far);
    std::vector<std::size_t> result;
    for (const auto& [distance, tile] : far) result.push_back(tile);
    return result;
  }

  std::vector<SeenCell> first_cells() {
    std::vector<SeenCell> result;
    const double side = std::exp2(std::ceil(same_bits::log2(std::max(camera_.width, camera_.height))));
    for (std::uint32_t k = 0; k < seen_.size(); ++k) {
      if (seen_[k].element)
        add_cells({k, seen_[k].outline, {0, 0}, {side, side}}, result);
      else
        painter_.add(SeenPart3{seen_[k].outline, std::nullopt, nullptr, {}});
    }
    return result;
  }

  void add_cells(const SeenCell& cell, std::vector<SeenCell>& result) const {
    if (std::fabs(pixel_area_doubled_3(cell.outline)) < kLeastArea) return;
    if (cell.longer() <= kFirstCell) return result.push_back(cell);
    for (const bool is_beyond : {false, true})
      if (SeenCell half = cell.half(is_beyond); half.outline.size() > 2) add_cells(half, result);
  }

  // Draws the cells that are told well by their points, and returns the halves of the others.
  std::vector<SeenCell> refine(std::vector<SeenCell> cells) {
    std::vector<Fan> fans;
    for (SeenCell& cell : cells) fans.push_back(fan_of(cell));
    points_.gather();
    const auto is_least = [&cells](std::size_t k) { return cells[k].longer() <= kLeastCell; };
    std::vector<char> is_told(cells.size());
    for (std::size_t k = 0; k < cells.size(); ++k) {
      is_told[k] = is_least(k) || off(fans[k]) <= kMostAround * most_steps_;
      if (is_told[k] && !is_least(k)) add_spokes(cells[k].seen, fans[k]);
    }
    points_.gather();
    std::vector<SeenCell> rest;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (is_told[k] && (is_least(k) || off_between(fans[k]) <= kMostBetween * most_steps_)) {
        draw(fans[k]);
        continue;
      }
      for (const bool is_beyond : {false, true})
        if (SeenCell half = cells[k].half(is_beyond); std::fabs(pixel_area_doubled_3(half.outline)) >= kLeastArea)
          rest.push_back(std::move(half));
    }
    return rest;
  }

  void add_spokes(std::uint32_t seen, Fan& fan) {
    for (std::size_t k = 0; k < fan.ring.size(); k += 2) {
      const Pixel middle = points_.place(fan.middle), corner = points_.place(fan.ring[k]);
      fan.spokes.push_back(points_.at(seen, place_between_3(middle, corner, 0.5)));
    }
  }

  // Makes the rectangle smaller until the line that halves it meets the outline.
  Fan fan_of(SeenCell& cell) {
    const auto all = [&cell](double sign) {
      return std::ranges::all_of(cell.outline, [&](const Pixel& p) { return sign * cell.beyond(p) >= 0; });
    };
    while (cell.longer() > kLeastCell && (all(1) || all(-1))) cell = cell.half(all(1));
    Fan fan;
    std::vector<std::size_t> ends;
    for (std::size_t k = 0; k < cell.outline.size(); ++k) {
      const Pixel &a = cell.outline[k], &b = cell.outline[k + 1 == cell.outline.size() ? 0 : k + 1];
      const double at_a = cell.beyond(a), at_b = cell.beyond(b);
      const bool is_halved = at_a * at_b < 0;
      if (is_halved) ends.push_back(fan.ring.size() + 1);
      fan.ring.push_back(points_.at(cell.seen, a));
      fan.ring.push_back(points_.at(cell.seen, place_between_3(a, b, is_halved ? at_a / (at_a - at_b) : 0.5)));
    }
    Pixel middle = middle_of_corners_3(cell.outline);
    if (ends.size() == 2) {
      fan.ends = {ends[0], ends[1]};
      middle = place_between_3(points_.place(fan.ring[ends[0]]), points_.place(fan.ring[ends[1]]), 0.5);
    }
    fan.middle = points_.at(cell.seen, middle);
    return fan;
  }

  // How far points are from what those on both sides of them say.
  double off(const Fan& fan) const {
    double most = 0;
    const std::size_t n = fan.ring.size();
    for (std::size_t k = 1; k < n; k += 2)
      most = std::max(most, off(fan.ring[k], fan.ring[k - 1], fan.ring[(k + 1) % n]));
    if (fan.ends) return std::max(most, off(fan.middle, fan.ring[(*fan.ends)[0]], fan.ring[(*fan.ends)[1]]));
    for (const std::uint32_t corner : fan.ring)
      most = std::max(most, steps_between(points_.value(fan.middle), points_.value(corner)));
    return most;
  }

  // The same of what is halfway between the middle and the corners.
  double off_between(const Fan& fan) const {
    double most = 0;
    for (std::size_t k = 0; k < fan.spokes.size(); ++k)
      most = std::max(most, off(fan.spokes[k], fan.middle, fan.ring[2 * k]));
    return most;
  }

  // The same of a point on the straight line between two others, by how far it is from each.
  double off(std::uint32_t point, std::uint32_t a, std::uint32_t b) const {
    const double to_a = length(points_.way(point) - points_.way(a)), to_b = length(points_.way(point) - points_.way(b));
    const double share = to_a + to_b > 0 ? to_a / (to_a + to_b) : 0;
    std::vector<double> told;
    for (std::size_t c = 0; c < scene_.responses.channels; ++c)
      told.push_back(std::lerp(points_.value(a)[c], points_.value(b)[c], share));
    return steps_between(points_.value(point), told);
  }

  double steps_between(std::span<const double> a, std::span<const double> b) const {
    std::vector<double> shown_a(scene_.paint.shown_channels()), shown_b(shown_a.size());
    scene_.paint.show(a, shown_a);
    scene_.paint.show(b, shown_b);
    return steps_between_(shown_a, shown_b);
  }

  void draw(const Fan& fan) {
    const std::size_t n = fan.ring.size();
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint32_t from = fan.ring[k], to = fan.ring[(k + 1) % n];
      if (fan.spokes.empty()) {
        draw({fan.middle, from, to});
        continue;
      }
      const bool is_corner = k % 2 == 0;
      const std::uint32_t spoke = fan.spokes[is_corner ? k / 2 : (k + 1) % n / 2];
      draw({fan.middle, is_corner ? spoke : from, is_corner ? to : spoke});
      draw({spoke, from, to});
    }
  }

  void draw(const std::array<std::uint32_t, 3>& corners) {
    const PixelPolygon outline{points_.place(corners[0]), points_.place(corners[1]), points_.place(corners[2])};
    if (std::fabs(pixel_area_doubled_3(outline)) < kLeastArea) return;
    const Shade3 shade(projection_, {points_.way(corners[0]), points_.way(corners[1]), points_.way(corners[2])},
                       {points_.value(corners[0]), points_.value(corners[1]), points_.value(corners[2])});
    painter_.add_blended(outline, shade);
  }

  static constexpr double kLeastArea = 1e-9;  // square pixels

  const GatheredScene3& scene_;
  const Camera3& camera_;
  const StepsBetween3& steps_between_;
  double most_steps_;
  Projection3 projection_;
  std::vector<SeenPlane> seen_;
  GatheredPoints points_;
  PixelPainter3 painter_;
};

}  // namespace

double steps_between_3(const Colour& a, const Colour& b) {
  return 255 * std::max({std::fabs(a.r - b.r), std::fabs(a.g - b.g), std::fabs(a.b - b.b)});
}

double sent_by_itself_3(const ElementRadiosity& element) {
  return element.reflectivity == 1 && element.emission == 0 ? element.net_value : element.emission;
}

void Responses3::value(std::uint32_t element, std::span<const double> irradiance, std::span<double> result) const {
  for (std::size_t c = 0; c < channels; ++c) {
    const std::size_t place = element * channels + c;
    result[c] = constant[place];
    for (std::size_t k = 0; k < of_light; ++k) result[c] += per_irradiance[place * of_light + k] * irradiance[k];
  }
}

Responses3 light_responses_3(const RadiositySolution& solution) {
  Responses3 result{.channels = solution.channels.size() == 2 ? 1 : solution.channels.size(),
                    .of_light = solution.channels.size(),
                    .constant = {},
                    .per_irradiance = {}};
  for (std::size_t i = 0; i < solution.channels[0].elements.size(); ++i)
    for (std::size_t c = 0; c < result.channels; ++c) {
      result.constant.push_back(sent_by_itself_3(solution.channels[c].elements[i]));
      for (std::size_t k = 0; k < result.of_light; ++k)
        result.per_irradiance.push_back(k == c ? solution.channels[c].elements[i].reflectivity : 0);
    }
  return result;
}

Responses3 irradiance_responses_3(const RadiositySolution& solution) {
  const std::size_t channels = solution.channels.size(), elements = solution.channels[0].elements.size();
  Responses3 result{.channels = channels,
                    .of_light = channels,
                    .constant = std::vector<double>(elements * channels, 0),
                    .per_irradiance = std::vector<double>(elements * channels * channels, 0)};
  for (std::size_t k = 0; k < elements * channels; ++k) result.per_irradiance[k * channels + k % channels] = 1;
  return result;
}

void require_gathered_3(const Shown& shown) {
  switch (shown.quantity) {
    case Quantity::kLight:
    case Quantity::kRadiosity:
    case Quantity::kIrradiance:
    case Quantity::kNet:
      return;
    case Quantity::kTemperature:
    case Quantity::kFactor:
      break;
  }
  throw UsageError("light, radiosity, irradiance and net are gathered: temperatures and factors are of elements");
}

Responses3 responses_3(const Shown& shown, const RadiositySolution& solution) {
  require_gathered_3(shown);
  if (shown.is_light()) return light_responses_3(solution);
  const bool is_irradiance = shown.quantity == Quantity::kIrradiance, is_net = shown.quantity == Quantity::kNet;
  HOTTEL_REQUIRE(is_irradiance || is_net || shown.quantity == Quantity::kRadiosity);
  Responses3 result{.channels = 1, .of_light = solution.channels.size(), .constant = {}, .per_irradiance = {}};
  for (std::size_t i = 0; i < solution.channels[0].elements.size(); ++i) {
    double constant = 0;
    for (std::size_t c = 0; c < result.of_light; ++c) {
      const ElementRadiosity& element = solution.channels[c].elements[i];
      const double weight = shown.channel ? (*shown.channel == c ? 1 : 0) : result.of_light == 3 ? 1.0 / 3 : 1;
      constant += is_irradiance ? 0 : weight * sent_by_itself_3(element);
      result.per_irradiance.push_back(weight * (is_irradiance ? 1 : element.reflectivity - (is_net ? 1 : 0)));
    }
    result.constant.push_back(constant);
  }
  return result;
}

Gathering3 gathered_view_3(const GatheredScene3& scene, const Camera3& camera, const StepsBetween3& steps_between,
                           double most_steps, const std::function<void(double)>& progress) {
  return GatheredView(scene, camera, steps_between, most_steps).run(progress);
}

void gathered_tiles_3(const GatheredScene3& scene, const Camera3& camera, const StepsBetween3& steps_between,
                      double most_steps, const std::function<void(PixelTile3)>& take) {
  GatheredView(scene, camera, steps_between, most_steps).run_tiles(take);
}

}  // namespace hottel
