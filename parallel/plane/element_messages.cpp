#include "parallel/plane/element_messages.h"

#include <cstdint>
#include <variant>

#include "kernel/support/failure.h"

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

void put_elements_2(const PreparedScene2& prepared, Granularity granularity, const ElementTable2& table,
                    MessageWriter& writer) {
  MessageWriter scene, lengths;
  scene.put(is_cut(prepared.division) ? Divided2::kYes : Divided2::kNo);
  put_scene(prepared.scene, scene);
  put_lengths(prepared, table, lengths);
  writer.put_text(scene.bytes());
  writer.put(granularity);
  writer.put_text(lengths.bytes());
}

ReceivedElements2 take_elements_2(MessageReader& reader, KeptScene2& kept) {
  ReceivedElements2 result;
  result.prepared = kept.prepared(reader.take_text(), prepared_scene);
  result.granularity = reader.take<Granularity>();
  result.table = result.prepared->elements(result.granularity);
  MessageWriter lengths;
  put_lengths(*result.prepared, *result.table, lengths);
  if (lengths.bytes() != reader.take_text())
    throw RequestError("it makes other elements of the scene: all ranks must run the same program and libraries");
  return result;
}

}  // namespace hottel
