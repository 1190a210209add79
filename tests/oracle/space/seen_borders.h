// Of which points of a polygon the ways past a point to another polygon begin or end to be free.
#pragma once

#include <optional>
#include <vector>

#include "tests/oracle/space/free_ways.h"
#include "tests/oracle/space/plane_lines.h"

namespace hottel::oracle {

// A part of a line, from where it meets one line to where it meets another one, along (c[1], -c[0]): how much more
// often ways are free (FreeWays::sides) to the left of it, where the line's function is positive, than to the right.
struct SeenBorder {
  std::size_t line, from, to;
  int count;
  friend bool operator==(const SeenBorder&, const SeenBorder&) = default;
};

// All of them, for one t that is no event. Found by trying points next to every part of every line.
template <class Real>
class BorderFinder {
 public:
  BorderFinder(const std::vector<PlanePolygon>& polygons, const SpaceSegment& f, const PlaneLines& lines, Real least);

  // Nothing where something is in doubt.
  std::optional<std::vector<SeenBorder>> at(const Real& t);

 private:
  struct Line {
    Real a, b, c;
    Real value(const Real& alpha, const Real& beta) const { return a * alpha + b * beta + c; }
  };
  struct Crossing {
    Real at;
    std::size_t line;
  };

  void move_to(const Real& t);
  std::vector<Crossing> crossings(std::size_t line);
  void join(std::size_t line, std::vector<Crossing>& found);
  bool clip(std::size_t line, std::vector<Crossing>& found);
  int seen_beside(std::size_t line, const Real& alpha, const Real& beta, int side);
  void add_borders(std::size_t line, std::vector<SeenBorder>& borders);

  const PlaneLines& given_;
  FreeWays<Real> ways_;
  VectorOf<Real> origin_, u_, v_, from_, way_, q_;
  Real least_;
  std::vector<Line> lines_;
  bool is_in_doubt_ = false;
};

extern template class BorderFinder<double>;
extern template class BorderFinder<RealOf<70>>;
extern template class BorderFinder<DeepReal>;

}  // namespace hottel::oracle
