#include "viewer/picture/space/render_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/convex_cut.h"
#include "kernel/support/failure.h"
#include "solver/space/light/scene_lights.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/palette.h"
#include "viewer/picture/png_file.h"
#include "viewer/picture/space/direct_view.h"
#include "viewer/picture/space/gathered_source.h"
#include "viewer/picture/space/gathered_view.h"
#include "viewer/picture/space/pixel_raster.h"
#include "viewer/picture/space/seen_sides.h"
#include "viewer/picture/space/tripod.h"

namespace hottel {
namespace {

constexpr int kBands = 128;  // from black to white, or of a scale
constexpr double kFooterUnits = 72, kPen = 1.4;
constexpr double kTitleOverBar = 1.6;  // how wide a title may be
constexpr double kLeastBand = 2;       // pixels
constexpr double kLeastArea = 1e-9;    // square pixels, of shapes that are drawn
// How far gathered points may be from what their neighbours tell; between them it is a quarter of that as a rule.
constexpr double kMostSteps = 1;
constexpr double kPart = 0.004;  // the same of numbers, as a part of them
constexpr double kDark = 1e-6;   // of the largest radiosity: what is less is told to a part of that

// How far values are apart, as a part of the larger one or of the least that counts, by the channel where that is most.
double parts_between(std::span<const double> a, std::span<const double> b, double least) {
  double most = 0;
  for (std::size_t c = 0; c < a.size(); ++c)
    most = std::max(most, std::fabs(a[c] - b[c]) / std::max({std::fabs(a[c]), std::fabs(b[c]), least}));
  return most;
}

double footer_unit(const Camera3& camera) { return std::max(camera.width / 1000.0, 0.6); }

PixelPolygon cut(const PixelPolygon& polygon, const AffineValue3& above, double sign) {
  return cut_convex(
      polygon, [&](const Pixel& p) { return sign * above.at(p); }, place_between_3);
}

double diameter(const PixelPolygon& polygon) {
  double result = 0;
  for (const Pixel& p : polygon)
    for (const Pixel& q : polygon) result = std::max(result, std::hypot(p.x - q.x, p.y - q.y));
  return result;
}

// Polygons of one colour together, to be filled at once.
struct FillsByColour {
  std::vector<ColouredPolygons> fills;

  void add(PixelPolygon polygon, const Colour& colour) {
    const double area = pixel_area_doubled_3(polygon);
    if (std::fabs(area) < 2 * kLeastArea) return;
    if (area < 0) std::reverse(polygon.begin(), polygon.end());
    const auto [place, is_new] = known_.try_emplace(pixel_of(colour), fills.size());
    if (is_new) fills.push_back({colour, {}});
    fills[place->second].polygons.push_back(std::move(polygon));
  }

 private:
  std::map<std::uint32_t, std::size_t> known_;
};

}  // namespace

Camera3 camera_of_scene(const PreparedScene3& prepared, std::uint32_t wanted_width) {
  Camera3 camera = prepared.scene.camera ? *prepared.scene.camera : default_camera_3(prepared);
  if (wanted_width > 0) {
    const double height = std::round(static_cast<double>(camera.height) * wanted_width / camera.width);
    camera.width = wanted_width;
    camera.height = static_cast<std::uint32_t>(std::clamp(height, 1.0, static_cast<double>(kMaxPictureSide)));
  }
  return camera;
}

RenderedView3::RenderedView3(const PreparedScene3& prepared, Granularity granularity, const RadiositySolution& solution,
                             RenderOptions3 options)
    : prepared_(prepared),
      options_(std::move(options)),
      camera_(camera_of_scene(prepared, options_.wanted_width)),
      table_(*prepared.elements(granularity)),
      paint_(options_.shown ? scale_paint_3(*options_.shown) : light_paint_3(prepared.scene, solution)) {
  if (options_.shading == Shading::kParents)
    paint_.values = values_from_parents(table_.elements(), paint_.values, paint_.channels);
  if (options_.shading != Shading::kFlat) mesh_.emplace(prepared, table_);
  if (options_.shading == Shading::kGathered)
    gather(granularity, solution);
  else
    add_pixels(solution);
  if (options_.has_outlines) outlines_ = seen_outlines_3(prepared, camera_);
  if (options_.shown || options_.has_axes)
    footer_ = static_cast<std::uint32_t>(std::ceil(kFooterUnits * footer_unit(camera_)));
  if (!options_.shown)
    tone_ = options_.curve.value_or(ToneCurve(options_.tone, options_.exposure, pixels_.values, pixels_.channels));
}

// What elements have, and where direct light is told apart, that of each point.
void RenderedView3::add_pixels(const RadiositySolution& solution) {
  const bool is_apart = options_.light_shares && !options_.light_shares->empty() && !options_.shown;
  if (!is_apart) {
    pixels_ = camera_view_3(seen(), camera_);
    return;
  }
  ElementPaint3 reflected = reflected_paint_3(prepared_, table_, solution, *options_.light_shares);
  if (options_.shading == Shading::kParents)
    reflected.values = values_from_parents(table_.elements(), reflected.values, reflected.channels);
  pixels_ = camera_view_3({prepared_, table_, reflected, mesh_ ? &*mesh_ : nullptr}, camera_);
  add_direct_light_3(prepared_, table_, solution, camera_, seen_sides_3(prepared_, camera_), pixels_);
}

void RenderedView3::gather(Granularity granularity, const RadiositySolution& solution) {
  const GatheredSource3 source(
      prepared_, granularity, solution, responses_3(options_.asked, solution),
      options_.light_shares ? std::span<const LightShares>(*options_.light_shares) : std::span<const LightShares>());
  std::optional<SceneLights3> lights;
  if (options_.shown) lights.emplace(prepared_);
  // Errors are counted by a curve that is fitted to smooth elements, and as good as the one that is fitted at the end.
  std::optional<ToneCurve> curve = options_.curve;
  if (!curve && !options_.shown) {
    const PixelValues3 smooth = camera_view_3(seen(), camera_);
    curve.emplace(options_.tone, options_.exposure, smooth.values, smooth.channels);
  }
  const double least = std::max(kDark * largest_radiosity(solution), std::numeric_limits<double>::min());
  const auto steps = [&](std::span<const double> shown_a, std::span<const double> shown_b) {
    const double levels = steps_between(curve ? &*curve : nullptr, shown_a, shown_b);
    return options_.is_for_numbers ? std::max(levels, parts_between(shown_a, shown_b, least) / kPart) : levels;
  };
  pixels_ =
      gathered_view_3(source.scene(paint_, lights ? &*lights : nullptr), camera_, steps, kMostSteps, options_.progress)
          .pixels;
  if (!options_.shown)
    add_direct_light_3(prepared_, table_, solution, camera_, seen_sides_3(prepared_, camera_), pixels_);
}

// In 256 levels.
double RenderedView3::steps_between(const ToneCurve* curve, std::span<const double> a,
                                    std::span<const double> b) const {
  const auto colour = [curve](std::span<const double> shown) {
    if (curve != nullptr) return (*curve)(shown);
    return Colour{srgb_from_linear(shown[0]), srgb_from_linear(shown[1]), srgb_from_linear(shown[2])};
  };
  return steps_between_3(colour(a), colour(b));
}

Colour RenderedView3::colour_of(std::span<const double> shown) const {
  if (tone_) return (*tone_)(shown);
  return {srgb_from_linear(shown[0]), srgb_from_linear(shown[1]), srgb_from_linear(shown[2])};
}

Colour RenderedView3::colour_of_value(std::span<const double> value) const {
  std::vector<double> shown(paint_.shown_channels());
  paint_.show(value, shown);
  return colour_of(shown);
}

// Of the sum by which bands are parted.
std::vector<double> RenderedView3::weights() const {
  if (paint_.channels == 1) return {1};
  return {0.2126, 0.7152, 0.0722};  // luminance, as ToneCurve has it
}

// The sums between bands, ascending.
std::vector<double> RenderedView3::levels() const {
  std::vector<double> result;
  if (paint_.scale) {
    for (int k = 1; k < kBands; ++k) result.push_back(paint_.scale->value(static_cast<double>(k) / kBands));
    return result;
  }
  const auto shown = [&](double light) { return (*tone_)(std::vector<double>(paint_.channels, light)).r; };
  double most = 0;
  for (const double value : paint_.values) most = std::isnan(value) ? most : std::max(most, value);
  for (int k = 1; k < kBands && shown(most) > static_cast<double>(k) / kBands; ++k) {
    double below = 0, above = most;
    for (int step = 0; step < 60; ++step) {
      const double middle = below + (above - below) / 2;
      (shown(middle) > static_cast<double>(k) / kBands ? above : below) = middle;
    }
    result.push_back(above);
  }
  return result;
}

// The lines between bands are every, every second, ... level, so that a band is some pixels wide.
void RenderedView3::add_bands(const SeenPart3& part, std::span<const double> levels,
                              std::vector<ColouredPolygons>& fills) const {
  const std::vector<double> weight = weights();
  std::vector<double> value(paint_.channels);
  const auto add = [&](const PixelPolygon& band) {
    if (band.size() < 3) return;
    part.shade->value(middle_of_corners_3(band), value);
    fills.push_back({colour_of_value(value), {band}});
  };
  const double high = part.shade->high(weight);
  const auto begin = std::upper_bound(levels.begin(), levels.end(), part.shade->low(weight)) - levels.begin();
  const auto end = std::lower_bound(levels.begin(), levels.end(), high) - levels.begin();
  const double room = std::max(1.0, std::floor(diameter(part.outline) / kLeastBand));
  const auto stride =
      static_cast<std::ptrdiff_t>(std::ceil(static_cast<double>(std::max<std::ptrdiff_t>(1, end - begin)) / room));
  PixelPolygon rest = part.outline;
  for (std::ptrdiff_t k = (begin + stride - 1) / stride * stride; k < end && rest.size() > 2; k += stride) {
    const AffineValue3 above = part.shade->above(weight, levels[static_cast<std::size_t>(k)]);
    add(cut(rest, above, -1));
    rest = cut(rest, above, 1);
  }
  add(rest);
}

RenderedView3::Shapes RenderedView3::shapes() const {
  FillsByColour above, below;
  const std::vector<double> level = levels();
  std::vector<double> value(paint_.channels);
  for_each_seen_part(seen(), camera_, [&](const SeenPart3& part) {
    const bool has_value = part.element && paint_.has_value(*part.element);
    if (part.shade != nullptr) {
      part.shade->value(middle_of_corners_3(part.outline), value);
      below.add(part.outline, colour_of_value(value));
      std::vector<ColouredPolygons> bands;
      add_bands(part, level, bands);
      for (const ColouredPolygons& band : bands) above.add(band.polygons[0], band.colour);
      return;
    }
    const Colour colour = has_value ? colour_of_value(paint_.value(*part.element))
                                    : colour_of(part.element ? paint_.unknown : paint_.black);
    below.add(part.outline, colour);
    above.add(part.outline, colour);
  });
  return {std::move(above.fills), std::move(below.fills)};
}

void RenderedView3::draw(PictureCanvas& canvas) const {
  const double right = camera_.width, bottom = camera_.height;
  canvas.fill_rectangle(Mark::kFloor, {0, 0}, {right, bottom}, colour_of(paint_.sky));
  const Shapes drawn = shapes();
  fill_below(canvas, drawn.below);
  for (const ColouredPolygons& fill : drawn.above) canvas.fill_all(Mark::kStripe, fill.polygons, fill.colour);
  draw_outlines(canvas);
  if (footer_ > 0) draw_footer(canvas);
}

void RenderedView3::draw_outlines(PictureCanvas& canvas) const {
  const double pen = kPen * footer_unit(camera_);
  for (const OutlineStroke3& line : outlines_) canvas.stroke(Mark::kEdge, line.from, line.to, palette::kInk, pen);
}

void RenderedView3::draw_footer(PictureCanvas& canvas) const {
  const double unit = footer_unit(camera_), wide = camera_.width, top = camera_.height;
  canvas.fill_rectangle(Mark::kPaper, {0, top}, {wide, top + footer_}, palette::kPaper);
  const double margin = std::min(16 * unit, wide / 12);
  double room = wide - 2 * margin;
  if (options_.has_axes) {
    const Tripod3 tripod(prepared_.scene, camera_, length_unit(prepared_.scene));
    const double taken = tripod.width(canvas, unit);
    tripod.draw(canvas, {wide - margin - taken, top + 6 * unit}, unit);
    room = (room - taken - 2 * margin) / kTitleOverBar;
  }
  if (options_.shown && room > 0)
    draw_legend(canvas, options_.shown->scale, options_.shown->title, {margin, top + 6 * unit},
                std::min(420 * unit, room), unit);
}

std::string RenderedView3::png() const {
  Raster raster = pixel_raster_3(pixels_, tone_ ? &*tone_ : nullptr, footer_);
  if (footer_ > 0 || !outlines_.empty()) {
    CairoCanvas canvas(raster);
    draw_outlines(canvas);
    if (footer_ > 0) draw_footer(canvas);
    canvas.finish();
  }
  return png_file(raster);
}

std::string RenderedView3::file(PictureFormat format) const {
  if (format == PictureFormat::kPng) return png();
  if (options_.shading == Shading::kGathered) throw UsageError("gathered light has no shapes: write it as .png");
  CairoCanvas canvas(format, width(), height());
  draw(canvas);
  return canvas.finish();
}

RenderedPicture3 render_picture_3(const PreparedScene3& prepared, Granularity granularity,
                                  const RadiositySolution& solution, const RenderOptions3& options,
                                  PictureFormat format) {
  const RenderedView3 view(prepared, granularity, solution, options);
  return {view.file(format), view.scale()};
}

}  // namespace hottel
