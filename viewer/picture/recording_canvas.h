// A canvas that remembers what was drawn on it, for tests.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "viewer/picture/canvas.h"

namespace hottel {

// Remembers every call, in order, with its mark and the clip that was in force; draws nothing.
//
//   (1) calls() is exactly what was asked for: nothing is merged, rounded or left out; clip() and unclip() are no
//       calls; fill_all() is a fill of each polygon; what is drawn on a layer has the corners of all its polygons as
//       clip
//   (2) texts are taken to be 0.55 of their size wide a byte, the same on every machine
class RecordingCanvas : public PictureCanvas {
 public:
  // What was drawn: one for each function of a PictureCanvas that leaves a mark. fill_rectangle() is a fill.
  enum class Kind : unsigned char { kStroke, kFill, kDisc, kCircle, kText, kImage };

  // One mark. Not kept are the line width of a circle, the weight of a text, whether an image is smooth, and
  // between which places colours run.
  struct Call {
    Kind kind;
    Mark mark;
    std::vector<Pixel> points;  // ends, corners, centre, or the box of a text
    Colour colour{};
    double size = 0;  // width of a line, radius, size of a font
    std::string text{};
    Raster image{};
    std::vector<Pixel> clip{};        // empty: none
    std::vector<ColourStop> stops{};  // of fill_along
  };

  // Of that many pixels; what is drawn outside is recorded all the same.
  RecordingCanvas(double width, double height) : width_(width), height_(height) {}

  double width() const override { return width_; }
  double height() const override { return height_; }

  void stroke(Mark mark, Pixel from, Pixel to, Colour colour, double line_width) override {
    record({Kind::kStroke, mark, {from, to}, colour, line_width});
  }
  void fill(Mark mark, std::span<const Pixel> polygon, Colour colour) override {
    record({Kind::kFill, mark, {polygon.begin(), polygon.end()}, colour});
  }
  void fill_all(Mark mark, std::span<const std::vector<Pixel>> polygons, Colour colour) override {
    for (const std::vector<Pixel>& polygon : polygons) fill(mark, polygon, colour);
  }
  void fill_along(Mark mark, std::span<const Pixel> polygon, Pixel, Pixel, std::span<const ColourStop> stops) override {
    record({.kind = Kind::kFill,
            .mark = mark,
            .points = {polygon.begin(), polygon.end()},
            .colour = stops.front().colour,
            .stops = {stops.begin(), stops.end()}});
  }
  void disc(Mark mark, Pixel centre, double radius, Colour colour) override {
    record({Kind::kDisc, mark, {centre}, colour, radius});
  }
  void circle(Mark mark, Pixel centre, double radius, Colour colour, double) override {
    record({Kind::kCircle, mark, {centre}, colour, radius});
  }
  void text(Mark mark, Pixel at, std::string_view text, const TextStyle& style) override {
    const double wide = text_width(text, style);
    const double left = at.x - (style.anchor == TextAnchor::kLeft    ? 0
                                : style.anchor == TextAnchor::kRight ? wide
                                                                     : wide / 2);
    record({Kind::kText,
            mark,
            {{left, at.y - style.size}, {left + wide, at.y + 0.25 * style.size}},
            style.colour,
            style.size,
            std::string(text)});
  }
  void image(Mark mark, Pixel top_left, Pixel bottom_right, const Raster& image, bool) override {
    record({Kind::kImage, mark, {top_left, bottom_right}, {}, 0, {}, image});
  }
  void clip(std::span<const Pixel> polygon) override { clip_.assign(polygon.begin(), polygon.end()); }
  void unclip() override { clip_.clear(); }
  void begin_layer() override { layer_ = calls_.size(); }
  void end_layer(std::span<const std::vector<Pixel>> inside) override {
    std::vector<Pixel> corners;
    for (const std::vector<Pixel>& polygon : inside) corners.insert(corners.end(), polygon.begin(), polygon.end());
    for (std::size_t k = layer_; k < calls_.size(); ++k) calls_[k].clip = corners;
  }
  double text_width(std::string_view text, const TextStyle& style) const override {
    return 0.55 * style.size * static_cast<double>(text.size());
  }

  // All calls, in order; those with a mark; those with a mark and of a kind.
  const std::vector<Call>& calls() const { return calls_; }
  std::vector<Call> calls(Mark mark) const {
    std::vector<Call> found;
    std::copy_if(calls_.begin(), calls_.end(), std::back_inserter(found),
                 [&](const Call& c) { return c.mark == mark; });
    return found;
  }
  std::vector<Call> calls(Mark mark, Kind kind) const {
    std::vector<Call> found = calls(mark);
    std::erase_if(found, [&](const Call& c) { return c.kind != kind; });
    return found;
  }
  // How many calls have this mark.
  std::size_t count(Mark mark) const { return calls(mark).size(); }
  // Whether exactly this text was drawn, under any mark.
  bool wrote(std::string_view text) const {
    return std::any_of(calls_.begin(), calls_.end(), [&](const Call& c) { return c.text == text; });
  }

 private:
  double width_, height_;
  void record(Call call) {
    call.clip = clip_;
    calls_.push_back(std::move(call));
  }

  std::vector<Pixel> clip_;
  std::size_t layer_ = 0;  // the first call of it
  std::vector<Call> calls_;
};

}  // namespace hottel
