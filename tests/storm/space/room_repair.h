// What repairs of a furnished room must keep.
#pragma once

#include <string>

namespace hottel::storm {

class RoomSubject3;

// The law `repair` (room_laws_3): what is wrong, or nothing.
std::string room_repair_is_broken(const RoomSubject3& subject);

}  // namespace hottel::storm
