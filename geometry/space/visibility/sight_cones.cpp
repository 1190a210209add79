#include "geometry/space/visibility/sight_cones.h"

#include <cmath>
#include <limits>

#include "geometry/space/visibility/cone_fragment.h"

namespace hottel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLeastCosine = 0.1;  // of a cone that excludes anything: two of them stay below 180 degrees
constexpr double kSlack = 1e-12;      // far above the rounding of what is compared, relative to the distances

const SightCone3 kEverywhere{1, 0, 0, -1, 0, 0, kInfinity};

// An axis-parallel box of vectors from the eye.
struct Box {
  double low[3] = {kInfinity, kInfinity, kInfinity}, high[3] = {-kInfinity, -kInfinity, -kInfinity};

  void include(const BoundedVector& w) {
    const double values[3] = {w.x, w.y, w.z};
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], values[a]);
      high[a] = std::max(high[a], values[a]);
    }
  }
  void include(const Box& other) {
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], other.low[a]);
      high[a] = std::max(high[a], other.high[a]);
    }
  }
  bool is_empty() const { return low[0] > high[0]; }
};

double length(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

// True for lengths whose squares neither underflow nor overflow.
bool is_plain(double value) { return value > 0x1p-400 && value < 0x1p400; }

SightCone3 cone_around(const Box& box) {
  if (box.is_empty()) return {};
  const double x = (box.low[0] + box.high[0]) / 2, y = (box.low[1] + box.high[1]) / 2,
               z = (box.low[2] + box.high[2]) / 2;
  const double distance = length(x, y, z);
  const double radius =
      length(box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]) / 2 + kSlack * distance;
  if (!is_plain(distance)) return kEverywhere;
  SightCone3 cone{x / distance, y / distance, z / distance, -1, 0, 0, (distance + radius) * (1 + kSlack)};
  cone.nearest = std::max(0.0, distance - radius);
  const double sine = radius / distance;
  if (sine * sine > 1 - kLeastCosine * kLeastCosine) return cone;
  cone.sine = sine;
  cone.cosine = std::sqrt(1 - sine * sine);
  return cone;
}

// The distance of the plane of a polygon, or less.
double plane_distance(const EyePlanes3& planes, std::size_t s) {
  const BoundedVector& normal = planes.blockers().normal(s);
  const BoundedVector& toward = planes.eye().toward(planes.blockers().outline(s).front());
  const double product = normal.x * toward.x + normal.y * toward.y + normal.z * toward.z;
  return std::max(0.0, std::fabs(product) / length(normal.x, normal.y, normal.z) - kSlack * toward.size);
}

SightCone3 cone_around(const EyePlanes3& planes, std::size_t s, const Box& box) {
  SightCone3 cone = cone_around(box);
  const auto outline = planes.blockers().outline(s);
  double x = 0, y = 0, z = 0, farthest = 0;
  for (const VertexId3 v : outline) {
    const BoundedVector& w = planes.eye().toward(v);
    const double distance = length(w.x, w.y, w.z);
    if (!is_plain(distance)) return kEverywhere;
    farthest = std::max(farthest, distance);
    x += w.x / distance;
    y += w.y / distance;
    z += w.z / distance;
  }
  cone.nearest = std::max(cone.nearest, plane_distance(planes, s));
  cone.farthest = std::min(cone.farthest, farthest * (1 + kSlack));
  const double size = length(x, y, z);
  if (size < 1e-3) return cone;
  double cosine = 1;
  for (const VertexId3 v : outline) {
    const BoundedVector& w = planes.eye().toward(v);
    cosine = std::min(cosine, (x * w.x + y * w.y + z * w.z) / (size * length(w.x, w.y, w.z)));
  }
  if (cosine < kLeastCosine || cosine < cone.cosine) return cone;
  return {x / size,     y / size,     z / size, cosine, std::sqrt(std::max(0.0, 1 - cosine * cosine)),
          cone.nearest, cone.farthest};
}

}  // namespace

SightCones3::SightCones3(const EyePlanes3& planes) : blockers_(planes.blockers()) {
  polygons_.resize(blockers_.size());
  std::vector<Box> boxes(blockers_.nodes().size());
  nodes_.resize(boxes.size());
  // Children stand behind their parents.
  for (std::size_t n = boxes.size(); n-- > 0;) {
    const Blockers3::Node& node = blockers_.nodes()[n];
    if (node.left != 0) {
      boxes[n].include(boxes[node.left]);
      boxes[n].include(boxes[node.right]);
    } else {
      for (std::uint32_t k = node.begin; k < node.end; ++k) {
        const std::uint32_t s = blockers_.order()[k];
        if (planes.facing(s) == 0) continue;
        Box box;
        for (const VertexId3 v : blockers_.outline(s)) box.include(planes.eye().toward(v));
        polygons_[s] = cone_around(planes, s, box);
        boxes[n].include(box);
      }
    }
    nodes_[n] = cone_around(boxes[n]);
  }
  add_normals(planes);
}

void SightCones3::add_normals(const EyePlanes3& planes) {
  std::vector<PlaneSide3> sides;
  for (std::size_t s = 0; s < blockers_.size(); ++s) {
    cone_sides(planes, s, sides);
    for (const PlaneSide3 side : sides) {
      const BoundedVector& m = planes.normal(side.plane);
      const double size = length(m.x, m.y, m.z);
      const bool is_known = is_plain(size) && m.error < 1e-10 * size;
      const double factor = !is_known ? 0 : side.is_opposite ? -1 / size : 1 / size;
      normals_.push_back({factor * m.x, factor * m.y, factor * m.z});
    }
    first_.push_back(normals_.size());
  }
}

void SightCones3::find_blockers(const SightCone3& target, std::vector<std::uint32_t>& found) {
  found.clear();
  if (nodes_.empty()) return;
  waiting_.assign(1, 0);
  while (!waiting_.empty()) {
    const std::uint32_t n = waiting_.back();
    waiting_.pop_back();
    if (!may_hide(nodes_[n], target)) continue;
    const Blockers3::Node& node = blockers_.nodes()[n];
    if (node.left != 0) {
      waiting_.push_back(node.right);
      waiting_.push_back(node.left);
      continue;
    }
    for (std::uint32_t k = node.begin; k < node.end; ++k)
      if (may_hide(polygons_[blockers_.order()[k]], target)) found.push_back(blockers_.order()[k]);
  }
}

}  // namespace hottel
