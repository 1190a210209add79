// What a lightmap of another program came to: as a file, as JSON and as text for people.
#pragma once

#include <string>
#include <vector>

#include "io/results/grid_report.h"
#include "solver/compare/grid_errors.h"

namespace hottel {

// A lightmap beside the exact light of the same texels.
struct JudgedTexels {
  std::string file, face, quantity;
  std::vector<std::string> channels;  // by name
  std::vector<GridErrors> errors;     // by channel
  GridPlace place;
  double beyond = 0;    // as in grid_errors()
  std::string reading;  // as grid_reading() has it
};

// `channel,texels,missing,extra,max_error,rms_error,mean_error,mean,ix,iy,s,t,x,y,z,value,exact`: one line a channel.
std::string texel_csv(const JudgedTexels& texels);

// Sentences without a full stop: for each channel how far the texels are off, in the unit of the light and relative to
// the mean, and where most; then one for texels that one of the two lacks, and one for the reading.
std::vector<std::string> texel_sentences(const JudgedTexels& texels);

}  // namespace hottel
