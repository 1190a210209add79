// Programs of others, simulated: small solvers with known mistakes, which share no code with what recognises them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace hottel {

using Place = std::array<double, 3>;

// A straight edge (two corners, its front on the right) or a plane convex polygon (counter-clockwise from its front).
struct SimulatedFace {
  std::vector<Place> corners;
  Place normal, centre;
  double area;
};

// Random rooms with a few bodies in them, or bodies on a ground under the sky; in doubles of few digits, so that a file
// says the same.
class SimulatedScene {
 public:
  SimulatedScene(int dimension, std::uint64_t seed);

  int dimension() const { return dimension_; }
  std::size_t size() const { return faces_.size(); }
  const SimulatedFace& face(std::size_t i) const { return faces_[i]; }
  std::string json() const;

  // cos cos' / (pi r^2), in the plane cos cos' / (2 r).
  double kernel(const Place& x, const Place& x_normal, const Place& y, const Place& y_normal) const;
  // Nothing stands between two points, of faces i and j.
  bool see_each_other(const Place& x, const Place& y, std::size_t i, std::size_t j) const;
  // The face that is met first from a point of face i; size() where it is the sky.
  std::size_t first_hit(const Place& x, const Place& way, std::size_t i) const;

 private:
  void add(std::vector<Place> corners);
  // Corners counter-clockwise from outside, or from above.
  void add_body(const std::vector<Place>& outline, double low, double high);
  void add_wall(const Place& origin, const Place& u, const Place& v, int nu, int nv);
  double distance_along(const Place& x, const Place& way, std::size_t face) const;

  int dimension_;
  std::vector<SimulatedFace> faces_;
};

// A matrix with the sky as the last column.
using Numbers = std::vector<std::vector<double>>;

// Points by which a face is measured, with weights that sum to 1.
struct WeightedPlace {
  Place at;
  double weight;
};
enum class PointsOf { kCenter, kCorners, kGauss2, kGauss3 };
std::vector<WeightedPlace> points_of(const SimulatedScene& scene, std::size_t face, PointsOf kind);

// A_j times the mean of the kernel over all pairs of points of i and j; nothing hides anything.
double mean_factor(const SimulatedScene& scene, std::size_t i, std::size_t j, PointsOf kind);
// From a centre to a disk of the same area.
double disk_factor(const SimulatedScene& scene, std::size_t i, std::size_t j);

// What rays from each face count: by a density over the sphere (the plane's: half circle), from places at random or in
// strata. way(u, v): the cosine to the normal and the angle about it, from two numbers in (0, 1).
struct CountedRays {
  int count = 1000;
  bool is_uniform = false;  // evenly over directions, not by the cosine
  bool is_stratified = false;
  std::uint64_t seed = 1;
};
Numbers counted(const SimulatedScene& scene, const CountedRays& rays);

}  // namespace hottel
