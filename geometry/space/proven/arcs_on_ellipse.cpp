#include "geometry/space/proven/arcs_on_ellipse.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/space/pieces/arc_angle.h"

namespace hottel {
namespace {

using namespace ball_arithmetic_3;

// From a right angle one way to a right angle the other way it is more than that.
constexpr double kAround = 3.1;
// Sums and products of unit vectors are rounded less than this, in units.
constexpr double kOfProducts = 32 * kUnit;
// Vectors that are further off than this part of their lengths tell no angle.
constexpr double kMostOff = 0x1p-10;

}  // namespace

void ArcsOnEllipse3::set(const PartArcs3& part) {
  part_ = part;
  planes_.clear();
  corners_.clear();
  middles_.clear();
  for (const PartVector3& plane : part.planes) planes_.emplace_back(plane);
  for (const PartVector3& corner : part.corners) corners_.emplace_back(corner);
  for (const SeenArc3& arc : part.arcs) middles_.push_back(middle(arc));
  half_axis_ = 0;
  reach_ = kNothingKnown;
  for (const auto* vectors : {&planes_, &corners_})
    for (const VectorOnEllipse3& vector : *vectors) reach_ = std::min(reach_, vector.reach());
}

// (X, Y) / R is off by what b and e are together, and n by its square.
ArcsOnEllipse3::Middle ArcsOnEllipse3::middle(const SeenArc3& arc) const {
  const PartVector3 &b = part_.corners[arc.begin], &e = part_.corners[arc.end], &n = part_.planes[arc.plane];
  const double both = b.size[0] * e.size[0];
  const double sine = dot(n.power[0], cross(b.power[0], e.power[0])) / (n.size[0] * both);
  const double cosine = dot(b.power[0], e.power[0]) / both;
  const double off = 2 * (b.error[0] / b.size[0] + e.error[0] / e.size[0] + n.error[0] / n.size[0]) + kOfProducts;
  const bool is_sure = off < kMostOff && (cosine > off || std::fabs(sine) > off);
  if (!is_sure) return {std::numbers::pi, 0};
  const double angle = angle_of(sine, cosine);
  return {std::min(std::fabs(angle) + 2 * off, std::numbers::pi), cosine > off ? 0 : sine > 0 ? 1 : -1};
}

void ArcsOnEllipse3::set_bounds(double half_axis) {
  if (half_axis == half_axis_) return;
  half_axis_ = half_axis;
  normals_.clear();
  turns_.clear();
  const auto over_square = [](const VectorOnEllipse3::Bounds& bounds) {
    return bounds.least_square > 0 ? 1 / bounds.least_square : kNothingKnown;
  };
  for (std::size_t k = 0; k < planes_.size(); ++k) {
    const VectorOnEllipse3::Bounds bounds = planes_[k].within(half_axis);
    const auto& [v, w, z] = part_.planes[k].power;
    const double product = std::fabs(dot(part_.moment, v)) +
                           half_axis * (std::fabs(dot(part_.moment, w)) + half_axis * std::fabs(dot(part_.moment, z)));
    const double off = part_.moment_size * (bounds.off + 8 * kUnit * bounds.most) + part_.moment_off * bounds.most;
    const double over = std::sqrt(over_square(bounds));
    normals_.push_back({up((product + off) * over), up(bounds.most * over)});
  }
  for (const VectorOnEllipse3& corner : corners_) {
    const VectorOnEllipse3::Bounds bounds = corner.within(half_axis);
    turns_.push_back(up(bounds.turn * over_square(bounds)));
  }
}

double ArcsOnEllipse3::speed(const SeenArc3& arc) const {
  return up(normals_[arc.plane].excess * (turns_[arc.begin] + turns_[arc.end]));
}

double ArcsOnEllipse3::largest(double half_axis) {
  set_bounds(half_axis);
  double sum = 0;
  for (std::size_t k = 0; k < part_.arcs.size(); ++k) {
    const SeenArc3& arc = part_.arcs[k];
    sum += std::fabs(arc.count / 2) * normals_[arc.plane].moment * (middles_[k].most + half_axis * speed(arc));
  }
  return sum < kNothingKnown ? up(sum) : kNothingKnown;
}

void ArcsOnEllipse3::find_turns(double half_axis, std::vector<signed char>& turns) {
  set_bounds(half_axis);
  turns.clear();
  for (std::size_t k = 0; k < part_.arcs.size(); ++k)
    turns.push_back(static_cast<signed char>(speed(part_.arcs[k]) < kAround ? middles_[k].sign : 0));
}

}  // namespace hottel
