// What every cell of a grid sees, as rows: passed on as they are found, in order, or kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/plane/light/cell_views.h"
#include "solver/plane/light/light_row.h"

namespace hottel {

// Calls visit(cell, row) once for each cell, number iy * nx + ix, with what its exact centre sees; from many threads at
// once, in any order. The row holds during the call.
using LightRowVisit2 = std::function<void(std::size_t, const LightRow2&)>;

// The rows of a grid, to be found band by band (CellViews2).
//
//   (1) a row depends on the cell's centre and the scene alone: not on the other cells, the threads, or on radiosities
// REQUIRES that scene and table outlive it, at least one cell, min < max; the table of the scene.
class LightRowBands2 {
 public:
  // Throws RequestError where the grid reaches beyond the range of doubles.
  LightRowBands2(const PreparedScene2& prepared, const Grid2& grid, const ElementTable2& table, Blacks2 blacks);
  LightRowBands2(const LightRowBands2&) = delete;
  LightRowBands2& operator=(const LightRowBands2&) = delete;

  std::size_t bands() const { return views_.bands(); }
  std::size_t first_cell(std::size_t band) const { return views_.first_cell(band); }
  // Those of one band. Throws Interrupted when asked to stop.
  void find(std::size_t band, const LightRowVisit2& visit) const;

 private:
  LightColumns2 columns_;
  CellViews2 views_;
  Blacks2 blacks_;
};

// All of them, band by band.
//
//   (1) a row depends on the cell's centre and the scene alone: not on the other cells, the threads, or on radiosities
// progress: fraction done, called by the calling thread; may throw to stop. Throws Interrupted when asked to stop.
// REQUIRES at least one cell, min < max; the table of the scene.
void for_each_light_row(const PreparedScene2& prepared, const Grid2& grid, const ElementTable2& table, Blacks2 blacks,
                        const std::function<void(double)>& progress, const LightRowVisit2& visit);

// Rows of consecutive cells, as a sparse matrix by rows: 12 bytes an entry, 9 a cell.
class LightRowBlock2 {
 public:
  std::size_t size() const { return states_.size(); }
  // REQUIRES k < size(), and that the block outlives the row.
  LightRow2 row(std::size_t k) const;
  std::uint64_t bytes() const;

  // A row with memory of its own.
  struct Row {
    std::vector<std::uint32_t> columns;
    std::vector<double> fractions;
    bool sees_black = false, is_in_solid = false;
  };
  explicit LightRowBlock2(std::span<const Row> rows);

 private:
  enum class State : unsigned char { kFree, kSeesBlack, kInSolid };
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> columns_;
  std::vector<double> fractions_;
  std::vector<State> states_;
};

// The rows of some rows of cells at a time, from below; visit(first cell, rows) is called by the calling thread.
//
//   (1) each cell once, in order; the rows are those of for_each_light_row
// memory: bytes that the rows of one band may take while they are put together; throws RequestError, which says about
// how many all take, as soon as they are more. Else as for_each_light_row.
using LightBandVisit2 = std::function<void(std::size_t, const LightRowBlock2&)>;
void for_each_light_band(const PreparedScene2& prepared, const Grid2& grid, const ElementTable2& table, Blacks2 blacks,
                         std::uint64_t memory, const std::function<void(double)>& progress,
                         const LightBandVisit2& visit);

// What all cells of a grid see, kept: light of another solution then needs no further look.
//
//   (1) row(cell) is the row of for_each_light_row, bit for bit
class LightRows2 {
 public:
  // memory: bytes that it may take, those of the band that is put together twice; throws RequestError, which says about
  // how many all would take, as soon as they are more. Else as for_each_light_row.
  LightRows2(const PreparedScene2& prepared, const Grid2& grid, const ElementTable2& table, Blacks2 blacks,
             std::uint64_t memory, const std::function<void(double)>& progress = {});

  std::size_t cells() const { return cells_; }
  // REQUIRES cell < cells(), and that this outlives the row.
  LightRow2 row(std::size_t cell) const { return blocks_[cell / cells_in_a_block_].row(cell % cells_in_a_block_); }
  std::uint64_t bytes() const { return bytes_; }

 private:
  std::size_t cells_ = 0, cells_in_a_block_ = 1;
  std::uint64_t bytes_ = 0;
  std::vector<LightRowBlock2> blocks_;  // all but the last of one size
};

}  // namespace hottel
