#include "cli/views.h"

#include <fmt/format.h>

#include <filesystem>

#include "cli/command.h"
#include "cli/scene_input.h"
#include "geometry/plane/prepared/element_pieces.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/files/disk_space.h"
#include "io/results/plane/light_matrix.h"
#include "kernel/support/memory.h"
#include "kernel/support/naming_file.h"

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
  naming_file(prepared.scene.file, [&] {
    const LightMatrixSize size = light_matrix_size(matrix, streams.progress("views, counted"));
    require_space(output.mtx.name(), light_matrix_bytes(matrix, size),
                  fmt::format("what {} x {} cells see takes about", grid.nx, grid.ny), "; take a coarser --grid");
    write_light_matrix_mtx(matrix, size, streams.progress("views, written"),
                           [&output](std::string_view text) { output.mtx.write(text); });
    write_faces_csv(factors, element_pieces(prepared, factors.granularity),
                    [&output](std::string_view text) { output.faces.write(text); });
  });
}

}  // namespace hottel
