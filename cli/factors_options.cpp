#include "cli/factors_options.h"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>

#include "io/files/disk_space.h"
#include "io/files/hdf5.h"
#include "kernel/support/failure.h"
#include "kernel/support/word_list.h"

namespace hottel {
namespace {

constexpr std::size_t kMostUnasked = 100'000'000;  // factors in a file that nobody said were wanted

// All file endings: ".csv, .mtx or .txt (View3D)".
std::string all_endings() {
  std::vector<std::string> all;
  for (const FactorFormatRow& row : kFactorFormats)
    all.push_back(row.ending + (*row.whose != 0 ? fmt::format(" ({})", row.whose) : ""));
  return word_list(all, " or ");
}

}  // namespace

Granularity FactorsOptions::per() const {
  return granularity == "element" ? Granularity::kElement
         : granularity == "group" ? Granularity::kGroup
                                  : Granularity::kFace;
}

bool FactorsOptions::lists_pairs() const { return matrix.empty() && row_of(format()).lists_pairs; }

FactorFormat FactorsOptions::format() const {
  if (out.empty() || out == "-") return FactorFormat::kCsv;
  const bool is_csv_only = !matrix.empty() || wants_exact_form;
  const std::optional<FactorFormat> by_ending = factor_format(out);
  if (by_ending == FactorFormat::kHdf5) require_hdf5("'" + out + "'");
  if (by_ending && (!is_csv_only || *by_ending == FactorFormat::kCsv)) return *by_ending;
  if (!is_csv_only) {
    if (awaits_deck || deck.out == 0U) return FactorFormat::kView3dText;
    if (deck.out == 1U) return FactorFormat::kView3dBinary;
  }
  throw UsageError(fmt::format("factors {} {}, not '{}'",
                               matrix.empty() ? "are written" : "as a dense matrix are written",
                               "as " + (is_csv_only ? ".csv" : all_endings()), out));
}

void require_room_for(const FactorsOptions& options, const std::function<DenseSize(FactorFormat)>& size) {
  const FactorFormatRow& format = row_of(options.format());
  if (options.lists_pairs() || (options.json && options.out.empty())) return;
  const auto [rows, bytes] = size(format.format);
  require_space(options.out.empty() ? "-" : options.out, bytes,
                fmt::format("{}: a dense matrix of {} x {} numbers takes {}", options.scene, rows, rows,
                            format.is_text ? "at least" : "exactly"),
                "; lists of the pairs that see each other, -o FILE.csv or FILE.mtx without --matrix, are smaller");
}

RowChoice rows_to_compute(const FactorsOptions& options, const SceneTable& scene) {
  if (options.rows.empty()) return {};
  const RowChoice written = RowChoice::of(scene, options.rows, options.per());
  const bool has_other_uses = options.script_f || !options.picture.empty() || !options.is_exact();
  return has_other_uses ? RowChoice() : written;
}

void take_rows(const FactorsOptions& options, const Streams& streams, FactorTable& table) {
  if (options.rows.empty()) return;
  const ExchangeMatrix& matrix = table.matrix;
  const RowChoice choice = RowChoice::of(table.scene, options.rows, table.granularity);
  std::size_t all = 0;
  table.only_rows.clear();
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    ++all;
    if (choice.has(matrix.elements()[i])) table.only_rows.push_back(i);
  }
  if (table.only_rows.empty())
    throw UsageError(
        fmt::format("--rows {}: none of these has a row in {}: they have no material there, or nothing is "
                    "left of them",
                    options.rows, options.scene));
  streams.note(fmt::format("--rows {}: {} of {} rows", options.rows, table.only_rows.size(), all));
}

bool takes_groups_of_many(FactorsOptions& options, std::size_t factors, const Streams& streams) {
  const bool is_told = options.per_option->count() > 0 || !options.rows.empty() || options.granularity != "face";
  if (is_told || options.wants_exact_form || !options.keeps_scene() || factors <= kMostUnasked) return false;
  options.granularity = "group";
  streams.note(
      fmt::format("{} would list {} factors of faces: it has groups instead, a row for each polyline or mesh; "
                  "--per face lists all, --rows NAME some",
                  options.out, factors));
  return true;
}

FactorsFiles::FactorsFiles(const FactorsOptions& options, const Streams& streams) {
  if (!options.json || !options.out.empty()) out.emplace(streams.output(options.out));
  if (const char* const beside = row_of(options.format()).beside) rows.emplace(options.out + beside);
  if (!options.picture.empty()) drawing.emplace(options.picture);
}

void FactorsFiles::finish() {
  for (std::optional<OutputFile>* file : {&out, &rows, &drawing})
    if (*file) (*file)->finish();
}

void FactorsFiles::commit() {
  for (std::optional<OutputFile>* file : {&rows, &drawing, &out})
    if (*file) (*file)->commit();
}

void note_matrix(const FactorsOptions& options, const FactorTable& table, const Streams& streams) {
  if (options.wants_exact_form || options.format() != FactorFormat::kNpy) return;
  const std::size_t size = table.matrix.size() + std::size_t{1};  // with the sky
  streams.note(fmt::format("{}: {}, {} x {}, from the row to the column; what these are is in {}.json", options.out,
                           table.gray_channel ? "script-F" : "view factors F", size, size, options.out));
}

void write_table(const FactorsOptions& options, const FactorTable& table, const FactorOrigin& origin,
                 FactorsFiles& files, const std::function<void(const Sink&)>& write_faces) {
  const Sink sink = [&files](std::string_view text) { files.out->write(text); };
  if (!options.matrix.empty()) {
    write_dense_csv(table,
                    options.matrix == "factor"     ? DenseQuantity::kFactor
                    : options.matrix == "exchange" ? DenseQuantity::kExchange
                                                   : DenseQuantity::kVisibility,
                    sink);
    return;
  }
  switch (options.format()) {
    case FactorFormat::kCsv:
      return write_factors_csv(table, sink);
    case FactorFormat::kMtx:
      write_factors_mtx(table, sink);
      return write_faces([&files](std::string_view text) { files.rows->write(text); });
    case FactorFormat::kNpy:
      write_factors_npy(table, sink);
      return files.rows->write(factors_sidecar(table));
    case FactorFormat::kHdf5:
      return write_factors_hdf5(table, origin, *files.out);
    case FactorFormat::kView3dText:
      return write_factors_view3d_text(table, sink);
    case FactorFormat::kView3dBinary:
      return write_factors_view3d_binary(table, sink);
  }
}

}  // namespace hottel
