// Draws docs/images/neighbouring_doubles.png: on which side of a line through two points 256 x 256 adjacent doubles
// lie, as plain doubles have it and as hottel has it.
#include <fmt/core.h>

#include <exception>
#include <functional>

#include "io/files/output_file.h"
#include "tests/geometry/plane/vertex_literal.h"
#include "tests/neighbouring_doubles/grid.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/palette.h"

namespace hottel {
namespace {

using namespace neighbouring_doubles;

constexpr double kScale = 3, kPanel = kScale * kSide, kGap = 24, kTitle = 64, kLegend = 44;
constexpr Colour kLeft = palette::kCurves[0], kOn = palette::kEmitter, kRight = palette::kCurves[1];

const Colour& colour_of(int sign) { return sign > 0 ? kLeft : sign < 0 ? kRight : kOn; }

// One panel with the number of wrong signs in its title.
void draw_panel(PictureCanvas& canvas, const Grid& grid, double left, const char* title,
                const std::function<int(const Double2&)>& side) {
  Raster image(kSide, kSide);
  auto pixel = image.pixels.begin();
  int wrong = 0;
  for (int j = kSide - 1; j >= 0; --j)
    for (int i = 0; i < kSide; ++i) {
      const Double2 p = grid.at(i, j);
      const int sign = side(p);
      wrong += sign != exact_orientation(exact(p), exact(grid.q), exact(grid.r));
      *pixel++ = pixel_of(colour_of(sign));
    }
  canvas.image(Mark::kPaper, {left, kTitle}, {left + kPanel, kTitle + kPanel}, image, false);
  canvas.text(Mark::kTitle, {left, 28}, title, {20, palette::kInk, TextAnchor::kLeft, TextWeight::kBold});
  canvas.text(Mark::kTitle, {left, 52}, fmt::format("{} of {} signs wrong", wrong, kSide * kSide), {16, palette::kInk});
  fmt::print("{}: {} of {} signs wrong\n", title, wrong, kSide * kSide);
}

void draw_legend(PictureCanvas& canvas, double top) {
  double x = kGap;
  for (const auto& [colour, text] : {std::pair(kLeft, "left of the line"), {kOn, "on it"}, {kRight, "right of it"}}) {
    canvas.fill_rectangle(Mark::kLegend, {x, top - 13}, {x + 16, top + 3}, colour);
    canvas.text(Mark::kLegend, {x + 24, top}, text, {16, palette::kInk});
    x += 24 + canvas.text_width(text, {16, palette::kInk}) + 32;
  }
  canvas.text(Mark::kLegend, {x, top},
              "Points (1/2 + i·2⁻⁵³, 1/2 + j·2⁻⁵³), i, j = 0..255, and the line through (12, 12) and (24, 24)",
              {16, palette::kInk});
}

void draw(const char* file) {
  const Grid& grid = kettner_grids().front();
  CairoCanvas canvas(PictureFormat::kPng, static_cast<std::uint32_t>(2 * kPanel + 3 * kGap),
                     static_cast<std::uint32_t>(kTitle + kPanel + kLegend));
  canvas.fill_rectangle(Mark::kPaper, {0, 0}, {canvas.width(), canvas.height()}, palette::kPaper);
  draw_panel(canvas, grid, kGap, "Plain doubles",
             [&](const Double2& p) { return naive_orientation(p, grid.q, grid.r); });
  draw_panel(canvas, grid, 2 * kGap + kPanel, "hottel", [&](const Double2& p) {
    const std::vector<Point2> points{exact(grid.q), exact(grid.r), exact(p)};
    return Vertices2(points, points.size()).orientation(2_v, 0_v, 1_v);
  });
  draw_legend(canvas, kTitle + kPanel + 28);
  write_output_file(file, canvas.finish());
}

}  // namespace
}  // namespace hottel

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: hottel_neighbouring_doubles FILE.png\n");
    return 2;
  }
  try {
    hottel::draw(argv[1]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
