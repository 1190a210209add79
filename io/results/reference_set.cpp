#include "io/results/reference_set.h"

#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>

#include "io/files/text_file.h"
#include "io/results/radiosity_files.h"
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
  json["radiosities"] = {{"of", "these elements"},
                         {"guarantee", to_string(scene.of_radiosities)},
                         {"max_relative_width", scene.max_relative_width}};
  json["files"] = nlohmann::ordered_json::array();
  for (const SetFile& file : scene.files)
    json["files"].push_back({{"file", file.path}, {"bytes", file.text.size()}, {"sha256", sha256(file.text)}});
  return json;
}

constexpr const char* kReadme =
    R"(Reference solutions of diffuse light, computed by hottel {version}.

One folder a scene:

  scene.json              the scene, as it was given (one from meshes or a deck: its polygons); coordinates are the
                          decimals as typed
  factors.csv             view factors F(from, to) of all elements that see each other. The real number lies in
                          [lower, upper], proven; Vis is the visible part (S / S0). In the plane each factor is the
                          double nearest to it. In space its guarantee says what is known of the double: `enclosed` is
                          within `tolerance` (reference.json) of the smaller area over its own, proven; `estimated` is
                          within as much by two rules of quadrature that agree and a check that every pair passes
  factors.mtx             the same in Matrix Market's format; rows and columns as in the next file, the sky last
  factors.mtx.faces.csv   the elements: number, face, part, area, material, and end points (in the plane; front on the
                          right of 0 -> 1) or corners (in space; counter-clockwise seen from the front)
  radiosity.csv           B, irradiance and net of each element and channel. These elements are the problem: B is
                          constant on each, and finer elements have another solution. Of them the true B lies in
                          [lower, upper], proven, where `radiosities` of reference.json are enclosed; else these are
                          bounds of what the factors as computed give

reference.json says how many of each there are and what is guaranteed; SHA256SUMS holds the checksums of all files.

To check the files:             sha256sum -c SHA256SUMS
To judge your own factors:      hottel compare NAME/scene.json --methods file:YOUR_FACTORS.csv
To compute the set again:       hottel reference DIR NAME/scene.json    (scenes are named after their folder then)
To cite it: name hottel {version} and the checksum of SHA256SUMS. The same version writes the same bytes.
)";

std::string readme() {
  std::string text = kReadme;
  const std::string place = "{version}";
  for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at))
    text.replace(at, place.size(), kVersion);
  return text;
}

}  // namespace

SceneReference scene_reference(const std::string& name, std::string text, const SolvedScene& solved) {
  const ExchangeMatrix& matrix = solved.matrix;
  SceneReference result;
  result.name = name;
  result.counts = solved.counts;
  result.factors = matrix.entry_count();
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k)
      result.enclosed += matrix.guarantee(i, k) == Guarantee::kEstimated ? 0 : 1;
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
  return result;
}

std::vector<SetFile> set_files(std::vector<SceneReference> scenes) {
  nlohmann::ordered_json manifest;
  manifest["hottel"] = kVersion;
  manifest["scenes"] = nlohmann::ordered_json::array();
  std::vector<SetFile> files;
  for (SceneReference& scene : scenes) {
    manifest["scenes"].push_back(manifest_entry(scene));
    std::move(scene.files.begin(), scene.files.end(), std::back_inserter(files));
  }
  files.push_back({"reference.json", manifest.dump(2) + "\n"});
  files.push_back({"README.txt", readme()});
  std::string sums;
  for (const SetFile& file : files) sums += sha256(file.text) + "  " + file.path + "\n";
  files.push_back({"SHA256SUMS", std::move(sums)});
  return files;
}

}  // namespace hottel
