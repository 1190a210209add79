// Radiosities and net fluxes as files.
//
//   const Simulation2 simulation(read_scene_2("scenes/analytic/square_radiosity.json"));
//   const auto factors = simulation.factors();
//   const auto solution = simulation.radiosities();
//   std::ofstream file("radiosity.csv");
//   write_radiosity_csv(simulation.scene(), factors->matrix, *solution, [&](std::string_view text) { file << text; });
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/scene_table.h"
#include "solver/radiosity/net_flux.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// `face,element,channel,area,emission,reflectivity,radiosity,lower,upper,irradiance,net`: one line for each element
// with a row and each channel, by elements of the matrix. Shortest decimals that read back to the same double; `net` is
// the difference of the two doubles printed, rounded once.
//
// With digits each number but the element has no more (short_digits): `lower` is rounded down, `upper` up, `net` by
// itself.
//
// Whatever the sink throws stops the writing.
// Throws ContractViolation where the solution has another number of elements. REQUIRES the solution of this matrix, of
// this scene.
void write_radiosity_csv(const SceneTable& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution,
                         const std::function<void(std::string_view)>& sink, std::optional<int> digits = {});

// `per,name,channel,area,net,lower,upper`: net flux in W (in the plane W per metre of depth) with proven bounds,
// positive where more leaves than arrives (net_flux.h). First a line for each face and channel, then for each group:
// polyline or edge of its own, fronts and backs by themselves. The sky is last in both. Then come the lights: each half
// sums to 0 together with them. In two bands there is a third channel, `total`: their sum.
struct NetFluxes {
  std::vector<NetFlux> faces, groups, lights;
  std::vector<std::string> channel_names;  // of all of them
  // Whether a sun shines: in two bands by band, else the first alone. What of it passes by has no number.
  std::array<bool, 2> has_sun{};

  // False where nobody knows the unit of length, so that nothing can be told in W: columns of W are empty then.
  bool are_in_watts = true;

  // REQUIRES the solution of this matrix, of this scene, and the shares of its lights. COST: two passes over the matrix
  // a channel.
  NetFluxes(const SceneTable& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution,
            std::span<const LightShares> shares);
};
void write_flux_csv(const NetFluxes& fluxes, const std::function<void(std::string_view)>& sink,
                    std::optional<int> digits = {});

}  // namespace hottel
