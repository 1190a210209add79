// What of a light a hand holds.
#pragma once

#include <cstdint>

namespace hottel {

// The light itself, the end of its axis, or that of a border of its beam.
enum class LightPart : unsigned char { kPlace, kAxis, kLeft, kRight };

struct LightHold {
  std::uint32_t light = 0;
  LightPart part = LightPart::kPlace;
  friend bool operator==(const LightHold&, const LightHold&) = default;
};

// What dragging a part does: "move", "turn", "focus".
inline const char* verb_of(LightPart part) {
  return part == LightPart::kPlace ? "move" : part == LightPart::kAxis ? "turn" : "focus";
}

}  // namespace hottel
