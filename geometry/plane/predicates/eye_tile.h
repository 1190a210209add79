// Points to look from that lie near each other on a grid, and what is decided for many of them at once.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane/predicates/vertices.h"

namespace hottel {

// The eyes where up to eight columns and up to eight rows cross: cells of a grid that look around together. Eye
// 8 * row + column is that bit of a set of eyes.
//
//   (1) what is answered of a set of eyes is what each of them would answer by itself (Eye2), exactly
//   (2) a line that passes by the box of a group has all of the group on one side: that is decided once, in doubles,
//       with a bound on the error that holds anywhere in the box
class EyeTile2 {
 public:
  static constexpr std::size_t kSide = 8;
  using Set = std::uint64_t;

  // Some of the eyes, and a box about the point (x, y) that holds them: as far as its radii to either side.
  struct Group {
    Set eyes;
    double x, y, radius_x, radius_y;
  };

  // Throws ContractViolation unless there are one to eight columns, and one to eight rows.
  // REQUIRES: both in ascending order and made with these vertices; all three outlive the tile.
  EyeTile2(const Vertices2& vertices, std::span<const EyeCoordinate2> columns, std::span<const EyeCoordinate2> rows);

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return eyes_.size() / columns_; }
  const Eye2& eye(std::size_t k) const { return eyes_[k / kSide * columns_ + k % kSide]; }

  // All eyes of the tile.
  Set all() const {
    Set eyes = 0;
    for (std::size_t row = 0; row < rows(); ++row) eyes |= (Set{0xff} >> (kSide - columns_)) << (kSide * row);
    return eyes;
  }

  // These eyes and a box that holds them, widened by the error of their coordinates.
  // REQUIRES: eyes of the tile, at least one.
  Group group(Set eyes) const;

  // The eyes of the group whose orientation(j, k) is positive; exactly.
  // COST: about 3 ns where the line through j and k passes by the box, else about as much again for each eye.
  Set seeing_left_turn(const Group& group, VertexId j, VertexId k) const {
    const Vertices2::Approximate &q = approximate_[j.index()], &r = approximate_[k.index()];
    const double ax = q.x - group.x, ay = q.y - group.y, bx = r.x - group.x, by = r.y - group.y;
    const double determinant = ax * by - ay * bx;
    const double bound = error_anywhere_ + group.radius_x * std::fabs(by - ay) + group.radius_y * std::fabs(bx - ax);
    if (!(std::fabs(determinant) > bound)) return seeing_left_turn_each(group, j, k);
    return group.eyes & -Set{determinant > 0};
  }

 private:
  Set seeing_left_turn_each(const Group& group, VertexId j, VertexId k) const;

  const Vertices2::Approximate* approximate_;
  double error_, error_of_eyes_ = 0;  // of an approximate coordinate
  double error_anywhere_;             // of a determinant, from the middle of any box
  std::size_t columns_;
  std::array<double, kSide> x_, y_;
  std::vector<Eye2> eyes_;
};

}  // namespace hottel
