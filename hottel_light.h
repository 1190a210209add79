// Light on grids in space: what Simulation3::light returns.
#pragma once

#include "solver/space/light/illumination_grid.h"  // IlluminationGrid3
