// The library hottel: exact view factors and light of scenes in the plane. Includes all that an outside program needs.
#pragma once

#include "geometry/check/finding.h"                      // Finding
#include "geometry/exchange/exchange_2.h"                // prepare, exact_exchange, exact_pair
#include "geometry/exchange/exchange_matrix.h"           // ExchangeMatrix
#include "geometry/scene/generators_2.h"                 // generate_2
#include "geometry/scene/scene_2.h"                      // Scene2
#include "io/factor_files.h"                             // write_factors_csv, ...
#include "io/foreign_matrix.h"                           // file_family_2, run_family_2
#include "io/output_file.h"                              // OutputFile
#include "io/scene_json.h"                               // read_scene_2, write_scene_2
#include "io/svg_reader.h"                               // read_svg_2
#include "kernel/enclosure.h"                            // Enclosure, Rounded
#include "kernel/failure.h"                              // InputError, RequestError
#include "kernel/interrupt.h"                            // request_interrupt
#include "kernel/parallel.h"                             // ThreadLimit
#include "kernel/rational.h"                             // Rational
#include "kernel/root_sum.h"                             // RootSum
#include "kernel/version.h"                              // kVersion
#include "solver/check/scene_check_2.h"                  // check_scene
#include "solver/compare/verdict.h"                      // judge
#include "solver/illumination/average_illumination_2.h"  // illuminate_averages
#include "solver/illumination/illumination_grid_2.h"     // illuminate_points
#include "solver/methods/method_catalogue_2.h"           // planar_methods
#include "solver/plan.h"                                 // Plan
#include "solver/system/gray_exchange.h"                 // gray_exchange
#include "solver/system/net_flux.h"                      // net_flux
#include "solver/system/radiosity.h"                     // solve_radiosity
#include "viewer/picture/scene_picture_2.h"              // scene_picture_2
