#include "viewer/picture/plane/scene_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kernel/support/failure.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/light_contours.h"
#include "viewer/picture/palette.h"
#include "viewer/picture/seamless_fill.h"

namespace hottel {
namespace {

constexpr double kFooter = 62;
constexpr double kBands = 128;  // of a scale, where values are blended

std::optional<double> value_of(const std::vector<std::optional<double>>& values, std::uint32_t place) {
  if (place >= values.size() || !values[place] || std::isnan(*values[place])) return std::nullopt;
  return values[place];
}

bool by_elements(const ScenePicture2& picture) { return picture.colouring && !picture.colouring->elements.empty(); }

}  // namespace

ScenePicturePainter2::ScenePicturePainter2(const PreparedScene2& prepared, const ScenePicture2& picture)
    : ScenePicturePainter2(prepared, picture, SceneSheet2(prepared, picture.sheet, kFooter)) {}

ScenePicturePainter2::ScenePicturePainter2(const PreparedScene2& prepared, const ScenePicture2& picture,
                                           SceneSheet2 sheet)
    : scene_(prepared.scene),
      picture_(picture),
      sheet_(std::move(sheet)),
      runs_(prepared, sheet_.frame(), by_elements(picture) ? Granularity::kElement : Granularity::kFace) {
  for (const std::uint32_t target : picture.targets) HOTTEL_REQUIRE(target < scene_.surfaces.size());
  if (by_elements(picture)) values_ = run_values_2(runs_, picture.colouring->elements, picture.colouring->shading);
  for (std::uint32_t run = 0; run < runs_.corners().surfaces(); ++run) colours_.push_back(colour(run));
}

// Of the stripe of a run, if it has one: its value, or in a plain plan that it emits.
std::optional<Colour> ScenePicturePainter2::colour(std::uint32_t run) const {
  const Face& face = runs_.face(run);
  const std::optional<std::uint32_t> material = scene_.surfaces[face.surface].material_of(face.is_back);
  if (!material) return std::nullopt;
  if (picture_.colouring) {
    const FaceColouring2& colouring = *picture_.colouring;
    if (by_elements(picture_))
      return values_[run] ? std::optional(scale_colour(colouring.scale, values_[run]->middle)) : std::nullopt;
    const auto value = value_of(face.is_back ? colouring.back : colouring.front, face.surface);
    return value ? std::optional(scale_colour(colouring.scale, *value)) : std::nullopt;
  }
  return scene_.materials[*material].emission.is_zero() ? std::nullopt : std::optional(palette::kEmitter);
}

void ScenePicturePainter2::draw(PictureCanvas& canvas) const {
  std::vector<bool> has_stripe;
  for (const std::optional<Colour>& c : colours_) has_stripe.push_back(c.has_value());
  const Stripes2 stripes(runs_.corners(), std::move(has_stripe), sheet_.stripe_depth());
  const Mark mark = picture_.colouring ? Mark::kStripe : Mark::kEmitter;
  SceneSheet2::Ground ground;
  ground.faces = [&](std::span<const std::uint32_t> surfaces) {
    draw_below(canvas, surfaces, stripes);
    for (const std::uint32_t s : surfaces)
      for (std::uint32_t run = runs_.begin(s); run < runs_.end(s); ++run)
        if (colours_[run]) draw_stripe(canvas, mark, run, stripes.stripe(run));
  };
  if (picture_.pixels) ground.cover = [&] { draw_pixels(canvas); };
  sheet_.draw_ground(canvas, ground);

  std::vector<bool> highlighted(scene_.surfaces.size(), false);
  for (const std::uint32_t target : picture_.targets) highlighted[target] = true;
  sheet_.draw_walls(canvas, highlighted);
  draw_targets(canvas);
  if (picture_.sheet.has_axes) sheet_.draw_axes(canvas);
  draw_footer(canvas);
}

// Of the colours that stripes have in their middle.
void ScenePicturePainter2::draw_below(PictureCanvas& canvas, std::span<const std::uint32_t> surfaces,
                                      const Stripes2& stripes) const {
  std::vector<ColouredPolygons> fills;
  for (const std::uint32_t s : surfaces)
    for (std::uint32_t run = runs_.begin(s); run < runs_.end(s); ++run) {
      if (!colours_[run]) continue;
      const std::array<Pixel, 4> stripe = stripes.stripe(run);
      if (fills.empty() || fills.back().colour != *colours_[run]) fills.push_back({*colours_[run], {}});
      fills.back().polygons.emplace_back(stripe.begin(), stripe.end());
    }
  fill_below(canvas, fills);
}

void ScenePicturePainter2::draw_stripe(PictureCanvas& canvas, Mark mark, std::uint32_t run,
                                       const std::array<Pixel, 4>& stripe) const {
  if (values_.empty() || values_[run]->is_constant()) return canvas.fill(mark, stripe, *colours_[run]);
  const ColourScale& scale = picture_.colouring->scale;
  const RunValue2& value = *values_[run];
  std::vector<ColourStop> stops;
  const auto add_half = [&](double begin, double rise) {
    const double bands = std::max(1.0, std::ceil(std::fabs(rise) * kBands));
    for (double k = 0; k <= bands; ++k) {
      const double share = begin + 0.5 * k / bands;
      if (stops.empty() || share > stops.back().share) stops.push_back({share, scale_colour(scale, value.at(share))});
    }
  };
  add_half(0, scale.position(value.middle) - scale.position(value.from));
  add_half(0.5, scale.position(value.to) - scale.position(value.middle));
  canvas.fill_along(mark, stripe, stripe[0], stripe[1], stops);
}

void ScenePicturePainter2::draw_pixels(PictureCanvas& canvas) const {
  const ScenePixels2& pixels = *picture_.pixels;
  canvas.image(Mark::kLight, sheet_.frame().at(std::array{pixels.min[0], pixels.max[1]}),
               sheet_.frame().at(std::array{pixels.max[0], pixels.min[1]}), pixels.image, pixels.smooth);
  if (!pixels.levels.empty()) draw_cell_contours(canvas);
}

// Of the pixels, where they are on the sheet: each has its own value, up to the walls that cut it.
void ScenePicturePainter2::draw_cell_contours(PictureCanvas& canvas) const {
  const ScenePixels2& pixels = *picture_.pixels;
  const Pixel from = sheet_.frame().at(std::array{pixels.min[0], pixels.max[1]});
  const Pixel to = sheet_.frame().at(std::array{pixels.max[0], pixels.min[1]});
  // Which of so many cells from one end to the other a place lies in; none beyond.
  const auto cell = [](double at, double first, double last, std::uint32_t cells) -> std::optional<std::size_t> {
    const double share = (at - first) / (last - first);
    if (!(share >= 0 && share < 1)) return std::nullopt;
    return std::min(static_cast<std::uint32_t>(share * cells), cells - 1);
  };
  const Pixel origin{std::max(std::floor(from.x), 0.0), std::max(std::floor(from.y), 0.0)};
  const double right = std::min<double>(std::ceil(to.x), width()), below = std::min<double>(std::ceil(to.y), height());
  if (!(origin.x < right && origin.y < below)) return;
  PixelField field{static_cast<std::uint32_t>(right - origin.x), static_cast<std::uint32_t>(below - origin.y), {}, {}};
  field.values.reserve(std::size_t{field.width} * field.height);
  for (std::uint32_t y = 0; y < field.height; ++y)
    for (std::uint32_t x = 0; x < field.width; ++x) {
      const auto row = cell(origin.y + y + 0.5, from.y, to.y, pixels.image.height);
      const auto column = cell(origin.x + x + 0.5, from.x, to.x, pixels.image.width);
      field.values.push_back(row && column ? static_cast<float>(pixels.values[*row * pixels.image.width + *column])
                                           : std::numeric_limits<float>::quiet_NaN());
    }
  for (std::uint32_t s = 0; s < scene_.surfaces.size(); ++s) cut_along(sheet_.from(s), sheet_.to(s), origin, field);
  const double cell_width = (to.x - from.x) / pixels.image.width;
  draw_light_contours(canvas, std::move(field), pixels.levels, cell_width, origin, sheet_.unit());
}

void ScenePicturePainter2::draw_targets(PictureCanvas& canvas) const {
  const double pen = std::max(2.2 * sheet_.wall_width(), 3 * sheet_.unit());
  for (const std::uint32_t s : picture_.targets)
    canvas.stroke(Mark::kTarget, sheet_.from(s), sheet_.to(s), palette::kTarget, pen);
}

void ScenePicturePainter2::draw_footer(PictureCanvas& canvas) const {
  const double unit = sheet_.unit(), left = sheet_.footer_left(), top = sheet_.footer_top();
  const double room = sheet_.footer_right() - left;
  sheet_.draw_footer_paper(canvas);
  sheet_.draw_scale_bar(canvas);
  double x = left;
  if (picture_.colouring)
    x += draw_legend(canvas, picture_.colouring->scale, picture_.colouring->title, {left, top},
                     std::min(420 * unit, 0.55 * room), unit) +
         44 * unit;
  const auto key = [&](Mark mark, const Colour& colour, const std::string& label) {
    const TextStyle style{.size = 15 * unit, .colour = palette::kInk};
    const double y = top + 31 * unit, line = 34 * unit, text = x + line + 10 * unit;
    const double end = text + canvas.text_width(label, style);
    if (end > left + 0.74 * room) return;  // no space: the picture speaks for itself
    canvas.stroke(mark, {x, y}, {x + line, y}, colour, 6 * unit);
    canvas.text(Mark::kLegend, {text, y + 5 * unit}, label, style);
    x = end + 32 * unit;
  };
  if (!picture_.targets.empty() && !picture_.target_label.empty())
    key(Mark::kLegend, palette::kTarget, picture_.target_label);
  const bool emits = std::any_of(colours_.begin(), colours_.end(), [](const auto& c) { return c.has_value(); });
  if (emits && !picture_.colouring) key(Mark::kLegend, palette::kEmitter, "emits light");
}

std::string scene_picture_2(const PreparedScene2& prepared, const ScenePicture2& picture, PictureFormat format) {
  const ScenePicturePainter2 painter(prepared, picture);
  CairoCanvas canvas(format, painter.width(), painter.height());
  painter.draw(canvas);
  return canvas.finish();
}

}  // namespace hottel
