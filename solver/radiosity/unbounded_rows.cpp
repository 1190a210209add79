#include "solver/radiosity/unbounded_rows.h"

#include <fmt/format.h>

#include <cstddef>
#include <limits>
#include <set>

namespace hottel {

std::vector<std::string> notes_of_unbounded_rows(const ExchangeMatrix& matrix, const RadiositySolution& solution) {
  std::set<std::string> notes;
  for (const ChannelSolution& channel : solution.channels) {
    std::size_t open = 0, rows = 0;
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      ++rows;
      open += channel.elements[i].upper == std::numeric_limits<double>::infinity();
    }
    if (open > 0) notes.insert(fmt::format("no upper bound could be proven for {} of {} radiosities", open, rows));
  }
  return {notes.begin(), notes.end()};
}

}  // namespace hottel
