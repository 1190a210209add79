// Laws of scenes whose edges are divided in elements, and of rooms in which nothing can hide anything.
#pragma once

#include "tests/storm/plane/laws.h"

namespace hottel::storm {

// What is wrong, or nothing; see laws().
std::string elements_are_broken(const Subject& subject);
std::string convex_room_is_broken(const Subject& subject);

}  // namespace hottel::storm
