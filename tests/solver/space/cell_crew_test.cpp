// Grids in space that others light together with this process.
#include "solver/space/light/cell_crew.h"

#include <gtest/gtest.h>

#include <string>

#include "kernel/support/failure.h"
#include "solver/space/light/illumination_grid.h"
#include "tests/lit_grids.h"
#include "tests/shuffled_cells.h"

namespace hottel::cell_crew_test {
namespace {

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";

IlluminationGrid3 light_of(const Simulation3& simulation, const LitGrid3& lit) {
  return illuminate_points(*simulation.prepared(), lit.granularity, *simulation.radiosities(), lit.grid);
}

// illuminate_points (4)
TEST(CellCrew3, WhoeverTakesPartTheLightIsTheSame) {
  for (const LitGrid3& lit : lit_grids_3()) {
    const Simulation3 simulation = simulation_of(lit, kScenes);
    const std::vector<std::uint64_t> expected = bits_of(light_of(simulation, lit).values);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      ShuffledCells3 crew(seed);
      const CrewScope<CellCrew3> scope(crew);
      EXPECT_EQ(bits_of(light_of(simulation, lit).values), expected) << lit.scene;
      EXPECT_EQ(crew.grids(), 1);
    }
  }
}

TEST(CellCrew3, WhatIsLostOrComesTwiceIsNoticed) {
  const LitGrid3 lit = lit_grids_3().front();
  const Simulation3 simulation = simulation_of(lit, kScenes);
  for (const WorkFault fault : {WorkFault::kLost, WorkFault::kTwice})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      ShuffledCells3 crew(seed, fault);
      const CrewScope<CellCrew3> scope(crew);
      EXPECT_THROW(light_of(simulation, lit), ContractViolation);
    }
}

TEST(CellCrew3, CellsThatAreNotOfTheGridAreNoticed) {
  const LitGrid3 lit = lit_grids_3().front();
  const Simulation3 simulation = simulation_of(lit, kScenes);
  const LightOfElements3 light(*simulation.prepared(), lit.granularity, *simulation.radiosities(), lit.grid);
  EXPECT_THROW(light.lit({0, lit.grid.cells() + 1}), ContractViolation);
}

}  // namespace
}  // namespace hottel::cell_crew_test
