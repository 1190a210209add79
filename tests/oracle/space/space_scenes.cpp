#include "tests/oracle/space/space_scenes.h"

#include <fstream>
#include <nlohmann/json.hpp>

namespace hottel::oracle {
namespace {

mpq_class number(const nlohmann::json& value) {
  return value.is_string() ? mpq_class(value.get<std::string>()) : mpq_class(value.get<double>());
}

std::vector<SpacePolygon> polygons_of(const nlohmann::json& list) {
  std::vector<SpacePolygon> polygons;
  for (const auto& points : list) {
    polygons.emplace_back();
    for (const auto& p : points) polygons.back().push_back({number(p[0]), number(p[1]), number(p[2])});
  }
  return polygons;
}

}  // namespace

std::vector<SpaceCase> read_space_cases(const std::string& file) {
  std::ifstream stream(file);
  const nlohmann::json all = nlohmann::json::parse(stream);
  std::vector<SpaceCase> cases;
  for (const auto& entry : all["cases"])
    cases.push_back({entry["name"].get<std::string>(), polygons_of(entry["polygons"]), entry["value"].get<double>()});
  return cases;
}

}  // namespace hottel::oracle
