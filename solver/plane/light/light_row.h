// What a point sees, as fractions of all directions: a row that depends on the geometry alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/plane/predicates/vertices.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/view.h"
#include "solver/plane/light/light_columns.h"

namespace hottel {

// Whether a row has entries for what is black. The light of both rows is the same, bit for bit.
enum class Blacks2 : bool { kLeftOut, kListed };

// What is seen from a point: which columns (LightColumns2), each with the fraction of the full turn that it takes.
//
//   (1) entries are in counter-clockwise order where the point is on no edge; what is seen in several places has as
//       many entries. Neighbouring steps of one element are one entry as long as they stay within half a turn
//   (2) fractions are not negative. With blacks listed they sum to 1 but for rounding; where they are left out all
//       other entries are the same doubles
//   (3) a point in a solid, in the interior of the union of all, has no entries
struct LightRow2 {
  std::span<const std::uint32_t> columns;
  std::span<const double> fractions;
  bool sees_black = false;  // listed or not
  bool is_in_solid = false;
};

// Finds rows of points. Rows do not depend on each other, nor on anything that is sent out.
//
// What is seen is decided exactly; the angles are computed in doubles, each good to about 2^-50 turns times the ratio
// of the scene's extent to the distance of the vertex.
//
// On an edge or vertex what is seen jumps. There the row is the limit of its mean over ever smaller discs about the
// point: on an edge the mean of the limits from its two sides; at a vertex the mean over the directions from which one
// can approach it. (Every line through the centre of a cell halves it: no side of an edge has the larger part.) One
// approaches through free space only: on the border of a solid the free side alone counts.
//
// Points that are near each other are best taken together, for their angles are: add() each, then measure(), then
// row().
class LightRowFinder2 {
 public:
  // Forgets all points, and takes those that follow. The memory is used again. REQUIRES that both outlive the rows, and
  // that the columns are those of the scene.
  void begin(const Vertices2& vertices, const LightColumns2& columns, Blacks2 blacks);
  // Adds a point. REQUIRES: location and view are those of the eye. COST: about 5 ns for each vertex seen.
  void add(const Eye2& eye, const Location2& location, const View2& view);
  // Takes the angles of all points. COST: one arc tangent an entry, 3 to 10 ns.
  void measure();

  std::size_t size() const { return ends_.size(); }
  // The row of the k-th point. REQUIRES k < size(); measure() after the last add(). It holds until begin().
  LightRow2 row(std::size_t k) const {
    const std::size_t begin = k == 0 ? 0 : ends_[k - 1], count = ends_[k] - begin;
    return {{columns_.data() + begin, count},
            {fractions_.data() + begin, count},
            sees_black_[k] != 0,
            count == 0 && sees_black_[k] == 0};
  }

 private:
  using Code = LightColumns2::Code;
  struct Direction {
    double x, y;
  };
  class Panorama;

  void add_turn(const Panorama& around);
  void add_arcs(const Panorama& around, std::size_t first);
  void add_sectors(const Panorama& around);
  double add_sector(const Panorama& around, std::size_t first, std::size_t last);
  void add_known(Code code, double fraction);
  void make_room(std::size_t entries);

  const Vertices2* vertices_ = nullptr;
  const LightColumns2* of_side_ = nullptr;
  bool lists_blacks_ = false;
  // Where the entries of each point end, and whether it sees what is black.
  std::vector<std::size_t> ends_;
  std::vector<char> sees_black_;
  // All entries: count_ of them, and room for more.
  std::size_t count_ = 0;
  std::vector<std::uint32_t> columns_;
  std::vector<double> fractions_;
  // Cosine and sine of the angle of each, both times one length; of those that are not known.
  std::vector<double> cosines_, sines_;
  std::vector<std::pair<std::size_t, double>> known_;  // entries and their fractions
  std::vector<std::size_t> large_, incident_;
};

}  // namespace hottel
