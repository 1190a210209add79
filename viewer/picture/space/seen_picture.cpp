#include "viewer/picture/space/seen_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/space/pixel_painter.h"

namespace hottel {
namespace {

constexpr std::uint32_t kRowsAtOnce = 8;   // so that their values stay in the cache
constexpr double kLeastPickedArea = 1e-9;  // square pixels, of what can be pointed at

// False for a polygon without an area.
bool holds(const PixelPolygon& polygon, const Pixel& at) {
  const double area = pixel_area_doubled_3(polygon);
  if (std::fabs(area) < kLeastPickedArea) return false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Pixel &a = polygon[k], &b = polygon[k + 1 == polygon.size() ? 0 : k + 1];
    const double side = (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
    if (area > 0 ? side < 0 : side > 0) return false;
  }
  return true;
}

}  // namespace

SeenPicture3::SeenPicture3(const SeenScene3& scene, const Camera3& camera)
    : paint_(scene.paint), width_(camera.width), height_(camera.height) {
  for_each_seen_part(scene, camera, [this](const SeenPart3& part) {
    parts_.push_back(
        {part.outline, part.element, part.shade ? std::optional(*part.shade) : std::nullopt, part.corners});
  });
}

bool SeenPicture3::show(const ElementPaint3& paint, const SmoothMesh3* mesh) {
  if (paint.channels != paint_.channels || paint.values.size() != paint_.values.size()) return false;
  for (std::size_t k = 0; k < paint.values.size(); k += paint.channels)
    if (std::isnan(paint.values[k]) != std::isnan(paint_.values[k])) return false;
  const std::vector<double> at_corners =
      mesh == nullptr ? std::vector<double>() : mesh->at_corners(paint.values, paint.channels);
  const auto at_corner = [&](std::uint32_t corner) {
    return std::span<const double>(at_corners).subspan(corner * paint.channels, paint.channels);
  };
  for (Part& part : parts_) {
    if (!part.shade) continue;
    HOTTEL_REQUIRE(mesh != nullptr);
    part.shade->set({paint.value(*part.element), at_corner(part.corners[0]), at_corner(part.corners[1])});
  }
  paint_ = paint;
  if (covers_.empty()) keep_covers();
  return true;
}

std::size_t SeenPicture3::blocks() const { return (height_ + kRowsAtOnce - 1) / kRowsAtOnce; }

PixelRows3 SeenPicture3::rows_of(std::size_t block) const {
  const auto begin = static_cast<std::uint32_t>(block) * kRowsAtOnce;
  return {begin, std::min(begin + kRowsAtOnce, height_)};
}

// The calls of for_each_covered_pixel, written down.
void SeenPicture3::keep_covers() {
  std::vector<Covers> all(blocks());
  parallel_for(all.size(), [&](std::size_t block) {
    Covers& covers = all[block];
    for (std::uint32_t k = 0; k < parts_.size(); ++k) {
      const auto starts_anew = [&](std::uint32_t y) {
        return covers.runs.empty() || covers.runs.back().part != k || covers.rows.back() != y;
      };
      for_each_covered_pixel(parts_[k].outline, width_, rows_of(block), [&](const PixelCover3& cover) {
        const bool is_whole = cover.part == 1 && cover.middle.x == cover.x + 0.5 && cover.middle.y == cover.y + 0.5;
        // Those at a border come before those that are covered wholly, in each run.
        if (starts_anew(cover.y) || (!is_whole && covers.runs.back().whole > 0)) {
          covers.runs.push_back({k, 0, 0, 0});
          covers.rows.push_back(cover.y);
        }
        Run& run = covers.runs.back();
        if (!is_whole) {
          ++run.at_border;
          covers.at_border.push_back(cover);
        } else if (run.whole++ == 0) {
          run.x = cover.x;
        }
      });
    }
  });
  covers_ = std::move(all);
}

template <class Paint>
void SeenPicture3::for_each_part(std::size_t block, const Paint& paint) const {
  if (covers_.empty()) {
    for (const Part& part : parts_)
      paint(part, [&](const auto& take) { for_each_covered_pixel(part.outline, width_, rows_of(block), take); });
    return;
  }
  const Covers& covers = covers_[block];
  const PixelCover3* at_border = covers.at_border.data();
  for (std::size_t first = 0, end = 0; first < covers.runs.size(); first = end) {
    while (end < covers.runs.size() && covers.runs[end].part == covers.runs[first].part) ++end;
    paint(parts_[covers.runs[first].part], [&](const auto& take) {
      for (std::size_t k = first; k < end; ++k) {
        const Run& run = covers.runs[k];
        const std::uint32_t y = covers.rows[k];
        for (std::uint32_t b = 0; b < run.at_border; ++b) take(*at_border++);
        for (std::uint32_t x = run.x; x < run.x + run.whole; ++x) take(PixelCover3{x, y, 1, {x + 0.5, y + 0.5}});
      }
    });
  }
}

const SeenPicture3::Part* SeenPicture3::at(const Pixel& place) const {
  const auto found = std::ranges::find_if(parts_, [&](const Part& part) { return holds(part.outline, place); });
  return found == parts_.end() ? nullptr : &*found;
}

PixelValues3 SeenPicture3::values() const {
  Camera3 size;
  size.width = width_;
  size.height = height_;
  PixelPainter3 painter(paint_, size);
  for (const Part& part : parts_)
    painter.add({part.outline, part.element, part.shade ? &*part.shade : nullptr, part.corners});
  return painter.finished();
}

Raster SeenPicture3::raster(const ToneCurve* tone) const {
  HOTTEL_REQUIRE((tone == nullptr) == paint_.scale.has_value());
  Raster result(width_, height_);
  parallel_for(blocks(), [&](std::size_t block) {
    if (tone == nullptr)
      draw_values(block, result);
    else if (paint_.channels == 1)
      draw_light<1>(block, *tone, result);
    else
      draw_light<3>(block, *tone, result);
  });
  return result;
}

// As PixelValues3 are filled, with what is covered in a last channel; then toned.
template <std::size_t Channels>
void SeenPicture3::draw_light(std::size_t block, const ToneCurve& tone, Raster& raster) const {
  const PixelRows3 rows = rows_of(block);
  using Levels = std::array<double, Channels>;
  std::vector<std::array<double, Channels + 1>> pixels(std::size_t{rows.end - rows.begin} * width_);
  const auto add = [&](const PixelCover3& cover, const Levels& light) {
    auto& pixel = pixels[std::size_t{cover.y - rows.begin} * width_ + cover.x];
    for (std::size_t c = 0; c < Channels; ++c) pixel[c] += cover.part * light[c];
    pixel[Channels] += cover.part;
  };
  for_each_part(block, [&](const Part& part, const auto& pixels_of_part) {
    if (part.shade) {
      const Shade3::Quick<Channels> shade(*part.shade);
      pixels_of_part([&](const PixelCover3& cover) { add(cover, shade.at(cover.middle)); });
      return;
    }
    Levels light{};
    if (part.element && paint_.has_value(*part.element))
      std::ranges::copy(paint_.value(*part.element), light.begin());
    else
      std::ranges::copy(part.element ? paint_.unknown : paint_.black, light.begin());
    pixels_of_part([&](const PixelCover3& cover) { add(cover, light); });
  });
  std::uint32_t* to = raster.pixels.data() + std::size_t{rows.begin} * width_;
  for (auto& pixel : pixels) {
    const double sky = std::max(0.0, 1 - pixel[Channels]);
    for (std::size_t c = 0; c < Channels; ++c) pixel[c] += sky * paint_.sky[c];
    *to++ = pixel_of_levels(tone.near_levels(std::span<const double>(pixel).first(Channels)));
  }
}

// The same of colours of a scale.
void SeenPicture3::draw_values(std::size_t block, Raster& raster) const {
  const PixelRows3 rows = rows_of(block);
  constexpr std::size_t kColours = 3;
  std::vector<std::array<double, kColours + 1>> pixels(std::size_t{rows.end - rows.begin} * width_);
  std::array<double, kColours> shown{};
  std::vector<double> value(paint_.channels);
  const auto add = [&](const PixelCover3& cover) {
    auto& pixel = pixels[std::size_t{cover.y - rows.begin} * width_ + cover.x];
    for (std::size_t c = 0; c < kColours; ++c) pixel[c] += cover.part * shown[c];
    pixel[kColours] += cover.part;
  };
  for_each_part(block, [&](const Part& part, const auto& pixels_of_part) {
    if (part.shade) {
      pixels_of_part([&](const PixelCover3& cover) {
        part.shade->value(cover.middle, value);
        paint_.show(value, shown);
        add(cover);
      });
      return;
    }
    if (part.element && paint_.has_value(*part.element))
      paint_.show(paint_.value(*part.element), shown);
    else
      std::ranges::copy(part.element ? paint_.unknown : paint_.black, shown.begin());
    pixels_of_part(add);
  });
  std::uint32_t* to = raster.pixels.data() + std::size_t{rows.begin} * width_;
  for (const auto& pixel : pixels) {
    const double sky = std::max(0.0, 1 - pixel[kColours]);
    std::array<std::uint8_t, 3> level{};
    for (std::size_t c = 0; c < kColours; ++c) level[c] = srgb_level(pixel[c] + sky * paint_.sky[c]);
    *to++ = pixel_of_levels(level);
  }
}

}  // namespace hottel
