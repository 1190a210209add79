#include "solver/radiosity/radiosity.h"

#include <memory>

#include "solver/radiosity/radiosity_solver.h"

namespace hottel {

RadiositySolution solve_radiosity(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                                  const Spectrum& sky_emission, const RadiosityOptions& options) {
  return solve_sources(matrix, materials, sources_of(matrix, materials, sky_emission), options);
}

RadiositySolution solve_sources(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                                const RadiositySources& sources, const RadiosityOptions& options) {
  const std::shared_ptr<const ExchangeMatrix> unowned(std::shared_ptr<const ExchangeMatrix>(), &matrix);
  const RadiositySolver solver(unowned, reflectivities_of(materials), options);
  RadiositySolution solution = solver.solve(sources, options.progress);
  if (const auto place = solution.seconds.find("radiosity"); place != solution.seconds.end())
    place->second += solver.seconds();
  return solution;
}

}  // namespace hottel
