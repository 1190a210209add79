// The matrix of what the cells of a grid see, as a file.
#pragma once

#include <cstdint>
#include <functional>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/results/factor_files.h"

namespace hottel {

// The matrix H: the entry of a cell and an element is the fraction of all directions in which the cell's centre sees
// the element (light_row.h says what that is on edges and vertices). Its rows are the cells, number iy * nx + ix, from
// the lowest y; its columns the elements of the table, then the sky.
//
//   (1) it depends on the scene's geometry, its elements and the grid alone; the mean irradiance at the centres is H
//       times the radiosities, the sky's emission last, but for rounding
//   (2) a row sums to 1 but for rounding, unless the cell lies in a solid: then it has no entries
struct LightMatrix2 {
  const PreparedScene2& prepared;
  const Grid2& grid;
  const ElementTable2& table;
  std::uint64_t memory;  // bytes that rows may take while they are written

  std::uint64_t rows() const { return std::uint64_t{grid.nx} * grid.ny; }
  std::uint64_t columns() const { return std::uint64_t{table.count()} + 1; }
};

// How many entries the matrix has, and how many of its rows have none for they are in solids.
struct LightMatrixSize {
  std::uint64_t entries = 0, in_solids = 0;
};
// COST: that of illuminate_points(). progress: fraction done; may throw to stop.
LightMatrixSize light_matrix_size(const LightMatrix2& matrix, const std::function<void(double)>& progress = {});

// About as many bytes as the file takes.
std::uint64_t light_matrix_bytes(const LightMatrix2& matrix, const LightMatrixSize& size);

// Matrix Market `coordinate real general`, 1-based, entries by row, then by column; comments say what rows and columns
// are. The columns are named by write_faces_csv, which goes into FILE.faces.csv. Some rows of cells are held at a time.
//
//   (3) the same bytes for any number of threads
// Throws RequestError where these rows take more than the memory that is allowed. REQUIRES the size of this matrix.
void write_light_matrix_mtx(const LightMatrix2& matrix, const LightMatrixSize& size,
                            const std::function<void(double)>& progress, const Sink& sink);

}  // namespace hottel
