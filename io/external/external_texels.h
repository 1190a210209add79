// A lightmap that another program made.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "io/external/external_grid.h"
#include "io/external/facts_beside.h"

namespace hottel {

// What FILE.json says beside a lightmap, as `hottel solve --texels` writes it. What it does not say is nothing.
struct TexelFacts {
  std::string file;  // empty: there is none
  std::optional<std::string> face, quantity;
  std::optional<RegionFacts3> region;
};

// The texels of a face: a value for each texel and channel, as ExternalGrid has them, row 0 at its first corner.
struct ExternalTexels {
  ExternalGrid values;
  TexelFacts facts;
};

// Reads a NumPy array as read_external_cells does, and FILE.json if there is one. Throws InputError for anything else,
// where FILE.json is no JSON object, and where it has another shape than the array.
ExternalTexels read_external_texels(const std::filesystem::path& file);

}  // namespace hottel
