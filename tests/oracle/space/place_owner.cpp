#include "tests/oracle/space/place_owner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

namespace hottel::oracle {

namespace {

constexpr double kStep = 1e-5, kNear = 1e-3;

void set(double (&to)[3], const SpacePoint& p) {
  to[0] = p.x.get_d();
  to[1] = p.y.get_d();
  to[2] = p.z.get_d();
}

double product(const double (&a)[3], const double (&b)[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

const mpq_class& coordinate(const SpacePoint& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

double distance_to_segment(const double (&p)[3], const double (&a)[3], const double (&b)[3]) {
  double way[3], to[3];
  for (int k = 0; k < 3; ++k) {
    way[k] = b[k] - a[k];
    to[k] = p[k] - a[k];
  }
  const double t = std::clamp(product(way, to) / product(way, way), 0.0, 1.0);
  for (int k = 0; k < 3; ++k) to[k] -= t * way[k];
  return std::sqrt(product(to, to));
}

}  // namespace

SpacePoint normal_of_loop(const SpacePolygon& loop) {
  SpacePoint sum{0, 0, 0};
  for (std::size_t k = 2; k < loop.size(); ++k) {
    const SpacePoint part = cross(loop[k - 1] - loop[0], loop[k] - loop[0]);
    sum = {sum.x + part.x, sum.y + part.y, sum.z + part.z};
  }
  return sum;
}

bool is_inside_loops(const std::vector<SpacePolygon>& loops, const SpacePoint& point) {
  const SpacePoint normal = normal_of_loop(loops[0]);
  const int dropped = normal.x != 0 ? 0 : normal.y != 0 ? 1 : 2;
  const int u = dropped == 0 ? 1 : 0, v = dropped == 2 ? 1 : 2;
  const mpq_class &pu = coordinate(point, u), &pv = coordinate(point, v);
  bool is_inside = false;
  for (const SpacePolygon& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const SpacePoint &a = loop[k], &b = loop[(k + 1) % loop.size()];
      const mpq_class &av = coordinate(a, v), &bv = coordinate(b, v);
      if ((av > pv) == (bv > pv)) continue;
      const mpq_class at = coordinate(a, u) + (pv - av) / (bv - av) * (coordinate(b, u) - coordinate(a, u));
      if (at > pu) is_inside = !is_inside;
    }
  return is_inside;
}

Places::Places(std::vector<PlaceFace> faces, std::vector<PlaceBody> bodies)
    : faces_(std::move(faces)), bodies_(std::move(bodies)), triangles_(bodies_.size()), rooms_(bodies_.size()) {
  for (const PlaceFace& face : faces_) {
    normals_.push_back(normal_of_loop(face.loops[0]));
    for (const SpacePolygon& loop : face.loops) {
      const bool is_turned = &loop != &face.loops[0] && dot(normal_of_loop(loop), normals_.back()) > 0;
      for (std::size_t k = 2; k < loop.size(); ++k) {
        Triangle& triangle = triangles_[face.body].emplace_back();
        set(triangle.a, loop[0]);
        set(triangle.b, loop[is_turned ? k : k - 1]);
        set(triangle.c, loop[is_turned ? k - 1 : k]);
      }
    }
  }
  for (std::size_t solid = 0; solid < bodies_.size(); ++solid)
    for (std::size_t room = 0; room < bodies_.size(); ++room)
      if (bodies_[solid] == PlaceBody::kSolid && bodies_[room] == PlaceBody::kRoom && lies_in(room, solid))
        rooms_[solid].push_back(room);
}

double Places::winding(std::size_t body, const double (&at)[3]) const {
  double sum = 0;
  for (const Triangle& t : triangles_[body]) {
    double a[3], b[3], c[3];
    for (int k = 0; k < 3; ++k) {
      a[k] = t.a[k] - at[k];
      b[k] = t.b[k] - at[k];
      c[k] = t.c[k] - at[k];
    }
    const double cross_bc[3] = {b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]};
    const double la = std::sqrt(product(a, a)), lb = std::sqrt(product(b, b)), lc = std::sqrt(product(c, c));
    sum += 2 * std::atan2(product(a, cross_bc),
                          la * lb * lc + product(a, b) * lc + product(a, c) * lb + product(b, c) * la);
  }
  return sum / (4 * std::acos(-1.0));
}

// Looked at near the eight corners of each unit cell of the room: REQUIRES that all its faces are of the lattice.
bool Places::lies_in(std::size_t room, std::size_t solid) const {
  double low[3] = {1e9, 1e9, 1e9}, high[3] = {-1e9, -1e9, -1e9};
  for (const Triangle& t : triangles_[room])
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min({low[k], t.a[k], t.b[k], t.c[k]});
      high[k] = std::max({high[k], t.a[k], t.b[k], t.c[k]});
    }
  for (double x = low[0]; x < high[0]; ++x)
    for (double y = low[1]; y < high[1]; ++y)
      for (double z = low[2]; z < high[2]; ++z) {
        const double centre[3] = {x + 0.5, y + 0.5, z + 0.5};
        if (winding(room, centre) > -0.5) continue;
        for (int corner = 0; corner < 8; ++corner) {
          const double at[3] = {x + ((corner & 1) != 0 ? 1 - kNear : kNear),
                                y + ((corner & 2) != 0 ? 1 - kNear : kNear),
                                z + ((corner & 4) != 0 ? 1 - kNear : kNear)};
          if (winding(solid, at) < 0.5) return false;
        }
      }
  return true;
}

bool Places::is_in(std::size_t body, const double (&at)[3]) const {
  return bodies_[body] == PlaceBody::kSolid && winding(body, at) > 0.5 &&
         std::none_of(rooms_[body].begin(), rooms_[body].end(),
                      [&](std::size_t room) { return winding(room, at) < -0.5; });
}

bool Places::is_coplanar(std::size_t face, std::size_t other) const {
  const SpacePoint zero{0, 0, 0};
  return cross(normals_[face], normals_[other]) == zero &&
         dot(normals_[face], faces_[other].loops[0][0] - faces_[face].loops[0][0]) == 0;
}

bool Places::is_clear(std::size_t face, const SpacePoint& point) const {
  if (!is_inside_loops(faces_[face].loops, point)) return false;
  double at[3];
  set(at, point);
  for (std::size_t other = 0; other < faces_.size(); ++other) {
    if (!is_coplanar(face, other)) {
      double normal[3];
      set(normal, normals_[other]);
      const double height = dot(normals_[other], point - faces_[other].loops[0][0]).get_d();
      if (std::abs(height) < kNear * std::sqrt(product(normal, normal))) return false;
      continue;
    }
    for (const SpacePolygon& loop : faces_[other].loops)
      for (std::size_t k = 0; k < loop.size(); ++k) {
        double a[3], b[3];
        set(a, loop[k]);
        set(b, loop[(k + 1) % loop.size()]);
        if (distance_to_segment(at, a, b) < kNear) return false;
      }
  }
  return true;
}

Places::Side Places::side(std::size_t face, const SpacePoint& point, bool is_back) const {
  double at[3], normal[3];
  const auto solids_beside = [&](bool back) {
    set(at, point);
    set(normal, normals_[face]);
    const double step = (back ? -kStep : kStep) / std::sqrt(product(normal, normal));
    for (int k = 0; k < 3; ++k) at[k] += step * normal[k];
    std::vector<bool> is_in_body;
    for (std::size_t body = 0; body < bodies_.size(); ++body) is_in_body.push_back(is_in(body, at));
    return is_in_body;
  };
  Side result;
  const std::vector<bool> here_in = solids_beside(is_back), beyond_in = solids_beside(!is_back);
  result.is_covered = std::find(here_in.begin(), here_in.end(), true) != here_in.end();
  if (result.is_covered) return result;
  // Faces at the point, and whether the side that is asked for is their back.
  std::vector<std::pair<std::size_t, bool>> here;
  bool has_covered_material = false;
  for (std::size_t other = 0; other < faces_.size(); ++other) {
    if (!is_coplanar(face, other) || !is_inside_loops(faces_[other].loops, point)) continue;
    const bool back_here = is_back == (dot(normals_[face], normals_[other]) > 0);
    here.emplace_back(other, back_here);
    has_covered_material = has_covered_material || back_here || faces_[other].back.has_value();
  }
  bool has_owner = false, has_claim = false;
  int material = 0;
  for (const auto& [other, back_here] : here) {
    if (!back_here && has_covered_material && beyond_in[faces_[other].body])
      continue;  // what lies on a solid and looks into it silences its front
    const std::optional<int> claim = back_here ? faces_[other].back : std::optional(faces_[other].front);
    if (!claim && has_owner) continue;
    if (claim && has_claim) {
      result.is_disputed = result.is_disputed || *claim != material;
      continue;
    }
    result.owner = 2 * other + (back_here ? 1 : 0);
    has_owner = true;
    if (claim) {
      has_claim = true;
      material = *claim;
    }
  }
  return result;
}

Places::Place Places::place(std::size_t face, const SpacePoint& point) const {
  return {point, side(face, point, false), side(face, point, true)};
}

std::vector<SpacePoint> Places::points(std::size_t face, unsigned long number, int tries) const {
  constexpr long kParts = 1'000'003;
  std::mt19937_64 random(number * 1009 + face);
  const auto part = [&random]() -> mpq_class { return mpq_class(static_cast<long>(random() % kParts)) / kParts; };
  const SpacePolygon& loop = faces_[face].loops[0];
  std::vector<SpacePoint> result;
  for (int k = 0; k < tries; ++k) {
    const std::size_t n = loop.size(), first = random() % n;
    const SpacePoint &a = loop[first], b = loop[(first + 1) % n] - a,
                     c = loop[(first + 2 + random() % (n - 2)) % n] - a;
    mpq_class s = part(), t = part();
    if (s + t > 1) {
      s = 1 - s;
      t = 1 - t;
    }
    SpacePoint point{a.x + s * b.x + t * c.x, a.y + s * b.y + t * c.y, a.z + s * b.z + t * c.z};
    if (is_clear(face, point)) result.push_back(std::move(point));
  }
  return result;
}

}  // namespace hottel::oracle
