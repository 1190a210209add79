#include "geometry/space/between/known_patch.h"

#include <algorithm>
#include <cmath>

#include "geometry/space/arrangement/short_integers.h"
#include "kernel/determinant.h"

namespace hottel {
namespace {

Box3 box_of(const Vertices3& vertices, const Patch3& patch) {
  Box3 box;
  for (const IntegerVector& corner : patch.corners) {
    const auto place = [&](const Integer& value) { return rounded_quotient(value, patch.weight, vertices.shift()); };
    BoundedVector p{place(corner.x), place(corner.y), place(corner.z)};
    p.size = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    p.error = 0x1p-50 * p.size;
    box.include(p);
  }
  return box;
}

VertexId3 vertex_at(const Occluders3& occluders, const Patch3& patch, const IntegerVector& corner) {
  VertexId3 same = VertexId3::none();
  if (!patch.is_sky())
    for (const VertexId3 v : occluders.outline(patch.surface))
      if (is_at_vertex_3(corner, patch.weight, occluders.vertices().exact(v))) same = v;
  return same;
}

}  // namespace

KnownPatch3::KnownPatch3(const Occluders3& occluders, const Patch3& its)
    : patch(&its),
      spare(std::max(0L, static_cast<long>(mpz_sizeinbase(its.weight.get_mpz_t(), 2)) - 53)),
      weight(rounded_quotient(its.weight, 1, spare)) {
  for (const IntegerVector& corner : its.corners) {
    bits = std::max(bits, hottel::bits(corner) - spare);
    approximate.push_back(rounded(corner, 0));
  }
  if (its.is_far()) return;
  for (const IntegerVector& corner : its.corners) vertices.push_back(vertex_at(occluders, its, corner));
  normal = primitive(normal_of(its));
  rounded_normal = rounded(normal, std::max(0L, hottel::bits(normal) - 53));
  if (!its.is_sky()) turn = dot_sign(normal, occluders.exact_normal(its.surface));
  box = box_of(occluders.vertices(), its);
}

}  // namespace hottel
