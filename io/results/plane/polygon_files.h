// Visibility polygons of many points as files: csv, GeoJSON, well-known text and NumPy's .npz.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "geometry/plane/prepared/prepared_scene.h"
#include "io/results/plane/polygon_writer.h"

namespace hottel {

enum class PolygonFormat2 { kCsv, kGeoJson, kWkt, kNpz };

// The format of a file by its ending: .csv, .geojson (or .json), .wkt, .npz; nothing for another one.
std::optional<PolygonFormat2> polygon_format_2(const std::filesystem::path& file);

// Returns a writer through a sink. REQUIRES that the scene outlives it, and exact corners for csv and GeoJSON only.
std::unique_ptr<PolygonWriter2> polygon_writer_2(PolygonFormat2 format, const PreparedScene2& prepared,
                                                 PolygonFileOptions2 options,
                                                 std::function<void(std::string_view)> sink);

}  // namespace hottel
