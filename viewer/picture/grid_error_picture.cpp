#include "viewer/picture/grid_error_picture.h"

#include <algorithm>
#include <cmath>

#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/palette.h"

namespace hottel {
namespace {

constexpr double kDecades = 1e-4;  // least over largest value of the scale
constexpr double kLongerSide = 900, kMargin = 40, kHeading = 56, kFooter = 84;

double length(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

// By cell, the largest over the channels; NaN where there is none.
std::vector<double> cell_errors(const GridValues& found, const GridValues& exact) {
  std::vector<double> errors(std::size_t{exact.nx} * exact.ny, 0);
  for (std::size_t k = 0; k < exact.values.size(); ++k) {
    double& error = errors[k / exact.channels];
    const double here = std::abs(found.values[k] - exact.values[k]);
    error = std::isnan(error) || !std::isfinite(here) ? std::nan("") : std::max(error, here);
  }
  return errors;
}

}  // namespace

std::string grid_error_picture(const GridValues& found, const GridValues& exact, const std::string& file,
                               const GridPlace& place, const std::string& quantity) {
  const std::vector<double> errors = cell_errors(found, exact);
  double largest = 0;
  for (const double error : errors) largest = std::isnan(error) ? largest : std::max(largest, error);
  ColourScale scale = largest > 0 ? ColourScale{kDecades * largest, largest, true} : ColourScale{0, 1, false};
  scale.has_zero = scale.logarithmic && std::ranges::find(errors, 0.0) != errors.end();

  Raster cells(exact.nx, exact.ny);
  for (std::uint32_t y = 0; y < exact.ny; ++y)
    for (std::uint32_t x = 0; x < exact.nx; ++x) {
      const double error = errors[std::size_t{exact.ny - 1 - y} * exact.nx + x];
      cells.pixels[std::size_t{y} * exact.nx + x] =
          pixel_of(std::isnan(error) ? palette::kHatch : scale_colour(scale, error));
    }
  const double u = length(place.u), v = length(place.v), most = std::max(u, v);
  const double wide = std::max(kLongerSide * u / most, 1.0), high = std::max(kLongerSide * v / most, 1.0);
  const double room = std::max(wide, 420.0);
  CairoCanvas canvas(PictureFormat::kPng, static_cast<std::uint32_t>(std::lround(room + 2 * kMargin)),
                     static_cast<std::uint32_t>(std::lround(high + kHeading + kFooter + kMargin)));
  canvas.fill_rectangle(Mark::kPaper, {0, 0}, {canvas.width(), canvas.height()}, palette::kPaper);
  TextStyle style{.size = 22, .colour = palette::kInk, .weight = TextWeight::kBold};
  const std::string title = "Error of the light: " + file;
  style.size *= std::min(1.0, room / std::max(1.0, canvas.text_width(title, style)));
  canvas.text(Mark::kTitle, {kMargin, 38}, title, style);
  canvas.image(Mark::kLight, {kMargin, kHeading}, {kMargin + wide, kHeading + high}, cells, false);
  draw_legend(canvas, scale, "|error of the " + quantity + "|", {kMargin, kHeading + high + 18},
              std::min(room / 1.6, 360.0), 1.1);
  return canvas.finish();
}

}  // namespace hottel
