#include "solver/plane/light/light_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/plane/light/cell_views.h"

namespace hottel {
namespace {

constexpr std::uint64_t kEntryBytes = sizeof(std::uint32_t) + sizeof(double);

// Counts the bytes of rows while they are found.
class Room {
 public:
  Room(const Grid2& grid, std::uint64_t allowed) : grid_(grid), allowed_(allowed) {}

  // Of the cells before the band, and of what is kept of them.
  void begin_band(std::size_t cells, std::uint64_t kept) {
    cells_ = cells;
    taken_ = kept;
  }
  // A row is held twice while its band is put together. Throws RequestError when there is no room for it.
  void add(std::size_t entries) {
    const std::uint64_t bytes = 2 * (kEntryBytes * entries + sizeof(LightRowBlock2::Row));
    const std::uint64_t taken = taken_.fetch_add(bytes) + bytes;
    const std::uint64_t cells = cells_.fetch_add(1) + 1;
    if (taken > allowed_) refuse(taken, cells);
  }

 private:
  [[noreturn]] void refuse(std::uint64_t taken, std::uint64_t cells) const {
    const std::uint64_t all = std::uint64_t{grid_.nx} * grid_.ny;
    throw RequestError(fmt::format(
        "what the {} x {} cells of the light see takes more than the {} bytes of memory that are allowed: {} for {} "
        "cells so far, about {:.2g} for all; take a coarser grid",
        grid_.nx, grid_.ny, allowed_, taken, cells,
        static_cast<double>(taken) / static_cast<double>(cells) * static_cast<double>(all)));
  }

  const Grid2& grid_;
  std::uint64_t allowed_;
  std::atomic<std::uint64_t> taken_{0}, cells_{0};
};

// Checks the grid, and returns it.
const Grid2& in_doubles(const Grid2& grid) {
  for (const Rational& x : {grid.min.x, grid.min.y, grid.max.x, grid.max.y})
    if (!std::isfinite(to_double(x))) throw RequestError("the grid reaches beyond the range of doubles");
  return grid;
}

}  // namespace

LightRowBands2::LightRowBands2(const PreparedScene2& prepared, const Grid2& grid, const ElementTable2& table,
                               Blacks2 blacks)
    : columns_(prepared.arrangement, table), views_(prepared, in_doubles(grid)), blacks_(blacks) {}

void LightRowBands2::find(std::size_t band, const LightRowVisit2& visit) const {
  views_.look_around(band, [&](const CellTile2& tile) {
    thread_local LightRowFinder2 finder;  // its memory serves many tiles
    finder.begin(views_.vertices(), columns_, blacks_);
    for (std::size_t k = 0; k < tile.size(); ++k) finder.add(tile.eye(k), tile.location(k), tile.view(k));
    finder.measure();
    for (std::size_t k = 0; k < tile.size(); ++k) visit(tile.cell(k), finder.row(k));
  });
}

void for_each_light_row(const PreparedScene2& prepared, const Grid2& grid, const ElementTable2& table, Blacks2 blacks,
                        const std::function<void(double)>& progress, const LightRowVisit2& visit) {
  const LightRowBands2 rows(prepared, grid, table, blacks);
  for (std::size_t band = 0; band < rows.bands(); ++band) {
    rows.find(band, visit);
    if (progress) progress(static_cast<double>(band + 1) / static_cast<double>(rows.bands()));
  }
}

LightRowBlock2::LightRowBlock2(std::span<const Row> rows) {
  begin_.reserve(rows.size() + 1);
  begin_.push_back(0);
  states_.reserve(rows.size());
  for (const Row& row : rows) {
    begin_.push_back(begin_.back() + row.columns.size());
    states_.push_back(row.is_in_solid ? State::kInSolid : row.sees_black ? State::kSeesBlack : State::kFree);
  }
  columns_.reserve(begin_.back());
  fractions_.reserve(begin_.back());
  for (const Row& row : rows) {
    columns_.insert(columns_.end(), row.columns.begin(), row.columns.end());
    fractions_.insert(fractions_.end(), row.fractions.begin(), row.fractions.end());
  }
}

LightRow2 LightRowBlock2::row(std::size_t k) const {
  const std::size_t begin = begin_[k], count = begin_[k + 1] - begin;
  return {std::span(columns_).subspan(begin, count), std::span(fractions_).subspan(begin, count),
          states_[k] == State::kSeesBlack, states_[k] == State::kInSolid};
}

std::uint64_t LightRowBlock2::bytes() const {
  return kEntryBytes * columns_.size() + sizeof(State) * states_.size() + sizeof(std::size_t) * begin_.size();
}

namespace {

// Calls visit(first cell, rows) band by band; it returns how many bytes are kept of all bands so far.
template <class Visit>
void for_each_band(const PreparedScene2& prepared, const Grid2& grid, const ElementTable2& table, Blacks2 blacks,
                   std::uint64_t memory, const std::function<void(double)>& progress, const Visit& visit) {
  const LightRowBands2 bands(prepared, grid, table, blacks);
  Room room(grid, memory);
  std::uint64_t kept = 0;
  for (std::size_t band = 0; band < bands.bands(); ++band) {
    const std::size_t first = bands.first_cell(band);
    std::vector<LightRowBlock2::Row> rows(bands.first_cell(band + 1) - first);
    room.begin_band(first, kept);
    bands.find(band, [&](std::size_t cell, const LightRow2& row) {
      room.add(row.columns.size());
      rows[cell - first] = {{row.columns.begin(), row.columns.end()},
                            {row.fractions.begin(), row.fractions.end()},
                            row.sees_black,
                            row.is_in_solid};
    });
    LightRowBlock2 block(rows);
    rows.clear();
    rows.shrink_to_fit();
    kept = visit(first, std::move(block));
    if (progress) progress(static_cast<double>(band + 1) / static_cast<double>(bands.bands()));
  }
}

}  // namespace

void for_each_light_band(const PreparedScene2& prepared, const Grid2& grid, const ElementTable2& table, Blacks2 blacks,
                         std::uint64_t memory, const std::function<void(double)>& progress,
                         const LightBandVisit2& visit) {
  for_each_band(prepared, grid, table, blacks, memory, progress, [&](std::size_t first, LightRowBlock2 rows) {
    visit(first, rows);
    return std::uint64_t{0};
  });
}

LightRows2::LightRows2(const PreparedScene2& prepared, const Grid2& grid, const ElementTable2& table, Blacks2 blacks,
                       std::uint64_t memory, const std::function<void(double)>& progress) {
  for_each_band(prepared, grid, table, blacks, memory, progress, [&](std::size_t first, LightRowBlock2 rows) {
    if (first == 0) cells_in_a_block_ = rows.size();
    cells_ += rows.size();
    bytes_ += rows.bytes();
    blocks_.push_back(std::move(rows));
    return bytes_;
  });
}

}  // namespace hottel
