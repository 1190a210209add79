// Grids in the plane that others light together with this process.
#include "solver/plane/light/cell_crew.h"

#include <gtest/gtest.h>

#include <string>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/plane/light/illumination_grid.h"
#include "solver/plane/light/sent_out.h"
#include "tests/lit_grids.h"
#include "tests/shuffled_cells.h"

namespace hottel::cell_crew_test {
namespace {

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";

IlluminationGrid2 light_of(const Simulation2& simulation, const LitGrid2& lit) {
  return illuminate_points(*simulation.prepared(), lit.granularity, *simulation.radiosities(), lit.grid);
}

// The light of a solution by cells, and by bands of them that others may take part in.
TEST(CellCrew2, WhoeverTakesPartTheLightIsTheSame) {
  for (const LitGrid2& lit : lit_grids_2()) {
    const Simulation2 simulation = simulation_of(lit, kScenes);
    const PreparedScene2& prepared = *simulation.prepared();
    const ElementTable2& table = *prepared.elements(lit.granularity);
    const std::vector<std::uint64_t> expected = bits_of(
        illuminate_points(prepared, lit.grid, table, sent_out_2(table, *simulation.radiosities(), prepared.scene))
            .values);
    EXPECT_EQ(bits_of(light_of(simulation, lit).values), expected) << lit.scene;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      ShuffledCells2 crew(seed);
      const CrewScope<CellCrew2> scope(crew);
      EXPECT_EQ(bits_of(light_of(simulation, lit).values), expected) << lit.scene;
      EXPECT_EQ(crew.grids(), 1);
    }
  }
}

TEST(CellCrew2, WhatIsLostOrComesTwiceIsNoticed) {
  const LitGrid2 lit = lit_grids_2().front();
  const Simulation2 simulation = simulation_of(lit, kScenes);
  for (const WorkFault fault : {WorkFault::kLost, WorkFault::kTwice})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      ShuffledCells2 crew(seed, fault);
      const CrewScope<CellCrew2> scope(crew);
      EXPECT_THROW(light_of(simulation, lit), ContractViolation);
    }
}

TEST(CellCrew2, BandsThatAreNotOfTheGridAreNoticed) {
  const LitGrid2 lit = lit_grids_2().front();
  const Simulation2 simulation = simulation_of(lit, kScenes);
  const LightOfElements2 light(*simulation.prepared(), lit.granularity, *simulation.radiosities(), lit.grid);
  EXPECT_GT(light.bands(), 1u);
  EXPECT_THROW(light.lit({0, light.bands() + 1}), ContractViolation);
}

}  // namespace
}  // namespace hottel::cell_crew_test
