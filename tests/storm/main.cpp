// hottel_storm: any number of lattice scenes against the laws. Exit code 1 when one is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "tests/storm/space/hiding_storm.h"
#include "tests/storm/space/room_storm.h"
#include "tests/storm/space/solid_storm.h"
#include "tests/storm/space/storm.h"
#include "tests/storm/storm.h"

namespace {

// The laws, or the one of a name, or all but the one of a name.
template <class Law>
std::vector<Law> chosen_laws(std::vector<Law> all, const std::string& only, const std::string& without) {
  for (const std::string& name : {only, without})
    if (!name.empty() && std::none_of(all.begin(), all.end(), [&](const Law& law) { return law.name == name; })) {
      fmt::print(stderr, "hottel_storm: there is no law called {}\n", name);
      std::exit(2);
    }
  std::erase_if(all, [&](const Law& law) { return law.name == without || (!only.empty() && law.name != only); });
  return all;
}

// Prints the result, and returns the exit code.
template <class Result, class Law>
int tell(const Result& result, const std::vector<Law>& laws, std::chrono::steady_clock::time_point start,
         unsigned threads) {
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  fmt::print(stderr, "\n");
  fmt::print("{}\n{:.1f} s on {} threads\n", report(result, laws), taken.count(), threads);
  return result.all_failures() == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace hottel::storm;
  StormOptions options;
  int dimension = 2;
  bool are_solids = false, are_rooms = false, is_hiding = false;
  options.threads = std::max(1U, std::thread::hardware_concurrency());
  CLI::App app{"Random scenes on a lattice, where nearly everything coincides, held against the laws of exchange"};
  app.add_option("--dimension", dimension, "2: edges; 3: pairs of polygons with others between")
      ->capture_default_str()
      ->check(CLI::Range(2, 3));
  CLI::Option* solids =
      app.add_flag("--solids", are_solids, "in dimension 3: closed bodies, rooms and sheets that overlap");
  CLI::Option* rooms = app.add_flag("--rooms", are_rooms, "in dimension 3: furnished rooms, everything equally warm");
  rooms->excludes(solids);
  app.add_flag("--hiding", is_hiding, "in dimension 3: convex bodies, whole and open, and what they hide")
      ->excludes(solids)
      ->excludes(rooms);
  app.add_option("--seed", options.first, "number of the first scene")->capture_default_str();
  app.add_option("--scenes", options.scenes, "how many")->capture_default_str()->check(CLI::PositiveNumber);
  app.add_option("--k", options.k, "of the lattice {0, ..., K}^2 of edges; 0: K = 2 to 6 in turn")
      ->capture_default_str()
      ->check(CLI::Range(0, 100));
  app.add_option("--threads", options.threads)->capture_default_str()->check(CLI::Range(1, 4096));
  std::string law;
  CLI::Option* only = app.add_option("--law", law, "this one alone")->type_name("NAME");
  std::string without;
  app.add_option("--without", without, "all laws but this one")->type_name("NAME")->excludes(only);
  app.add_flag("--all", options.all_laws, "every law on every scene");
  bool prints = false;
  app.add_flag("--print", prints, "of rooms: write the first scene, and hold it against nothing")->needs(rooms);
  app.add_flag("!--whole", options.shrinks, "show a scene that breaks a law as it is, not shrunk");
  CLI11_PARSE(app, argc, argv);
  if ((are_solids || are_rooms || is_hiding) && dimension != 3) {
    fmt::print(stderr, "hottel_storm: {} goes with --dimension 3\n",
               are_solids  ? "--solids"
               : are_rooms ? "--rooms"
                           : "--hiding");
    return 2;
  }

  if (prints) {
    fmt::print("{}", room_text_3(options.first));
    return 0;
  }

  const auto start = std::chrono::steady_clock::now();
  auto shown = start;
  options.progress = [&](std::uint64_t done) {
    const auto now = std::chrono::steady_clock::now();
    if (now - shown < std::chrono::seconds(1)) return;
    shown = now;
    const std::chrono::duration<double> taken = now - start;
    const double left = taken.count() * static_cast<double>(options.scenes - done) / static_cast<double>(done);
    fmt::print(stderr, "\r{} of {} scenes, {:.0f} s left  ", done, options.scenes, left);
  };
  const auto hold = [&](const auto& all, const auto& run) {
    const auto laws = chosen_laws(all, law, without);
    return tell(run(options, laws), laws, start, options.threads);
  };
  if (are_solids) return hold(solid_laws_3(), run_solid_storm_3);
  if (is_hiding) return hold(hiding_laws_3(), run_hiding_storm_3);
  if (are_rooms) return hold(room_laws_3(), run_room_storm_3);
  return dimension == 2 ? hold(hottel::storm::laws(), run_storm) : hold(laws_3(), run_storm_3);
}
