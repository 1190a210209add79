// What the light of another program on a grid came to: as a file and as text for people.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "solver/compare/grid_errors.h"

namespace hottel {

// Where the cells of a grid lie: parts of the parallelogram of u and v. [unit of the scene]
struct GridPlace {
  std::array<double, 3> origin, u, v;
  std::uint32_t nu = 1, nv = 1;
  bool is_in_space = false;

  std::array<double, 3> centre(std::uint32_t iu, std::uint32_t iv) const;
  std::array<double, 2> fractions(std::uint32_t iu, std::uint32_t iv) const;  // of u and v, of the centre
};

// `channel,cells,missing,extra,max_error,rms_error,largest,ix,iy,x,y,z,value,exact`: one line a channel; z is empty in
// the plane.
std::string grid_csv(std::span<const GridErrors> errors, std::span<const std::string> channels, const GridPlace& place);

// A sentence a channel, without a full stop, of how many cells are off; then one for cells that one of the two lacks,
// and one for the reading.
std::vector<std::string> grid_sentences(std::span<const GridErrors> errors, std::span<const std::string> channels,
                                        const GridPlace& place, double beyond, const std::string& reading);

}  // namespace hottel
