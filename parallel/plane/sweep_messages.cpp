#include "parallel/plane/sweep_messages.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

#include "kernel/support/failure.h"
#include "parallel/message.h"
#include "solver/plane/simulation/cached_sweep.h"

namespace hottel {
namespace {

// What shows that two processes have the same elements: their lengths to the last bit.
void put_lengths(const PreparedScene2& prepared, const ElementTable2& table, MessageWriter& writer) {
  const Arrangement2& arrangement = prepared.arrangement;
  writer.put(table.count(), std::uint64_t{arrangement.vertices().size()}, std::uint64_t{arrangement.pieces().size()});
  for (std::uint32_t label = 0; label < table.count(); ++label) {
    const auto value = static_cast<UInt128>(table.length(label).value);
    writer.put(static_cast<std::uint64_t>(value), static_cast<std::uint64_t>(value >> 64));
  }
}

PreparedScene2 prepared_scene(MessageReader& reader) {
  const auto divided = reader.take<Divided2>();
  return prepare(std::get<Scene2>(take_scene(reader)), divided);
}

}  // namespace

std::string sweep_job_message_2(const SweepJob2& job) {
  MessageWriter scene, writer, lengths;
  scene.put(is_cut(job.prepared.division) ? Divided2::kYes : Divided2::kNo);
  put_scene(job.prepared.scene, scene);
  put_lengths(job.prepared, job.table, lengths);
  writer.put_text(scene.bytes());
  writer.put(job.granularity);
  writer.put_text(lengths.bytes());
  for (std::uint32_t label = 0; label < job.table.count(); ++label) writer.put(job.table.has_row(label));
  return writer.bytes();
}

ReceivedSweepJob2::ReceivedSweepJob2(std::string_view bytes, Kept& kept) {
  MessageReader reader(bytes);
  prepared = kept.prepared(reader.take_text(), prepared_scene);
  table = prepared->elements(reader.take<Granularity>());
  MessageWriter lengths;
  put_lengths(*prepared, *table, lengths);
  if (lengths.bytes() != reader.take_text())
    throw RequestError("it makes other elements of the scene: all ranks must run the same program and libraries");
  std::vector<bool> is_chosen(table->count());
  for (std::uint32_t label = 0; label < table->count(); ++label) is_chosen[label] = reader.take<bool>();
  ElementTable2 chosen = *table;
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
