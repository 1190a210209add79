// The elements of a scene in the plane in messages: each process makes them for itself.
#pragma once

#include <memory>

#include "geometry/element.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "parallel/scene_message.h"

namespace hottel {

using KeptScene2 = KeptScene<PreparedScene2>;

// Writes what elements come from, and what shows that another process has the same ones. table: that of the scene by
// this granularity.
void put_elements_2(const PreparedScene2& prepared, Granularity granularity, const ElementTable2& table,
                    MessageWriter& writer);

struct ReceivedElements2 {
  std::shared_ptr<const PreparedScene2> prepared;  // without lights and grids
  Granularity granularity = Granularity::kElement;
  std::shared_ptr<const ElementTable2> table;  // by that
};

// Throws RequestError where this process makes other elements of the scene than the one that wrote it.
ReceivedElements2 take_elements_2(MessageReader& reader, KeptScene2& kept);

}  // namespace hottel
