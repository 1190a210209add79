#include "benchmarks/reports/space/full_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "geometry/space/exchange/event_surfaces.h"
#include "geometry/space/visibility/direction.h"
#include "kernel/support/parallel.h"
#include "solver/space/light/scene_lights.h"

namespace hottel {
namespace {

constexpr double kStep = 0.25;  // of a pixel, along lines that are marked

// The faces that emit.
std::set<Face> emitting_faces(const ElementTable3& table, const RadiositySolution& solution) {
  std::set<Face> result;
  for (const ChannelSolution& channel : solution.channels)
    for (std::size_t i = 0; i < channel.elements.size(); ++i)
      if (channel.elements[i].emission > 0) result.insert({table.elements()[i].surface, table.elements()[i].is_back});
  return result;
}

Direction3 way_to(const Point3& eye, const std::array<double, 3>& place) {
  return {place[0] - to_double(eye.x), place[1] - to_double(eye.y), place[2] - to_double(eye.z)};
}

}  // namespace

FullSampling3::FullSampling3(const GatheredScene3& scene, const Camera3& camera)
    : scene_(scene), camera_(camera), projection_(camera), seen_(seen_sides_3(scene.prepared, camera)) {
  const std::vector<std::optional<std::uint32_t>> element = elements_of_sides_3(scene.prepared, scene.table);
  for (const SeenSide3& seen : seen_) {
    planes_.emplace_back(scene.prepared, seen.side, camera.eye);
    elements_.push_back(element[seen.side.number()]);
  }
}

std::vector<FullSampling3::Sample> FullSampling3::samples(std::span<const std::uint32_t> pixels,
                                                          std::uint32_t across) const {
  const std::size_t nowhere = pixels.size();
  std::vector<std::size_t> place(std::size_t{camera_.width} * camera_.height, nowhere);
  for (std::size_t k = 0; k < pixels.size(); ++k) place[pixels[k]] = k;
  std::vector<Sample> result;
  const double scale = across;
  for (std::uint32_t k = 0; k < seen_.size(); ++k) {
    for_each_covered_pixel(seen_[k].outline, camera_.width, camera_.height, [&](const PixelCover3& whole) {
      const std::size_t own = place[std::size_t{whole.y} * camera_.width + whole.x];
      if (own == nowhere || !(whole.part > 0)) return;
      const double x = whole.x, y = whole.y;
      PixelPolygon wide = common_polygon_3({{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}, seen_[k].outline);
      for (Pixel& p : wide) p = {scale * (p.x - x), scale * (p.y - y)};
      for_each_covered_pixel(wide, across, across, [&](const PixelCover3& cover) {
        if (!(cover.part > 0)) return;
        const Pixel at{x + cover.middle.x / scale, y + cover.middle.y / scale};
        result.push_back({own, k, cover.part / (scale * scale), at});
      });
    });
  }
  return result;
}

Point3 FullSampling3::point(const Sample& sample) const {
  const SidePlane3& plane = planes_[sample.seen];
  return plane.point(plane.way(projection_.direction(sample.at)));
}

std::vector<double> FullSampling3::irradiance(const Sample& sample) const {
  std::vector<double> result(scene_.light.channels());
  scene_.light.irradiance(point(sample), seen_[sample.seen].side, result);
  return result;
}

std::vector<double> FullSampling3::values(std::span<const std::uint32_t> pixels, std::uint32_t across,
                                          std::uint32_t lights_across) const {
  const std::size_t channels = scene_.responses.channels;
  std::vector<double> result(pixels.size() * channels, 0), left(pixels.size(), 1), value(channels), nothing(channels);
  const auto add_all = [&](const std::vector<Sample>& all, const auto& light_at, bool has_constant) {
    std::vector<std::vector<double>> light(all.size());
    parallel_for(
        all.size(), [&](std::size_t k) { light[k] = light_at(all[k]); }, 4);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::uint32_t element = *elements_[all[k].seen];
      scene_.responses.value(element, light[k], value);
      if (!has_constant) {
        scene_.responses.value(element, std::vector<double>(light[k].size(), 0), nothing);
        for (std::size_t c = 0; c < channels; ++c) value[c] -= nothing[c];
      }
      for (std::size_t c = 0; c < channels; ++c) result[all[k].place * channels + c] += all[k].part * value[c];
    }
  };
  std::vector<Sample> lit;
  for (const Sample& sample : samples(pixels, across)) {
    left[sample.place] -= sample.part;
    if (elements_[sample.seen])
      lit.push_back(sample);
    else
      for (std::size_t c = 0; c < channels; ++c)
        result[sample.place * channels + c] += sample.part * scene_.paint.black[c];
  }
  add_all(
      lit, [this](const Sample& sample) { return irradiance(sample); }, true);
  for (std::size_t k = 0; k < pixels.size(); ++k)
    for (std::size_t c = 0; c < channels; ++c) result[k * channels + c] += std::max(0.0, left[k]) * scene_.paint.sky[c];
  if (scene_.lights == nullptr || scene_.lights->lamps().empty()) return result;
  std::vector<Sample> by_lamps = samples(pixels, lights_across);
  std::erase_if(by_lamps, [this](const Sample& sample) { return !elements_[sample.seen]; });
  const auto direct = [this](const Sample& sample) {
    std::vector<double> sum(scene_.light.channels());
    scene_.lights->add(point(sample), normal_of_side_3(scene_.prepared.occluders(), seen_[sample.seen].side), sum);
    return sum;
  };
  add_all(by_lamps, direct, false);
  return result;
}

std::vector<PixelBorders3> FullSampling3::borders(const RadiositySolution& solution,
                                                  std::uint32_t lights_across) const {
  std::vector<PixelBorders3> result(std::size_t{camera_.width} * camera_.height);
  mark_edges(result);
  mark_shadows(lights_across, result);
  mark_events(solution, result);
  return result;
}

// What one side has of a pixel may be cut into several polygons: no edge is between these.
void FullSampling3::mark_edges(std::vector<PixelBorders3>& result) const {
  std::vector<double> of_side(result.size());
  std::vector<std::uint32_t> touched;
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    for_each_covered_pixel(seen_[k].outline, camera_.width, camera_.height, [&](const PixelCover3& cover) {
      const std::uint32_t pixel = cover.y * camera_.width + cover.x;
      of_side[pixel] += cover.part;
      touched.push_back(pixel);
    });
    if (k + 1 < seen_.size() && seen_[k + 1].side == seen_[k].side) continue;
    for (const std::uint32_t pixel : touched) {
      const double part = std::exchange(of_side[pixel], 0);
      if (part > 1e-9 && part < 1 - 1e-9) result[pixel].has_edge = true;
    }
    touched.clear();
  }
}

void FullSampling3::mark_shadows(std::uint32_t across, std::vector<PixelBorders3>& result) const {
  if (scene_.lights == nullptr || scene_.lights->lamps().empty()) return;
  std::vector<std::uint32_t> all;
  for (std::uint32_t k = 0; k < result.size(); ++k) all.push_back(k);
  const std::vector<Sample> points = samples(all, across);
  for (const SceneLights3::Lamp& lamp : scene_.lights->lamps()) {
    std::vector<char> is_lit(points.size());
    parallel_for(
        points.size(),
        [&](std::size_t k) {
          const Vector3 normal = normal_of_side_3(scene_.prepared.occluders(), seen_[points[k].seen].side);
          is_lit[k] = lamp.light->irradiance(point(points[k]), normal) > 0 ? 1 : 0;
        },
        64);
    std::map<std::pair<std::size_t, std::uint32_t>, std::array<bool, 2>> found;  // dark, lit; by pixel and side
    for (std::size_t k = 0; k < points.size(); ++k)
      found[{points[k].place, seen_[points[k].seen].side.number()}][static_cast<std::size_t>(is_lit[k])] = true;
    for (const auto& [key, seen] : found)
      if (seen[0] && seen[1]) result[key.first].has_shadow = true;
  }
}

void FullSampling3::mark_events(const RadiositySolution& solution, std::vector<PixelBorders3>& result) const {
  const std::set<Face> emitting = emitting_faces(scene_.table, solution);
  std::map<Face, std::set<std::uint32_t>> pixels_of;  // of faces that are seen
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    if (!elements_[k]) continue;
    const Element& element = scene_.table.elements()[*elements_[k]];
    std::set<std::uint32_t>& own = pixels_of[{element.surface, element.is_back}];
    for_each_covered_pixel(seen_[k].outline, camera_.width, camera_.height,
                           [&](const PixelCover3& cover) { own.insert(cover.y * camera_.width + cover.x); });
  }
  const auto mark = [&](const std::set<std::uint32_t>& own, const std::array<double, 3>& a,
                        const std::array<double, 3>& b) {
    const auto line = projection_.line(way_to(camera_.eye, a), way_to(camera_.eye, b));
    if (!line) return;
    const double far = std::hypot((*line)[1].x - (*line)[0].x, (*line)[1].y - (*line)[0].y);
    const auto steps = static_cast<std::size_t>(std::ceil(far / kStep)) + 1;
    for (std::size_t k = 0; k <= steps; ++k) {
      const Pixel p = place_between_3((*line)[0], (*line)[1], static_cast<double>(k) / static_cast<double>(steps));
      if (!(p.x >= 0 && p.y >= 0 && p.x < camera_.width && p.y < camera_.height)) continue;
      const std::uint32_t pixel = static_cast<std::uint32_t>(p.y) * camera_.width + static_cast<std::uint32_t>(p.x);
      if (own.contains(pixel)) result[pixel].has_event = true;
    }
  };
  for (const Face& from : emitting)
    for (const auto& [to, own] : pixels_of) {
      if (from == to) continue;
      for (const EventSurface3& event : event_surfaces(scene_.prepared, from, to))
        for (std::size_t k = 1; k < event.rulings.size(); ++k)
          mark(own, event.rulings[k - 1].on_to, event.rulings[k].on_to);
    }
}

}  // namespace hottel
