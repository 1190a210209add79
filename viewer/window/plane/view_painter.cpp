#include "viewer/window/plane/view_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/scene_names.h"
#include "solver/plane/methods/computed_factors.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/palette.h"
#include "viewer/picture/plane/illumination_painter.h"
#include "viewer/picture/plane/light_pixels.h"
#include "viewer/picture/plane/scene_painter.h"
#include "viewer/picture/plane/visibility_painter.h"
#include "viewer/picture/tone_curve.h"

namespace hottel {
namespace {

constexpr double kFooter = 118;                 // its content ends above the line at the bottom
constexpr std::uint32_t kCoarsePixels = 4;      // of a cell of a coarse grid
constexpr Colour kOutside{0.36, 0.365, 0.385};  // around light

ToneCurve curve_of(const IlluminationGrid2& light, const ToneChoice& tone) {
  return {tone.tone, tone.exposure, light.values, light.channels};
}

// With one pixel a cell the light is that of the cells; with more it is blended, but not through walls.
Raster texture_of(const IlluminationGrid2& light, const PreparedScene2& prepared, const ToneChoice& tone,
                  std::uint32_t pixels) {
  return toned_pixels_2(light,
                        pixels > 1 ? LightPixels2(prepared, light, pixels, pixels) : LightPixels2(light, 1, 1, nullptr),
                        curve_of(light, tone));
}

// The pixel of each level of a channel, once the floor has coloured it.
Raster floor_texture(const IlluminationGrid2& light, const PreparedScene2& prepared, double exposure) {
  Raster texture = texture_of(light, prepared, {Tone::kMax, exposure}, 1);
  const std::array<double, 3> floor{palette::kFloor.r, palette::kFloor.g, palette::kFloor.b};
  std::array<std::array<std::uint32_t, 256>, 3> shade{};
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t level = 0; level < 256; ++level)
      shade[c][level] = srgb_level(linear_from_srgb(static_cast<double>(level) / 255) * linear_from_srgb(floor[c]))
                        << (16 - 8 * c);
  const std::uint32_t solid = pixel_of(palette::kUnlitSolid);
  for (std::uint32_t& pixel : texture.pixels)
    if (pixel != solid)
      pixel = 0xFF000000u | shade[0][pixel >> 16 & 255] | shade[1][pixel >> 8 & 255] | shade[2][pixel & 255];
  return texture;
}

void draw_texture(PictureCanvas& canvas, const Frame2& frame, const Grid2& grid, const Raster& texture, bool smooth) {
  canvas.image(Mark::kLight, frame.at(Point2{grid.min.x, grid.max.y}), frame.at(Point2{grid.max.x, grid.min.y}),
               texture, smooth);
}

void draw_light(PictureCanvas& canvas, const Frame2& frame, double unit, const ViewDrawing2& drawing,
                const SolvedLight2& light) {
  const LiveState2& state = *drawing.state;
  canvas.fill_rectangle(Mark::kPaper, {0, 0}, {frame.width(), frame.height()}, kOutside);
  ToneChoice tone = drawing.tone;
  const bool is_floor = drawing.request->mode == ViewMode2::kFloor;
  if (is_floor) {
    tone.tone = Tone::kMax;
    draw_texture(canvas, frame, light.grid.grid, floor_texture(light.grid, *state.prepared, tone.exposure), false);
  } else if (drawing.texture != nullptr && drawing.texture->state.get() == &state && drawing.texture->tone == tone &&
             &light == state.light.get()) {
    draw_texture(canvas, frame, light.grid.grid, drawing.texture->raster, true);
  } else {
    draw_texture(canvas, frame, light.grid.grid, texture_of(light.grid, *state.prepared, tone, kCoarsePixels), true);
  }
  LitPlan2(*state.prepared, frame, unit).draw(canvas, curve_of(light.grid, tone));
}

// What was computed of this very state; that of another version fits neither its edges nor its surfaces.
const ViewResult2* result_of(const ViewDrawing2& drawing) {
  return drawing.result && drawing.result->version == drawing.state->version ? drawing.result : nullptr;
}

// Radiosities as bands: those of the channels averaged.
ScenePicture2 bands_of(const LiveState2& state) {
  ScenePicture2 picture;
  const RadiositySolution& solution = *state.radiosities;
  const ExchangeMatrix& matrix = state.factors->matrix;
  FaceColouring2 colouring;
  colouring.elements.resize(matrix.size());
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    double sum = 0;
    for (const ChannelSolution& channel : solution.channels) sum += channel.elements[i].radiosity;
    colouring.elements[i] = sum / static_cast<double>(solution.channels.size());
  }
  const double most = largest_radiosity(solution);
  colouring.scale = most > 0 ? ColourScale{1e-3 * most, most, true} : ColourScale{0, 1, false};
  colouring.title = solution.channels.size() == 2  ? "radiosity, mean of both bands [W/m²]"
                    : solution.channels.size() > 1 ? "radiosity, mean of r, g, b [W/m²]"
                                                   : "radiosity [W/m²]";
  picture.colouring = std::move(colouring);
  return picture;
}

// The factors from one face to all others. Where the matrix is by elements: the mean of its elements by area.
ScenePicture2 factors_of(const LiveState2& state, const Face& face) {
  const ExchangeMatrix& matrix = state.factors->matrix;
  ScenePicture2 picture;
  picture.targets = {face.surface};
  picture.target_label = face_name(state.prepared->scene, face);
  FaceColouring2 colouring;
  colouring.front.resize(state.prepared->scene.surfaces.size());
  colouring.back.resize(colouring.front.size());
  double area = 0, largest = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const Element& from = matrix.elements()[i];
    if (from.surface != face.surface || from.is_back != face.is_back || !matrix.has_row(i)) continue;
    area += from.area.value;
    for (const FactorEntry& entry : matrix.row(i)) {
      if (entry.to == matrix.sky()) continue;
      const Element& to = matrix.elements()[entry.to];
      std::optional<double>& value = (to.is_back ? colouring.back : colouring.front)[to.surface];
      value = value.value_or(0) + from.area.value * entry.factor.value;
    }
  }
  for (auto* side : {&colouring.front, &colouring.back})
    for (std::optional<double>& value : *side)
      if (value) largest = std::max(largest, *value /= area);
  colouring.scale = {1e-4, std::max(largest, 2e-4), true};
  colouring.title = "view factor from " + picture.target_label;
  picture.colouring = std::move(colouring);
  return picture;
}

void draw_plan(PictureCanvas& canvas, const Frame2& frame, double unit, const LiveState2& state,
               const ScenePicture2& picture) {
  ScenePicturePainter2(*state.prepared, picture, SceneSheet2(*state.prepared, frame, unit, kFooter)).draw(canvas);
}

// What the colours at the right of the bar mean, wherever the bar is.
void draw_split_legend(PictureCanvas& canvas, const Frame2& frame, double unit, const FaceColouring2& colouring) {
  const double left = 24 * unit, top = frame.height() - kFooter * unit;
  const double wide = std::min(420 * unit, 0.55 * (frame.width() - 2 * left));
  canvas.fill_rectangle(Mark::kPaper, {0, top - 10 * unit}, {left + 1.66 * wide, top + 66 * unit},
                        palette::kPaper.with_alpha(0.94));
  draw_legend(canvas, colouring.scale, colouring.title, {left, top}, wide, unit);
}

// Light at the left of the bar, errors at its right.
void draw_split(PictureCanvas& canvas, const Frame2& frame, double unit, const ViewDrawing2& drawing) {
  draw_light(canvas, frame, unit, drawing, *drawing.state->light);
  const double x = std::clamp(drawing.split, 0.0, 1.0) * frame.width();
  const ViewResult2* result = result_of(drawing);
  if (!result || !result->plan) return;
  // The errors go onto a raster of their own: the plan clips by itself.
  Raster errors(static_cast<std::uint32_t>(frame.width()), static_cast<std::uint32_t>(frame.height()));
  CairoCanvas beside(errors);
  draw_plan(beside, frame, unit, *drawing.state, *result->plan);
  beside.finish();
  const auto from = static_cast<std::uint32_t>(x);
  if (from >= errors.width) return;
  Raster right(errors.width - from, errors.height);
  for (std::uint32_t y = 0; y < errors.height; ++y)
    std::copy_n(errors.pixels.data() + std::size_t{y} * errors.width + from, right.width,
                right.pixels.data() + std::size_t{y} * right.width);
  canvas.image(Mark::kLight, {static_cast<double>(from), 0}, {frame.width(), frame.height()}, right, false);
  canvas.stroke(Mark::kAxis, {x, 0}, {x, frame.height()}, palette::kPaper, 3 * unit);
  canvas.stroke(Mark::kAxis, {x, 0}, {x, frame.height()}, palette::kInk, 1.2 * unit);
  canvas.disc(Mark::kAxis, {x, frame.height() / 2}, 9 * unit, palette::kPaper);
  canvas.circle(Mark::kAxis, {x, frame.height() / 2}, 9 * unit, palette::kInk, 1.5 * unit);
  draw_split_legend(canvas, frame, unit, *result->plan->colouring);
}

Colour colour_of(Severity severity) {
  return severity == Severity::kError     ? palette::kSecond
         : severity == Severity::kWarning ? palette::kEmitter
                                          : palette::kFirst;
}

void draw_findings(PictureCanvas& canvas, const Frame2& frame, double unit, const ViewDrawing2& drawing) {
  draw_plan(canvas, frame, unit, *drawing.state, {});
  const ViewResult2* result = result_of(drawing);
  if (!result) return;
  for (const FindingPlace2& finding : result->findings) {
    const Pixel at = frame.at(finding.at);
    canvas.circle(Mark::kCritical, at, 10 * unit, colour_of(finding.severity), 3 * unit);
    canvas.text(Mark::kLabel, {at.x + 14 * unit, at.y - 8 * unit}, std::to_string(finding.number),
                {.size = 16 * unit, .colour = colour_of(finding.severity), .weight = TextWeight::kBold});
  }
}

}  // namespace

std::shared_ptr<const SolvedLight2> shown_light_2(const ViewDrawing2& drawing) {
  const ViewMode2 mode = drawing.request->mode;
  const ViewResult2* result = result_of(drawing);
  if (mode == ViewMode2::kSweeps && result && result->light) return result->light;
  const bool is_lit = mode == ViewMode2::kLight || mode == ViewMode2::kFloor || mode == ViewMode2::kErrors ||
                      mode == ViewMode2::kSweeps;
  return is_lit ? drawing.state->light : nullptr;
}

bool shines(const IlluminationGrid2& light) {
  return std::ranges::any_of(light.values, [](double value) { return value > 0; });
}

Raster light_texture_2(const LiveState2& state, const ToneChoice& tone, std::uint32_t pixels_per_cell) {
  return texture_of(state.light->grid, *state.prepared, tone, pixels_per_cell);
}

Raster first_texture_2(const LiveState2& state, const ToneChoice& tone) {
  return light_texture_2(state, tone, state.depth == LiveDepth2::kCoarse ? kCoarsePixels : 1);
}

void draw_edges(PictureCanvas& canvas, const Frame2& frame, const Scene2& scene, const Colour& colour,
                double line_width) {
  for (const Edge2& edge : scene.edges)
    canvas.stroke(Mark::kEdge, frame.at(edge.from), frame.at(edge.to), colour, line_width);
}

void draw_view(PictureCanvas& canvas, const Frame2& frame, double unit, const ViewDrawing2& drawing) {
  const LiveState2& state = *drawing.state;
  const ViewRequest2& request = *drawing.request;
  const ViewResult2* result = result_of(drawing);
  if (!state.prepared) {
    canvas.fill_rectangle(Mark::kPaper, {0, 0}, {frame.width(), frame.height()}, palette::kPaper);
    draw_edges(canvas, frame, *state.scene, palette::kInk, 2 * unit);
    return;
  }
  const auto sheet = [&] { return SceneSheet2(*state.prepared, frame, unit, kFooter); };
  if (const std::shared_ptr<const SolvedLight2> light = shown_light_2(drawing)) {
    if (request.mode == ViewMode2::kErrors) return draw_split(canvas, frame, unit, drawing);
    if (shines(light->grid)) return draw_light(canvas, frame, unit, drawing, *light);
  }
  if (request.mode == ViewMode2::kBands && state.radiosities)
    return draw_plan(canvas, frame, unit, state, bands_of(state));
  if (request.mode == ViewMode2::kVisibility && result && result->sight)
    return VisibilityPainter2(*result->sight, sheet()).draw(canvas);
  if (const auto face = face_called(state.prepared->scene, request.face);
      face && request.mode == ViewMode2::kFactors && state.factors)
    return draw_plan(canvas, frame, unit, state, factors_of(state, *face));
  if (request.mode == ViewMode2::kPair && result && result->pair)
    return PairPainter2(*result->pair, sheet()).draw(canvas);
  if (request.mode == ViewMode2::kCheck) return draw_findings(canvas, frame, unit, drawing);
  draw_plan(canvas, frame, unit, state, {});
}

}  // namespace hottel
