#include "cli/grid_exr.h"

#include "io/results/exr.h"

namespace hottel {

std::string grid_exr(const GridNumbers& numbers) {
  return exr_file({.width = numbers.columns,
                   .height = numbers.rows,
                   .channels = numbers.channels,
                   .values = numbers.values,
                   .begins_below = true,
                   .attributes = {{"unit", numbers.unit}, {"hottel", numbers.about}}});
}

}  // namespace hottel
