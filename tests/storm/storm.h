// A storm of lattice scenes, each held against the laws.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/storm/plane/contacts.h"
#include "tests/storm/plane/laws.h"

namespace hottel::storm {

struct StormOptions {
  std::uint64_t first = 0;  // number of the first scene
  std::uint64_t scenes = 10'000;
  int k = 0;              // of the lattice {0, ..., k}^2; 0: 2 to 6 in turn
  bool all_laws = false;  // every law on every scene, not one in Law::every
  unsigned threads = 1;
  std::function<void(std::uint64_t done)> progress = {};  // called by one thread
};

// A scene that breaks a law, with nothing in it that could be left out or moved nearer to the origin.
struct Failure {
  std::uint64_t number = 0;
  std::string law, what;
  Edges edges;
};

struct StormResult {
  std::uint64_t scenes = 0, edges = 0;
  std::vector<std::uint64_t> checks, failures;  // by law
  std::vector<double> seconds;                  // of processor time, by law
  std::vector<Failure> examples;                // the first of each law, by number
  ContactCounts contacts{};
  double slowest = 0, total = 0;  // seconds of processor time of a scene; of all, summed over the threads

  std::uint64_t all_checks() const;
  std::uint64_t all_failures() const;
  void add(const StormResult& other);
};

// Holds scenes first, first + 1, ... against `which` laws, each up to the first that it breaks. The result does not
// depend on the number of threads, but for its times. What ends the program tells the number of its scene first.
StormResult run_storm(const StormOptions& options, const std::vector<Law>& which = laws());

// The result as text: counts, times, contacts, and each failure as a scene file.
std::string report(const StormResult& result, const std::vector<Law>& which = laws());

}  // namespace hottel::storm
