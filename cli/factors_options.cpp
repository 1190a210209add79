#include "cli/factors_options.h"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>

#include "io/files/disk_space.h"
#include "kernel/support/failure.h"

namespace hottel {

Granularity FactorsOptions::per() const {
  return granularity == "element" ? Granularity::kElement
         : granularity == "group" ? Granularity::kGroup
                                  : Granularity::kFace;
}

FactorsFormat FactorsOptions::format() const {
  const std::string ending = std::filesystem::path(out).extension().string();
  const bool is_csv_only = !matrix.empty() || wants_exact_form;
  if (out.empty() || out == "-" || ending == ".csv") return FactorsFormat::kCsv;
  if (!is_csv_only) {
    if (ending == ".mtx") return FactorsFormat::kMtx;
    if (ending == ".npy") return FactorsFormat::kNpy;
    if (ending == ".txt") return FactorsFormat::kView3dText;
    if (ending == ".bin") return FactorsFormat::kView3dBinary;
    if (awaits_deck || deck.out == 0U) return FactorsFormat::kView3dText;
    if (deck.out == 1U) return FactorsFormat::kView3dBinary;
  }
  throw UsageError(fmt::format("factors {} {}, not '{}'",
                               matrix.empty() ? "are written" : "as a dense matrix are written",
                               is_csv_only ? "as .csv" : "as .csv, .mtx, .npy, .txt (View3D) or .bin (View3D)", out));
}

void require_room_for(const FactorsOptions& options, const std::function<DenseSize(DenseFormat)>& size) {
  const FactorsFormat format = options.format();
  std::optional<DenseFormat> dense;
  if (!options.matrix.empty()) dense = DenseFormat::kCsv;
  if (format == FactorsFormat::kNpy) dense = DenseFormat::kNpy;
  if (format == FactorsFormat::kView3dText) dense = DenseFormat::kView3dText;
  if (format == FactorsFormat::kView3dBinary) dense = DenseFormat::kView3dBinary;
  if (!dense || (options.json && options.out.empty())) return;
  const auto [rows, bytes] = size(*dense);
  const bool is_text = *dense == DenseFormat::kCsv || *dense == DenseFormat::kView3dText;
  require_space(options.out.empty() ? "-" : options.out, bytes,
                fmt::format("{}: a dense matrix of {} x {} numbers takes {}", options.scene, rows, rows,
                            is_text ? "at least" : "exactly"),
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

FactorsFiles::FactorsFiles(const FactorsOptions& options, const Streams& streams) {
  const FactorsFormat format = options.format();
  if (!options.json || !options.out.empty()) out.emplace(streams.output(options.out));
  if (format == FactorsFormat::kMtx) rows.emplace(options.out + ".faces.csv");
  if (format == FactorsFormat::kNpy) rows.emplace(options.out + ".json");
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
  if (options.wants_exact_form || options.format() != FactorsFormat::kNpy) return;
  const std::size_t size = table.matrix.size() + std::size_t{1};  // with the sky
  streams.note(fmt::format("{}: {}, {} x {}, from the row to the column; what these are is in {}.json", options.out,
                           table.gray_channel ? "script-F" : "view factors F", size, size, options.out));
}

void write_table(const FactorsOptions& options, const FactorTable& table, FactorsFiles& files,
                 const std::function<void(const Sink&)>& write_faces) {
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
    case FactorsFormat::kCsv:
      return write_factors_csv(table, sink);
    case FactorsFormat::kMtx:
      write_factors_mtx(table, sink);
      return write_faces([&files](std::string_view text) { files.rows->write(text); });
    case FactorsFormat::kNpy:
      write_factors_npy(table, sink);
      return files.rows->write(factors_sidecar(table));
    case FactorsFormat::kView3dText:
      return write_factors_view3d_text(table, sink);
    case FactorsFormat::kView3dBinary:
      return write_factors_view3d_binary(table, sink);
  }
}

}  // namespace hottel
