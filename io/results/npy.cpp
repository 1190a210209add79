#include "io/results/npy.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "kernel/rational.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

static_assert(std::endian::native == std::endian::little, "numbers are written as the machine holds them");

std::string npy_header(std::span<const std::size_t> shape, std::string_view type) {
  std::string sides;
  for (const std::size_t side : shape) sides += (sides.empty() ? "" : " ") + std::to_string(side) + ",";
  if (shape.size() > 1) sides.pop_back();  // a tuple of one keeps its comma
  std::string text = "{'descr': '" + std::string(type) + "', 'fortran_order': False, 'shape': (" + sides + "), }";
  constexpr std::size_t kPreamble = 10;
  text.append(63 - (kPreamble + text.size()) % 64, ' ');
  text += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(text.size() & 0xff);
  header += static_cast<char>(text.size() >> 8);
  return header + text;
}

namespace {

// Well-formed UTF-8 as code points.
std::u32string code_points(std::string_view text) {
  std::u32string result;
  for (std::size_t k = 0; k < text.size();) {
    const auto lead = static_cast<unsigned char>(text[k]);
    const std::size_t more = lead < 0x80 ? 0 : lead < 0xE0 ? 1 : lead < 0xF0 ? 2 : 3;
    char32_t code = more == 0 ? lead : lead & (0x3Fu >> more);
    for (std::size_t i = 1; i <= more; ++i) code = code << 6 | (static_cast<unsigned char>(text[k + i]) & 0x3Fu);
    result += code;
    k += more + 1;
  }
  return result;
}

}  // namespace

std::string npy_of_texts(const std::vector<std::string>& texts) {
  std::vector<std::u32string> lines;
  std::size_t width = 1;
  for (const std::string& text : texts) {
    lines.push_back(code_points(text));
    width = std::max(width, lines.back().size());
  }
  const std::size_t shape[] = {texts.size()};
  std::string bytes = npy_header(shape, "<U" + std::to_string(width));
  for (std::u32string& line : lines) {
    line.resize(width, U'\0');
    bytes.append(reinterpret_cast<const char*>(line.data()), width * sizeof(char32_t));
  }
  return bytes;
}

void write_npy(std::span<const std::size_t> shape, std::span<const double> values,
               const std::function<void(std::string_view)>& sink) {
  std::size_t places = 1;
  for (const std::size_t side : shape) places *= side;
  HOTTEL_REQUIRE(places == values.size());
  sink(npy_header(shape));
  sink({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
}

namespace {

using Json = nlohmann::ordered_json;

void add_shape(const GridRegion& region, Json& sidecar) {
  if (!region.name.empty()) sidecar["grid"] = region.name;
  sidecar["shape"] = {region.ny, region.nx};
  sidecar["order"] = "C";
  sidecar["axes"] = {"y", "x"};
  sidecar["region"]["min"] = region.min;
  sidecar["region"]["max"] = region.max;
}

void add_shape(const GridRegion3& region, Json& sidecar) {
  if (!region.name.empty()) sidecar["grid"] = region.name;
  sidecar["shape"] = region.w ? Json{region.nw, region.nv, region.nu} : Json{region.nv, region.nu};
  sidecar["order"] = "C";
  sidecar["axes"] = region.w ? Json{"w", "v", "u"} : Json{"v", "u"};
  sidecar["region"]["origin"] = region.origin;
  sidecar["region"]["u"] = region.u;
  sidecar["region"]["v"] = region.v;
  if (region.w) sidecar["region"]["w"] = *region.w;
}

void add_channels(const std::vector<std::string>& channels, Json& sidecar) {
  sidecar["shape"].push_back(channels.size());
  sidecar["axes"].push_back("channel");
  sidecar["channels"] = channels;
}

template <class Region>
std::string sidecar_of_light(const Region& region, const std::vector<std::string>& channels, std::string_view way) {
  Json sidecar;
  sidecar["quantity"] = way == "inverse-square" ? "sum of B H / r^2" : "mean irradiance";
  sidecar["illumination"] = way;
  add_shape(region, sidecar);
  add_channels(channels, sidecar);
  return sidecar.dump(2) + "\n";
}

template <class Region>
std::string sidecar_of_values(const Region& region, const std::string& quantity, const std::string& unit) {
  Json sidecar;
  sidecar["quantity"] = quantity;
  sidecar["unit"] = unit;
  add_shape(region, sidecar);
  return sidecar.dump(2) + "\n";
}

}  // namespace

std::string illumination_sidecar(const GridRegion& region, const std::vector<std::string>& channels,
                                 std::string_view way) {
  return sidecar_of_light(region, channels, way);
}

std::string illumination_sidecar(const GridRegion3& region, const std::vector<std::string>& channels,
                                 std::optional<double> max_error) {
  if (!max_error) return sidecar_of_light(region, channels, "point");
  Json sidecar;
  sidecar["quantity"] = "irradiance";
  sidecar["illumination"] = "average";
  sidecar["max_error"] = *max_error;
  add_shape(region, sidecar);
  add_channels(channels, sidecar);
  return sidecar.dump(2) + "\n";
}

std::string average_error_sidecar(const GridRegion3& region) {
  return sidecar_of_values(region, "what irradiance may be off", kRadiosityUnit);
}

std::string shown_sidecar(const GridRegion& region, const std::string& quantity, const std::string& unit) {
  return sidecar_of_values(region, quantity, unit);
}

std::string shown_sidecar(const GridRegion3& region, const std::string& quantity, const std::string& unit) {
  return sidecar_of_values(region, quantity, unit);
}

std::string texel_sidecar(const GridRegion3& region, const std::string& face,
                          const std::vector<std::string>& channels) {
  Json sidecar;
  sidecar["quantity"] = "radiosity";
  sidecar["unit"] = kRadiosityUnit;
  sidecar["face"] = face;
  add_shape(region, sidecar);
  add_channels(channels, sidecar);
  return sidecar.dump(2) + "\n";
}

std::string texel_sidecar(const GridRegion3& region, const std::string& face, const std::string& quantity,
                          const std::string& unit) {
  Json sidecar;
  sidecar["quantity"] = quantity;
  sidecar["unit"] = unit;
  sidecar["face"] = face;
  add_shape(region, sidecar);
  return sidecar.dump(2) + "\n";
}

std::string pixel_sidecar(std::size_t height, std::size_t width, const std::vector<std::string>& channels) {
  Json sidecar;
  sidecar["quantity"] = "radiosity";
  sidecar["unit"] = kRadiosityUnit;
  sidecar["shape"] = {height, width, channels.size()};
  sidecar["order"] = "C";
  sidecar["axes"] = {"y", "x", "channel"};
  sidecar["channels"] = channels;
  return sidecar.dump(2) + "\n";
}

}  // namespace hottel
