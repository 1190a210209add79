// Plain loops over lanes: the compiler makes vectors of them, and none of the results depends on that.
//
// A unit vector along b + d, |d| <= off, is no further than off / |b|, times a little more than 1, from that along b.
// So with unit vectors b, e and n, each off by that much, the point (x, y) = (n . (b x e), b . e), which is on the unit
// circle, is off by what b and e are together: b x e is along n, so what n is off counts by its square alone.
//
// The angle of (x + dx, y + dy) is off by dx y - dy x, as a sine. The product n . (b x w), w = e - b, is rounded by no
// more than 3.5 |w| + 9 |x| units, the length of n included, and b . e by 3: little where b and e are close.
#include "geometry/space/proven/node_lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/space/pieces/arc_angle.h"
#include "kernel/support/each_processor.h"

namespace hottel {
namespace {

using namespace ball_arithmetic_3;

using Lanes = std::array<double, kNodeLanes3>;

// Unit vectors, and how far off they are; of normals also their products with the moment.
struct DirectionLanes {
  Lanes x, y, z, off;
  Lanes moment, moment_off;
};
struct SumLanes {
  Lanes value{}, off{}, size{}, doubt{};  // doubt: positive where an angle may be half a turn either way
};

// Unit vectors that are further off tell no angle. What is off by less counts so much more than by itself.
constexpr double kMostOff = 0x1p-10, kMore = 1 + 0x1p-9;
// What components of unit vectors, sums of products of them, and products with the moment are rounded.
constexpr double kOfUnits = 2 * kUnit, kOfSine = 20 * kUnit, kOfMoments = 10 * kUnit;
// All that is known of an angle.
constexpr double kAnyAngle = 7;

}  // namespace

HOTTEL_FOR_EACH_PROCESSOR
static void set_directions(const PartVector3& vector, const Lanes& at, DirectionLanes& to) {
  const auto& [v, w, z] = vector.power;
  const auto [off, more_off, most_off] = vector.off_at_nodes();
  for (std::size_t k = 0; k < kNodeLanes3; ++k) {
    const double s = at[k];
    const double a = v.x + s * (w.x + s * z.x), b = v.y + s * (w.y + s * z.y), c = v.z + s * (w.z + s * z.z);
    const double scale = 1 / std::sqrt(a * a + b * b + c * c);
    to.x[k] = scale * a;
    to.y[k] = scale * b;
    to.z[k] = scale * c;
    to.off[k] = kMore * scale * (off + std::fabs(s) * (more_off + std::fabs(s) * most_off));
  }
}

HOTTEL_FOR_EACH_PROCESSOR
static void set_moments(const LocalVector3<double>& m, double m_off, double m_size, DirectionLanes& of) {
  for (std::size_t k = 0; k < kNodeLanes3; ++k) {
    of.moment[k] = m.x * of.x[k] + m.y * of.y[k] + m.z * of.z[k];
    of.moment_off[k] = m_off * kMore + m_size * ((of.off[k] < 2 ? of.off[k] : 2.0) + kOfMoments);
  }
}

HOTTEL_FOR_EACH_PROCESSOR
static void add_arc(double half, int turn, const DirectionLanes& b, const DirectionLanes& e, const DirectionLanes& n,
                    SumLanes& __restrict sum) {
  const double most = std::fabs(half), asks = turn == 0 ? 1 : 0;
  for (std::size_t k = 0; k < kNodeLanes3; ++k) {
    const double bx = b.x[k], by = b.y[k], bz = b.z[k], ex = e.x[k], ey = e.y[k], ez = e.z[k];
    const double x = ex - bx, y = ey - by, z = ez - bz;
    const double sine = n.x[k] * (by * z - bz * y) + n.y[k] * (bz * x - bx * z) + n.z[k] * (bx * y - by * x);
    const double cosine = bx * ex + by * ey + bz * ez;
    const double n_off = n.off[k], both = b.off[k] + e.off[k];
    const double products = std::fabs(cosine) * (3.5 * std::sqrt(x * x + y * y + z * z) + 9 * std::fabs(sine));
    const double off = both + n_off * n_off + kOfUnits + kUnit * (products + 3 * std::fabs(sine));
    const double doubt = cosine < 0 ? asks * (kMore * off + kOfSine - std::fabs(sine)) : 0.0;
    const double angle = arc_angle(sine, cosine, turn);
    const double angle_off = both + n_off < kMostOff ? kMore * off + 0x1p-51 * std::fabs(angle) : kAnyAngle;
    const double moment = n.moment[k], moment_off = n.moment_off[k];
    const double term = half * (moment * angle);
    sum.value[k] += term;
    sum.size[k] += std::fabs(term);
    sum.off[k] += most * (std::fabs(moment) * angle_off + moment_off * (std::fabs(angle) + angle_off));
    sum.doubt[k] = doubt > sum.doubt[k] ? doubt : sum.doubt[k];
  }
}

namespace {

// The true nodes k and n - 1 - k sum up to 1: so no digit is lost.
double x_of_node(const LegendreRule<double>& rule, std::size_t k) {
  const double node = rule.node[k];
  return node < 0.5 ? 1 - 2 * rule.node[rule.node.size() - 1 - k] : 2 * node - 1;
}

SumLanes sums_at(const PartArcs3& part, std::span<const signed char> turns, const Lanes& at) {
  thread_local std::vector<DirectionLanes> corners, normals;
  corners.resize(part.corners.size());
  normals.resize(part.planes.size());
  for (std::size_t k = 0; k < corners.size(); ++k) set_directions(part.corners[k], at, corners[k]);
  for (std::size_t k = 0; k < normals.size(); ++k) {
    set_directions(part.planes[k], at, normals[k]);
    set_moments(part.moment, part.moment_off, part.moment_size, normals[k]);
  }
  SumLanes sums;
  for (std::size_t k = 0; k < part.arcs.size(); ++k) {
    const SeenArc3& arc = part.arcs[k];
    add_arc(arc.count / 2, turns[k], corners[arc.begin], corners[arc.end], normals[arc.plane], sums);
  }
  return sums;
}

}  // namespace

std::optional<Ball3<double>> mean_at_nodes_3(const PartArcs3& part, std::span<const signed char> turns,
                                             const LegendreRule<double>& rule) {
  const auto count = static_cast<std::size_t>(rule.size());
  double mean = 0, off = 0, size = 0;
  for (std::size_t first = 0; first < count; first += kNodeLanes3) {
    const std::size_t end = std::min(count, first + kNodeLanes3);
    Lanes at;
    for (std::size_t k = 0; k < kNodeLanes3; ++k) at[k] = x_of_node(rule, std::min(first + k, end - 1));
    const SumLanes sum = sums_at(part, turns, at);
    if (std::ranges::any_of(sum.doubt, [](double doubt) { return doubt > 0; })) return {};
    for (std::size_t k = first; k < end; ++k) {
      mean += rule.weight[k] * sum.value[k - first];
      off += rule.weight[k] * sum.off[k - first];
      size += rule.weight[k] * sum.size[k - first];
    }
  }
  const double roundings = static_cast<double>(count + part.arcs.size() + 8);
  return Ball3<double>{mean, up(up(off) + roundings * kUnit * size)};
}

}  // namespace hottel
