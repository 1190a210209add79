// The elements of a scene in space in messages: each process makes them for itself.
#pragma once

#include <memory>

#include "geometry/element.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "parallel/scene_message.h"

namespace hottel {

using KeptScene3 = KeptScene<PreparedScene3>;

// Writes what elements come from, and what shows that another process has the same ones. table: that of the scene by
// this granularity.
void put_elements_3(const PreparedScene3& prepared, Granularity granularity, const ElementTable3& table,
                    MessageWriter& writer);

struct ReceivedElements3 {
  std::shared_ptr<const PreparedScene3> prepared;  // without lights and grids
  Granularity granularity = Granularity::kElement;
  std::shared_ptr<const ElementTable3> table;  // by that
};

// Throws RequestError where this process makes other elements of the scene than the one that wrote it.
ReceivedElements3 take_elements_3(MessageReader& reader, KeptScene3& kept);

}  // namespace hottel
