// Sums of what wedges add to the cells of a grid, with a bound on their errors.
#pragma once

#include <vector>

#include "solver/plane/light/lit_wedge.h"
#include "solver/plane/light/polar_integrals.h"

namespace hottel {

// By cell and channel, the integral over the cell of constant + slope * angle of all wedges, in the unit of radiosity
// times the area of a cell that is one wide.
//
//   (1) sum() is within error() of the real number, for the wedges that were placed
//   (2) a sum depends on the order in which wedges came, and on nothing else
class CellSums2 {
 public:
  // All sums are 0. REQUIRES that the frame outlives this. COST: 8 bytes a cell and channel, 8 more a cell.
  CellSums2(const CellFrame2& frame, std::uint32_t channels);

  // Adds the wedges of a vertex to the cells of the rows first_row to end_row - 1. Threads may work on different rows.
  // COST: the cells of these rows that the wedges come near.
  void add(const LitWedges2& lit, std::uint32_t first_row, std::uint32_t end_row);

  // What a cell holds so far, and how far each of its channels may be off. REQUIRES cell = iy * nx + ix.
  double sum(std::size_t cell, std::uint32_t channel) const { return sums_[cell * channels_ + channel]; }
  double error(std::size_t cell) const { return errors_[cell]; }

 private:
  struct Cell {
    std::size_t index;
    FinePoint2 centre;
    Vector2 rough;  // the centre
  };
  // What a part is multiplied by: the difference of two wedges' coefficients, and their doubt.
  struct Weight {
    const double *plus, *minus;
    double doubt;
  };

  void add_wedge(const LitWedges2& lit, std::size_t w, std::uint32_t first_row, std::uint32_t end_row);
  bool is_before_end(const LitWedge2& wedge, const Cell& cell) const;
  bool is_within_quadrant(const LitWedges2& lit, const LitWedge2& wedge, const Cell& cell) const;
  void add_sector(const LitWedges2& lit, std::size_t w, const Cell& cell);
  void add_cell(const Vector2& z, const Vector2& axis, const Cell& cell, const Weight& weight);
  void add_right_of(const CutLine2& ray, const Vector2& z, const Vector2& axis, const Cell& cell, const Weight& weight);
  void add_between(const LitWedges2& lit, const LitWedge2& wedge, const Cell& cell);
  void add_part(const CellPart2& part, double doubt, const Vector2& z, const Vector2& axis, const Cell& cell,
                const Weight& weight);
  void deposit(const AreaAndAngle2& part, double area_doubt, double angle_doubt, const Cell& cell,
               const Weight& weight);

  const CellFrame2& frame_;
  const PolarIntegrals2 integrals_;
  const std::uint32_t channels_;
  const std::vector<double> nothing_;  // coefficients
  std::vector<double> sums_, errors_;
};

}  // namespace hottel
