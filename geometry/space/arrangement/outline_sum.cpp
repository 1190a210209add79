#include "geometry/space/arrangement/outline_sum.h"

#include <algorithm>
#include <tuple>

namespace hottel {

bool OutlineSum3::Key::operator<(const Key& other) const {
  const auto tied = [](const Key& key) {
    return std::tie(key.way.x, key.way.y, key.way.z, key.moment.x, key.moment.y, key.moment.z, key.place);
  };
  return tied(*this) < tied(other);
}

void OutlineSum3::add(const IntegerVector& from, const IntegerVector& to, long factor) {
  IntegerVector way = primitive(difference(to, from));
  if (std::tie(way.x, way.y, way.z) < std::make_tuple(0, 0, 0)) way = opposite(way);
  const IntegerVector moment = cross(from, way);
  const auto count = [&](const IntegerVector& point, long times) {
    End& end = ends_[{way, moment, dot(way, point)}];
    end.count += times;
    end.point = point;
  };
  count(from, -factor);
  count(to, factor);
}

std::optional<IntegerVector> OutlineSum3::open_end() const {
  const auto open = std::find_if(ends_.begin(), ends_.end(), [](const auto& end) { return end.second.count != 0; });
  return open == ends_.end() ? std::nullopt : std::optional(open->second.point);
}

}  // namespace hottel
