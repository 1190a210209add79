// The matrix of what the cells of a grid see, as `solve --views` writes it.
#pragma once

#include <cstdint>
#include <string>

#include "cli/streams.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/files/output_file.h"
#include "io/results/factor_files.h"

namespace hottel {

// FILE.mtx, and FILE.mtx.faces.csv that says what its columns are.
struct ViewsOutput {
  OutputFile mtx, faces;
  // Throws OutputError where it cannot be written.
  explicit ViewsOutput(const std::string& file);
};

// Throws UsageError unless the file of --views ends in .mtx and light is that of points.
void require_sense_of_views(const std::string& file, const std::string& illumination);

// Writes both; neither takes its name yet. memory: as asked for, 0 where it was not. Throws RequestError, naming the
// scene's file, where there is not room enough in memory or on disk.
// REQUIRES factors of the scene, whose elements are the columns.
void write_views_2(const PreparedScene2& prepared, const Grid2& grid, const FactorTable& factors, std::uint64_t memory,
                   const Streams& streams, ViewsOutput& output);
void write_views_3(const PreparedScene3& prepared, const Grid3& grid, const FactorTable& factors, std::uint64_t memory,
                   const Streams& streams, ViewsOutput& output);

}  // namespace hottel
