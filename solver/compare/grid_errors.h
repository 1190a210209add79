// Light on a grid beside the exact light of the same cells.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "solver/compare/method_report.h"

namespace hottel {

// A value for each cell and channel, in C order (ny, nx, channels).
struct GridValues {
  std::uint32_t ny = 0, nx = 0, channels = 1;
  std::span<const double> values;

  double at(std::uint32_t ix, std::uint32_t iy, std::uint32_t channel) const {
    return values[(std::size_t{iy} * nx + ix) * channels + channel];
  }
};

// Errors of one channel, over the cells in which both have a finite value.
struct GridErrors {
  std::uint64_t cells = 0;       // such cells
  std::uint64_t missing = 0;     // of which only the exact light has one
  std::uint64_t extra = 0;       // of which only the other has one: in solids, and at lights
  std::uint64_t off = 0;         // of cells: wrong by more than was allowed, and half of the last digit written
  double max = 0, rms = 0;       // NaN without cells [unit of the light]
  double bias = 0, mean = 0;     // mean of what is found less what is right, and of what is right; NaN without cells
  double largest = 0;            // exact value
  std::uint32_t ix = 0, iy = 0;  // where max is; the first of equals
  double value = 0, exact = 0;   // there
};

// Returns the errors by channel. beyond: what a cell may be off, of the largest exact value; digits: of the file.
// REQUIRES as many cells and channels of both. COST: two passes.
std::vector<GridErrors> grid_errors(const GridValues& found, const GridValues& exact, double beyond,
                                    const WrittenDigits& digits);

// How a grid reads that is off: "upside down", "times 2 pi". Empty where nothing of this brings the root mean square,
// over all channels, below a tenth; what does best is told.
//
// Tried are the rows, the columns and both the other way round, where there are as many of both also with the axes
// exchanged, each with no ratio and with the one that fits best, by its name where it has one (named_factors.h).
// REQUIRES as above.
std::string grid_reading(const GridValues& found, const GridValues& exact);

}  // namespace hottel
