// The files of hottel solve, of scenes of either dimension: opened before the work, there all together when it is done.
#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/solve_options.h"
#include "cli/streams.h"
#include "geometry/exchange_matrix.h"
#include "geometry/scene_table.h"
#include "io/files/output_file.h"
#include "io/results/solve_report.h"
#include "solver/radiosity/net_flux.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// A scene and what came of it.
struct Solved {
  const SceneTable& scene;
  const ExchangeMatrix& matrix;
  const RadiositySolution& solution;
  const NetFluxes& fluxes;
};

// radiosity.csv, flux.csv, temperature.csv where a face has one, report.json, and what else a run adds.
//
//   (1) a path that cannot be written is found when a file is added, before the work
//   (2) all files are whole before the first one takes its name; the report is the last
//   (3) what says what a file holds takes its name before it: files take theirs in the reverse of their order here
class SolveFiles {
 public:
  // Makes the folder where there is none. Throws OutputError, here and below.
  SolveFiles(const std::filesystem::path& folder, const SceneTable& scene);

  // Opens a file of the folder. It stays where it is. REQUIRES one of the names that solve has; of a grid with a name,
  // with that before the ending: `kind` is the name without it.
  OutputFile& add(const std::string& kind) { return add(kind, kind); }
  OutputFile& add(const std::string& kind, const std::string& name);
  // Opens a file that was named by itself.
  OutputFile& add_elsewhere(const std::filesystem::path& file);
  // Takes a file that is open already: it takes its name with the others. REQUIRES that it outlives this.
  void add(OutputFile& file) { files_.push_back(&file); }

  void write_tables(const Solved& solved, std::optional<int> digits);
  // Ends the run: writes the report, to standard output too where options.json, gives all files their names, and says
  // what came of it, with `more` at the end.
  void finish(const SolveOptions& options, const SolveReport& report, const Solved& solved, const std::string& more,
              Streams& streams);

 private:
  bool has(const std::string& name) const;
  std::string names() const;
  std::string earlier() const;

  OutputFolder made_;
  std::filesystem::path folder_;
  std::deque<OutputFile> own_;
  std::vector<std::pair<std::string, std::string>> names_;  // kinds and names of files of the folder
  std::vector<OutputFile*> files_;
  OutputFile &radiosity_, &flux_;
  OutputFile* temperature_;
  OutputFile report_;
};

}  // namespace hottel
