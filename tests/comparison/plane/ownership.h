// Scenes as the oracles take them, and who has each side of each piece by the engine and by the oracle.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/scene/scene.h"
#include "tests/oracle/plane/split.h"

namespace hottel::oracle {

// One surface for each edge, "e0", "e1", ... or, in a polyline, "p2[0]", "p2[1]", ... after its first edge; material m
// reflects m/4, and 2 emits 1 as well.
Scene2 to_scene(const std::vector<InputSegment>& edges);

// One edge for each surface; Divided::kYes: for each of its elements.
std::vector<InputSegment> to_edges(const Scene2& scene, Divided2 divided = Divided2::kNo);

// Returns where the two differ: in the pieces, in what is covered, in the owner of a side.
std::string ownership_differs(const PreparedScene2& prepared, const Split& split);

// Returns where the verdicts on a scene differ: refused by the one and not by the other, refused for another reason, or
// ownership_differs(). `expected`: of to_edges(scene).
std::string verdict_differs(const Scene2& scene, const Split& expected);

}  // namespace hottel::oracle
