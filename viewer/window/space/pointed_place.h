// What a way from the eye meets first.
#pragma once

#include <optional>

#include "geometry/space/scene/scene.h"
#include "geometry/space/visibility/direction.h"

namespace hottel {

// Returns where the first polygon of a scene is met, whichever of its sides; nothing where none is. In doubles, for a
// hand: what all but touches may be taken for what it touches. COST: linear in the corners.
std::optional<Direction3> first_place_on_way_3(const Scene3& scene, const Direction3& eye, const Direction3& way);

}  // namespace hottel
