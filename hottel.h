// The library hottel: exact view factors and light of scenes in the plane and in space. Includes all that an outside
// program needs; docs/library.md is the way in.
#pragma once

#include "geometry/exchange_matrix.h"                      // ExchangeMatrix
#include "geometry/plane/check/finding.h"                  // Finding2
#include "geometry/plane/exchange/closed_forms.h"          // exact_pair
#include "geometry/plane/scene/scene_builder.h"            // SceneBuilder2
#include "geometry/plane/visibility/critical_points.h"     // critical_points
#include "geometry/plane/visibility/point_place.h"         // place_of
#include "geometry/plane/visibility/polygons_of_points.h"  // visibility_polygons
#include "geometry/scene_names.h"                          // face_of, material_called
#include "io/external/plane/named_methods.h"               // method_2
#include "io/results/factor_files.h"                       // write_factors_csv, ...
#include "io/results/radiosity_files.h"                    // write_radiosity_csv, write_flux_csv
#include "io/scene/plane/svg_reader.h"                     // read_svg_2
#include "io/scene/scene_json.h"                           // read_scene_2, write_scene_2
#include "kernel/support/failure.h"                        // InputError, RequestError
#include "kernel/support/interrupt.h"                      // request_interrupt
#include "kernel/support/parallel.h"                       // ThreadLimit
#include "kernel/version.h"                                // kVersion
#include "solver/plane/compare/method_comparison.h"        // MethodComparison2, add_verdict
#include "solver/plane/simulation/queries.h"               // view_factor, radiosity_of, light_at
#include "solver/plane/simulation/simulation.h"            // Simulation2
#include "solver/radiosity/gray_exchange.h"                // gray_exchange
#include "solver/radiosity/net_flux.h"                     // net_flux
#include "solver/radiosity/radiosity_solver.h"             // RadiositySolver
#include "solver/space/simulation/queries.h"               // view_factor, radiosity_of
#include "solver/space/simulation/simulation.h"            // Simulation3
#include "viewer/picture/plane/illumination_picture.h"     // illumination_picture_2, light_painter_2
#include "viewer/picture/plane/scene_picture.h"            // scene_picture_2
#include "viewer/picture/plane/visibility_picture.h"       // visibility_picture_2, pair_picture_2
