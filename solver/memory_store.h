// Factors kept in memory, for as long as a run lasts.
#pragma once

#include <cstdint>
#include <memory>

#include "solver/store.h"

namespace hottel {

// Makes an empty store. Threads may share it. It takes so many bytes at most, and some for elements' names; then what
// was kept first gives way.
std::shared_ptr<FactorStore> make_memory_store(std::uint64_t bytes = std::uint64_t{1} << 32);

}  // namespace hottel
