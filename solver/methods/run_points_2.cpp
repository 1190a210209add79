#include "solver/methods/run_points_2.h"

#include "kernel/parallel.h"

namespace hottel {

RunPoints2::RunPoints2(const PreparedScene2& prepared, const ElementGeometry2& geometry,
                       const std::vector<Rational>& places)
    : geometry_(geometry), visibility_(prepared.arrangement), points_(geometry.all_runs().size()) {
  parallel_for(points_.size(), [&](std::size_t run) {
    points_[run].reserve(places.size());
    for (const Rational& t : places) points_[run].emplace_back(prepared.arrangement, geometry.all_runs()[run].ends, t);
  });
}

}  // namespace hottel
