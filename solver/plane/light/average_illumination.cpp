#include "solver/plane/light/average_illumination.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "kernel/doubles.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "solver/plane/light/cell_sums.h"
#include "solver/plane/light/free_shares.h"

namespace hottel {
namespace {

constexpr std::uint32_t kRowsInABand = 8;
constexpr std::size_t kVerticesInABlock = 16;

std::vector<double> largest_radiosities(const Arrangement2& arrangement, const FaceRadiosity2& radiosity) {
  const auto sky = radiosity.of(kSky);
  std::vector<double> largest(sky.begin(), sky.end());
  for (const PieceSideId side : arrangement.sides())
    for (std::size_t c = 0; c < largest.size(); ++c) largest[c] = std::max(largest[c], radiosity.of(side)[c]);
  return largest;
}

// Adds the wedges of all vertices; returns what could not be placed.
double add_all(const Arrangement2& arrangement, const FaceRadiosity2& radiosity, const CellFrame2& frame,
               const std::function<void(double)>& progress, CellSums2& sums) {
  const WedgeLighting2 lighting(arrangement, radiosity, frame);
  const std::size_t vertices = arrangement.vertices().size();
  const std::size_t bands = (frame.ny() + kRowsInABand - 1) / kRowsInABand;
  std::vector<LitWedges2> of_vertex(kVerticesInABlock);
  double lost = 0;
  for (std::size_t begin = 0; begin < vertices; begin += kVerticesInABlock) {
    const std::size_t end = std::min(vertices, begin + kVerticesInABlock);
    parallel_for(end - begin, [&](std::size_t k) {
      throw_if_interrupted();
      lighting.find(VertexId(begin + k), of_vertex[k]);
    });
    parallel_for(bands, [&](std::size_t band) {
      const auto first = static_cast<std::uint32_t>(band * kRowsInABand);
      const std::uint32_t last = std::min(frame.ny(), first + kRowsInABand);
      for (std::size_t v = begin; v < end; ++v) {
        throw_if_interrupted();
        sums.add(of_vertex[v - begin], first, last);
      }
    });
    for (std::size_t v = begin; v < end; ++v) lost += of_vertex[v - begin].lost;
    if (progress) progress(static_cast<double>(end) / static_cast<double>(vertices));
  }
  return lost;
}

}  // namespace

AverageIllumination2 illuminate_averages(const PreparedScene2& prepared, const Grid2& grid,
                                         const FaceRadiosity2& radiosity, const std::function<void(double)>& progress) {
  const DefaultFloatingPoint arithmetic;
  HOTTEL_REQUIRE(grid.nx > 0 && grid.ny > 0 && grid.min.x < grid.max.x && grid.min.y < grid.max.y);
  const Arrangement2& arrangement = prepared.arrangement;
  const std::uint32_t channels = radiosity.channels();
  const CellFrame2 frame(arrangement.vertices(), grid);
  CellSums2 sums(frame, channels);
  const double lost = add_all(arrangement, radiosity, frame, progress, sums);

  const std::vector<double> shares = free_shares(arrangement, FreeParts2(prepared), grid, frame);
  const std::size_t cells = std::size_t{grid.nx} * grid.ny;
  AverageIllumination2 result{{grid, channels, std::vector<double>(cells * channels)}, std::vector<double>(cells), 0};
  const std::vector<double> largest = largest_radiosities(arrangement, radiosity);
  const double brightest = *std::max_element(largest.begin(), largest.end());
  const double scale = 1 / (2 * std::numbers::pi * frame.height());
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const double share = shares.empty() ? 1 : shares[cell];
    if (share == 0) {
      std::fill_n(result.grid.values.begin() + static_cast<std::ptrdiff_t>(cell * channels), channels,
                  std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const double of_cell = sums.error(cell) * scale + lost / (2 * std::numbers::pi) + 16 * kUnitRoundoff * brightest;
    const double error = of_cell / share * 1.0001;
    const bool is_known = error < brightest;
    for (std::uint32_t c = 0; c < channels; ++c) {
      const double value = radiosity.of(kSky)[c] + sums.sum(cell, c) * scale / share;
      result.grid.values[cell * channels + c] = is_known ? std::clamp(value, 0.0, largest[c]) : largest[c] / 2;
    }
    result.errors[cell] = is_known ? error : brightest;
    result.max_error = std::max(result.max_error, result.errors[cell]);
  }
  return result;
}

}  // namespace hottel
