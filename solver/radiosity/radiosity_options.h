// How radiosities are solved for, and how it is decided which elements the scene's lights reach.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace hottel {

// kAuto:      where rows sum to 1, cholesky for each component of at most kMostDenseUnknowns unknowns, cg for larger
//             ones. Elsewhere, by the number of all unknowns: lu up to kMostDenseUnknowns; LU in single precision
//             (single_precision_lu.h) up to 900, or 2000 if serves_many; bicgstab beyond. Refined in every case
// kCholesky:  symmetric elimination without subtraction, refined in double-double
// kCg:        conjugate gradients, refined in double-double
// kShooting:  progressive refinement: the face with the most unshot light shoots (an iteration is one shot)
// The others are the methods of these names in plain doubles, not refined. Bounds are proven for the result of
// every solver in the same way.
enum class Solver { kAuto, kCholesky, kCg, kLu, kBicgstab, kJacobi, kGaussSeidel, kShooting };

inline constexpr std::uint32_t kMostDenseUnknowns = 500;

// The name of a solver as --solver takes it, and the solver of a name; nothing for other names.
const char* to_string(Solver solver);
std::optional<Solver> solver_named(std::string_view name);  // "auto", "cholesky", ..., "gauss-seidel", "shooting"

// How to solve: by what, how far, and whom it tells how far it is. Two that differ in the last alone are equal.
struct RadiosityOptions {
  Solver solver = Solver::kAuto;
  // Iterative solvers stop after so many iterations, or when |residual| <= until * (largest source of the component)
  // everywhere, whichever is first. Default: 10,000 iterations (100,000 shots), 1e-12. `iterations` alone: until is 0,
  // so all are done. If one of the two is given, cg is not refined. Direct solvers, and kAuto where rows do not sum to
  // 1, take neither.
  //
  // To run out of iterations is no failure: bounds are proven of what was reached, and are wider. A note of the
  // solution tells the residual; with `iterations` alone only where it is above 1e-9. REQUIRES that neither is
  // negative.
  std::optional<int> iterations = {};
  std::optional<double> until = {};
  // One light after another will be solved for. Where rows do not sum to 1, kAuto then uses LU up to 2000 unknowns in
  // place of 900 (4 n^2 bytes for each distinct reflectivity vector).
  bool serves_many = false;
  std::function<void(double)> progress = {};  // fraction done; may throw to stop

  friend bool operator==(const RadiosityOptions& a, const RadiosityOptions& b) {
    return a.solver == b.solver && a.iterations == b.iterations && a.until == b.until && a.serves_many == b.serves_many;
  }
};

// How it is decided which elements the light of a point light or a beam reaches.
// kExact: what the light sees, cut at borders of beams and shadows: shares within proven bounds.
// The others look at a few points of each element, as old programs do, and cut nothing: estimates, to compare with, of
// Phi, the power that arrives at an element of area A (in the plane, of length A).
// With G = I0 cos^n t cos u / r^(d-1) at the centroid: I0 the intensity on the axis, n the exponent of the beam, t the
// angle from the axis, u the angle between the normal of the element and the way to the light, r the distance, d the
// dimension:
//   kCentroid  Phi = A G where the centroid is in the beam and seen, else 0
//   kVertices  Phi = A G times the vertices that are in the beam and seen over all of them; G whether or not the
//              centroid is in the beam, but 0 where n > 0 and t is beyond 90 degrees
// A point on the border of the beam is in it; what is in the beam and what is seen is decided exactly. An element that
// the light is behind, or in the plane of, has Phi = 0.
enum class LightTest : unsigned char { kExact, kCentroid, kVertices };

// The word for it: "exact", "centroid", "vertices".
const char* to_string(LightTest test);
// The test of a word; nothing for other words.
std::optional<LightTest> light_test(std::string_view word);

}  // namespace hottel
