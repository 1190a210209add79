// What a camera sees of a solution, as a picture.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "solver/radiosity/direct_light.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/picture_options.h"
#include "viewer/picture/seamless_fill.h"
#include "viewer/picture/shading.h"
#include "viewer/picture/shown_values.h"
#include "viewer/picture/space/camera_view.h"
#include "viewer/picture/space/seen_outlines.h"
#include "viewer/picture/tone_curve.h"

namespace hottel {

// What is shown, and how it becomes a picture.
struct RenderOptions3 {
  Tone tone = kUsualTone3;             // of the light
  double exposure = 1;                 // what the light is multiplied by; ToneCurve says relative to what
  std::uint32_t wanted_width = 0;      // pixels across instead of the camera's, in its shape, where not 0
  Shading shading = Shading::kFlat;    // how values run over elements
  std::optional<ShownValues> shown{};  // instead of the light
  bool has_outlines = false;           // over what is shown (seen_outlines_3)
  bool has_axes = false;               // the axes and the box of the scene in the footer (Tripod3)
  Shown asked{};                       // what `shown` are values of; of Shading::kGathered
  // What lights send to elements first: then the direct light of pixels is that of each point, whatever the shading of
  // what is reflected (add_direct_light_3). Null: elements have it with the rest.
  // Gathered light has it of each point, and needs them of what sends.
  std::shared_ptr<const std::vector<LightShares>> light_shares = nullptr;
  std::optional<ToneCurve> curve{};  // of the light, instead of one that is fitted to it
  bool is_for_numbers = false;       // gathered light is told to a part of itself too, for who takes pixels()
  std::function<void(double)> progress = nullptr;  // of what is gathered: fraction done
};

// The camera of a scene, or that of default_camera_3, with so many pixels across where that is not 0.
Camera3 camera_of_scene(const PreparedScene3& prepared, std::uint32_t wanted_width);

// The picture of the scene's camera, or of default_camera_3.
//
//   (1) light has the size of the camera; a quantity on a scale has a footer below it, with bar, unit and range, and so
//       have axes
//   (2) a PNG has the pixels of camera_view_3, toned; colours of a scale are averaged as light is
//   (3) an SVG and a PDF have polygons, each in one colour, with the colours of the PNG: what hides what is decided
//       exactly at any size. Where values are blended, bands of 1/128 of the way from black to white, or of the scale,
//       have one colour each, or of more where they would be less than two pixels wide; the lines between them are
//       straight, as the values' are. Nothing shines through between neighbours: all lies on polygons of what is seen
//       that are half a pixel larger, within the border of all of them
//   (4) gathered light is that of gathered_view_3, off by half a step of 256 as a rule, as an estimate; a scale's by as
//       much. Only a PNG has it: file() throws UsageError for others
//   (5) outlines are lines over all that, without steps in a PNG
class RenderedView3 {
 public:
  // Throws as camera_view_3 does. REQUIRES: the solution of the scene's matrix by that granularity, and values of its
  // elements; that prepared outlives this.
  RenderedView3(const PreparedScene3& prepared, Granularity granularity, const RadiositySolution& solution,
                RenderOptions3 options);

  std::uint32_t width() const { return camera_.width; }
  std::uint32_t height() const { return camera_.height + footer_; }
  // What the light was multiplied by before it was toned; of other quantities 1.
  double scale() const { return tone_ ? tone_->scale() : 1; }

  // The curve of the light. REQUIRES that light is shown.
  const ToneCurve& tone() const { return *tone_; }
  // What the pixels show, before curves and colours; without the footer.
  const PixelValues3& pixels() const { return pixels_; }
  // What is shown instead of the light.
  const std::optional<ShownValues>& shown() const { return options_.shown; }

  // Returns the bytes of a file. COST: of shapes once more that of the map.
  std::string file(PictureFormat format) const;
  const Camera3& camera() const { return camera_; }
  // Draws as shapes. REQUIRES a canvas of width() by height().
  void draw(PictureCanvas& canvas) const;

 private:
  SeenScene3 seen() const { return {prepared_, table_, paint_, mesh_ ? &*mesh_ : nullptr}; }
  void add_pixels(const RadiositySolution& solution);
  void gather(Granularity granularity, const RadiositySolution& solution);
  double steps_between(const ToneCurve* curve, std::span<const double> a, std::span<const double> b) const;
  Colour colour_of(std::span<const double> shown) const;
  Colour colour_of_value(std::span<const double> value) const;
  std::vector<double> levels() const;
  std::vector<double> weights() const;
  // What is drawn, and what lies below it: each part of what is seen in one colour.
  struct Shapes {
    std::vector<ColouredPolygons> above, below;
  };
  Shapes shapes() const;
  void add_bands(const SeenPart3& part, std::span<const double> levels, std::vector<ColouredPolygons>& fills) const;
  void draw_outlines(PictureCanvas& canvas) const;
  void draw_footer(PictureCanvas& canvas) const;
  std::string png() const;

  const PreparedScene3& prepared_;
  RenderOptions3 options_;
  Camera3 camera_;
  const ElementTable3& table_;
  ElementPaint3 paint_;
  std::optional<SmoothMesh3> mesh_;
  PixelValues3 pixels_;
  std::optional<ToneCurve> tone_;  // of light
  std::vector<OutlineStroke3> outlines_;
  std::uint32_t footer_ = 0;
};

// One file of it, and its scale.
struct RenderedPicture3 {
  std::string bytes;
  double scale = 1;
};
RenderedPicture3 render_picture_3(const PreparedScene3& prepared, Granularity granularity,
                                  const RadiositySolution& solution, const RenderOptions3& options,
                                  PictureFormat format = PictureFormat::kPng);

}  // namespace hottel
