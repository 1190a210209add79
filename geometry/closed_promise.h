// The promise of a scene to be closed.
#pragma once

#include <optional>

#include "geometry/exchange_matrix.h"
#include "geometry/row_ranges.h"
#include "geometry/scene_table.h"

namespace hottel {

// Throws RequestError, naming the first front, where a scene promises to be closed and a front with a material sees the
// sky: where it has an entry, however small. REQUIRES the exact matrix of the scene.
void require_closed(const SceneTable& scene, const ExchangeMatrix& matrix);
// The same of its rows.
void require_closed(const SceneTable& scene, RowRanges& rows);

// Throws what require_closed() does of an element that sees the sky, with its factor where that is known.
[[noreturn]] void refuse_promise(const SceneTable& scene, const Element& element, std::optional<double> factor);

}  // namespace hottel
