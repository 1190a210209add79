// How radiosities are to be solved for.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace hottel {

// kAuto:      cholesky for components of up to kMostDenseUnknowns, else cg; where rows do not sum to 1 lu for so many
//             unknowns in all, in single precision for more (single_precision_lu.h), else bicgstab; refined
// kCholesky:  symmetric elimination without subtraction, refined in double-double
// kCg:        conjugate gradients, refined in double-double
// kShooting:  progressive refinement: the face with the most unshot light shoots (an iteration is one shot)
// The others are what their names say, in plain doubles, as they are. Every result is certified alike.
enum class Solver { kAuto, kCholesky, kCg, kLu, kBicgstab, kJacobi, kGaussSeidel, kShooting };

inline constexpr std::uint32_t kMostDenseUnknowns = 500;

// The name of a solver as --solver takes it, and the solver of a name; nothing for other names.
const char* to_string(Solver solver);
std::optional<Solver> solver_named(std::string_view name);  // "auto", "cholesky", ..., "gauss-seidel", "shooting"

// How to solve: by what, how far, and whom it tells how far it is.
struct RadiosityOptions {
  Solver solver = Solver::kAuto;
  // Iterative solvers stop after so many iterations, or when |residual| <= until * (largest source of the component)
  // everywhere. When either is given, cg is not refined either. Default: 1e-12, 10,000 iterations (100,000 shots).
  std::optional<int> iterations = {};
  std::optional<double> until = {};
  // One light after another will be solved for: kAuto then factors up to 2000 unknowns whose rows do not sum to 1, of
  // which it would factor 900 for one light (4 n^2 bytes for each distinct reflectivity vector).
  bool serves_many = false;
  std::function<void(double)> progress = {};  // fraction done; may throw to stop
};

}  // namespace hottel
