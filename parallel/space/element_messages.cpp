#include "parallel/space/element_messages.h"

#include <cstdint>
#include <utility>
#include <variant>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

// What shows that two processes have the same elements: their areas to the last bit, and how many patches each has.
void put_extents(const ElementTable3& table, MessageWriter& writer) {
  writer.put(table.count(), std::uint64_t{table.parts().size()});
  for (std::uint32_t label = 0; label < table.count(); ++label)
    writer.put(std::uint64_t{table.parts(label).size()}, table.extent(label).value);
}

PreparedScene3 prepared_scene(MessageReader& reader) { return prepare(std::get<Scene3>(take_scene(reader))); }

}  // namespace

void put_elements_3(const PreparedScene3& prepared, Granularity granularity, const ElementTable3& table,
                    MessageWriter& writer) {
  MessageWriter scene, extents;
  put_scene(prepared.scene, scene);
  put_extents(table, extents);
  writer.put_text(scene.bytes());
  writer.put(granularity);
  writer.put_text(extents.bytes());
}

ReceivedElements3 take_elements_3(MessageReader& reader, KeptScene3& kept) {
  ReceivedElements3 result;
  result.prepared = kept.prepared(reader.take_text(), prepared_scene);
  result.granularity = reader.take<Granularity>();
  result.table = result.prepared->elements(result.granularity);
  MessageWriter extents;
  put_extents(*result.table, extents);
  if (extents.bytes() != reader.take_text())
    throw RequestError("it makes other elements of the scene: all ranks must run the same program and libraries");
  return result;
}

}  // namespace hottel
