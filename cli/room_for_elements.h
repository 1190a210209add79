// Whether what a command will make of a scene fits into memory, asked before anything is made.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "cli/level_options.h"
#include "cli/memory/give_back.h"
#include "solver/plane/scene_memory.h"
#include "solver/space/scene_memory.h"

namespace hottel {

// What is asked of memory for the radiosities of a scene whose elements are divided further by --levels.
inline MemoryQuestion solving_question(const Scene2& scene, const LevelOptions& levels = {}) {
  return {.parts = std::exp2(levels.everywhere), .solves = true, .channels = channel_count(scene)};
}
inline MemoryQuestion solving_question(const Scene3& scene, const LevelOptions& levels = {}) {
  return {.parts = std::exp2(2 * levels.everywhere), .solves = true, .channels = channel_count(scene)};
}

// Throws RequestError where it does not fit. memory: as asked for; then what is freed is given back soon.
template <class AnyScene>
void require_room_for_solving(const AnyScene& scene, std::optional<std::uint64_t> memory,
                              const LevelOptions& levels = {}, bool pairs_on_disk = false) {
  if (memory) give_memory_back_soon();
  MemoryQuestion question = solving_question(scene, levels);
  question.pairs_on_disk = pairs_on_disk;
  require_memory(scene, question, memory.value_or(0));
}

}  // namespace hottel
