// The scenes that the benchmarks share.
#pragma once

#include <string>

#include "geometry/scene/generators_2.h"

namespace hottel::benchmarks {

// How far one sees in a clutter: a few neighbours, or some hundred others.
enum class View : bool { kShort, kLong };

inline std::string to_string(View view) { return view == View::kShort ? "short" : "long"; }

// Random disjoint segments in a closed square room, `edges` of them, with seed 1: what `hottel generate clutter
// --view VIEW --n EDGES --seed 1 --digits DIGITS` makes.
inline Scene2 clutter(View view, std::uint64_t edges, int digits = 0) {
  GeneratorRequest request;
  request.kind = "clutter";
  request.n = edges;
  request.seed = 1;
  request.digits = digits;
  request.length = view == View::kShort ? kShortView : kLongView;
  return generate_2(request);
}

}  // namespace hottel::benchmarks
