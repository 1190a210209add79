// What is known of radiosities once they are solved for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "kernel/enclosure.h"
#include "solver/radiosity/radiosity_options.h"

namespace hottel {

// The unit of emissions, radiosities, irradiances and net fluxes of elements; in the plane it is per metre of depth and
// per metre of edge.
inline constexpr const char* kRadiosityUnit = "W/m²";

// One element in one channel, in that unit.
struct ElementRadiosity {
  double emission = 0, reflectivity = 0;  // correctly rounded; of an enclosed emission its middle
  double radiosity = 0;
  double lower = 0, upper = 0;          // proven bounds; RadiositySolution::guarantee says of which equations
  double irradiance = 0;                // sum_j F_ij B_j + D_i (RadiositySources), reflected or not
  double net_lower = 0, net_upper = 0;  // proven bounds of radiosity - irradiance, likewise
  double net_value = 0;                 // within them; does not lose digits as the difference of two doubles does

  // Returns the difference of these two doubles, rounded once: what is printed as net.
  double net() const { return radiosity - irradiance; }
};

// Power [W; W per metre of depth in the plane; radiosity times area where the unit of length is not known], sums over
// the rows of the matrix. What the sky sends in and what
// arrives directly (RadiositySources) counts as emitted. emitted = absorbed + to_sky + defect.
struct EnergyBalance {
  double emitted = 0, absorbed = 0, to_sky = 0, defect = 0;
};

// Elements that exchange light with each other and that no light reaches, `size` of them. Their radiosities are exactly
// 0, and were not solved for.
struct DarkComponent {
  std::uint32_t first_element = 0, size = 0;
};

// One channel of a solution. Lists by element are as long as the matrix has elements.
struct ChannelSolution {
  std::vector<ElementRadiosity> elements;  // by element of the matrix; those without a row are 0
  // Max |residual| / largest source of its component: of the start, then after each iteration; of lu once. Of shooting
  // the largest light that is not shot yet, in place of the residual. Empty where nothing was solved.
  std::vector<double> residual_history;
  std::vector<DarkComponent> dark;
  EnergyBalance energy;
  double max_relative_width = 0;  // the most (upper - lower) / |radiosity|, of radiosities that are not 0
};

// Radiosities in all channels, and how they were found.
//
//   (1) channels and channel_names are equally many: one, two bands, or three
struct RadiositySolution {
  // kEnclosed: the bounds hold for the true factors and lights. kEstimated: some factor, or what the lights shine on
  // first, is only an estimate, and the bounds are those of the equations with the factors as printed and the lights as
  // computed; nothing is said of the true ones.
  Guarantee guarantee = Guarantee::kEnclosed;
  std::vector<std::string> channel_names;  // {"all"}; {"solar", "thermal"}; or {"r", "g", "b"}
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

// Sets what is over all channels: the width of bounds, and the energy.
inline void sum_up_channels(RadiositySolution& solution) {
  solution.max_relative_width = 0;
  solution.energy = {};
  for (const ChannelSolution& channel : solution.channels) {
    solution.max_relative_width = std::max(solution.max_relative_width, channel.max_relative_width);
    solution.energy.emitted += channel.energy.emitted;
    solution.energy.absorbed += channel.energy.absorbed;
    solution.energy.to_sky += channel.energy.to_sky;
    solution.energy.defect += channel.energy.defect;
  }
}

// Returns the largest radiosity of all channels and elements, 0 where all are dark; one that is NaN is passed over.
inline double largest_radiosity(const RadiositySolution& solution) {
  double value = 0;
  for (const ChannelSolution& channel : solution.channels)
    for (const ElementRadiosity& element : channel.elements) value = std::max(value, element.radiosity);
  return value;
}

}  // namespace hottel
