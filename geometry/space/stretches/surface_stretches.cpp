#include "geometry/space/stretches/surface_stretches.h"

#include <optional>

namespace hottel {
namespace {

// Where a function that is linear on a convex polygon is zero: from its values at the corners.
std::optional<std::array<WeightedPoint3, 2>> zero_line(const Occluders3& occluders, std::uint32_t s,
                                                       const std::vector<Integer>& values) {
  const auto corners = occluders.outline(s);
  std::array<WeightedPoint3, 2> ends;
  std::size_t count = 0;
  const auto add = [&](WeightedPoint3 point) {
    if (count < 2) ends[count] = std::move(point);
    ++count;
  };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t next = (k + 1) % corners.size();
    const IntegerVector &a = occluders.vertices().exact(corners[k]), &b = occluders.vertices().exact(corners[next]);
    const Integer &at_a = values[k], &at_b = values[next];
    if (at_a == 0) add({a, 1});
    if (sgn(at_a) * sgn(at_b) >= 0) continue;
    const Integer p = abs(at_a), q = abs(at_b);
    add({{q * a.x + p * b.x, q * a.y + p * b.y, q * a.z + p * b.z}, p + q});
  }
  if (count != 2) return std::nullopt;
  return ends;
}

struct Signs {
  bool has_positive = false, has_negative = false;
  void add(int sign) {
    has_positive |= sign > 0;
    has_negative |= sign < 0;
  }
};

Signs signs_of(const std::vector<Integer>& values) {
  Signs signs;
  for (const Integer& value : values) signs.add(sgn(value));
  return signs;
}

// The part of an edge's line that runs through the inside of a surface whose plane contains it.
std::optional<LinePart3> part_inside(const Occluders3& occluders, const Occluders3::Edge& edge, EdgeId3 e,
                                     std::uint32_t s) {
  SignTier tier;
  if (occluders.side_of(edge.from, s, tier) != 0 || occluders.side_of(edge.to, s, tier) != 0) return std::nullopt;
  const IntegerVector across = cross(occluders.exact_normal(s), occluders.exact_vector(e));
  std::vector<Integer> values;
  for (const VertexId3 v : occluders.outline(s))
    values.push_back(dot(across, difference(occluders.vertices().exact(v), occluders.vertices().exact(edge.from))));
  const Signs signs = signs_of(values);
  if (!signs.has_positive || !signs.has_negative) return std::nullopt;
  auto ends = zero_line(occluders, s, values);
  if (!ends) return std::nullopt;
  return LinePart3{std::move((*ends)[0]), std::move((*ends)[1]), {s, true}, true};
}

}  // namespace

SurfaceStretches3::SurfaceStretches3(const Occluders3& occluders, const SurfaceBoxes3& boxes) {
  for (std::size_t s = 0; s < occluders.size(); ++s) normals_.push_back(occluders.exact_normal(s));
  add_outlines(occluders, boxes);
  for (auto& grounds : grounds_) grounds.resize(occluders.size());
  for (std::uint32_t s = 0; s < occluders.size(); ++s) add_grounds(occluders, boxes, s);
}

void SurfaceStretches3::add_outlines(const Occluders3& occluders, const SurfaceBoxes3& boxes) {
  const Vertices3& vertices = occluders.vertices();
  std::vector<LinePart3> parts;
  for (std::uint32_t s = 0; s < occluders.size(); ++s) {
    const auto corners = occluders.outline(s);
    for (std::size_t k = 0; k < corners.size(); ++k)
      parts.push_back(
          {{vertices.exact(corners[k]), 1}, {vertices.exact(corners[(k + 1) % corners.size()]), 1}, {s, true}, false});
  }
  std::vector<std::uint32_t> near;
  for (std::size_t e = 0; e < occluders.edge_count(); ++e) {
    const Occluders3::Edge& edge = occluders.edge(EdgeId3(e));
    Box3 box;
    box.include(vertices.approximate(edge.from));
    box.include(vertices.approximate(edge.to));
    near.clear();
    boxes.find(box, near);
    for (const std::uint32_t s : near)
      if (auto part = part_inside(occluders, edge, EdgeId3(e), s)) parts.push_back(std::move(*part));
  }
  outlines_ = atomic_stretches(parts, false, normals_);
  const auto place = [&vertices](const IntegerVector& numerator, const Integer& weight) {
    const Rational scale(1, weight);
    const auto of_one = [&](const Integer& value) {
      return to_double(scaled_by_power_of_two(scale * value, -vertices.shift()));
    };
    return Direction3{of_one(numerator.x), of_one(numerator.y), of_one(numerator.z)};
  };
  for (const AtomicStretch3& outline : outlines_) {
    const Stretch3& s = outline.stretch;
    const IntegerVector end{s.from.x + s.way.x, s.from.y + s.way.y, s.from.z + s.way.z};
    outline_ends_.push_back({place(s.from, s.weight), place(end, s.weight)});
  }
  outlines_of_.resize(occluders.size());
  for (std::uint32_t number = 0; number < outlines_.size(); ++number)
    for (const StretchFace3& face : outlines_[number].faces) outlines_of_[face.surface].push_back(number);
}

void SurfaceStretches3::add_grounds(const Occluders3& occluders, const SurfaceBoxes3& boxes, std::uint32_t s) {
  std::array<std::vector<LinePart3>, 2> parts;
  std::vector<std::uint32_t> near;
  boxes.find(boxes.of(s), near);
  std::vector<Integer> values;
  for (const std::uint32_t k : near) {
    if (k == s) continue;
    Signs signs;
    std::size_t zeros = 0;
    for (const VertexId3 v : occluders.outline(k)) {
      SignTier tier;
      const int sign = occluders.side_of(v, s, tier);
      signs.add(sign);
      zeros += sign == 0;
    }
    if (!(signs.has_positive && signs.has_negative) && zeros != 2) continue;
    values.clear();
    const IntegerVector& anchor = occluders.vertices().exact(occluders.outline(s).front());
    for (const VertexId3 v : occluders.outline(k))
      values.push_back(dot(normals_[s], difference(occluders.vertices().exact(v), anchor)));
    const auto ends = zero_line(occluders, k, values);
    if (!ends) continue;
    const IntegerVector way = stretch_between((*ends)[0], (*ends)[1]).way;
    const bool is_forward = sgn(dot(normals_[s], cross(normals_[k], way))) > 0;
    if (signs.has_positive) parts[0].push_back({(*ends)[0], (*ends)[1], {k, is_forward}, false});
    if (signs.has_negative) parts[1].push_back({(*ends)[0], (*ends)[1], {k, !is_forward}, false});
  }
  for (int side = 0; side < 2; ++side) grounds_[side][s] = atomic_stretches(parts[side], true, normals_);
}

}  // namespace hottel
