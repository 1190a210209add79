#include "solver/plane/methods/arithmetic_cgal.h"

#include <cmath>

#include "kernel/kernels.h"
#include "kernel/support/stopwatch.h"

namespace hottel {
namespace {

class CgalPoints {
 public:
  explicit CgalPoints(const Vertices2& vertices) {
    points_.reserve(vertices.size());
    // Below 1 where they are no doubles, so that squares stay in range.
    const auto below_one = [shift = -vertices.exponent()](const Rational& value) {
      return ExactKernel::FT(scaled_by_power_of_two(value, shift));
    };
    for (const VertexId v : vertices.ids()) {
      const Vertices2::Approximate& near = vertices.approximate(v);
      const Point2 exact = vertices.exact(v);
      if (vertices.approximation_error() == 0)
        points_.emplace_back(ExactKernel::FT(near.x), ExactKernel::FT(near.y));
      else
        points_.emplace_back(below_one(exact.x), below_one(exact.y));
    }
  }

  int orientation(VertexId i, VertexId j, VertexId k) const {
    return static_cast<int>(CGAL::orientation(points_[i.index()], points_[j.index()], points_[k.index()]));
  }
  double distance(VertexId i, VertexId j) const {
    return std::sqrt(CGAL::to_double(CGAL::squared_distance(points_[i.index()], points_[j.index()])));
  }

 private:
  std::vector<ExactKernel::Point_2> points_;
};

}  // namespace

CgalExchange2 cgal_exchange(const Arrangement2& arrangement, const ElementTable2& table,
                            const std::function<void(double)>& progress) {
  const CgalPoints points(arrangement.vertices());
  CgalExchange2 result;
  Stopwatch watch;
  result.sums = plain_sums(arrangement, table, progress, [&](VertexId) -> const CgalPoints& { return points; });
  result.lengths = plain_lengths(arrangement, table, points);
  result.seconds = watch.lap();
  return result;
}

}  // namespace hottel
