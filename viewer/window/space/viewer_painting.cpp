// The frames of a viewer in space.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/scene_names.h"
#include "kernel/support/failure.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/palette.h"
#include "viewer/picture/space/seen_picture.h"
#include "viewer/window/lights.h"
#include "viewer/window/space/first_light.h"
#include "viewer/window/space/light_lines.h"
#include "viewer/window/space/viewer.h"

namespace hottel {
namespace {

constexpr double kPanelWidth = 0.4;  // of the window's width, at most
constexpr Colour kTouched{0.02, 0.62, 0.83, 0.16}, kBar{0.992, 0.988, 0.980, 0.9};
constexpr Colour kDimmed{0.992, 0.988, 0.980, 0.62};
constexpr std::uint32_t kBlank = 0xFFFDFCFA;  // where nothing can be drawn

constexpr double kInk = 0.45;  // of an outline
constexpr std::uint32_t kSky = 0, kBlack = 1;

std::uint32_t face_number(const SeenPicture3::Part& part, const ElementTable3& table) {
  if (!part.element) return kBlack;
  const Element& element = table.elements()[*part.element];
  return 2 + 2 * element.surface + (element.is_back ? 1 : 0);
}

// Calls row(y, first, end) for the pixels whose centres lie in a convex polygon.
template <class Row>
void for_each_row(const PixelPolygon& polygon, std::uint32_t width, std::uint32_t height, const Row& row) {
  if (polygon.empty()) return;
  const auto [low, high] = std::ranges::minmax(polygon, {}, &Pixel::y);
  const auto pixel = [](double v, std::uint32_t most) {
    return static_cast<std::uint32_t>(std::clamp(std::ceil(v - 0.5), 0.0, static_cast<double>(most)));
  };
  for (std::uint32_t y = pixel(low.y, height); y < pixel(high.y, height); ++y) {
    double left = HUGE_VAL, right = -HUGE_VAL;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Pixel &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
      if ((a.y > y + 0.5) == (b.y > y + 0.5)) continue;
      const double x = std::lerp(a.x, b.x, (y + 0.5 - a.y) / (b.y - a.y));
      left = std::min(left, x);
      right = std::max(right, x);
    }
    if (left < right) row(y, pixel(left, width), pixel(right, width));
  }
}

std::uint32_t darkened(std::uint32_t pixel) {
  const std::uint32_t ink = pixel_of(palette::kInk);
  std::uint32_t result = 0xFF000000u;
  for (const int shift : {0, 8, 16}) {
    const double mixed = std::lerp(pixel >> shift & 255u, ink >> shift & 255u, kInk);
    result |= static_cast<std::uint32_t>(mixed + 0.5) << shift;
  }
  return result;
}

// Darkens the pixels of a picture at which one face ends and another begins, so many pixels wide: where light alone
// does not tell faces apart. REQUIRES that parts are those of the raster's picture, with elements of the table. COST:
// some ms a megapixel.
void draw_outlines_3(Raster& raster, const std::vector<SeenPicture3::Part>& parts, const ElementTable3& table,
                     std::uint32_t width) {
  std::vector<std::uint32_t> faces(raster.pixels.size(), kSky);
  for (const SeenPicture3::Part& part : parts)
    for_each_row(part.outline, raster.width, raster.height,
                 [&](std::uint32_t y, std::uint32_t first, std::uint32_t end) {
                   std::fill_n(faces.begin() + static_cast<std::ptrdiff_t>(std::size_t{y} * raster.width + first),
                               end > first ? end - first : 0, face_number(part, table));
                 });
  for (std::uint32_t y = 0; y < raster.height; ++y)
    for (std::uint32_t x = 0; x < raster.width; ++x) {
      const std::size_t at = std::size_t{y} * raster.width + x;
      bool is_outline = false;
      for (std::uint32_t step = 1; step <= width; ++step)
        is_outline = is_outline || (x + step < raster.width && faces[at + step] != faces[at]) ||
                     (y + step < raster.height && faces[at + std::size_t{step} * raster.width] != faces[at]);
      if (is_outline) raster.pixels[at] = darkened(raster.pixels[at]);
    }
}

}  // namespace

// What the camera sees, painted: kept pictures of it take another paint, where that will do.
const SeenPicture3& Viewer3::see(const std::shared_ptr<const LiveModel3>& model, const ElementPaint3& paint,
                                 bool is_smooth, std::optional<Seen>& kept) const {
  const SmoothMesh3* mesh = is_smooth ? &model->mesh : nullptr;
  const Camera3 camera = camera_.camera(size_);
  const bool is_kept = kept && kept->model == model && kept->camera == camera && kept->is_smooth == is_smooth &&
                       kept->picture.show(paint, mesh);
  if (!is_kept)
    kept.emplace(Seen{model, camera, is_smooth, SeenPicture3({model->prepared, model->table(), paint, mesh}, camera)});
  return kept->picture;
}

void Viewer3::add_outlines(const SeenPicture3& picture) {
  if (!has_outlines_ || !state().version) return;
  const auto width = static_cast<std::uint32_t>(std::max(1.0, std::round(unit_)));
  draw_outlines_3(base_, picture.parts(), view().version()->model().table(), width);
}

void Viewer3::draw_seen() {
  live_.look_from(place_of(camera_.camera(size_).eye));
  const ShownView3 view = this->view();
  const auto& model = view.version()->shared_model();
  if (view.values() != nullptr) {
    const bool is_quantity = request_.mode == ViewMode3::kRadiosity || request_.mode == ViewMode3::kIrradiance;
    const SeenPicture3& seen = see(model, scale_paint_3(*view.values()), is_smooth_ && is_quantity, values_);
    base_ = seen.raster(nullptr);
    if (!is_split()) return add_outlines(seen);
  } else {
    values_.reset();
  }
  // Toned by all elements there are, whatever is seen: so light stays the same while one walks.
  paint_ = view.light();
  const ToneCurve tone(tone_.tone, tone_.exposure, paint_.values, paint_.channels);
  legend_.emplace(tone, paint_.values, paint_.channels,
                  view.version()->scene().has_bands ? "radiosity, solar [W/m²]" : "radiosity [W/m²]");
  const bool is_form = legend_->is_dark();
  const ToneCurve as_it_is(Tone::kLinear, 1, {}, 1);
  const SeenPicture3& seen =
      see(model, is_form ? form_of_3(view.version()->scene(), model->table()) : paint_, is_smooth_, light_);
  Raster lit = seen.raster(is_form ? &as_it_is : &tone);
  if (!is_form) gathered_.draw(tone, lit);
  if (!is_split()) {
    base_ = std::move(lit);
    return add_outlines(seen);
  }
  const auto left = static_cast<std::ptrdiff_t>(std::clamp(split_, 0.0, 1.0) * size_.width);
  for (std::size_t y = 0; y < size_.height; ++y)
    std::copy_n(lit.pixels.begin() + static_cast<std::ptrdiff_t>(y * size_.width), left,
                base_.pixels.begin() + static_cast<std::ptrdiff_t>(y * size_.width));
}

// Everything but what is said about it.
void Viewer3::draw_base() {
  needs_base_ = false;
  needs_frame_ = true;
  try {
    if (view().version() != nullptr && is_fitted_)
      draw_seen();
    else
      base_ = Raster(size_.width, size_.height, kBlank);
  } catch (const RequestError& error) {
    message_ = error.what();
    light_.reset();
    values_.reset();
    base_ = Raster(size_.width, size_.height, kBlank);
  }
  touch();
}

void Viewer3::draw_marks_of_hand(PictureCanvas& canvas) {
  draw_touched(canvas);
  draw_selection(canvas);
  draw_lights(canvas);
  draw_problem(canvas);
}

// The polygon under the mouse where light is seen.
void Viewer3::draw_touched(PictureCanvas& canvas) const {
  if (hover_ && seen() != nullptr && view().values() == nullptr && drag_ == Drag::kNone) {
    std::vector<std::vector<Pixel>> outlines;
    const std::vector<Element>& elements = seen()->model->table().elements();
    for (const SeenPicture3::Part& part : seen()->picture.parts()) {
      if (!part.element) continue;
      const Element& its = elements[*part.element];
      if (Face{its.surface, its.is_back} != hover_->face()) continue;
      outlines.push_back(part.outline);
      if (pixel_area_doubled_3(part.outline) < 0) std::ranges::reverse(outlines.back());
    }
    if (!outlines.empty()) canvas.fill_all(Mark::kTarget, outlines, kTouched);
  }
}

void Viewer3::draw_problem(PictureCanvas& canvas) {
  if (state().problem.empty()) return;
  canvas.fill_rectangle(Mark::kPaper, {0, 0}, {canvas.width(), canvas.height()}, kDimmed);
  draw_warning(canvas, {"no light", state().problem});
}

std::string Viewer3::head() const {
  std::string text = file_title() + "   " + to_string(request_.mode);
  const ShownView3 view = this->view();
  if (view.values() == nullptr) text += fmt::format(", tone {} x {:.3g}", to_string(tone_.tone), tone_.exposure);
  if (legend_ && legend_->is_dark() && view.values() == nullptr) text += "   nothing shines: the form alone";
  if (request_.mode == ViewMode3::kErrors) text += ": " + request_.method;
  if (time_) text += fmt::format("   {:.2f} s", to_double(*time_));
  const LiveState3& now = state();
  if (!now.stage.empty() && now.all_rows > 0)
    return text + fmt::format("   {} of {} rows, nearest first", now.rows, now.all_rows);
  if (!now.stage.empty()) return text + "   " + now.stage;
  if (now.is_coarse) return text + "   coarse: whole polygons, estimated";
  if (!now.is_lit() || !now.problem.empty()) return text;
  if (view.version() != now.version.get()) text += "   before the last edit";
  return text +
         fmt::format("   {} elements, {:.0f} ms", view.version()->model().table().count(),
                     1e3 * view.version()->seconds()) +
         gathering_text();
}

// What lies under the mouse.
std::string Viewer3::status() const {
  if (hover_light_ && drag_ == Drag::kNone)
    return light_line(scene()->lights[hover_light_->light], rotation_of(hover_light_->light));
  if (!hover_) return "";
  const Scene3& found_in = hover_->model->prepared.scene;
  std::string text = face_name(found_in, hover_->face());
  if (const auto material = hover_->element().material) text += " of " + found_in.materials[*material].name;
  const ShownView3 view = this->view();
  const std::string value = view.number(hover_);
  if (value.empty() || state().is_coarse) return text;
  const bool is_light = view.values() == nullptr && view.name_of_number() == std::string_view("radiosity");
  return text + "   " + view.name_of_number() + " " + value + (is_light ? " W/m²" : "");
}

// What is known of what is picked, and the result of the view mode.
std::vector<SideText> Viewer3::side_texts() const {
  std::vector<SideText> texts;
  const ShownView3 view = this->view();
  if (const auto light = editor_.selected_light()) texts.push_back({"light", light_lines_3(*scene(), *light)});
  if (request_.face && view.version() && knows(view.version()->scene(), *request_.face))
    texts.push_back(
        {"face", face_lines_3(*view.version(), *request_.face, state().is_coarse ? std::nullopt : picked_)});
  if (view.result()) texts.push_back({std::string("look ") + to_string(request_.mode), view.result()->lines});
  return texts;
}

// What colours and light mean, with the value under the mouse.
void Viewer3::draw_legends(PictureCanvas& canvas, double bottom) const {
  const ShownView3 view = this->view();
  if (!view.version()) return;
  const bool is_pointed = hover_ && drag_ == Drag::kNone;
  constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  const std::uint32_t at = is_pointed ? hover_->number_in(view.version()->model()).value_or(kNone) : kNone;
  if (view.values() != nullptr)
    return draw_legend_on_paper(canvas, view.values()->scale, view.values()->title,
                                {.marked = at != kNone ? view.values()->elements[at] : std::nullopt}, bottom, unit_);
  if (!legend_ || !state().is_lit() || !state().problem.empty()) return;
  const bool has_value = at != kNone && (at + std::size_t{1}) * paint_.channels <= paint_.values.size();
  legend_->draw(canvas, has_value ? std::optional(brightness_of(paint_.value(at))) : std::nullopt, bottom, unit_);
}

void Viewer3::draw_texts(PictureCanvas& canvas) {
  const double x = split_ * size_.width;
  if (is_split()) canvas.stroke(Mark::kLegend, {x, 0}, {x, canvas.height()}, kBar, 3 * unit_);
  const TextRoom room = draw_head(canvas);
  draw_legends(canvas, room.bottom);
  draw_side_texts(canvas, side_texts(), kPanelWidth, room, scrolls_, unit_);
}

}  // namespace hottel
