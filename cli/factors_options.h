// The options of hottel factors, and its files: what both dimensions have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/guarantee_option.h"
#include "cli/scene_input.h"
#include "cli/sky_option.h"
#include "cli/store_option.h"
#include "cli/streams.h"
#include "cli/sums_option.h"
#include "geometry/exchange_request.h"
#include "io/results/factor_files.h"
#include "io/results/factor_hdf5.h"

namespace hottel {

struct FactorsOptions {
  std::string scene, out;
  std::string method = "exact", granularity = "face", pairs = "visible", matrix;
  std::optional<std::string> tolerance;
  GuaranteeOption guarantee;
  ElementOptions elements;
  PolygonOptions polygons;
  StoreOption store;
  SkyOption sky;
  std::vector<std::string> exact_form;
  const CLI::Option *exact_form_option = nullptr, *pairs_option = nullptr, *per_option = nullptr;
  bool wants_exact_form = false, json = false, script_f = false, areas = false;
  std::string channel;
  std::string picture, toward;
  std::string rows;  // those that are written; empty: all
  std::optional<int> digits;
  std::uint64_t memory = 0;
  SumsOption sums;
  bool awaits_deck = false;  // the scene is a deck that was not read yet: it may say the format of the output
  DeckOutput3 deck;          // what it asks for

  bool is_exact() const { return method == "exact"; }
  Granularity per() const;
  // By the ending of the file; where it is none of ours, as a deck says (out=0, out=1). Throws UsageError for one that
  // is not known, or not for what is asked.
  FactorFormat format() const;
  // Whether the pairs that see each other are listed: else all have a place.
  bool lists_pairs() const;
  // Whether the file holds the scene too.
  bool keeps_scene() const { return format() == FactorFormat::kHdf5; }
};

// Throws RequestError where a dense file of so many rows would not fit on its disk. sizes: of all faces, and of those
// that radiate.
void require_room_for(const FactorsOptions& options, const std::function<DenseSize(FactorFormat)>& size);

// Sets --per to group, and says so, where a file that holds its scene (.h5) would list more than 10^8 factors of faces,
// and neither --per nor --rows tells what of them is wanted. Returns whether it did.
bool takes_groups_of_many(FactorsOptions& options, std::size_t factors, const Streams& streams);

// The files of a run, opened before the work: a path that cannot be written is found at once.
struct FactorsFiles {
  std::optional<OutputFile> out, rows, drawing;

  FactorsFiles(const FactorsOptions& options, const Streams& streams);
  // All files are whole before the first one takes its name.
  void finish();
  void commit();
};

// Which rows have to be computed: those that are written, where nothing else is made of the matrix. Throws UnknownName
// where --rows names nothing.
RowChoice rows_to_compute(const FactorsOptions& options, const SceneTable& scene);

// Restricts a table to the rows of --rows, if there is one, and tells how many these are. Throws UsageError where none
// of those that it names has a row.
void take_rows(const FactorsOptions& options, const Streams& streams, FactorTable& table);

// Says which matrix a .npy holds: the file itself has numbers only.
void note_matrix(const FactorsOptions& options, const FactorTable& table, const Streams& streams);

// Writes the factors as they are asked for, and what their rows are where the format has a file for that. write_faces:
// writes FILE.faces.csv of a .mtx. Not for closed forms.
void write_table(const FactorsOptions& options, const FactorTable& table, const FactorOrigin& origin,
                 FactorsFiles& files, const std::function<void(const Sink&)>& write_faces);

}  // namespace hottel
