// Temperatures of faces as a file, and what is told of those that come out: of insulated faces, of given net fluxes.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/scene_table.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// Whether a scene has temperatures to tell: a surface has a material given by one above 0, an insulated one, or
// one of a given net flux.
bool has_temperatures(const SceneTable& scene);

// `face,element,channel,temperature,lower,upper`: one line [K] for each element with a row and a temperature
// (ElementTemperatures) and each channel, in the order of radiosity.csv. Shortest decimals that read back to the same
// double, or the digits that are asked for, bounds rounded outward; bounds are proven where those of the radiosities
// are (RadiositySolution::guarantee).
//
// Whatever the sink throws stops the writing.
// REQUIRES the solution of this matrix, of this scene.
void write_temperature_csv(const SceneTable& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution,
                           const std::function<void(std::string_view)>& sink, std::optional<int> digits = {});

// What those elements of a group come to whose temperature comes out, in one channel.                            [K]
struct FoundTemperatures {
  std::string name;  // of the group; with ":back" where the backs are
  std::string channel;
  double coldest = 0, warmest = 0;  // of the values
  double lower = 0, upper = 0;      // all of them lie between these, proven where the radiosities are
};

// Returns those of the insulated faces, and those of faces of given net flux, in the order of radiosity.csv. REQUIRES
// what write_temperature_csv does.
std::vector<FoundTemperatures> insulated_groups(const SceneTable& scene, const ExchangeMatrix& matrix,
                                                const RadiositySolution& solution);
std::vector<FoundTemperatures> given_flux_groups(const SceneTable& scene, const ExchangeMatrix& matrix,
                                                 const RadiositySolution& solution);

}  // namespace hottel
