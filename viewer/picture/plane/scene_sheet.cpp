#include "viewer/picture/plane/scene_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "kernel/support/failure.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/palette.h"
#include "viewer/picture/plane/axes.h"
#include "viewer/picture/plane/solid_polygons.h"
#include "viewer/picture/scale_bar.h"

namespace hottel {
namespace {

constexpr double kMargin = 64, kTitleHeight = 40, kSubtitleHeight = 34, kHeadingGap = 22;
constexpr double kFooterSide = 24;  // of a footer over the drawing

double unit_of(std::uint32_t width) {
  if (width < kMinPictureWidth || width > kMaxPictureSide)
    throw UsageError(
        fmt::format("picture: the width must be between {} and {} pixels", kMinPictureWidth, kMaxPictureSide));
  return std::max(width / 1600.0, 0.6);  // letters stay readable in small pictures
}

SheetMargins2 margins(const SheetText2& text, double unit, double footer) {
  const double side = std::min(kMargin * unit, text.width / 12.0);
  double top = side;
  if (!text.title.empty()) top += kTitleHeight * unit;
  if (!text.title.empty() || !text.subtitle.empty()) top += kHeadingGap * unit;
  if (!text.subtitle.empty()) top += kSubtitleHeight * unit;
  return {side, side, top, std::max(side, 44 * unit) + footer * unit};
}

// The length of the edge in the middle when all edges lie end to end, by length: neither a few long walls nor the many
// sides of round pillars decide.
double typical_length(const Corners2& corners) {
  std::vector<double> lengths;
  double sum = 0;
  for (std::size_t s = 0; s < corners.surfaces(); ++s) {
    const Pixel a = corners.at[corners.from[s]], b = corners.at[corners.to[s]];
    lengths.push_back(std::hypot(b.x - a.x, b.y - a.y));
    sum += lengths.back();
  }
  std::sort(lengths.begin(), lengths.end());
  double behind = 0;
  for (const double length : lengths)
    if ((behind += length) >= sum / 2) return length;
  return 0;
}

}  // namespace

SceneSheet2::SceneSheet2(const PreparedScene2& prepared, const SheetText2& text, double footer,
                         const std::vector<std::array<double, 2>>& extra_points)
    : title_(text.title),
      subtitle_(text.subtitle),
      length_unit_(length_unit(prepared.scene)),
      unit_(unit_of(text.width)),
      frame_(prepared.scene, extra_points, text.width, margins(text, unit_, footer)),
      corners_(prepared.scene, frame_),
      outlines_(prepared.scene, corners_),
      solids_(solid_polygons(prepared.arrangement, frame_)),
      footer_top_(frame_.bottom_right().y + 34 * unit_),
      footer_left_(frame_.top_left().x),
      footer_right_(frame_.bottom_right().x) {
  set_widths();
  for (const Surface& surface : prepared.scene.surfaces) is_patch_.push_back(surface.on.has_value());
}

SceneSheet2::SceneSheet2(const PreparedScene2& prepared, const Frame2& frame, double unit, double footer)
    : length_unit_(length_unit(prepared.scene)),
      unit_(unit),
      frame_(frame),
      corners_(prepared.scene, frame_),
      outlines_(prepared.scene, corners_),
      solids_(solid_polygons(prepared.arrangement, frame_)),
      has_footer_over_drawing_(true),
      footer_top_(frame_.height() - footer * unit_),
      footer_left_(kFooterSide * unit_),
      footer_right_(frame_.width() - kFooterSide * unit_) {
  set_widths();
  for (const Surface& surface : prepared.scene.surfaces) is_patch_.push_back(surface.on.has_value());
}

void SceneSheet2::set_widths() {
  const double length = typical_length(corners_);
  wall_width_ = std::clamp(0.03 * length, 0.6 * unit_, 3.0 * unit_);
  stripe_depth_ = std::clamp(0.07 * length, 2.0 * unit_, 7.5 * unit_);
}

void SceneSheet2::draw_ground(PictureCanvas& canvas, const Ground& ground) const {
  canvas.fill_rectangle(Mark::kPaper, {0, 0}, {frame_.width(), frame_.height()}, palette::kPaper);
  draw_heading(canvas);
  const bool open = std::all_of(outlines_.closed.begin(), outlines_.closed.end(), [](auto& o) { return o.is_outward; });
  if (open && ground.cover) ground.cover();
  for (std::size_t level = 0; level <= outlines_.levels; ++level) draw_level(canvas, level, ground);
  for (const std::vector<Pixel>& solid : solids_) {
    canvas.fill(Mark::kSolid, solid, palette::kSolid);
    draw_hatch_2(canvas, solid, 13 * unit_, 0.9 * unit_, palette::kHatch);
  }
}

void SceneSheet2::draw_heading(PictureCanvas& canvas) const {
  double base_line = frame_.top_left().x + 22 * unit_;
  if (!title_.empty()) {
    draw_text(canvas, title_, base_line, {.size = 36 * unit_, .colour = palette::kInk, .weight = TextWeight::kBold});
    base_line += 38 * unit_;
  }
  if (!subtitle_.empty()) draw_text(canvas, subtitle_, base_line, {.size = 20 * unit_, .colour = palette::kSoftInk});
}

// First the faces that look out of this level's furniture, then its floors, then the faces of its rooms.
void SceneSheet2::draw_level(PictureCanvas& canvas, std::size_t level, const Ground& ground) const {
  if (ground.faces) draw_outside_faces(canvas, level, ground);
  for (const Outline2& outline : outlines_.closed) {
    if (outline.level != level || outline.is_outward) continue;
    canvas.fill(Mark::kFloor, outline.polygon, palette::kFloor);
    canvas.clip(outline.polygon);
    if (ground.cover) ground.cover();
    if (ground.faces) ground.faces(outline.surfaces);
    canvas.unclip();
  }
}

void SceneSheet2::draw_outside_faces(PictureCanvas& canvas, std::size_t level, const Ground& ground) const {
  std::map<std::optional<std::size_t>, std::vector<std::uint32_t>> within;  // by the outline around
  for (const Outline2& outline : outlines_.closed)
    if (outline.is_outward && outline.level == level)
      within[outline.around].insert(within[outline.around].end(), outline.surfaces.begin(), outline.surfaces.end());
  for (std::size_t k = 0; k < outlines_.loose.size(); ++k) {
    const auto& around = outlines_.around_loose[k];
    if ((around ? outlines_.closed[*around].level + 1 : 0) == level) within[around].push_back(outlines_.loose[k]);
  }
  for (const auto& [around, surfaces] : within) {
    const bool in_room = around && !outlines_.closed[*around].is_outward;
    if (in_room) canvas.clip(outlines_.closed[*around].polygon);
    ground.faces(surfaces);
    if (in_room) canvas.unclip();
  }
}

void SceneSheet2::draw_text(PictureCanvas& canvas, const std::string& text, double base_line, TextStyle style) const {
  const double room = frame_.bottom_right().x - frame_.top_left().x, wide = canvas.text_width(text, style);
  if (wide > room) style.size *= room / wide;
  canvas.text(Mark::kTitle, {frame_.top_left().x, base_line}, text, style);
}

void SceneSheet2::draw_walls(PictureCanvas& canvas, const std::vector<bool>& hidden) const {
  for (std::uint32_t s = 0; s < corners_.surfaces(); ++s)
    if (!is_patch_[s] && (hidden.empty() || !hidden[s]))
      canvas.stroke(Mark::kEdge, from(s), to(s), palette::kInk, wall_width_);
}

void SceneSheet2::draw_footer_paper(PictureCanvas& canvas) const {
  if (!has_footer_over_drawing_) return;
  canvas.fill_rectangle(Mark::kPaper, {0, footer_top_ - 8 * unit_}, {frame_.width(), frame_.height()},
                        palette::kPaper.with_alpha(0.85));
}

void SceneSheet2::draw_scale_bar(PictureCanvas& canvas) const {
  const double room = std::min(190 * unit_, (footer_right_ - footer_left_) / 4);
  hottel::draw_scale_bar(canvas, frame_.pixels_per_length(), length_unit_,
                         {.right = {footer_right_, footer_top() + 31 * unit_}, .room = room, .unit = unit_});
}

void SceneSheet2::draw_axes(PictureCanvas& canvas) const { draw_axes_2(canvas, frame_, unit_, length_unit_); }

}  // namespace hottel
