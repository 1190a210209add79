#include "solver/plane/methods/run_points.h"

#include "kernel/support/parallel.h"

namespace hottel {

RunPoints2::RunPoints2(const PreparedScene2& prepared, const ElementGeometry2& geometry,
                       const std::vector<Rational>& places)
    : geometry_(geometry), visibility_(prepared.arrangement), points_(geometry.all_runs().size()) {
  parallel_for(points_.size(), [&](std::size_t run) {
    points_[run].reserve(places.size());
    for (const Rational& t : places) points_[run].emplace_back(prepared.arrangement, geometry.all_runs()[run].ends, t);
  });
}

void RunPoints2::append_partners(std::uint32_t element, std::vector<std::uint32_t>& elements) const {
  thread_local View2 view;
  for (const ElementRun2& run : geometry_.runs(element))
    for (const RunPoint2& point : points_[geometry_.number_of(run)]) {
      visibility_.look_around(point, view);
      for (const View2::Seen& seen : view.seen)
        if (const std::uint32_t other = geometry_.table().of(seen.behind); other < geometry_.count())
          elements.push_back(other);
    }
}

}  // namespace hottel
