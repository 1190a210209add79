// The materials of an OBJ file: MTL.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/material.h"

namespace hottel {

// Returns the materials of an MTL file, in its order.
//
//   (1) Kd is the reflectivity and Ke the emission, exactly; each is one value or r, g, b, and where the three are
//       equal it is a scalar. Missing ones are 0, as in a scene file
//   (2) all other keys (Ks, Ns, d, illum, map_Kd, ...) are about what is not computed here, and are passed over
//
// Throws InputError with file and line for a Kd or Ke that is no number, out of its range (spectrum_problem), given
// twice, or before any newmtl, for a name given twice, and for what ObjStatements refuses. COST: linear.
std::vector<Material> parse_mtl(std::string_view text, const std::string& file);

}  // namespace hottel
