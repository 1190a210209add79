// How two patches see each other.
#pragma once

namespace hottel {

// How a pair was settled.
//   kHidden: S = 0: not in front of each other, or one surface hides each from the other (proven)
//   kClear:  nothing can stand between them (proven): the measure is that of the two alone
//   kMixed:  surfaces stand between, or may
enum class PairVisibility3 : unsigned char { kHidden, kClear, kMixed };

}  // namespace hottel
