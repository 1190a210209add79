// Files other than those of scenes: results and drawings; and options and reports of what reads meshes and maps.
#pragma once

#include "geometry/space/scene/triangulator.h"  // Triangulator3
#include "io/files/text_file.h"                 // read_text_file
#include "io/results/factor_files.h"            // write_factors_csv, ...
#include "io/results/radiosity_files.h"         // write_radiosity_csv, write_flux_csv
#include "io/scene/passed_over.h"               // PassedOver
#include "io/scene/plane/map_defaults.h"        // MapSide2
#include "io/scene/plane/svg_reader.h"          // read_svg_2
