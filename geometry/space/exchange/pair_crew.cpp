#include "geometry/space/exchange/pair_crew.h"

#include <atomic>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

std::atomic<PairCrew3*> crew{nullptr};

}  // namespace

PairCrewScope3::PairCrewScope3(PairCrew3& its) {
  PairCrew3* none = nullptr;
  HOTTEL_REQUIRE(crew.compare_exchange_strong(none, &its));
}
PairCrewScope3::~PairCrewScope3() { crew = nullptr; }

PairCrew3* pair_crew_3() { return crew; }

}  // namespace hottel
