#include "parallel/plane/cell_messages.h"

#include "kernel/support/failure.h"
#include "parallel/grid_message.h"
#include "parallel/radiosity_message.h"

namespace hottel {

std::string cell_job_message_2(const CellJob2& job) {
  MessageWriter writer;
  put_elements_2(job.prepared, job.granularity, *job.prepared.elements(job.granularity), writer);
  const Grid2& grid = job.grid;
  put_place(writer, grid.min.x, grid.min.y, grid.max.x, grid.max.y);
  writer.put(grid.nx, grid.ny);
  put_radiosities(job.solution, writer);
  return writer.bytes();
}

ReceivedCellJob2::ReceivedCellJob2(std::string_view bytes, KeptScene2& kept) {
  MessageReader reader(bytes);
  elements = take_elements_2(reader, kept);
  Grid2 grid;
  take_place(reader, grid.min.x, grid.min.y, grid.max.x, grid.max.y);
  reader.take_into(grid.nx, grid.ny);
  solution = take_radiosities(reader);
  HOTTEL_REQUIRE(reader.is_at_end());
  light.emplace(*elements.prepared, elements.granularity, solution, grid);
}

}  // namespace hottel
