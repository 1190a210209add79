#include "parallel/radiosity_message.h"

#include <cstdint>
#include <vector>

namespace hottel {

void put_radiosities(const RadiositySolution& solution, MessageWriter& writer) {
  writer.put(std::uint64_t{solution.channels.size()});
  for (const ChannelSolution& channel : solution.channels) {
    std::vector<double> radiosities;
    for (const ElementRadiosity& element : channel.elements) radiosities.push_back(element.radiosity);
    writer.put_all(radiosities);
  }
}

RadiositySolution take_radiosities(MessageReader& reader) {
  RadiositySolution solution;
  solution.channels.resize(reader.take<std::uint64_t>());
  for (ChannelSolution& channel : solution.channels)
    for (const double radiosity : reader.take_all<double>()) channel.elements.push_back({.radiosity = radiosity});
  return solution;
}

}  // namespace hottel
