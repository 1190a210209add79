// What is counted of proofs along edges.
#pragma once

#include <cstdint>

namespace hottel {

// How integrals along edges were proven.
struct ProofCounts3 {
  std::uint64_t parts = 0;     // of pieces that were bounded by an ellipse
  std::uint64_t halvings = 0;  // where a part was too near to where something is singular
  std::uint64_t redone = 0;    // parts that were done again with more digits
  std::uint64_t failures = 0;  // parts that were left to what can be seen at most

  ProofCounts3& operator+=(const ProofCounts3& other) {
    parts += other.parts;
    halvings += other.halvings;
    redone += other.redone;
    failures += other.failures;
    return *this;
  }
};

}  // namespace hottel
