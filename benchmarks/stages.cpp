// Where the time of `hottel solve` goes: the program as it is, on the scenes of scenes/showcase and on clutter.
//
// Each iteration runs the program anew, with the default grid, and takes the seconds of its report. The time reported
// is their sum; `share_STAGE` is the percentage of a stage: read (the scene), prepare (overlay and triangulation),
// factors, radiosity, certificate, irradiance, illumination, picture (with its encoding), write (the other files).
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "benchmarks/clutter.h"
#include "benchmarks/folder.h"
#include "io/scene/scene_json.h"

namespace hottel::benchmarks {
namespace {

std::string stage_of(const std::string& name) {
  for (const char* part : {"label", "sweep", "strings", "round", "exact", "matrix"})
    if (name == part) return "factors";
  return name;
}

void stages(benchmark::State& state, const std::string& scene, const Folder& folder) {
  const std::string command =
      std::string("'") + HOTTEL_PROGRAM + "' solve '" + scene + "' --quiet -o '" + folder.file("out") + "'";
  std::map<std::string, double> seconds;
  double all = 0;
  for (auto _ : state) {
    if (std::system(command.c_str()) != 0) {
      state.SkipWithError("the program failed");
      return;
    }
    double total = 0;
    const auto report = nlohmann::json::parse(std::ifstream(folder.file("out/report.json")));
    for (const auto& [name, time] : report.at("seconds").items()) {
      seconds[stage_of(name)] += time.get<double>();
      total += time.get<double>();
    }
    state.SetIterationTime(total);
    all += total;
  }
  for (const auto& [stage, time] : seconds) state.counters["share_" + stage] = 100 * time / all;
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  const Folder folder("stages");
  const auto add = [&](const std::string& name, const std::string& file) {
    add_case("stages/" + name, [=, &folder](benchmark::State& state) { stages(state, file, folder); });
  };
  for (const std::string name : {"apartment", "museum", "maze"}) add(name, "scenes/showcase/" + name + ".json");
  for (const std::uint64_t edges : {300, 3'000}) {
    const std::string file = folder.file("clutter" + std::to_string(edges) + ".json");
    std::ofstream(file) << hottel::write_scene_2(clutter(View::kShort, edges));
    add("clutter/" + to_string(View::kShort, edges), file);
  }
  return run(argc, argv);
}
