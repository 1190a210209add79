// Places and ways of grids in messages, exactly.
#pragma once

#include <string>

#include "kernel/rational.h"
#include "parallel/message.h"

namespace hottel {

// Points or vectors: REQUIRES the same number of coordinates where they are taken.
template <class... Coordinates>
void put_place(MessageWriter& writer, const Coordinates&... coordinates) {
  (writer.put_text(coordinates.get_str()), ...);
}
template <class... Coordinates>
void take_place(MessageReader& reader, Coordinates&... coordinates) {
  ((coordinates = Rational(std::string(reader.take_text()))), ...);
}

}  // namespace hottel
