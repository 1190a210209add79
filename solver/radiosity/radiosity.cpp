#include "solver/radiosity/radiosity.h"

#include <utility>

#include "kernel/support/parallel.h"
#include "solver/radiosity/enclosed_radiosity.h"
#include "solver/radiosity/factors_as_given.h"
#include "solver/radiosity/faint_radiosities.h"

namespace hottel {

RadiositySolution solve_radiosity(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                                  const Spectrum& sky_emission, const RadiosityOptions& options) {
  const DefaultFloatingPoint arithmetic;
  const auto solve = [&](const ExchangeMatrix& of, const RadiosityOptions& with, bool is_whole) {
    return solve_as_given(of, materials, sky_emission, with, !is_whole);
  };
  RadiositySolution solution = matrix.guarantee() == Guarantee::kEnclosed
                                   ? solve_enclosed(matrix, sky_emission, options, solve)
                                   : solve(matrix, options, true);
  if (matrix.guarantee() == Guarantee::kEstimated)
    solution.guarantee = Guarantee::kEstimated;
  else  // the faint radiosities of estimates are what they are: estimates
    for (std::string& note : notes_of_faint_radiosities(matrix, solution)) solution.notes.push_back(std::move(note));
  return solution;
}

}  // namespace hottel
