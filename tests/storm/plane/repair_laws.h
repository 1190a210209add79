// Laws of repairs in the plane.
#pragma once

#include "tests/storm/plane/laws.h"

namespace hottel::storm {

// What is wrong, or nothing; see laws().
std::string repair_is_broken(const Subject& subject);

}  // namespace hottel::storm
