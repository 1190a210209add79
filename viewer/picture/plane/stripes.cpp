#include "viewer/picture/plane/stripes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/plain_functions.h"

namespace hottel {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr double kSameDirection = 1e-7;
constexpr double kFarthestMitre = 1.2;

}  // namespace

Stripes2::Stripes2(const Corners2& corners, std::vector<bool> is_striped, double thickness)
    : corners_(corners), is_striped_(std::move(is_striped)), thickness_(thickness) {
  first_ray_.assign(corners.at.size() + 1, 0);
  for (std::uint32_t s = 0; s < corners.surfaces(); ++s) {
    ++first_ray_[corners.from[s] + 1];
    ++first_ray_[corners.to[s] + 1];
  }
  for (std::size_t v = 1; v < first_ray_.size(); ++v) first_ray_[v] += first_ray_[v - 1];
  rays_.resize(2 * corners.surfaces());
  std::vector<std::uint32_t> next = first_ray_;
  for (std::uint32_t s = 0; s < corners.surfaces(); ++s) {
    const Pixel a = corners.at[corners.from[s]], b = corners.at[corners.to[s]];
    rays_[next[corners.from[s]]++] = {same_bits::atan2(b.y - a.y, b.x - a.x), s, true};
    rays_[next[corners.to[s]]++] = {same_bits::atan2(a.y - b.y, a.x - b.x), s, false};
  }
  for (std::size_t v = 0; v + 1 < first_ray_.size(); ++v)
    std::sort(rays_.begin() + first_ray_[v], rays_.begin() + first_ray_[v + 1],
              [](const Ray& a, const Ray& b) { return a.angle < b.angle; });
  ray_of_.resize(rays_.size());
  for (std::uint32_t k = 0; k < rays_.size(); ++k) ray_of_[2 * rays_[k].edge + (rays_[k].leaves ? 0 : 1)] = k;
}

// Whether one meets a stripe when turning towards the ray. turn: +1 for growing angles.
bool Stripes2::striped(const Ray& ray, int turn) const {
  // Seen from its corner the right side of an edge that leaves lies at growing angles (y is downwards), so whoever
  // comes with shrinking angles meets it.
  return ray.leaves == (turn < 0) && is_striped_[ray.edge];
}

double Stripes2::shortening(std::uint32_t edge, bool at_from) const {
  const std::uint32_t corner = at_from ? corners_.from[edge] : corners_.to[edge];
  const std::ptrdiff_t begin = first_ray_[corner], count = first_ray_[corner + 1] - begin;
  const std::ptrdiff_t self = ray_of_[2 * edge + (at_from ? 0 : 1)];
  const int turn = at_from ? 1 : -1;
  double wedge = 0;  // to the next edge of another direction; 0: there is none
  bool meets_stripe = false;
  for (std::ptrdiff_t step = 1; step < count; ++step) {
    const Ray& ray = rays_[static_cast<std::size_t>(begin + (self - begin + turn * step + count) % count)];
    double angle = turn * (ray.angle - rays_[static_cast<std::size_t>(self)].angle);
    if (angle < 0) angle += kFullTurn;
    if (angle < kSameDirection || angle > kFullTurn - kSameDirection) continue;  // the same wall, listed twice
    // Several edges may leave in the next direction; one stripe on this side is enough.
    if (wedge != 0 && angle - wedge > kSameDirection) break;
    if (wedge == 0) wedge = angle;
    meets_stripe |= striped(ray, turn);
  }
  if (meets_stripe) return std::max(thickness_ / same_bits::tan(wedge / 2), -kFarthestMitre * thickness_);
  return wedge > 0 && wedge < std::numbers::pi / 2 ? thickness_ / same_bits::tan(wedge) : 0;
}

std::array<Pixel, 4> Stripes2::stripe(std::uint32_t edge) const {
  const Pixel a = corners_.at[corners_.from[edge]], b = corners_.at[corners_.to[edge]];
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (length == 0) return {a, b, b, a};
  const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
  const double nx = -uy, ny = ux;  // right of from -> to, with y downwards
  double depth = thickness_, at_from = shortening(edge, true), at_to = shortening(edge, false);
  if (at_from + at_to > length) {  // the mitres meet before the full depth
    const double share = length / (at_from + at_to);
    depth *= share;
    at_from *= share;
    at_to *= share;
  }
  return {a, b, Pixel{b.x - ux * at_to + nx * depth, b.y - uy * at_to + ny * depth},
          Pixel{a.x + ux * at_from + nx * depth, a.y + uy * at_from + ny * depth}};
}

}  // namespace hottel
