// The frames of a viewer.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/plane/check/wording.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/scene_names.h"
#include "kernel/support/failure.h"
#include "solver/plane/methods/computed_factors.h"
#include "viewer/edit/decimals.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/palette.h"
#include "viewer/window/lights.h"
#include "viewer/window/plane/viewer.h"
#include "viewer/window/viewer_texts.h"

namespace hottel {
namespace {

constexpr double kLegends = 138, kLeastText = 110;  // units that legends take, and texts at least
constexpr Colour kSelected = palette::kTarget, kTouched{0.02, 0.62, 0.83, 0.55}, kDimmed{0.992, 0.988, 0.980, 0.62};
constexpr Colour kChanged{0.98, 0.72, 0.10, 0.9};  // edges whose light is not there yet
constexpr std::uint32_t kBlank = 0xFFFDFCFA;       // where nothing can be drawn

}  // namespace

ViewDrawing2 Viewer2::drawing() const {
  const bool is_lit = !views_.state().problem.empty() && views_.lit();
  return {.state = is_lit ? views_.texture()->state.get() : &views_.state(),
          .request = &views_.request(),
          .result = views_.result(),
          .tone = tone_,
          .texture = views_.texture(),
          .split = split_};
}

// Everything but what is said about it.
void Viewer2::draw_marks(PictureCanvas& canvas) const {
  const Frame2 frame = camera_.frame(size_);
  const LiveState2& state = views_.state();
  if (!state.scene) {
    canvas.fill_rectangle(Mark::kPaper, {0, 0}, {frame.width(), frame.height()}, palette::kPaper);
    draw_edges(canvas, frame, *shown_scene(), palette::kInk, 2 * unit_);
    return;
  }
  draw_view(canvas, frame, unit_, drawing());
  if (state.problem.empty()) return;
  canvas.fill_rectangle(Mark::kPaper, {0, 0}, {frame.width(), frame.height()}, kDimmed);
  draw_edges(canvas, frame, *state.scene, palette::kInk, 2 * unit_);
}

void Viewer2::draw_base() {
  base_ = Raster(size_.width, size_.height);
  needs_base_ = false;
  make_legend();
  try {
    CairoCanvas canvas(base_);
    draw_marks(canvas);
    canvas.finish();
  } catch (const RequestError& error) {  // places too far apart for a drawing: nothing that was edited is lost
    base_ = Raster(size_.width, size_.height, kBlank);
    message_ = error.what();
  }
}

void Viewer2::draw_marks_of_hand(PictureCanvas& canvas) {
  draw_lights(canvas);
  draw_selection(canvas);
  draw_tool(canvas);
  draw_problem(canvas);
}

void Viewer2::draw_selection(PictureCanvas& canvas) const {
  const Frame2 frame = camera_.frame(size_);
  const Scene2& scene = *shown_scene();
  const auto stroke = [&](std::uint32_t s, const Colour& colour, double width) {
    canvas.stroke(Mark::kTarget, frame.at(scene.edges[s].from), frame.at(scene.edges[s].to), colour, width * unit_);
  };
  // What was changed since the state that is shown.
  const Scene2* shown = views_.state().scene.get();
  if (shown != nullptr && shown != &scene)
    for (std::uint32_t s = 0; s < scene.edges.size(); ++s)
      if (s >= shown->edges.size() || scene.edges[s] != shown->edges[s]) stroke(s, kChanged, 2);
  if (drag_ == Drag::kNone && !tool_ && hover_.surface && *hover_.surface < scene.edges.size())
    stroke(*hover_.surface, kTouched, 5);
  for (const std::uint32_t s : editor_.selected()) stroke(s, kSelected, 3.5);
  for (const std::uint32_t s : editor_.selected())
    for (const Point2* end : {&scene.edges[s].from, &scene.edges[s].to})
      canvas.disc(Mark::kTarget, frame.at(*end), 3.5 * unit_, kSelected);
  const auto ring = [&](const Point2& at) {
    canvas.disc(Mark::kTarget, frame.at(at), 6 * unit_, palette::kPaper);
    canvas.circle(Mark::kTarget, frame.at(at), 6 * unit_, kSelected, 2.5 * unit_);
  };
  if (drag_ == Drag::kNone && !tool_ && hover_.vertex) ring(*hover_.vertex);
  if (editor_.selected_vertex()) ring(*editor_.selected_vertex());
  if (request_.mode == ViewMode2::kFactors || request_.mode == ViewMode2::kPair)
    for (const auto& [name, colour] : {std::pair(request_.face, palette::kFirst), {request_.other, palette::kSecond}})
      if (const auto face = face_called(scene, name)) stroke(face->surface, colour, 4);
}

void Viewer2::draw_tool(PictureCanvas& canvas) const {
  const Frame2 frame = camera_.frame(size_);
  if (drag_ == Drag::kRectangle) {
    const Pixel corners[] = {pressed_, {mouse_.x, pressed_.y}, mouse_, {pressed_.x, mouse_.y}};
    canvas.fill(Mark::kTarget, corners, kSelected.with_alpha(0.15));
    for (std::size_t k = 0; k < 4; ++k)
      canvas.stroke(Mark::kTarget, corners[k], corners[(k + 1) % 4], kSelected, unit_);
  }
  if (!tool_) return;
  const Snap2 next = editor_.snap(pointer());
  std::vector<Point2> points = tool_->points;
  points.push_back(next.at);
  for (std::size_t k = 1; k < points.size(); ++k)
    canvas.stroke(Mark::kTarget, frame.at(points[k - 1]), frame.at(points[k]), kSelected, 3 * unit_);
  for (const Point2& point : points) canvas.disc(Mark::kTarget, frame.at(point), 4 * unit_, kSelected);
}

// Where the scene has no light, and what `check` says of it.
void Viewer2::draw_problem(PictureCanvas& canvas) {
  const LiveState2& state = views_.state();
  if (state.problem.empty()) return;
  const Frame2 frame = camera_.frame(size_);
  std::vector<std::string> lines{"no light"};
  const auto mark = [&](const Pixel& at) {
    canvas.circle(Mark::kCritical, at, 12 * unit_, palette::kSecond, 3.5 * unit_);
  };
  for (const Finding2& error : state.errors) {
    lines.push_back(error.message);
    if (!error.suggestion.empty()) lines.push_back(error.suggestion);
    if (error.at) mark(frame.at(*error.at));
    for (const std::uint32_t s : error.surfaces)
      if (s < state.scene->edges.size())
        canvas.stroke(Mark::kCritical, frame.at(state.scene->edges[s].from), frame.at(state.scene->edges[s].to),
                      palette::kSecond, 4 * unit_);
  }
  for (const Edge2& edge : state.scene->edges)
    if (edge.from == edge.to) mark(frame.at(edge.from));
  if (state.errors.empty()) lines.push_back(state.problem);
  draw_warning(canvas, std::move(lines));
}

std::string Viewer2::head() const {
  const LiveState2& state = views_.state();
  std::string text = file_title() + "   " + to_string(request_.mode);
  if (request_.mode == ViewMode2::kLight)
    text += fmt::format(", tone {} x {:.3g}", to_string(tone_.tone), tone_.exposure);
  if (request_.mode == ViewMode2::kFloor) text += fmt::format(" x {:.3g}", tone_.exposure);
  if (request_.mode == ViewMode2::kErrors) text += ": " + request_.method;
  if (time_) text += fmt::format("   {:.2f} s", to_double(*time_));
  if (legend_ && legend_->is_dark()) text += "   nothing shines: the plan";
  if (views_.is_behind()) text += "   numbers before the last edit";
  if (!state.light) return text;
  const bool is_behind = state.scene != shown_scene();
  if (state.depth == LiveDepth2::kCoarse || is_behind)
    text += fmt::format("   coarse: {} x {} cells, {:.0f} ms", state.light->grid.grid.nx, state.light->grid.grid.ny,
                        1e3 * state.seconds);
  else
    text += fmt::format("   exact, {:.0f} ms", 1e3 * state.seconds);
  return text;
}

// Where the mouse is, what lies there, and the number that can be copied: with the place that it is of, while that of
// the mouse is on its way.
std::string Viewer2::status() const {
  if (!has_mouse_) return "";
  const ViewResult2* result = views_.result();
  const bool has_number = result != nullptr && !result->number.empty();
  const bool is_of_place = has_number && shows_light_at_mouse(result->request.mode) && result->request.mouse;
  std::string text = place_text(is_of_place ? *result->request.mouse : exact_mouse());
  const Scene2& scene = *shown_scene();
  if (hover_light_ && hover_light_->light < scene.lights.size()) {
    const std::uint32_t light = hover_light_->light;
    text += "   " + light_line(scene.lights[light], {&scene.light_places[light].rotation, 1});
  }
  if (hover_.surface && *hover_.surface < scene.surfaces.size()) {
    text += "   " + face_name(scene, hover_.face);
    const auto material = scene.surfaces[*hover_.surface].material_of(hover_.face.is_back);
    text += material ? " of " + scene.materials[*material].name : ", opaque and black";
  }
  if (!has_number || result->request.other != views_.request().other) return text;
  return text + (is_of_place ? "   mean irradiance " + result->number + " W/m²" : "   " + result->number);
}

// What light means, with the light under the mouse.
void Viewer2::draw_light_legend(PictureCanvas& canvas, double bottom) const {
  if (!legend_ || request_.mode == ViewMode2::kErrors || !views_.state().problem.empty()) return;
  const ViewResult2* result = views_.result();
  const bool is_marked = has_mouse_ && result != nullptr && !result->at_mouse.empty() && drag_ == Drag::kNone;
  legend_->draw(canvas, is_marked ? std::optional(brightness_of(result->at_mouse)) : std::nullopt, bottom, unit_);
}

void Viewer2::make_legend() {
  const ViewDrawing2 drawing = this->drawing();
  const std::shared_ptr<const SolvedLight2> light = drawing.state->prepared ? shown_light_2(drawing) : nullptr;
  if (light == legend_of_ && tone_ == legend_tone_ && request_.mode != ViewMode2::kFloor) return;
  legend_of_ = light;
  legend_tone_ = tone_;
  legend_.reset();
  if (!light) return;
  const IlluminationGrid2& grid = light->grid;
  const Tone tone = request_.mode == ViewMode2::kFloor ? Tone::kMax : tone_.tone;
  legend_tone_.tone = tone;
  legend_.emplace(ToneCurve(tone, tone_.exposure, grid.values, grid.channels), grid.values, grid.channels,
                  grid.channels == 2 ? "mean irradiance, solar [W/m²]" : "mean irradiance [W/m²]");
}

void Viewer2::draw_texts(PictureCanvas& canvas) {
  TextRoom room = draw_head(canvas);
  draw_light_legend(canvas, room.bottom);
  const bool has_text =
      (request_.mode == ViewMode2::kVisibility || !shows_light_at_mouse(request_.mode)) && views_.result() != nullptr;
  if (!has_text) return;
  const double above_legends = canvas.height() - kLegends * unit_;
  room.bottom = std::max(std::min(room.bottom, above_legends), std::min(room.bottom, room.top + kLeastText * unit_));
  const SideText text{std::string("look ") + to_string(request_.mode), views_.result()->lines};
  draw_side_texts(canvas, {&text, 1}, kPanelWidth, room, scrolls_, unit_);
}

}  // namespace hottel
