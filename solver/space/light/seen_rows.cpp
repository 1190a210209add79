#include "solver/space/light/seen_rows.h"

#include <fmt/format.h>

#include <atomic>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/progress_count.h"
#include "solver/space/light/illumination_grid.h"
#include "solver/space/light/seen_elements.h"

namespace hottel {
namespace {

SeenRow3 row_at(const SeenElements3& seen, const Point3& centre, std::uint32_t sky) {
  SeenRow3 row;
  const auto fraction =
      seen.around(centre, [&row](std::uint32_t label, double part) { row.emplace_back(label, part); });
  if (!fraction) return {};
  if (*fraction > 0) row.emplace_back(sky, *fraction);
  return row;
}

void require_memory(std::uint64_t taken, std::uint64_t allowed, const Grid3& grid) {
  if (taken > allowed)
    throw RequestError(
        fmt::format("what {} cells see takes more than the {} bytes of memory that are allowed; take a coarser --grid",
                    grid.cells(), allowed));
}

}  // namespace

std::vector<SeenRow3> seen_rows(const PreparedScene3& prepared, const ElementTable3& table, const Grid3& grid,
                                std::uint64_t memory, const std::function<void(double)>& progress) {
  const SeenElements3 seen(prepared, table, Blacks3::kListed);
  std::vector<SeenRow3> rows(grid.cells());
  std::atomic<std::uint64_t> taken = rows.size() * sizeof(SeenRow3);
  ProgressCount count(progress, rows.size());
  parallel_for(
      rows.size(),
      [&](std::size_t cell) {
        const Point3 centre = cell_centre(grid, cell);
        if (!prepared.arrangement().solids().around(centre)) rows[cell] = row_at(seen, centre, table.sky());
        taken += rows[cell].capacity() * sizeof(SeenRow3::value_type);
        require_memory(taken, memory, grid);
        count.add(1);
      },
      4);
  return rows;
}

}  // namespace hottel
