#include "parallel/plane/sweep_messages.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

#include "kernel/support/failure.h"
#include "parallel/message.h"
#include "solver/plane/simulation/cached_sweep.h"

namespace hottel {
std::string sweep_job_message_2(const SweepJob2& job) {
  MessageWriter writer;
  put_elements_2(job.prepared, job.granularity, job.table, writer);
  for (std::uint32_t label = 0; label < job.table.count(); ++label) writer.put(job.table.has_row(label));
  return writer.bytes();
}

ReceivedSweepJob2::ReceivedSweepJob2(std::string_view bytes, KeptScene2& kept) {
  MessageReader reader(bytes);
  const ReceivedElements2 elements = take_elements_2(reader, kept);
  prepared = elements.prepared;
  ElementTable2 chosen = *elements.table;
  std::vector<bool> is_chosen(chosen.count());
  for (std::uint32_t label = 0; label < chosen.count(); ++label) is_chosen[label] = reader.take<bool>();
  chosen.keep_rows(is_chosen);
  table = std::make_shared<const ElementTable2>(std::move(chosen));
}

std::string vertices_message_2(std::span<const VertexId> vertices) {
  MessageWriter writer;
  for (const VertexId vertex : vertices) writer.put(static_cast<std::uint32_t>(vertex.index()));
  return writer.bytes();
}
std::vector<VertexId> read_vertices_2(std::string_view bytes) {
  std::vector<VertexId> vertices;
  for (MessageReader reader(bytes); !reader.is_at_end();) vertices.emplace_back(reader.take<std::uint32_t>());
  return vertices;
}

// As a store keeps it, which has to tell orders of sweeps apart; here there is one.
std::string part_message_2(const SweptPart2& part) { return bytes_of(part, 0); }

SweptPart2 read_part_2(std::string_view bytes) {
  std::optional<SweptPart2> part = swept_part_2(bytes, 0);
  HOTTEL_REQUIRE(part.has_value());
  return *std::move(part);
}

}  // namespace hottel
