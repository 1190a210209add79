#include "parallel/plane/sweep_messages.h"

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <variant>

#include "kernel/support/failure.h"
#include "parallel/message.h"
#include "parallel/scene_message.h"

namespace hottel {
namespace {

// Lists of values that are bytes in memory, and nothing between them.
template <class T>
std::string_view bytes_of(std::span<const T> list) {
  static_assert(std::is_trivially_copyable_v<T>);
  return {reinterpret_cast<const char*>(list.data()), list.size_bytes()};
}
template <class T>
std::vector<T> list_of(std::string_view bytes) {
  HOTTEL_REQUIRE(bytes.size() % sizeof(T) == 0);
  std::vector<T> list(bytes.size() / sizeof(T));
  if (!list.empty()) std::memcpy(list.data(), bytes.data(), bytes.size());
  return list;
}

// What shows that two processes have the same elements: their lengths to the last bit.
void put_lengths(const PreparedScene2& prepared, const ElementTable2& table, MessageWriter& writer) {
  const Arrangement2& arrangement = prepared.arrangement;
  writer.put(table.count(), std::uint64_t{arrangement.vertices().size()}, std::uint64_t{arrangement.pieces().size()});
  for (std::uint32_t label = 0; label < table.count(); ++label) {
    const auto value = static_cast<UInt128>(table.length(label).value);
    writer.put(static_cast<std::uint64_t>(value), static_cast<std::uint64_t>(value >> 64));
  }
}

std::shared_ptr<const PreparedScene2> prepared_scene(std::string_view bytes, ReceivedSweepJob2::Kept& kept) {
  if (kept.prepared == nullptr || kept.bytes != bytes) {
    kept.prepared.reset();  // two do not have to fit into the memory
    MessageReader reader(bytes);
    const auto divided = reader.take<Divided2>();
    kept.prepared = std::make_shared<const PreparedScene2>(prepare(std::get<Scene2>(take_scene(reader)), divided));
    kept.bytes = bytes;
  }
  return kept.prepared;
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
  prepared = prepared_scene(reader.take_text(), kept);
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

std::string vertices_message_2(std::span<const VertexId> vertices) { return std::string(bytes_of(vertices)); }
std::vector<VertexId> read_vertices_2(std::string_view bytes) { return list_of<VertexId>(bytes); }

std::string part_message_2(const SweptPart2& part) {
  static_assert(sizeof(PairSum2) == 32, "a key, counts and a sum, and nothing between them");
  MessageWriter writer;
  writer.put(std::uint64_t{part.begin}, std::uint64_t{part.end}, part.counts.gaps, part.counts.updates);
  return writer.bytes() + std::string(bytes_of(std::span<const PairSum2>(part.sums)));
}

SweptPart2 read_part_2(std::string_view bytes) {
  MessageReader reader(bytes);
  SweptPart2 part;
  reader.take_into(part.begin, part.end, part.counts.gaps, part.counts.updates);
  part.sums = list_of<PairSum2>(reader.rest());
  return part;
}

}  // namespace hottel
