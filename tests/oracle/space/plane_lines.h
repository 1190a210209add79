// Lines in the plane of a polygon, where what points of it see past a point that moves along an edge may change.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tests/oracle/space/border_edges.h"
#include "tests/oracle/space/real_of_digits.h"

namespace hottel::oracle {

using DeepReal = RealOf<150>;

// The line c[0] alpha + c[1] beta + c[2] = 0 of the points A + alpha u + beta v, where c = at_0 + t slope. A, u and v
// are those of a PlaneFrame.
struct PlaneLine {
  std::array<mpz_class, 3> at_0, slope;
  bool is_moving = false;

  std::array<mpz_class, 3> at(long t) const;
};

struct PlaneFrame {
  SpacePoint origin, u, v;

  explicit PlaneFrame(const SpacePolygon& polygon);
  std::array<mpq_class, 2> place(const SpacePoint& p) const;  // alpha and beta of a point of the plane
};

// All lines in the plane of polygon 0 at which the answer to "is the way from x past f(t) to polygon 1 free" may change
// as x moves, for f(t) = f.a + t (f.b - f.a): where x and f(t) are in a plane with a side or a foot, where x passes
// through the plane of a polygon, and the sides of polygon 0 first. No two are the same line for all t.
class PlaneLines {
 public:
  PlaneLines(const std::vector<PlanePolygon>& polygons, const SpaceSegment& f);

  const std::vector<PlaneLine>& all() const { return lines_; }
  std::size_t sides() const { return sides_; }
  // Do the three meet in one point, or nowhere, for all t?
  bool always_meet(std::size_t a, std::size_t b, std::size_t c) const;

  // All t of (0, 1), in order, at which lines that do not always do so meet in one point of the polygon or near it, or
  // become one line; and 0 and 1.
  std::vector<DeepReal> events() const;

 private:
  using Polynomial = std::array<mpz_class, 4>;

  void add(const std::array<mpq_class, 3>& at_0, const std::array<mpq_class, 3>& at_1, bool is_moving);
  void add_static(const PlanePolygon& polygon);
  void add_moving(const SpaceSegment& e);
  void add_plain_events(std::vector<DeepReal>& found) const;
  void meet_all();
  Polynomial meeting(std::size_t a, std::size_t b, std::size_t c) const;
  template <class Real>
  std::optional<bool> meet_near(const Real& t, const std::array<std::size_t, 3>& which, double least) const;
  bool is_near(const DeepReal& t, const std::array<std::size_t, 3>& which) const;

  struct Meeting {
    std::size_t a, b, c;
    Polynomial when;
  };

  const std::vector<PlanePolygon>& polygons_;
  SpaceSegment f_;
  PlaneFrame frame_;
  std::array<double, 4> reach_;  // of polygon 0 in the frame, with a margin: alpha from, to, beta from, to
  std::vector<PlaneLine> lines_;
  std::size_t sides_ = 0;
  std::vector<char> always_;
  std::vector<Meeting> meetings_;
};

}  // namespace hottel::oracle
