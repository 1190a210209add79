// Radiosities to a hundred digits, from closed forms of the factors: what bounds are held against.
#pragma once

#include <gmpxx.h>

#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/radiosity/radiosity.h"

namespace hottel::testing_radiosity {

inline constexpr unsigned kBits = 384;

mpf_class number(const Rational& q);
mpf_class number(const RootSum& sum);

// The rows of A^-1 B from those of [A B], A square. REQUIRES that the diagonal of A dominates: no pivots are sought.
std::vector<std::vector<mpf_class>> solve_dense(std::vector<std::vector<mpf_class>> rows);

// Factors to kBits: [from][to], the sky last.
using WideFactors = std::vector<std::vector<mpf_class>>;

// Radiosities by element for factors of the rows of this matrix, by Gaussian elimination. REQUIRES a solution.
std::vector<mpf_class> radiosity_of(const ExchangeMatrix& matrix, const WideFactors& factors,
                                    const std::vector<Material>& materials, const Spectrum& sky, int channel);

// A scene, its exact factors rounded, and the same factors to kBits.
class ExactScene {
 public:
  explicit ExactScene(Scene2 scene, Divided2 divided = Divided2::kNo);

  const Scene2& scene() const { return prepared_.scene; }
  const ExchangeMatrix& matrix() const { return matrix_; }
  const WideFactors& factors() const { return factors_; }
  const std::vector<mpf_class>& areas() const { return areas_; }

  std::vector<mpf_class> radiosity(const std::vector<Material>& materials, const Spectrum& sky, int channel) const {
    return radiosity_of(matrix_, factors_, materials, sky, channel);
  }

  RadiositySolution solve(const std::vector<Material>& materials, RadiosityOptions options = {}) const {
    return solve_radiosity(matrix_, materials, scene().sky_emission, options);
  }
  RadiositySolution solve(RadiosityOptions options = {}) const { return solve(scene().materials, options); }

 private:
  PreparedScene2 prepared_;
  ExchangeMatrix matrix_;
  std::vector<mpf_class> areas_;
  WideFactors factors_;
};

// How well a solution's bounds hold.
struct BoundsCheck {
  std::size_t checked = 0, misses = 0;
  double narrowest = 1e300, widest = 0;  // relative, of bounds that are not a point
  std::string first_miss;

  void add(const ExactScene& scene, const RadiositySolution& solution, const std::vector<Material>& materials);
};

// Closed rooms to try things on.
Scene2 scene_of(const std::string& text);
Scene2 analytic_scene(const std::string& stem);
Scene2 convex_polygon(int n);             // n edges around a circle, materials "lamp" (the first edge) and "wall"
Scene2 random_scene(std::uint64_t seed);  // small, of all generated kinds, materials of many reflectivities

}  // namespace hottel::testing_radiosity
