// The library hottel: exact view factors and light of scenes in the plane. Includes all that an outside program needs.
#pragma once

#include "geometry/exchange_matrix.h"                   // ExchangeMatrix
#include "geometry/plane/arrangement/prepared_scene.h"  // prepare
#include "geometry/plane/check/finding.h"               // Finding
#include "geometry/plane/exchange/closed_forms.h"       // exact_pair
#include "geometry/plane/exchange/exchange.h"           // exact_exchange
#include "geometry/plane/generate/generators.h"         // generate_2
#include "geometry/plane/scene/scene.h"                 // Scene2
#include "io/files/output_file.h"                       // OutputFile
#include "io/foreign/plane/foreign_matrix.h"            // file_family_2, run_family_2
#include "io/results/factor_files.h"                    // write_factors_csv, ...
#include "io/scene/plane/svg_reader.h"                  // read_svg_2
#include "io/scene/scene_json.h"                        // read_scene_2, write_scene_2
#include "kernel/enclosure.h"                           // Enclosure, Rounded
#include "kernel/rational.h"                            // Rational
#include "kernel/root_sum.h"                            // RootSum
#include "kernel/support/failure.h"                     // InputError, RequestError
#include "kernel/support/interrupt.h"                   // request_interrupt
#include "kernel/support/parallel.h"                    // ThreadLimit
#include "kernel/version.h"                             // kVersion
#include "solver/plan.h"                                // Plan
#include "solver/plane/check/scene_check.h"             // check_scene
#include "solver/plane/compare/verdict.h"               // judge
#include "solver/plane/light/average_illumination.h"    // illuminate_averages
#include "solver/plane/light/illumination_grid.h"       // illuminate_points
#include "solver/plane/methods/method_catalogue.h"      // methods_2
#include "solver/radiosity/gray_exchange.h"             // gray_exchange
#include "solver/radiosity/net_flux.h"                  // net_flux
#include "solver/radiosity/radiosity.h"                 // solve_radiosity
#include "solver/radiosity/radiosity_solver.h"          // RadiositySolver
#include "viewer/picture/plane/scene_picture.h"         // scene_picture_2
