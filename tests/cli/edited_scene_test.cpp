// What is edited is what a new simulation, and a fresh process, makes of the saved scene, byte for byte.
#include <gtest/gtest.h>

#include <string>

#include "io/results/factor_files.h"
#include "io/results/npy.h"
#include "io/results/radiosity_files.h"
#include "io/scene/scene_json.h"
#include "tests/cli/program.h"
#include "tests/sanitizers.h"
#include "tests/solver/plane/edited_scenes.h"

namespace hottel::testing_cli::edited_scene_test {
namespace {

constexpr std::uint32_t kCells = 6;
constexpr int kEdits = kHasAddressSanitizer ? 60 : 1000;
constexpr int kPerProcess = 5;  // edits, of which one is given to fresh processes: these take most of the time

// The files that `solve` writes of it, or where it has none the first line of the error.
struct Solved {
  bool has_files = false;
  std::string text;
};

Solved solved_of(const Simulation2& simulation) {
  std::string text;
  const Sink sink = [&text](std::string_view more) { text += more; };
  try {
    const auto factors = simulation.factors();
    const auto solution = simulation.radiosities();
    const auto light = simulation.light();
    write_radiosity_csv(simulation.scene(), factors->matrix, *solution, sink);
    const std::size_t shape[3] = {light->grid.grid.ny, light->grid.grid.nx, light->grid.channels};
    write_npy(shape, light->grid.values, sink);
  } catch (const std::exception& error) {
    const std::string message = error.what();
    return {false, message.substr(0, message.find('\n'))};
  }
  return {true, std::move(text)};
}

// The file that `factors --per element` writes of it, or nothing where it has none.
std::string factors_of(const Simulation2& simulation) {
  std::string text;
  SimulationRequest2 request{.granularity = Granularity::kElement, .wants_visibility = true};
  const Simulation2 by_elements = simulation.with_request(request);
  try {
    by_elements.require_closed();
    const auto factors = by_elements.factors();
    write_factors_csv({by_elements.scene(), factors->matrix, Granularity::kElement, {}, {}},
                      [&text](std::string_view more) { text += more; });
  } catch (const std::exception&) {
  }
  return text;
}

TEST(EditedScene, IsThatOfANewSimulationAndAFreshProcess) {
  Workplace place;
  RandomEdits edits(7);
  const Scene2 room = room_to_edit();
  Simulation2 simulation(room, {.grid = grid_over(room, kCells, kCells)});
  int solved = 0;
  for (int k = 0; k < kEdits; ++k) {
    Simulation2 edited = edits.next(simulation);
    SimulationRequest2 request = edited.request();
    request.grid = grid_over(edited.scene(), kCells, kCells);  // as --grid says it
    simulation = edited.with_request(request);
    const Solved expected = solved_of(simulation);  // some stages are made, others were shared
    const std::string factors = factors_of(simulation);
    if (expected.has_files) ++solved;
    place.write("edited.json", write_scene_2(simulation.scene()));
    const Simulation2 fresh(read_scene_2(place.path("edited.json")), request);
    const Solved again = solved_of(fresh);
    ASSERT_EQ(again.has_files, expected.has_files) << k << again.text << expected.text;
    // The message of what is read names its file too.
    if (expected.has_files)
      ASSERT_EQ(again.text, expected.text) << k;
    else
      ASSERT_NE(again.text.find(expected.text), std::string::npos) << k << again.text << expected.text;
    ASSERT_EQ(factors_of(fresh), factors) << k;
    if (k % kPerProcess != 0) continue;
    const std::string line = "hottel solve edited.json --quiet --no-picture -o out --grid 6x6 --illumination " +
                             std::string(to_string(request.light)) +
                             (request.everything ? " --simulate everything" : "");
    const Outcome outcome = place.run(line);
    ASSERT_EQ(outcome.code == 0, expected.has_files) << k << " " << line << outcome.err << expected.text;
    if (expected.has_files)
      ASSERT_EQ(place.read("out/radiosity.csv") + place.read("out/illumination.npy"), expected.text) << k << line;
    else
      ASSERT_NE(outcome.err.find(expected.text), std::string::npos) << k << line << outcome.err << expected.text;
    ASSERT_EQ(place.run("hottel factors edited.json --quiet --per element").out, factors) << k;
  }
  EXPECT_GT(solved, kEdits / 4);
}

}  // namespace
}  // namespace hottel::testing_cli::edited_scene_test
