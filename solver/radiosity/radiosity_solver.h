// Radiosities of one scene for many lights, one after the other.
//
//   const Simulation2 simulation(read_scene_2("scenes/analytic/square_radiosity.json"));
//   const auto factors = simulation.factors();
//   const Scene2& scene = simulation.scene();
//   const RadiositySolver solver({factors, &factors->matrix}, reflectivities_of(scene.materials));
//   RadiositySources sources = sources_of(factors->matrix, scene.materials, scene.sky_emission);
//   for (const double emission : {1.0, 2.0, 3.0}) {
//     sources.emission[*factors->matrix.find("top")] = SourceSpectrum::scalar({emission, emission});
//     std::printf("B = %.6g\n", solver.solve(sources).channels[0].elements[*factors->matrix.find("top")].radiosity);
//   }
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/radiosity/radiosity_sources.h"

namespace hottel {

// Solves B_i = E_i + rho_i (sum_j F_ij B_j + D_i) in every channel, for fixed view factors F and reflectivities rho and
// any number of emissions E and direct irradiances D. The solver factors the system when it first needs
// it, and keeps the factorization.
//
//   (1) lower <= true B <= upper in every element, for the exact reflectivities and any sources within their
//       enclosures. Which factors the true B belongs to depends on the weakest of them:
//         exact       the real factors
//         enclosed    any factors within their bounds; where the matrix has closed rows, those whose rows sum to 1
//         estimated   the doubles in the matrix. Nothing is proven about the scene then
//       `guarantee` is kEstimated in the last case, else kEnclosed
//   (2) lower = upper = 0 = B where no light reaches; B = E within half an ulp where rho = 0 and E is exact; lower is
//       never below the largest double that is not above E, net_upper never above the smallest that is not below it
//       (unless a factor is negative)
//   (3) bounds are a few ulps wide after cholesky and cg, or up to 3 n ulps for n unknowns if doubles do not suffice
//       (high_precision_elimination.h). That holds however near rho is to 1, and for elements that almost no
//       light reaches. If factors or sources are enclosed, bounds are a few ulps wider than the range of the
//       radiosities that those allow; they are infinite if some factors within the bounds let light circulate
//       for ever (enclosed_radiosity.h)
//   (4) each component (faces that exchange light) is bounded on its own scale, however bright others are; a note
//       names faces whose bounds remain wide relative to their radiosity
//   (5) irradiance is computed from the returned radiosities and D, and net() is radiosity less irradiance; if
//       iterations were stopped early, B = E + rho H holds within the residual only, and a note says so
//   (6) emission is E, the middle of its enclosure; in the energy balance D counts as emitted
//   (7) D changes radiosities only by rho D: they are those of the emissions E + rho D
//   (8) a solution is the same bit for bit for any number of threads and after any earlier solutions: it is a function
//       of the matrix, the reflectivities, the options and the sources
//   (9) solve() may be called by many threads at once
//   (10) withdrawn sources (net fluxes below 0) are solved for alone, and bounds subtracted (signed_radiosity.h):
//       (2) and (3) then hold of both solutions, not of their difference, which may be below 0
//   (11) in two bands the solar one is solved first. What insulated and given-flux faces gain there is a source
//       of the thermal one; bounds hold for both together
//
// Two bands are two channels. Otherwise there is one if all reflectivities and sources are scalars, else three.
class RadiositySolver {
 public:
  // `reflectivity`: by material; elements refer to it by the index of their material. options.progress is not called.
  // Throws ContractViolation if a row's material is not in the list or a reflectivity is not from 0 to 1, RequestError
  // if a factor is NaN or infinite.
  RadiositySolver(std::shared_ptr<const ExchangeMatrix> matrix, const std::vector<Spectrum>& reflectivity,
                  RadiosityOptions options = {});
  ~RadiositySolver();
  RadiositySolver(RadiositySolver&&) noexcept;
  RadiositySolver& operator=(RadiositySolver&&) noexcept;

  const ExchangeMatrix& matrix() const;
  // Seconds that the constructor took. Those of a solution are of its call alone, and count its factorizations.
  double seconds() const;

  // Throws RequestError when
  //
  //   a component with reflectivity 1 throughout and no way out emits or is shone on directly (one that does not is 0,
  //   with a note),
  //   an upper bound of an exact matrix is infinite (factors that underflow, or more light than doubles can tell),
  //   rows do not sum to 1 and the spectral radius cannot be shown to be below 1,
  //   cholesky or cg are asked of such a matrix, which is not symmetric;
  //
  // ContractViolation unless there are as many emissions as elements, and as many direct irradiances or none.
  // `progress` gets the fraction done; it is called by this thread and may throw to stop.
  // COST: the first time one factorization for each distinct reflectivity vector, n^3 / 3 for a component of n
  // unknowns, which keeps 8 n^2 bytes (conjugate gradients factor nothing); then a few passes over the matrix for each
  // channel. Three times the passes where some source is wider than a few ulps; three times all of it where the weakest
  // factor is enclosed.
  RadiositySolution solve(const RadiositySources& sources, const std::function<void(double)>& progress = {}) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace hottel
