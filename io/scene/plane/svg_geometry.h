// What the attributes of a drawing say about straight lines: points, paths and transforms, exactly.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/plane/scene/scene.h"
#include "kernel/rational.h"

namespace hottel {

// An attribute that cannot be read, or not exactly. what() is the end of a sentence whose subject is the attribute.
class SvgAttributeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A run of straight pieces in user units, y down as in the drawing. A closed run does not repeat its first point.
struct SvgRun {
  std::vector<Point2> points;
  bool closed = false;
};

// (x, y) -> (a x + c y + e, b x + d y + f). The default is the identity.
struct SvgTransform2 {
  Rational a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  // The point that p goes to, exactly.
  Point2 apply(const Point2& p) const;
  // Whether what turns left before turns right after.
  bool is_mirrored() const { return a * d < b * c; }
  // The transform that applies `inner` first.
  SvgTransform2 after(const SvgTransform2& inner) const;
};

// Every function throws SvgAttributeError.

// A length in user units: a number, alone or followed by "px". Other units are refused: they are not exact.
Rational parse_svg_length_2(std::string_view text);

// The points of a polyline or polygon, in order, as they are typed; blanks and one comma may stand between numbers. An
// x without a y is refused; an empty text has no points.
std::vector<Point2> parse_svg_points_2(std::string_view text);

// The runs of a path of straight pieces: the commands M, L, H, V and Z, absolute and relative.
//
//   (1) pairs after the first one of an M are corners, as of an L; Z closes a run, and goes back to its first point
//   (2) a run that comes back to its first point before Z does not repeat it; an M without a piece after it is no run
// Other commands are refused, since curves are not exact; so is a path that does not begin with M.
std::vector<SvgRun> parse_svg_path_2(std::string_view text);

// A list of translate, scale, matrix, and rotate by multiples of 90 degrees: what is exact over the rationals. The last
// of the list is applied first; an empty one is the identity. What flattens the plane onto a line is refused.
SvgTransform2 parse_svg_transform_2(std::string_view text);

}  // namespace hottel
