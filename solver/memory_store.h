// Factors kept in memory, for as long as a run lasts.
#pragma once

#include <memory>

#include "solver/store.h"

namespace hottel {

// Makes an empty store. Threads may share it. It takes whatever memory it takes; nothing gives way.
std::shared_ptr<FactorStore> make_memory_store();

}  // namespace hottel
