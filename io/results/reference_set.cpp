#include "io/results/reference_set.h"

#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>

#include "geometry/unit_of_length.h"
#include "io/files/text_file.h"
#include "io/results/npy.h"
#include "io/results/radiosity_files.h"
#include "io/results/reference_pages.h"
#include "kernel/version.h"

namespace hottel {
namespace {

std::string written(const std::function<void(const Sink&)>& write) {
  std::string text;
  write([&text](std::string_view piece) { text += piece; });
  return text;
}

nlohmann::ordered_json manifest_entry(const SceneReference& scene) {
  nlohmann::ordered_json json;
  json["name"] = scene.name;
  json["problem"] = {{"is", "discrete"},
                     {"radiosity", "constant on each element"},
                     {"unknowns", scene.unknowns},
                     {"channels", scene.channels}};
  json["units"] = {
      {"coordinates", scene.units.coordinates}, {"areas", scene.units.areas}, {"radiosities", scene.units.radiosities}};
  json["counts"] = {{"surfaces", scene.counts.surfaces},
                    {"elements", scene.counts.elements},
                    {"vertices", scene.counts.vertices},
                    {"pairs", scene.counts.pairs},
                    {"factors", scene.factors}};
  json["factors"] = {{"guarantee", to_string(scene.of_factors)}, {"closure_is_exact", scene.counts.closure_is_exact}};
  if (scene.tolerance) {
    json["factors"]["tolerance"] = *scene.tolerance;
    json["factors"]["enclosed"] = scene.enclosed;
    json["factors"]["estimated"] = scene.factors - scene.enclosed;
    json["factors"]["max_defect"] = scene.max_defect;
  }
  json["radiosities"] = {{"of", "the discrete problem of these elements"},
                         {"guarantee", to_string(scene.of_radiosities)},
                         {"max_relative_width", scene.max_relative_width}};
  for (const auto& [file, shape] : scene.lights) {
    const nlohmann::ordered_json light = {{"quantity", "mean irradiance"}, {"shape", shape}, {"guarantee", "none"}};
    file == "illumination" ? json["light"] = light : json["lights"][file] = light;
  }
  json["files"] = nlohmann::ordered_json::array();
  for (const SetFile& file : scene.files)
    json["files"].push_back({{"file", file.path}, {"bytes", file.text.size()}, {"sha256", sha256(file.text)}});
  return json;
}

ReferenceUnits units_of(const SceneTable& scene, const char* area) {
  const std::string length = length_unit(scene);
  return {length, (has_known_unit(scene) ? "m" : length) + area, kRadiosityUnit};
}

void add_light(const std::string& folder, const ReferenceLight& light, SceneReference& scene) {
  scene.lights.emplace_back(light.file, light.shape);
  const std::string npy = folder + light.file + ".npy";
  scene.files.push_back({npy, written([&](const Sink& sink) { write_npy(light.shape, light.values, sink); })});
  scene.files.push_back({npy + ".json", light.sidecar});
}

// Counts of the matrix, and what is known of it.
void add_counts(const SolvedScene& solved, SceneReference& scene) {
  const ExchangeMatrix& matrix = solved.matrix;
  scene.counts = solved.counts;
  scene.factors = matrix.entry_count();
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    scene.unknowns += matrix.has_row(i) ? 1 : 0;
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k)
      scene.enclosed += matrix.guarantee(i, k) == Guarantee::kEstimated ? 0 : 1;
  }
}

}  // namespace

ReferenceUnits reference_units_2(const SceneTable& scene) { return units_of(scene, ""); }
ReferenceUnits reference_units_3(const SceneTable& scene) { return units_of(scene, "²"); }

SceneReference scene_reference(const std::string& name, ReferenceUnits units, std::string text,
                               const SolvedScene& solved) {
  const ExchangeMatrix& matrix = solved.matrix;
  SceneReference result;
  result.name = name;
  result.units = std::move(units);
  result.channels = solved.solution.channel_names;
  add_counts(solved, result);
  result.of_factors = matrix.guarantee();
  result.of_radiosities = solved.solution.guarantee;
  result.max_defect = solved.max_defect;
  result.tolerance = solved.tolerance;
  result.max_relative_width = solved.solution.max_relative_width;
  const FactorTable table{solved.scene, matrix, Granularity::kElement, {}, {}};
  const std::string folder = name + "/";
  result.files.push_back({folder + "scene.json", std::move(text)});
  result.files.push_back({folder + "factors.csv", written([&](const Sink& sink) { write_factors_csv(table, sink); })});
  result.files.push_back({folder + "factors.mtx", written([&](const Sink& sink) { write_factors_mtx(table, sink); })});
  result.files.push_back({folder + "factors.mtx.faces.csv", written(solved.write_faces)});
  result.files.push_back({folder + "radiosity.csv", written([&](const Sink& sink) {
                            write_radiosity_csv(solved.scene, matrix, solved.solution, sink);
                          })});
  for (const ReferenceLight& light : solved.lights) add_light(folder, light, result);
  return result;
}

std::vector<SetFile> set_files(std::vector<SceneReference> scenes, const std::string& options) {
  const std::string command = "hottel reference AGAIN */scene.json" + options;
  nlohmann::ordered_json manifest;
  manifest["hottel"] = kVersion;
  manifest["licence"] = "CC0-1.0";
  manifest["made_by"] = command;
  manifest["scenes"] = nlohmann::ordered_json::array();
  std::vector<SetFile> files;
  for (SceneReference& scene : scenes) {
    manifest["scenes"].push_back(manifest_entry(scene));
    std::move(scene.files.begin(), scene.files.end(), std::back_inserter(files));
  }
  files.push_back({"reference.json", manifest.dump(2) + "\n"});
  files.push_back({"README.md", reference_readme(command)});
  files.push_back({"LICENSE.txt", reference_licence()});
  std::string sums;
  for (const SetFile& file : files) sums += sha256(file.text) + "  " + file.path + "\n";
  files.push_back({"SHA256SUMS", std::move(sums)});
  return files;
}

}  // namespace hottel
