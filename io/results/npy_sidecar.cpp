#include "io/results/npy_sidecar.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "kernel/rational.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Point2& p) { return {to_double(p.x), to_double(p.y)}; }

}  // namespace

std::string illumination_sidecar(const IlluminationGrid& light, const std::vector<std::string>& channels,
                                 std::string_view way) {
  Json sidecar;
  sidecar["quantity"] = way == "inverse-square" ? "sum of B H / r^2" : "mean irradiance";
  sidecar["illumination"] = way;
  sidecar["shape"] = {light.grid.ny, light.grid.nx, light.channels};
  sidecar["order"] = "C";
  sidecar["axes"] = {"y", "x", "channel"};
  sidecar["region"]["min"] = json_of(light.grid.min);
  sidecar["region"]["max"] = json_of(light.grid.max);
  sidecar["channels"] = channels;
  return sidecar.dump(2) + "\n";
}

std::string factors_sidecar(const FactorTable& table) {
  const std::size_t n = table.matrix.size() + std::size_t{1};
  Json sidecar;
  sidecar["quantity"] = table.gray_channel ? "script-F" : "view factor";
  sidecar["shape"] = {n, n};
  sidecar["order"] = "C";
  sidecar["axes"] = {"from", "to"};
  Json names = Json::array(), areas = Json::array();
  for (const Element& element : table.matrix.elements()) {
    names.push_back(element.name);
    areas.push_back(std::isfinite(element.area.value) ? Json(element.area.value) : Json());
  }
  names.push_back("sky");
  areas.push_back(nullptr);
  sidecar["names"] = std::move(names);
  sidecar["areas"] = std::move(areas);
  return sidecar.dump(2) + "\n";
}

}  // namespace hottel
