// hottel_viewer_storm: storms of events over viewers without a screen. Exit code 1 when a law is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>

#include "tests/viewer/window/viewer_storm.h"

int main(int argc, char** argv) {
  using namespace hottel::viewer_storm;
  StormOptions options;
  std::uint64_t storms = 10;
  CLI::App app{"Keys, mouse, sizes, files and time over a window's viewer, at random, held against what it promises"};
  app.add_option("--dimension", options.dimension)->capture_default_str()->check(CLI::Range(2, 3));
  app.add_option("--seed", options.seed, "of the first storm")->capture_default_str();
  app.add_option("--storms", storms, "how many")->capture_default_str();
  app.add_option("--events", options.events, "of each")->capture_default_str();
  app.add_option("--elements", options.elements, "in space: divides the polygons")
      ->capture_default_str()
      ->check(CLI::Range(1u, 100u));
  app.add_option("--scene", options.scene, "a file, instead of a small room");
  CLI11_PARSE(app, argc, argv);

  const auto start = std::chrono::steady_clock::now();
  StormResult all;
  for (std::uint64_t k = 0; k < storms; ++k, ++options.seed) {
    fmt::print(stderr, "\rseed {}  ", options.seed);  // a crash names it
    const StormResult one = run_storm(options);
    all.events += one.events;
    all.frames += one.frames;
    all.edits += one.edits;
    all.problems += one.problems;
    all.sizes += one.sizes;
    all.reads += one.reads;
    all.viewers += one.viewers;
    all.shapes += one.shapes;
    all.rests += one.rests;
    all.failures.insert(all.failures.end(), one.failures.begin(), one.failures.end());
  }
  for (const std::string& failure : all.failures) fmt::print("{}\n", failure);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  fmt::print(stderr, "\n");
  fmt::print(
      "{} events: {} keys, {} shapes dragged, {} sizes, {} files written by others; {} frames, {} of them without "
      "light, {} viewers; "
      "files compared {} times; "
      "{} failures, {:.1f} s\n",
      all.events, all.edits, all.shapes, all.sizes, all.reads, all.frames, all.problems, all.viewers, all.rests,
      all.failures.size(), taken.count());
  return all.failures.empty() ? 0 : 1;
}
