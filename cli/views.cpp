#include "cli/views.h"

#include <fmt/format.h>

#include <filesystem>

#include "cli/command.h"
#include "cli/scene_input.h"
#include "geometry/plane/prepared/element_pieces.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/space/exchange/written_outlines.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/files/disk_space.h"
#include "io/results/plane/light_matrix.h"
#include "io/results/space/element_files.h"
#include "io/results/view_rows.h"
#include "kernel/support/memory.h"
#include "kernel/support/with_file_context.h"
#include "solver/space/light/seen_rows.h"

namespace hottel {

void require_sense_of_views(const std::string& file, const std::string& illumination) {
  if (std::filesystem::path(file).extension() != ".mtx")
    throw UsageError("--views is written as .mtx, not '" + file + "'");
  if (illumination != "point")
    throw UsageError("--views is what the centres of cells see: it goes with --illumination point, not " +
                     illumination);
}

ViewsOutput::ViewsOutput(const std::string& file) : mtx(file), faces(file + ".faces.csv") {}

void write_views_2(const PreparedScene2& prepared, const Grid2& grid, const FactorTable& factors, std::uint64_t memory,
                   const Streams& streams, ViewsOutput& output) {
  const ElementTable2& table = *prepared.elements(factors.granularity);
  const LightMatrix2 matrix{prepared, grid, table, memory_allowed(memory)};
  with_file_context(prepared.scene.file, [&] {
    const LightMatrixSize size = light_matrix_size(matrix, streams.progress("views, counted"));
    require_space(output.mtx.name(), light_matrix_bytes(matrix, size),
                  fmt::format("what {} x {} cells see takes about", grid.nx, grid.ny), "; take a coarser --grid");
    write_light_matrix_mtx(matrix, size, streams.progress("views, written"),
                           [&output](std::string_view text) { output.mtx.write(text); });
    write_faces_csv(factors, element_pieces(prepared, factors.granularity),
                    [&output](std::string_view text) { output.faces.write(text); });
  });
}

namespace {

// Merged by columns. The rows may take half of the memory, and the text is made of some at a time.
std::vector<ViewEntries> rows_of_views(const PreparedScene3& prepared, const Grid3& grid, const ElementTable3& table,
                                       std::uint64_t memory, const Streams& streams) {
  std::vector<ViewEntries> rows =
      seen_rows(prepared, table, grid, memory_allowed(memory) / 2, streams.progress("views"));
  for (ViewEntries& row : rows) merge_columns(row);
  return rows;
}

void write_rows(const std::vector<ViewEntries>& rows, const Grid3& grid, std::uint32_t columns, OutputFile& output) {
  std::uint64_t entries = 0, empty = 0;
  for (const ViewEntries& row : rows) {
    entries += row.size();
    empty += row.empty() ? 1 : 0;
  }
  output.write(view_matrix_head(
      grid.is_volume()
          ? fmt::format("{} x {} x {} cells, (iw * {} + iv) * {} + iu + 1 with iw = iv = 0 at the origin", grid.nu,
                        grid.nv, grid.nw, grid.nv, grid.nu)
          : fmt::format("{} x {} cells, iv * {} + iu + 1 with iv = 0 at the origin", grid.nu, grid.nv, grid.nu),
      rows.size(), columns, entries, empty));
  for (std::size_t k = 0; k < rows.size(); ++k) output.write(view_row_text(k + 1, rows[k]));
}

}  // namespace

void write_views_3(const PreparedScene3& prepared, const Grid3& grid, const FactorTable& factors, std::uint64_t memory,
                   const Streams& streams, ViewsOutput& output) {
  const ElementTable3& table = *prepared.elements(factors.granularity);
  with_file_context(prepared.scene.file, [&] {
    write_rows(rows_of_views(prepared, grid, table, memory, streams), grid, table.count() + 1, output.mtx);
    write_faces_csv_3(factors, written_outlines(table, prepared.occluders().vertices()),
                      [&output](std::string_view text) { output.faces.write(text); });
  });
}

}  // namespace hottel
