#include "io/results/plane/reference_set.h"

#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>

#include "geometry/plane/scene/division.h"
#include "io/files/text_file.h"
#include "io/results/factor_files.h"
#include "io/results/radiosity_files.h"
#include "kernel/version.h"

namespace hottel {
namespace {

std::string written(const std::function<void(const Sink&)>& write) {
  std::string text;
  write([&text](std::string_view piece) { text += piece; });
  return text;
}

nlohmann::ordered_json manifest_entry(const SceneReference2& scene) {
  nlohmann::ordered_json json;
  json["name"] = scene.name;
  json["counts"] = {{"surfaces", scene.exchange.surfaces},
                    {"elements", scene.exchange.elements},
                    {"vertices", scene.exchange.vertices},
                    {"pairs", scene.exchange.pairs},
                    {"factors", scene.factors}};
  json["factors"] = {{"guarantee", to_string(Guarantee::kExact)},
                     {"closure_is_exact", scene.exchange.closure_is_exact}};
  json["radiosities"] = {{"guarantee", to_string(Guarantee::kEnclosed)},
                         {"max_relative_width", scene.max_relative_width}};
  json["files"] = nlohmann::ordered_json::array();
  for (const SetFile& file : scene.files)
    json["files"].push_back({{"file", file.path}, {"bytes", file.text.size()}, {"sha256", sha256(file.text)}});
  return json;
}

constexpr const char* kReadme =
    R"(Reference solutions of diffuse light in the plane, computed by hottel {version}.

One folder a scene:

  scene.json              the scene, as it was given; coordinates are the decimals as typed
  factors.csv             view factors F(from, to) of all elements that see each other. Each is the double nearest to
                          the real number; it lies in [lower, upper]. Vis is the visible part (S / S0)
  factors.mtx             the same in Matrix Market's format; rows and columns as in the next file, the sky last
  factors.mtx.faces.csv   the elements: number, face, part, area, material, end points (front on the right of 0 -> 1)
  radiosity.csv           B, irradiance and net of each element and channel; the true B lies in [lower, upper], proven

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

SceneReference2 scene_reference(const std::string& name, std::string text, const Scene2& scene,
                                const ExchangeMatrix& matrix, const ExchangeReport& exchange,
                                const RadiositySolution& solution) {
  SceneReference2 result;
  result.name = name;
  result.exchange = exchange;
  result.factors = matrix.entry_count();
  result.max_relative_width = solution.max_relative_width;
  const FactorTable table{scene, matrix, Granularity::kElement, {}, {}};
  const std::string folder = name + "/";
  result.files.push_back({folder + "scene.json", std::move(text)});
  result.files.push_back({folder + "factors.csv", written([&](const Sink& sink) { write_factors_csv(table, sink); })});
  result.files.push_back({folder + "factors.mtx", written([&](const Sink& sink) { write_factors_mtx(table, sink); })});
  result.files.push_back({folder + "factors.mtx.faces.csv", written([&](const Sink& sink) {
                            write_faces_csv(table, element_ends(scene, matrix.elements()), sink);
                          })});
  result.files.push_back({folder + "radiosity.csv",
                          written([&](const Sink& sink) { write_radiosity_csv(scene, matrix, solution, sink); })});
  return result;
}

std::vector<SetFile> set_files(std::vector<SceneReference2> scenes) {
  nlohmann::ordered_json manifest;
  manifest["hottel"] = kVersion;
  manifest["scenes"] = nlohmann::ordered_json::array();
  std::vector<SetFile> files;
  for (SceneReference2& scene : scenes) {
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
