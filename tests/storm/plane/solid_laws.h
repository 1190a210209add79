// Laws of solids, and of what is covered by them; of groups.
#pragma once

#include "tests/storm/plane/laws.h"

namespace hottel::storm {

// What is wrong, or nothing; see laws().
std::string owners_differ(const Subject& subject);
std::string groups_are_broken(const Subject& subject);
std::string cut_by_hand_differs(const Subject& subject);

}  // namespace hottel::storm
