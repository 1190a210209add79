// Where light leaves a scene that should be closed.
#pragma once

#include <optional>

#include "geometry/exchange_matrix.h"
#include "geometry/space/check/mesh_findings.h"
#include "geometry/space/prepared/prepared_scene.h"

namespace hottel {

// Returns the gap that is widest; nothing where none is found.
//
//   (1) gaps are looked for along edges that lie on nothing (Meshes3::bare), and on fronts that see the sky where a
//       corner of another polygon lies on them beside a side
//   (2) those count from whose middle some of the sky is seen, a quarter or more of what is seen from any of them: what
//       hangs free within a room sees it through the gaps of others only
//   (3) the width is the distance from the middle of the edge to the nearest other polygon, or of the corner from the
//       side; rounded
//
// COST: a map (map_from) for each of at most 64 edges, evenly chosen, and 64 corners; for each of the 16 faces that see
// most of the sky an exact sign for each corner of the scene.
std::optional<Meshes3::Gap> widest_gap(const Meshes3& meshes, const PreparedScene3& prepared,
                                       const ExchangeMatrix& matrix);

}  // namespace hottel
