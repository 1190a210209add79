// A storm of lattice scenes of the plane, each held against the laws.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/storm/law_run.h"
#include "tests/storm/plane/contacts.h"
#include "tests/storm/plane/laws.h"

namespace hottel::storm {

struct StormResult : LawResult<Edges> {
  ContactCounts contacts{};

  void add(const StormResult& other);
};

// Holds scenes first, first + 1, ... against `which` laws, each up to the first that it breaks. The result does not
// depend on the number of threads, but for its times. What ends the program tells the number of its scene first.
StormResult run_storm(const StormOptions& options, const std::vector<Law>& which = laws());

// The result as text: counts, times, contacts, and each failure as a scene file.
std::string report(const StormResult& result, const std::vector<Law>& which = laws());

}  // namespace hottel::storm
