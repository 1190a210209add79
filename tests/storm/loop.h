// Runs numbered scenes on some threads.
#pragma once

#include <cstdint>
#include <functional>

namespace hottel::storm {

struct StormOptions {
  std::uint64_t first = 0;  // number of the first scene
  std::uint64_t scenes = 10'000;
  int k = 0;              // in the plane: of the lattice {0, ..., k}^2; 0: 2 to 6 in turn
  bool all_laws = false;  // every law on every scene, not one in Law::every
  bool shrinks = true;    // a scene that breaks a law, to what breaks it
  unsigned threads = 1;
  std::function<void(std::uint64_t done)> progress = {};  // called by one thread
};

// Seconds of processor time that this thread has taken.
double processor_seconds();

// Calls run(thread, number) for the scenes of `options`, each once, thread being below max(1, options.threads). What
// ends the program tells the number of its scene first (CrashNotice).
void for_each_scene(const StormOptions& options, const std::function<void(unsigned thread, std::uint64_t number)>& run);

}  // namespace hottel::storm
