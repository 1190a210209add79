// What a NumPy file does not say of itself, as FILE.npy.json beside it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/results/factor_files.h"
#include "solver/plane/light/illumination_grid.h"

namespace hottel {

// Returns a JSON object of `quantity`, `shape`, `order` ("C": the last index runs fastest), `axes`, `region` (`min` and
// `max`: the outer borders of the first and the last cells, as the doubles next to them) and `channels`. A place that
// is NaN lies in a solid. way: how the light was computed, as `--illumination` names it.
std::string illumination_sidecar(const IlluminationGrid& light, const std::vector<std::string>& channels,
                                 std::string_view way);

// Returns a JSON object of `quantity`, `shape`, `order`, `axes`, and of `names` and `areas` of rows and columns alike,
// the sky last; an area that is beyond the range of doubles, as that of the sky, is null.
std::string factors_sidecar(const FactorTable& table);

}  // namespace hottel
