// The sheet that all plane drawings share: paper, title, floors and furniture, walls, scale bar.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/plane/corners.h"
#include "viewer/picture/plane/frame.h"
#include "viewer/picture/plane/outlines.h"
#include "viewer/picture/plane/scene_picture.h"

namespace hottel {

// A scene laid out on paper. Sizes grow with the picture: a unit is a pixel of a picture 1600 pixels wide, and never
// below 0.6 pixels, so that letters stay readable.
//
//   (1) lines of walls and stripes grow with the length of a typical edge, within limits: neither a few long walls nor
//       the many sides of round pillars decide
//   (2) a heading that is too wide is written smaller
class SceneSheet2 {
 public:
  // footer: height kept free below the drawing, in units. extra_points: shown as well, in scene coordinates.
  // Throws UsageError unless the width is in [kMinPictureWidth, kMaxPictureSide].
  SceneSheet2(const PreparedScene2& prepared, const SheetText2& text, double footer,
              const std::vector<std::array<double, 2>>& extra_points = {});

  // The same in a frame that is given, as a window has it: no heading, sizes by `unit` in pixels, and the footer of
  // that many units over the drawing, at its lower border.
  SceneSheet2(const PreparedScene2& prepared, const Frame2& frame, double unit, double footer);

  const Frame2& frame() const { return frame_; }
  const Corners2& corners() const { return corners_; }
  std::uint32_t width() const { return static_cast<std::uint32_t>(frame_.width()); }
  std::uint32_t height() const { return static_cast<std::uint32_t>(frame_.height()); }
  double unit() const { return unit_; }
  double wall_width() const { return wall_width_; }  // of the line of an edge
  double stripe_depth() const { return stripe_depth_; }
  // Where a surface begins and ends in the picture.
  Pixel from(std::uint32_t surface) const { return corners_.at[corners_.from[surface]]; }
  Pixel to(std::uint32_t surface) const { return corners_.at[corners_.to[surface]]; }

  // What else lies on the ground, both may be empty.
  struct Ground {
    std::function<void(std::span<const std::uint32_t>)> faces;  // draws the faces of these surfaces
    std::function<void()> cover;                                // draws over the floors, beneath everything else
  };

  // Paper, title, the outlines from the outside in, floors light and warm, and over them the solids of the arrangement,
  // grey and hatched. Faces are clipped to the room they are in; each surface is handed to `faces` once.
  void draw_ground(PictureCanvas& canvas, const Ground& ground) const;
  // One dark line for each edge that is not hidden, but for patches, which lie on one. hidden: one entry per surface,
  // or none at all.
  void draw_walls(PictureCanvas& canvas, const std::vector<bool>& hidden = {}) const;
  // Paper behind a footer that lies over the drawing, translucent; nothing where there is room kept free for it.
  void draw_footer_paper(PictureCanvas& canvas) const;
  // A bar of a round length (1, 2 or 5 times a power of ten, in the unit of the scene) at the right of the footer; at
  // most a quarter of the drawing's width.
  void draw_scale_bar(PictureCanvas& canvas) const;
  // Coordinates along the frame (axes.h).
  void draw_axes(PictureCanvas& canvas) const;
  // The top of the footer's content, and its ends.
  double footer_top() const { return footer_top_; }
  double footer_left() const { return footer_left_; }
  double footer_right() const { return footer_right_; }

 private:
  void set_widths();
  void draw_heading(PictureCanvas& canvas) const;
  void draw_level(PictureCanvas& canvas, std::size_t level, const Ground& ground) const;
  void draw_outside_faces(PictureCanvas& canvas, std::size_t level, const Ground& ground) const;
  void draw_text(PictureCanvas& canvas, const std::string& text, double base_line, TextStyle style) const;

  std::string title_, subtitle_, length_unit_;
  double unit_;
  Frame2 frame_;
  Corners2 corners_;
  Outlines2 outlines_;
  std::vector<std::vector<Pixel>> solids_;
  std::vector<bool> is_patch_;  // by surface
  double wall_width_ = 0, stripe_depth_ = 0;
  bool has_footer_over_drawing_ = false;
  double footer_top_, footer_left_, footer_right_;
};

}  // namespace hottel
