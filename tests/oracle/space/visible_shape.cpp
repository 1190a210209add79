#include "tests/oracle/space/visible_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace hottel::oracle {
namespace {

constexpr double kNear = 1e-8;  // how far from a corner it is looked around

// Two directions in a plane, square to each other.
std::pair<Vector, Vector> frame_of(const Vector& normal) {
  const Vector other = std::abs(normal.x) < 0.5 ? Vector{1, 0, 0} : Vector{0, 1, 0};
  Vector u = cross(normal, other);
  u = (1 / length(u)) * u;
  return {u, cross(normal, u)};
}

bool is_inside(const FlatPolygon& polygon, const Vector& normal, const Vector& place) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector& from = polygon[k];
    if (dot(cross(polygon[(k + 1) % polygon.size()] - from, place - from), normal) <= 0) return false;
  }
  return true;
}

// Where the line from the eye through a place meets a plane beyond the eye.
std::optional<Vector> on_plane(const FlatPlane& plane, const Vector& eye, const Vector& place) {
  const double above = plane.height(eye), rise = plane.height(place) - above;
  if (rise == 0 || -above / rise <= 0) return std::nullopt;
  return eye + (-above / rise) * (place - eye);
}

}  // namespace

VisibleShape::VisibleShape(FlatPolygon target, std::vector<FlatPolygon> between)
    : target_(std::move(target)), between_(std::move(between)), plane_(target_) {
  add(target_);
  for (const FlatPolygon& polygon : between_) add(polygon);
}

int VisibleShape::vertex_of(const Vector& place) {
  for (std::size_t k = 0; k < vertices_.size(); ++k)
    if (length(vertices_[k] - place) == 0) return static_cast<int>(k);
  vertices_.push_back(place);
  return static_cast<int>(vertices_.size()) - 1;
}

void VisibleShape::add(const FlatPolygon& polygon) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const int a = vertex_of(polygon[k]), b = vertex_of(polygon[(k + 1) % polygon.size()]);
    const Edge edge{std::min(a, b), std::max(a, b)};
    const auto is_same = [&edge](const Edge& other) { return other.from == edge.from && other.to == edge.to; };
    if (std::ranges::none_of(edges_, is_same)) edges_.push_back(edge);
  }
}

bool VisibleShape::is_visible(const Vector& eye, const Vector& place) const {
  if (!is_inside(target_, plane_.normal, place)) return false;
  return std::ranges::none_of(between_, [&](const FlatPolygon& polygon) {
    const FlatPlane plane(polygon);
    const double at_eye = plane.height(eye), there = plane.height(place);
    if ((at_eye > 0) == (there > 0)) return false;
    return is_inside(polygon, plane.normal, eye + (at_eye / (at_eye - there)) * (place - eye));
  });
}

bool VisibleShape::is_corner(const Vector& eye, const Vector& place, const std::vector<Vector>& ways) const {
  const auto [u, v] = frame_of(plane_.normal);
  std::vector<double> angles;
  for (const Vector& way : ways) angles.push_back(std::atan2(dot(way, v), dot(way, u)));
  std::ranges::sort(angles);
  double visible = 0;  // the angle in all
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double end = k + 1 < angles.size() ? angles[k + 1] : angles[0] + 2 * std::numbers::pi;
    const double middle = (angles[k] + end) / 2;
    if (is_visible(eye, place + kNear * (std::cos(middle) * u + std::sin(middle) * v))) visible += end - angles[k];
  }
  const auto is_about = [visible](double angle) { return std::abs(visible - angle) < 1e-9; };
  return !is_about(0) && !is_about(std::numbers::pi) && !is_about(2 * std::numbers::pi);
}

std::set<VisibleShape::Corner> VisibleShape::seen_from(const Vector& eye) const {
  std::vector<std::optional<Vector>> places;
  for (const Vector& vertex : vertices_) places.push_back(on_plane(plane_, eye, vertex));
  std::set<Corner> corners;
  for (std::size_t k = 0; k < vertices_.size(); ++k) {
    if (!places[k]) continue;
    std::vector<Vector> ways;
    for (const Edge& edge : edges_) {
      const int other = edge.from == static_cast<int>(k) ? edge.to : edge.to == static_cast<int>(k) ? edge.from : -1;
      if (other >= 0 && places[static_cast<std::size_t>(other)])
        ways.push_back(*places[static_cast<std::size_t>(other)] - *places[k]);
    }
    if (is_corner(eye, *places[k], ways)) corners.insert({-1, static_cast<int>(k)});
  }
  for (std::size_t i = 0; i < edges_.size(); ++i)
    for (std::size_t j = i + 1; j < edges_.size(); ++j) {
      const auto place_of = [&places](int vertex) { return places[static_cast<std::size_t>(vertex)]; };
      const auto a = place_of(edges_[i].from), b = place_of(edges_[i].to), c = place_of(edges_[j].from),
                 d = place_of(edges_[j].to);
      if (!a || !b || !c || !d || edges_[i].from == edges_[j].from || edges_[i].to == edges_[j].to ||
          edges_[i].from == edges_[j].to || edges_[i].to == edges_[j].from)
        continue;
      const double across = dot(cross(*b - *a, *d - *c), plane_.normal);
      if (std::abs(across) < 1e-12) continue;
      const double s = dot(cross(*c - *a, *d - *c), plane_.normal) / across;
      const double t = dot(cross(*c - *a, *b - *a), plane_.normal) / across;
      if (s <= 0 || s >= 1 || t <= 0 || t >= 1) continue;
      const Vector along = *b - *a, other = *d - *c;
      if (is_corner(eye, *a + s * along, {along, -1 * along, other, -1 * other}))
        corners.insert({static_cast<int>(i), static_cast<int>(j)});
    }
  return corners;
}

}  // namespace hottel::oracle
