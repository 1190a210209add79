// What is edited in one process is what another makes of the saved scene, byte for byte.
#include <gtest/gtest.h>

#include <string>

#include "io/results/factor_files.h"
#include "io/results/npy.h"
#include "io/results/radiosity_files.h"
#include "tests/cli/program.h"
#include "tests/sanitizers.h"
#include "tests/solver/plane/edited_scenes.h"

namespace hottel::testing_cli::edited_scene_test {
namespace {

constexpr std::uint32_t kCells = 6;
constexpr int kEdits = kHasAddressSanitizer ? 60 : 1000;

// The files that `solve` writes of it, or the last line of its error.
std::string files_of(const Simulation2& simulation) {
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
    return error.what();
  }
  return text;
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

TEST(EditedScene, IsThatOfAFreshProcess) {
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
    files_of(simulation);  // some stages are made, others will be shared
    place.write("edited.json", write_scene_2(simulation.scene()));
    const std::string line = "hottel solve edited.json --quiet --no-picture -o out --grid 6x6 --illumination " +
                             std::string(to_string(request.light)) +
                             (request.everything ? " --simulate everything" : "");
    const Outcome outcome = place.run(line);
    const std::string expected = files_of(simulation);
    if (k % 4 == 0) {
      const Outcome factors = place.run("hottel factors edited.json --quiet --per element");
      ASSERT_EQ(factors.out, factors_of(simulation)) << k;
    }
    if (outcome.code == 0) {
      ASSERT_EQ(place.read("out/radiosity.csv") + place.read("out/illumination.npy"), expected) << k << " " << line;
      ++solved;
    } else {
      ASSERT_NE(outcome.err.find(expected.substr(0, expected.find('\n'))), std::string::npos)
          << k << " " << line << "\n"
          << outcome.err << expected;
    }
  }
  EXPECT_GT(solved, kEdits / 4);
}

}  // namespace
}  // namespace hottel::testing_cli::edited_scene_test
