// Whether a scene can be drawn at all.
#pragma once

#include <string>

#include "geometry/plane/predicates/vertices.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// The largest coordinate, and one over the smallest extent, that drawings with points in doubles take.
inline constexpr double kLargestDrawn = 1e300;

// Throws RequestError, naming a surface, where a drawing that places points by doubles could not: a coordinate beyond
// their range, or a scene so far from the origin that they do not tell its points apart.
void require_drawable(const Scene2& scene);

// The same for a point that is shown beside the scene. Throws RequestError that calls it by `text`.
void require_drawable(const Scene2& scene, const Point2& point, const std::string& text);

}  // namespace hottel
