// A storm of furnished rooms, each held against the laws.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/storm/law_run.h"
#include "tests/storm/space/room_laws.h"
#include "tests/storm/space/room_scene.h"

namespace hottel::storm {

struct RoomStormResult3 : LawResult<SolidBodies3> {
  std::array<std::uint64_t, kRoomNumbers3> numbers{};  // scenes by how their numbers came about
  std::uint64_t disputed = 0;                          // that claim one side for two materials

  void add(const RoomStormResult3& other);
};

// Holds scenes first, first + 1, ... against `which` laws, each up to the first that it breaks. The result does not
// depend on the number of threads, but for its times.
RoomStormResult3 run_room_storm_3(const StormOptions& options, const std::vector<RoomLaw3>& which = room_laws_3());

// The result as text: counts, times, and each failure as a scene file.
std::string report(const RoomStormResult3& result, const std::vector<RoomLaw3>& which = room_laws_3());

// The file of a room, as it is.
std::string room_text_3(std::uint64_t number);

}  // namespace hottel::storm
