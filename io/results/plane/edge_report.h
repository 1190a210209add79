// What some point of a face sees, and the critical lines of a scene, for people and programs.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "geometry/plane/visibility/critical_lines.h"
#include "geometry/plane/visibility/weak_visibility.h"
#include "io/results/plane/visibility_report.h"

namespace hottel {

// The stretches of each face that are seen, each end as a place on its edge (0 to 1) and as a point, exactly and as
// doubles; whether the sky is seen. name: what the face was called.
VisibilityAnswer edge_answer(const PreparedScene2& prepared, const std::string& name, const WeakVisibility2& sight);

// What is met beyond a vertex of a line: the name of a face, "sky", or "#solid".
std::string met_name(const PreparedScene2& prepared, PieceSideId side);

// `x0,y0,x1,y1,along,behind_x,behind_y,behind_left,behind_right,ahead_x,ahead_y,ahead_left,ahead_right,
// from_behind_left,from_behind_right,from_ahead_left,from_ahead_right`: one line each. along: the surface on the
// segment between the vertices, else empty; both coordinates of an end at infinity are empty; from_...: what the line
// separates (LineReach2::seen_from_left), empty where it does not reach beyond the vertex. Coordinates are the nearest
// doubles, or p/q where is_exact. Throws RequestError for what is beyond the range of doubles.
void write_critical_lines_csv(const PreparedScene2& prepared, std::span<const CriticalLine2> lines, bool is_exact,
                              const std::function<void(std::string_view)>& sink);

// The same as a JSON object with one list, `lines`; an end at infinity is null.
std::string critical_lines_json(const PreparedScene2& prepared, std::span<const CriticalLine2> lines);

}  // namespace hottel
