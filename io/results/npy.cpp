#include "io/results/npy.h"

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
  sidecar["shape"] = {region.ny, region.nx};
  sidecar["order"] = "C";
  sidecar["axes"] = {"y", "x"};
  sidecar["region"]["min"] = region.min;
  sidecar["region"]["max"] = region.max;
}

void add_shape(const PlanarRegion& region, Json& sidecar) {
  sidecar["shape"] = {region.nv, region.nu};
  sidecar["order"] = "C";
  sidecar["axes"] = {"v", "u"};
  sidecar["region"]["origin"] = region.origin;
  sidecar["region"]["u"] = region.u;
  sidecar["region"]["v"] = region.v;
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

std::string illumination_sidecar(const PlanarRegion& region, const std::vector<std::string>& channels) {
  return sidecar_of_light(region, channels, "point");
}

std::string shown_sidecar(const GridRegion& region, const std::string& quantity, const std::string& unit) {
  return sidecar_of_values(region, quantity, unit);
}

std::string shown_sidecar(const PlanarRegion& region, const std::string& quantity, const std::string& unit) {
  return sidecar_of_values(region, quantity, unit);
}

std::string texel_sidecar(const PlanarRegion& region, const std::string& face,
                          const std::vector<std::string>& channels) {
  Json sidecar;
  sidecar["quantity"] = "radiosity";
  sidecar["unit"] = kRadiosityUnit;
  sidecar["face"] = face;
  add_shape(region, sidecar);
  add_channels(channels, sidecar);
  return sidecar.dump(2) + "\n";
}

std::string texel_sidecar(const PlanarRegion& region, const std::string& face, const std::string& quantity,
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
