// The borders of sides of pieces that are seen, by the lines of space that they lie on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "geometry/face.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/direction.h"

namespace hottel {

// A part of a line of space, from place(line, from) to place(line, to).
struct BorderPart3 {
  double from = 0, to = 0;  // from < to
};

// Lines that hold borders of sides of pieces, told exactly: borders that lie on one line have one number, whatever
// their ends. Places are relative to the eye.
class BorderLines3 {
 public:
  // One segment of the outline of a piece, as a border of the side that is seen.
  struct Border {
    std::uint32_t line = 0;
    Direction3 begin, end;            // the ways from the eye to its ends
    double at_begin = 0, at_end = 0;  // on the line
    std::vector<BorderPart3> drawn;   // its parts, ascending, across which no surface goes on
  };

  // Of sides of pieces that an eye sees: `surface` of each Face is the number of a piece. round_bend: the bend in
  // degrees up to which neighbours of one group and material count as one surface. COST:
  // n log n exact comparisons.
  BorderLines3(const PreparedScene3& prepared, const Point3& eye, std::span<const Face> seen, double round_bend);

  // The borders of a side that is seen, in the order of the outline of its piece.
  std::span<const Border> borders(std::size_t seen) const {
    return std::span(borders_).subspan(first_[seen], first_[seen + 1] - first_[seen]);
  }
  std::size_t count() const { return lines_.size(); }
  // The way from the eye to a place on a line.
  Direction3 place(std::uint32_t line, double at) const { return lines_[line].origin + at * lines_[line].way; }

 private:
  // What a side is, for what goes on beyond its borders.
  struct Side {
    std::uint32_t group = 0;
    std::optional<std::uint32_t> material;
    Direction3 normal;  // unit, towards the eye
  };
  struct Line {
    Direction3 origin, way;  // place(t) = origin + t way
    std::vector<std::size_t> borders;
  };
  // An exact line: its direction, 1 along its first axis that is not 0, and its moment about the eye.
  using Key = std::array<Rational, 6>;

  void add_side(const PreparedScene3& prepared, const Point3& eye, const Face& face);
  void add_border(const Vector3& begin, const Vector3& end);
  std::vector<BorderPart3> drawn_of(std::size_t border) const;
  bool goes_on(std::size_t border, std::size_t other) const;

  double least_cosine_;
  std::vector<Side> sides_;
  std::vector<std::size_t> first_{0};  // of a side in borders_
  std::vector<std::size_t> side_of_;   // of a border
  std::vector<Border> borders_;
  std::vector<Line> lines_;
  std::map<Key, std::uint32_t> known_;
};

}  // namespace hottel
