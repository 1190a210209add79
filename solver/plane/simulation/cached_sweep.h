// Parts of a sweep that are kept in a store until the factors are.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/plane/exchange/term_sums.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/store.h"

namespace hottel {

// What exact factors in the plane leave in a store while they are computed: sums over the vertices that were swept.
// They serve a run of the same elements, which sweeps the others.
class CachedSweep2 {
 public:
  // factors: the table of the factors. REQUIRES that all outlive this.
  CachedSweep2(FactorStore& store, const PreparedScene2& prepared, const StoreTable& factors);

  // What is there, and what is to be done with more: both for a sweep of this scene.
  SweepParts2 parts() const;
  // The factors are kept, or were: nobody asks for parts any more.
  void forget() const;

 private:
  FactorStore& store_;
  const PreparedScene2& prepared_;
  StoreTable table_;
};

// A part as bytes, and again; nothing for bytes that are none. order: a number that tells the order of a sweep from
// others.
std::string bytes_of(const SweptPart2& part, std::uint64_t order);
std::optional<SweptPart2> swept_part_2(std::string_view bytes, std::uint64_t order);

}  // namespace hottel
