// Radiosities of a scene from its view factors, with proven bounds.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"

namespace hottel {

// kAuto:      cholesky for components of up to kMostDenseUnknowns, else cg; where rows do not sum to 1 lu for so many
//             unknowns in all, else bicgstab
// kCholesky:  symmetric elimination without subtraction, refined in double-double
// kCg:        conjugate gradients, refined in double-double
// kShooting:  progressive refinement: the face with the most unshot light shoots (an iteration is one shot)
// The others are what their names say, in plain doubles, as they are. Every result is certified alike.
enum class Solver { kAuto, kCholesky, kCg, kLu, kBicgstab, kJacobi, kGaussSeidel, kShooting };

inline constexpr std::uint32_t kMostDenseUnknowns = 500;

const char* to_string(Solver solver);
std::optional<Solver> solver_named(std::string_view name);  // "auto", "cholesky", ..., "gauss-seidel", "shooting"

struct RadiosityOptions {
  Solver solver = Solver::kAuto;
  // Iterative solvers stop after so many iterations, or when |residual| <= until * (largest source of the component)
  // everywhere. When either is given, cg is not refined either. Default: 1e-12, 10,000 iterations (100,000 shots).
  std::optional<int> iterations = {};
  std::optional<double> until = {};
  std::function<void(double)> progress = {};  // fraction done; may throw to stop
};

// One element in one channel. Units: W/m in the plane, W/m² in space.
struct ElementRadiosity {
  double emission = 0, reflectivity = 0;  // correctly rounded
  double radiosity = 0;
  double lower = 0, upper = 0;          // proven bounds of the radiosity of the exact system
  double irradiance = 0;                // sum_j F_ij B_j of these radiosities, where there is no reflection too
  double net_lower = 0, net_upper = 0;  // proven bounds of radiosity - irradiance of the exact system
  double net_value = 0;                 // within them, without what cancels in the difference of two doubles

  // Returns the difference of these two doubles, rounded once: what is printed as net.
  double net() const { return radiosity - irradiance; }
};

// Power [W; W per metre of depth in the plane], sums over the rows of the matrix. What the sky sends in counts as
// emitted. emitted = absorbed + to_sky + defect.
struct EnergyBalance {
  double emitted = 0, absorbed = 0, to_sky = 0, defect = 0;
};

// Faces that exchange light with each other and that no light reaches: exactly 0, not solved.
struct DarkComponent {
  std::uint32_t first_element = 0, size = 0;
};

struct ChannelSolution {
  std::vector<ElementRadiosity> elements;  // by element of the matrix; those without a row are 0
  std::vector<double> residual_history;    // max |residual| / largest source of its component, the start first
  std::vector<DarkComponent> dark;
  EnergyBalance energy;
  double max_relative_width = 0;  // of the bounds, over elements with radiosity > 0
};

struct RadiositySolution {
  std::vector<std::string> channel_names;  // {"all"} when every spectrum is a scalar, else {"r", "g", "b"}
  std::vector<ChannelSolution> channels;
  Solver used = Solver::kAuto;                 // kAuto: nothing had to be solved
  std::uint32_t unknowns = 0, components = 0;  // the most of any channel
  std::uint32_t factorizations = 0;            // distinct reflectivity vectors; 0: no light is reflected
  double max_relative_width = 0;               // over all channels
  EnergyBalance energy;                        // summed over the channels
  double closure_defect = 0;                   // max |sum_j F_ij - 1|, of the doubles
  double reciprocity_defect = 0;               // max |A_i F_ij - A_j F_ji| / min(A_i, A_j), of the doubles
  std::map<std::string, double> seconds;       // "irradiance"; "radiosity", "certificate" if something was solved
  std::vector<std::string> notes;
};

// Solves B_i = E_i + rho_i sum_j F_ij B_j in every channel.
//
//   (1) lower <= true B <= upper in every element, the true B being that of the exact reflectivities, emissions and
//       factors; for an enclosed matrix, of any factors within its enclosures; for an estimated one, of the doubles it
//       holds, which says nothing of the scene (set_a_priori_bounds gives what holds there)
//   (2) lower = upper = 0 = B where no light reaches; B = E within half an ulp where rho = 0; lower is never below the
//       largest double that is not above E, net_upper never above the smallest that is not below it (unless a factor is
//       negative)
//   (3) widths of a few ulps after cholesky and cg, or up to 3 n ulps for n unknowns where doubles do not do
//       (high_precision_elimination.h), for any distance of rho from 1 and for elements that next to no light reaches;
//       for an enclosed matrix a few ulps more than the radiosities of its factors differ, and infinite where for some
//       of them light need not die out (enclosed_radiosity.h)
//   (4) each component is bounded on its own scale, whatever shines elsewhere; a note names faces that remain wide
//       relative to themselves (faint_radiosities.h)
//   (5) irradiance is that of the radiosities as given, so net() is what they exchange; where iterations were stopped
//       early B = E + rho H holds within the residual only, and a note says so
//   (6) the same bit for bit for any number of threads
//
// Throws RequestError when a component with reflectivity 1 throughout and no way out emits (one that does not is 0,
// with a note), when an upper bound of an exact matrix is infinite (factors that underflow, or more light than doubles
// can tell), when rows do not sum to 1 and the spectral radius cannot be shown to be below 1, when cholesky or cg
// are asked of such a matrix, which is not symmetric, and when a factor is no number. Where a factor of an estimated
// matrix is negative the equations are solved and all bounds are infinite. Rows sum to 1 in exact matrices, and are
// taken to where their enclosures allow it, which concerns the radiosity, not its bounds.
// REQUIRES: the materials of the elements index into `materials`.
// COST: one factorization a distinct reflectivity vector; then a few passes over the matrix a channel. Three times that
// for an enclosed matrix.
RadiositySolution solve_radiosity(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                                  const Spectrum& sky_emission, const RadiosityOptions& options = {});

}  // namespace hottel
