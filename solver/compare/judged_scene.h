// What verdicts ask of the scene behind the exact factors.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/compare/judged_pairs.h"

namespace hottel {

// A method that is not exact and computes the factor of each pair of elements by itself, and its name.
struct PairwiseMethod {
  std::string name;
  std::function<double(std::uint32_t from, std::uint32_t to)> factor;  // REQUIRES that the first has a row
  bool takes_visibility = false;                                       // is to be multiplied by the exact one
};

inline constexpr std::uint32_t kMostApproximated = 2000;  // elements
inline constexpr double kNotBehind = 1e-7;

// How the factor of two elements may be taken from points of them, whatever stands between.
enum class PointRule : unsigned char {
  kCenter,    // cos cos' / (pi r^2) between the centres; in the plane cos cos' / (2 r)
  kDisk,      // from the centre to a disk of the same area; in space
  kVertices,  // the mean over all pairs of corners
  kGauss2,    // the mean over 2 (2 x 2) Gauss points of each
  kGauss4     // over 4 (4 x 4)
};

// How two elements lie to each other.
struct PairPlace {
  double distance = 0;                    // of their middles [any unit]
  double from_cosine = 0, to_cosine = 0;  // of the angles between the line of the middles and the normals
};

// The same from the way between the middles, and the normals, which have the length 1.
template <class Vector>
PairPlace pair_place(const Vector& way, const Vector& from_normal, const Vector& to_normal) {
  const double distance = length(way);
  if (!(distance > 0)) return {};
  return {distance, dot(from_normal, way) / distance, -dot(to_normal, way) / distance};
}

// Whether something before a plane as far as from `least` to `most` has a part behind it, or lies in it.
inline bool is_behind_in_part(double least, double most, double extent) {
  return least < -kNotBehind * extent || most < kNotBehind * extent;
}

// A scene whose factors are judged. Hypotheses that follow from more than the numbers ask it; they know of no
// dimension. Asked only when some pair is off. For several threads at once.
class JudgedScene {
 public:
  virtual ~JudgedScene() = default;

  // The name of a surface, to be printed. REQUIRES an index of Element::surface.
  virtual const std::string& surface_name(std::uint32_t surface) const = 0;

  // Returns F(from, to) without any obstacle. REQUIRES two elements of which the first has a row.
  virtual double unobstructed_factor(std::uint32_t from, std::uint32_t to) const = 0;

  // The rules that there are in the dimension of the scene, and what one gives for F(from, to) without any obstacle.
  // REQUIRES two elements of which the first has a row.
  virtual const std::vector<PointRule>& point_rules() const = 0;
  virtual double factor_by(PointRule rule, std::uint32_t from, std::uint32_t to) const = 0;

  // Nothing where one of them has no extent.
  virtual std::optional<PairPlace> place_of(std::uint32_t from, std::uint32_t to) const = 0;

  // Methods that other programs use as well. They live as long as this. COST: linear.
  virtual std::vector<PairwiseMethod> pairwise_methods() const = 0;

  // Returns what `rays` counted for each element would be, on an average, if they left evenly in all directions and not
  // by the cosine: a power of two of them, spread by Sobol.
  virtual ExchangeMatrix uniform_factors(std::uint32_t rays) const = 0;

  // False where all of `to` lies before `from`, in part farther than kNotBehind of the smaller extent, and nowhere
  // farther behind: then nothing leaves the back of the one for either side of the other. True where both lie in one
  // plane: they may touch. REQUIRES two elements of which the first has a row.
  virtual bool reaches_behind(std::uint32_t from, std::uint32_t to) const = 0;

  // Returns the exact factors of the same surfaces when both sides of each have a material, divided as before. Nothing
  // where backs with a material would make claims that the scene cannot grant.
  virtual std::optional<ExchangeMatrix> factors_of_both_sides() const = 0;
};

// Returns F(from, to) without any obstacle, by place in judged.pairs(): of pairs that are off and whose second is not
// the sky; 0 for the others. COST: parallel over the pairs.
std::vector<double> unobstructed_factors(const JudgedScene& scene, const JudgedPairs& judged);

}  // namespace hottel
