// The library hottel: exact view factors and light of scenes in the plane and in space. This header declares
// scenes, their readers, simulations, and queries to simulations. Others next to it declare the rest; docs/library.md
// is the way in.
#pragma once

#include "geometry/exchange_matrix.h"             // ExchangeMatrix
#include "geometry/plane/scene/scene_builder.h"   // SceneBuilder2
#include "geometry/scene_names.h"                 // face_of, material_called
#include "io/scene/scene_json.h"                  // read_scene_2, write_scene_2
#include "kernel/support/failure.h"               // InputError, RequestError
#include "kernel/support/interrupt.h"             // request_interrupt
#include "kernel/version.h"                       // kVersion
#include "solver/plane/simulation/queries.h"      // view_factor, exact_pair, radiosity_of, light_at
#include "solver/plane/simulation/simulation.h"   // Simulation2
#include "solver/radiosity/radiosity_solution.h"  // RadiositySolution
#include "solver/space/simulation/queries.h"      // view_factor, radiosity_of
#include "solver/space/simulation/simulation.h"   // Simulation3
