#include "solver/illumination/average_illumination_2.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/failure.h"
#include "kernel/interrupt.h"
#include "kernel/parallel.h"
#include "solver/illumination/lit_wedge_2.h"
#include "solver/illumination/polar_integrals.h"

namespace hottel {
namespace {

constexpr double kUnit = 0x1p-53;
constexpr std::uint32_t kRowsInABand = 8;
constexpr std::size_t kVerticesInABlock = 16;

struct Range {
  double min, max;
  void include(double value) {
    min = std::min(min, value);
    max = std::max(max, value);
  }
};

// The x that a triangle takes between two heights; empty when it takes none.
Range columns_of(const Vector2 (&corners)[3], double bottom, double top) {
  Range range{HUGE_VAL, -HUGE_VAL};
  for (int k = 0; k < 3; ++k) {
    const Vector2 &p = corners[k], &q = corners[(k + 1) % 3];
    const Vector2 &low = p.y < q.y ? p : q, &high = p.y < q.y ? q : p;
    if (high.y < bottom || low.y > top) continue;
    const double left = std::min(low.x, high.x), right = std::max(low.x, high.x);
    if (high.y - low.y <= 0) {
      range.include(left);
      range.include(right);
      continue;
    }
    const double slope = (high.x - low.x) / (high.y - low.y);
    range.include(low.y >= bottom ? low.x : std::clamp(low.x + (bottom - low.y) * slope, left, right));
    range.include(high.y <= top ? high.x : std::clamp(low.x + (top - low.y) * slope, left, right));
  }
  return range;
}

// Index of the cell that a place lies in, kept within [0, count].
std::uint32_t index_in(double place, std::uint32_t count) {
  return place > 0 ? static_cast<std::uint32_t>(std::min(place, static_cast<double>(count))) : 0;
}

// Sums over the cells of a grid, in the unit of radiosity times the area of a cell that is one wide, times 2 pi.
class CellSums {
 public:
  CellSums(const CellFrame2& frame, std::uint32_t channels)
      : frame_(frame),
        integrals_(frame.height()),
        channels_(channels),
        sums_(std::size_t{frame.nx()} * frame.ny() * channels),
        errors_(std::size_t{frame.nx()} * frame.ny()) {}

  // Adds one wedge to the cells of some rows. Threads may work on different rows.
  void add(const LitWedge2& wedge, const double* coefficients, std::uint32_t first_row, std::uint32_t end_row) {
    const double height = frame_.height();
    Range y{HUGE_VAL, -HUGE_VAL};
    for (const Vector2& corner : wedge.corners) y.include(corner.y);
    const double slack = wedge.margin + 0x1p-40 * frame_.extent();
    const std::uint32_t begin = std::max(first_row, index_in((y.min - slack) / height, frame_.ny()));
    const std::uint32_t end = std::min(end_row, index_in((y.max + slack) / height + 1, frame_.ny()));
    for (std::uint32_t iy = begin; iy < end; ++iy) {
      const Range x = columns_of(wedge.corners, iy * height - slack, (iy + 1) * height + slack);
      const std::uint32_t left = index_in(x.min - slack, frame_.nx()), right = index_in(x.max + slack + 1, frame_.nx());
      for (std::uint32_t ix = left; ix < right; ++ix) add_to_cell(wedge, coefficients, ix, iy);
    }
  }

  double sum(std::size_t cell, std::uint32_t channel) const { return sums_[cell * channels_ + channel]; }
  double error(std::size_t cell) const { return errors_[cell]; }

 private:
  void add_to_cell(const LitWedge2& wedge, const double* coefficients, std::uint32_t ix, std::uint32_t iy) {
    const FinePoint2 centre = frame_.centre(ix, iy);
    const double height = frame_.height(), diagonal = 2 * integrals_.radius();
    // Which lines cut the cell? Only those are worth a careful look.
    double cut_at[3], doubt = 0;
    int cuts[3], cut_count = 0;
    for (int k = 0; k < wedge.line_count; ++k) {
      const CutLine2& line = wedge.lines[k];
      const double support = (std::fabs(line.gradient().x) + height * std::fabs(line.gradient().y)) / 2;
      const double rough = line.rough(centre);
      if (rough > support + line.rough_doubt()) continue;
      if (rough < -support - line.rough_doubt()) return;
      const double at = line.at(centre), error = line.doubt() + 16 * kUnit * diagonal;
      if (at > support + error) continue;
      if (at < -support - error) return;
      cuts[cut_count] = k;
      cut_at[cut_count++] = at;
      doubt += error;
    }
    const Vector2 z = rounded(centre - wedge.apex);
    AreaAndAngle part;
    double error = doubt * 2 * diagonal * wedge.largest;
    if (cut_count == 0) {
      part = integrals_.over_cell(z, wedge.axis);
      error += 12 * kUnit * part.area * wedge.largest_slope;
    } else {
      CellPart2 rest(height);
      for (int k = 0; k < cut_count; ++k) rest.cut(cut_at[k], wedge.lines[cuts[k]].gradient());
      if (rest.size() >= 3) part = integrals_.over(rest, z, wedge.axis);
      error += kUnit * integrals_.area_error() * wedge.largest;
    }
    if (cut_count > 0 || integrals_.is_near(z)) error += kUnit * integrals_.angle_error(z) * wedge.largest_slope;
    error += (wedge.angle_doubt * wedge.sources + 8 * kUnit * wedge.largest) * part.area;
    const std::size_t cell = std::size_t{iy} * frame_.nx() + ix;
    double largest = 0;
    for (std::uint32_t c = 0; c < channels_; ++c) {
      double& sum = sums_[cell * channels_ + c];
      sum += coefficients[2 * c] * part.area + coefficients[2 * c + 1] * part.angle;
      largest = std::max(largest, std::fabs(sum));
    }
    errors_[cell] += error + kUnit * largest;
  }

  const CellFrame2& frame_;
  const PolarIntegrals integrals_;
  const std::uint32_t channels_;
  std::vector<double> sums_, errors_;
};

std::vector<double> largest_radiosities(const Arrangement2& arrangement, const FaceRadiosity2& radiosity) {
  const auto sky = radiosity.of(kSky);
  std::vector<double> largest(sky.begin(), sky.end());
  for (PieceSideId side = 0; side < static_cast<PieceSideId>(arrangement.side_count()); ++side)
    for (std::size_t c = 0; c < largest.size(); ++c) largest[c] = std::max(largest[c], radiosity.of(side)[c]);
  return largest;
}

// Adds the wedges of all vertices; returns what could not be placed.
double add_all(const Arrangement2& arrangement, const FaceRadiosity2& radiosity, const CellFrame2& frame,
               const std::function<void(double)>& progress, CellSums& sums) {
  const WedgeLighting2 lighting(arrangement, radiosity, frame);
  const std::size_t vertices = arrangement.vertices().size();
  const std::size_t bands = (frame.ny() + kRowsInABand - 1) / kRowsInABand;
  std::vector<LitWedges2> of_vertex(kVerticesInABlock);
  double lost = 0;
  for (std::size_t begin = 0; begin < vertices; begin += kVerticesInABlock) {
    const std::size_t end = std::min(vertices, begin + kVerticesInABlock);
    parallel_for(end - begin, [&](std::size_t k) {
      throw_if_interrupted();
      of_vertex[k].clear();
      lighting.append(static_cast<VertexId>(begin + k), of_vertex[k]);
    });
    parallel_for(bands, [&](std::size_t band) {
      const auto first = static_cast<std::uint32_t>(band * kRowsInABand);
      const std::uint32_t last = std::min(frame.ny(), first + kRowsInABand);
      for (std::size_t v = begin; v < end; ++v) {
        throw_if_interrupted();
        const LitWedges2& lit = of_vertex[v - begin];
        for (const LitWedge2& wedge : lit.wedges) sums.add(wedge, &lit.coefficients[wedge.coefficients], first, last);
      }
    });
    for (std::size_t v = begin; v < end; ++v) lost += of_vertex[v - begin].lost;
    if (progress) progress(static_cast<double>(end) / static_cast<double>(vertices));
  }
  return lost;
}

}  // namespace

AverageIllumination illuminate_averages(const PreparedScene2& prepared, const Grid2& grid,
                                        const FaceRadiosity2& radiosity, const std::function<void(double)>& progress) {
  HOTTEL_REQUIRE(grid.nx > 0 && grid.ny > 0 && grid.min.x < grid.max.x && grid.min.y < grid.max.y);
  const Arrangement2& arrangement = prepared.arrangement;
  const std::uint32_t channels = radiosity.channels();
  const CellFrame2 frame(arrangement.vertices(), grid);
  CellSums sums(frame, channels);
  const double lost = add_all(arrangement, radiosity, frame, progress, sums);

  const std::size_t cells = std::size_t{grid.nx} * grid.ny;
  AverageIllumination result{{grid, channels, std::vector<double>(cells * channels)}, std::vector<double>(cells), 0};
  const std::vector<double> largest = largest_radiosities(arrangement, radiosity);
  const double brightest = *std::max_element(largest.begin(), largest.end());
  const double scale = 1 / (2 * std::numbers::pi * frame.height());
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const double error = (sums.error(cell) * scale + lost / (2 * std::numbers::pi) + 16 * kUnit * brightest) * 1.0001;
    const bool is_known = error < brightest;
    for (std::uint32_t c = 0; c < channels; ++c) {
      const double value = radiosity.of(kSky)[c] + sums.sum(cell, c) * scale;
      result.grid.values[cell * channels + c] = is_known ? std::clamp(value, 0.0, largest[c]) : largest[c] / 2;
    }
    result.errors[cell] = is_known ? error : brightest;
    result.max_error = std::max(result.max_error, result.errors[cell]);
  }
  return result;
}

}  // namespace hottel
