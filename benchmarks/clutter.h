// What the benchmarks share: their scenes, and how their cases are named, measured and run.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <string>

#include "geometry/plane/generate/generators.h"

namespace hottel::benchmarks {

// How far one sees in a clutter: a few neighbours, or some hundred others.
enum class View : bool { kShort, kLong };

inline std::string to_string(View view) { return view == View::kShort ? "short" : "long"; }

// Random disjoint segments in a closed square room, `edges` of them, with seed 1: what `hottel generate clutter
// --view VIEW --n EDGES --seed 1 --digits DIGITS` makes.
inline Scene2 clutter(View view, std::uint64_t edges, int digits = 0) {
  GeneratorRequest2 request;
  request.kind = "clutter";
  request.n = edges;
  request.seed = 1;
  request.digits = digits;
  request.length = view == View::kShort ? kShortView : kLongView;
  return generate_2(request);
}

// "short/edges:1000"
inline std::string to_string(View view, std::uint64_t edges) {
  return to_string(view) + "/edges:" + std::to_string(edges);
}

// Adds a case whose time is what it sets by SetIterationTime().
inline void add_case(const std::string& name, const std::function<void(benchmark::State&)>& measure) {
  benchmark::RegisterBenchmark(name.c_str(), measure)->UseManualTime()->Unit(benchmark::kMillisecond);
}

// Runs the cases that were added, as the command line asks. Returns the exit code of the program.
inline int run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace hottel::benchmarks
