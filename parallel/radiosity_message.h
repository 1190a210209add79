// Radiosities of a solution in messages, without all else that it has.
#pragma once

#include "parallel/message.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

void put_radiosities(const RadiositySolution& solution, MessageWriter& writer);
RadiositySolution take_radiosities(MessageReader& reader);

}  // namespace hottel
