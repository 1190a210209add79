// The elements of a scene as approximate methods see them: straight runs in doubles.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"

namespace hottel {

// A difference of places, or a direction, in local units.
struct LocalVector2 {
  double x = 0, y = 0;
};
inline double dot(const LocalVector2& a, const LocalVector2& b) { return a.x * b.x + a.y * b.y; }
inline double length(const LocalVector2& v) { return std::sqrt(dot(v, v)); }

// A place in local units. Each coordinate is the sum of two doubles, so that also what is small and far from the
// origin keeps its shape; differences are to be formed before anything is rounded.
struct LocalPoint2 {
  double x = 0, y = 0;
  double x_low = 0, y_low = 0;

  friend LocalVector2 operator-(const LocalPoint2& p, const LocalPoint2& q) {
    return {(p.x - q.x) + (p.x_low - q.x_low), (p.y - q.y) + (p.y_low - q.y_low)};
  }
};

// One straight run of an element, its front on the right of from -> to.
//
//   (1) at(0) is `from` and at(1) is `to`, exactly; in between places are as good as doubles of the length allow
//   (2) a back has its ends exchanged: normal() always leads into the space that the face looks into
struct ElementRun2 {
  Segment2 ends;  // the vertices at from and to
  LocalPoint2 from, to, centre;
  LocalVector2 direction;  // of length 1
  double length = 0;       // > 0
  double share = 1;        // of the length of its element, in (0, 1]

  LocalVector2 normal() const { return {direction.y, -direction.x}; }  // into the space before the front
  LocalPoint2 at(double t) const;                                      // from + t (to - from)
};

// The elements of a prepared scene, Granularity::kElement, in a frame of their own:
// translated by the first vertex, exactly, and scaled by a power of two so that coordinates stay below 1. Factors do
// not depend on scale, so methods need no other.
//
// Where surfaces overlap an element may be left with several runs. A method treats each run as an element of its own;
// with shares w the factors of the elements are F_ij = sum_a w_a sum_b F_ab over the runs a of i and b of j. There is
// no such thing as the centre of an element, only of a run.
//
//   (1) lengths and directions are those of the exact end points, rounded once or twice; places are good to 2^-104
//   (2) everything is the same bit for bit when the scene is translated, or scaled by a power of two
// Runs shorter than 2^-500 are left out (labels().runs() still has them): an element that has no other exchanges
// nothing.
class ElementGeometry2 {
 public:
  explicit ElementGeometry2(const PreparedScene2& prepared);

  const ElementTable2& table() const { return *table_; }
  std::uint32_t count() const { return table_->count(); }
  bool has_row(std::uint32_t element) const { return table_->has_row(element); }
  std::span<const ElementRun2> runs(std::uint32_t element) const {
    return {runs_.data() + begin_[element], runs_.data() + begin_[element + 1]};
  }
  // Whether no run of an element was left out.
  bool is_whole(std::uint32_t element) const { return runs(element).size() == table_->runs(element).size(); }
  // The runs of all elements, one element after the other.
  std::span<const ElementRun2> all_runs() const { return runs_; }
  // The place of a run in all_runs(). REQUIRES a reference into it, not a copy.
  std::size_t number_of(const ElementRun2& run) const { return static_cast<std::size_t>(&run - runs_.data()); }
  double length(std::uint32_t element) const { return length_[element]; }  // in local units

  double diagonal() const { return diagonal_; }   // of the bounding box of all vertices, in local units
  const Rational& unit() const { return unit_; }  // one local unit in units of the scene
  const LocalPoint2& place(VertexId v) const { return place_[v.index()]; }

 private:
  void add_run(const Vertices2& vertices, const Segment2& ends);

  std::shared_ptr<const ElementTable2> table_;
  Rational unit_ = 1;
  double diagonal_ = 0;
  std::vector<LocalPoint2> place_;
  std::vector<ElementRun2> runs_;
  std::vector<std::size_t> begin_;
  std::vector<double> length_;
};

// Which elements have a row and a run to see from. REQUIRES that the geometry outlives what is returned.
inline auto has_runs(const ElementGeometry2& geometry) {
  return [&geometry](std::uint32_t element) { return geometry.has_row(element) && !geometry.runs(element).empty(); };
}

}  // namespace hottel
