#include "cli/solve_files.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "io/results/radiosity_files.h"
#include "io/results/temperature_files.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// In the order in which they are said, and the report.
constexpr std::array<const char*, 19> kNames{"radiosity.csv",
                                             "flux.csv",
                                             "temperature.csv",
                                             "radiosity.vtu",
                                             "illumination.npy",
                                             "illumination.npy.json",
                                             "illumination.vti",
                                             "illumination.vts",
                                             "illumination_error.npy",
                                             "illumination_error.npy.json",
                                             "illumination.exr",
                                             "shown.npy",
                                             "shown.npy.json",
                                             "shown.exr",
                                             "texels.npy",
                                             "texels.npy.json",
                                             "texels.png",
                                             "illumination.png",
                                             "render.png"};

// Whether a file is of a kind: called so, or of a grid, with its name before the ending.
bool is_of_kind(const std::string& name, const std::string& kind) {
  if (name == kind) return true;
  const std::size_t stem = kind.find('.');
  const bool is_of_grids = kind.starts_with("illumination") || kind.starts_with("shown");
  return is_of_grids && name.starts_with(kind.substr(0, stem) + "-") && name.ends_with(kind.substr(stem));
}

}  // namespace

SolveFiles::SolveFiles(const std::filesystem::path& folder, const SceneTable& scene)
    : made_(folder),
      folder_(folder),
      radiosity_(add("radiosity.csv")),
      flux_(add("flux.csv")),
      temperature_(has_temperatures(scene) ? &add("temperature.csv") : nullptr),
      report_(folder / "report.json") {}

OutputFile& SolveFiles::add(const std::string& kind, const std::string& name) {
  HOTTEL_REQUIRE(std::ranges::find(kNames, kind) != kNames.end());
  names_.emplace_back(kind, name);
  return add_elsewhere(folder_ / name);
}

OutputFile& SolveFiles::add_elsewhere(const std::filesystem::path& file) {
  OutputFile& opened = own_.emplace_back(file);
  add(opened);
  return opened;
}

void SolveFiles::write_tables(const Solved& solved, std::optional<int> digits) {
  const auto to = [](OutputFile& file) { return [&file](std::string_view text) { file.write(text); }; };
  write_radiosity_csv(solved.scene, solved.matrix, solved.solution, to(radiosity_), digits);
  write_flux_csv(solved.fluxes, to(flux_), digits);
  if (temperature_ != nullptr)
    write_temperature_csv(solved.scene, solved.matrix, solved.solution, to(*temperature_), digits);
}

void SolveFiles::finish(const SolveOptions& options, const SolveReport& report, const Solved& solved,
                        const std::string& more, Streams& streams) {
  report_.write(solve_json(report));
  for (OutputFile* file : files_) file->finish();
  report_.finish();
  if (options.json) streams.write("", solve_json(report));
  for (std::size_t k = files_.size(); k-- > 0;) files_[k]->commit();
  report_.commit();
  streams.note(solve_text(report) + small_scene_text(solved.scene, solved.matrix, solved.solution) + "\nin " +
               folder_.string() + ":" + names() + " report.json" + earlier() + more);
}

bool SolveFiles::has(const std::string& name) const {
  return std::ranges::any_of(names_, [&](const auto& each) { return each.second == name; });
}

std::string SolveFiles::names() const {
  std::string names;
  for (const char* kind : kNames)
    for (const auto& [its_kind, name] : names_)
      if (its_kind == kind) names += " " + name;
  return names;
}

// Files of `hottel solve` that this run did not write.
std::string SolveFiles::earlier() const {
  std::vector<std::string> there;
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    there.push_back(entry.path().filename().string());
  std::ranges::sort(there);
  std::string names;
  for (const char* kind : kNames)
    for (const std::string& name : there)
      if (!has(name) && is_of_kind(name, kind)) names += " " + name;
  return names.empty() ? names : "\nof an earlier run, and left as it was:" + names;
}

}  // namespace hottel
