// A canvas that draws into pixels, or becomes the bytes of a PNG, an SVG or a PDF file.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "viewer/picture/canvas.h"
#include "viewer/picture/picture_options.h"
#include "viewer/picture/raster.h"

namespace hottel {

// Draws with Cairo: antialiased, sRGB, fonts of the system.
//
//   (1) the same calls give the same bytes on one machine; fonts may differ on others
//   (2) an SVG and a PDF hold shapes, texts as text that can be searched and edited, and their images as pixels; the
//       size of an SVG in pixels is that of the canvas, and a PDF is one page on which a pixel is 3/4 point
//   (3) a polygon of fewer than three corners and an image without pixels draw nothing
//   (4) a PNG holds what the same calls draw into an opaque black raster
//
// image() throws ContractViolation unless there are width * height pixels.
// COST: a text of ten letters about 2 us, which cairo remembers by size and weight; the first of a process 10 ms.
class CairoCanvas : public PictureCanvas {
 public:
  // Throws UsageError unless both sides are in [1, kMaxPictureSide], RequestError when memory does not suffice.
  CairoCanvas(PictureFormat format, std::uint32_t width, std::uint32_t height);
  // Draws onto what is in the raster, where all of it is seen after finish(), or when the canvas is gone.
  // Throws as above, and ContractViolation unless there are width * height pixels.
  // REQUIRES: the raster outlives the canvas, and nothing else writes it meanwhile.
  explicit CairoCanvas(Raster& raster);
  ~CairoCanvas() override;

  double width() const override;
  double height() const override;
  void stroke(Mark mark, Pixel from, Pixel to, Colour colour, double line_width) override;
  void fill(Mark mark, std::span<const Pixel> polygon, Colour colour) override;
  void fill_all(Mark mark, std::span<const std::vector<Pixel>> polygons, Colour colour) override;
  void fill_along(Mark mark, std::span<const Pixel> polygon, Pixel from, Pixel to,
                  std::span<const ColourStop> stops) override;
  void disc(Mark mark, Pixel centre, double radius, Colour colour) override;
  void circle(Mark mark, Pixel centre, double radius, Colour colour, double line_width) override;
  void text(Mark mark, Pixel at, std::string_view text, const TextStyle& style) override;
  void image(Mark mark, Pixel top_left, Pixel bottom_right, const Raster& raster, bool smooth) override;
  void clip(std::span<const Pixel> polygon) override;
  void unclip() override;
  void begin_layer() override;
  void end_layer(std::span<const std::vector<Pixel>> inside) override;
  double text_width(std::string_view text, const TextStyle& style) const override;

  // Returns the bytes of the file, none for a raster. Nothing can be drawn or finished afterwards. Throws RequestError
  // when cairo failed.
  std::string finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hottel
