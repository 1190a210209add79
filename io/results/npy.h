// NumPy's file format, version 1.0: arrays of float64 in C order, little-endian; and beside FILE.npy, as FILE.npy.json,
// what such a file does not say of itself.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hottel {

// Returns what stands before the numbers of an array of that shape: magic, version, a header padded to whole 64 bytes.
// The numbers follow as they lie in memory, the last index running fastest.
// `type` is NumPy's word for what a number is: '<f8' is float64.
std::string npy_header(std::span<const std::size_t> shape, std::string_view type = "<f8");

// Returns a whole array of texts, as code points. REQUIRES well-formed UTF-8.
std::string npy_of_texts(const std::vector<std::string>& texts);

// Writes a whole array through a sink; whatever the sink throws stops the writing.
// REQUIRES as many values as the shape has places; throws ContractViolation otherwise. COST: the sink is called twice,
// the values are not copied.
void write_npy(std::span<const std::size_t> shape, std::span<const double> values,
               const std::function<void(std::string_view)>& sink);

// Returns a JSON object of `quantity`, `shape`, `order` ("C": the last index runs fastest), `axes`, `region` (`min` and
// `max`: the outer borders of the first and the last cells, as the doubles next to them, null where
// doubles do not tell them), `channels`, and `grid`, the name of a grid that has one. A place that is NaN lies in a
// solid. way: how the light was computed, as `--illumination` names it.
struct GridRegion {
  std::array<double, 2> min, max;  // corners
  std::size_t nx = 0, ny = 0;      // cells
  std::string name{};
};
std::string illumination_sidecar(const GridRegion& region, const std::vector<std::string>& channels,
                                 std::string_view way);

// The same of light on a grid in space: axes v, u, channel; a region of `origin`, `u` and `v`, the two sides of the
// parallelogram that the cells are parts of, and `grid`, its name, where it has one. Of a volume axes w, v, u, channel,
// and `w`, the third side. way: "point", mean irradiance at
// the centres of cells; "average", the `irradiance` of cells on the side that u x v points to, with the `max_error` of
// their values.
struct GridRegion3 {
  std::array<double, 3> origin, u, v;
  std::size_t nu = 0, nv = 0;  // cells
  std::string name{};
  std::optional<std::array<double, 3>> w{};  // of a volume
  std::size_t nw = 1;
};
std::string illumination_sidecar(const GridRegion3& region, const std::vector<std::string>& channels,
                                 std::optional<double> max_error = std::nullopt);
// Of what each of these averages may be off: one number a cell, axes v, u.
std::string average_error_sidecar(const GridRegion3& region);
// The same of one number a cell, of a quantity by its name and unit: axes v, u.
std::string shown_sidecar(const GridRegion3& region, const std::string& quantity, const std::string& unit);
// The same of texels of a face, with its name as `face`: of radiosity in W/m² by channel, axes v, u, channel; and of
// one number a texel, axes v, u.
std::string texel_sidecar(const GridRegion3& region, const std::string& face, const std::vector<std::string>& channels);
std::string texel_sidecar(const GridRegion3& region, const std::string& face, const std::string& quantity,
                          const std::string& unit);
// Of the pixels of what a camera sees: radiosity in W/m², axes y (from the top down), x, channel.
std::string pixel_sidecar(std::size_t height, std::size_t width, const std::vector<std::string>& channels);
// The same of one number a cell in the plane: axes y, x.
std::string shown_sidecar(const GridRegion& region, const std::string& quantity, const std::string& unit);

}  // namespace hottel
