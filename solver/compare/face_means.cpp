#include "solver/compare/face_means.h"

#include <algorithm>
#include <cmath>

#include "kernel/support/failure.h"

namespace hottel {

FaceMeans face_mean_radiosities(const ExchangeMatrix& matrix, const RadiositySolution& solution) {
  std::size_t faces = 0;
  for (const Element& element : matrix.elements()) faces = std::max<std::size_t>(faces, 2 * element.surface + 2);
  FaceMeans means;
  for (const ChannelSolution& channel : solution.channels) {
    std::vector<long double> sums(faces, 0), areas(faces, 0);
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      const Element& element = matrix.elements()[i];
      const std::size_t face = 2 * element.surface + (element.is_back ? 1 : 0);
      sums[face] += static_cast<long double>(element.area.value) * channel.elements[i].radiosity;
      areas[face] += element.area.value;
    }
    std::vector<std::optional<double>>& of_channel = means.emplace_back(faces);
    for (std::size_t face = 0; face < faces; ++face)
      if (areas[face] > 0) of_channel[face] = static_cast<double>(sums[face] / areas[face]);
  }
  return means;
}

double face_mean_error(const FaceMeans& means, const FaceMeans& finer) {
  HOTTEL_REQUIRE(means.size() == finer.size());
  double difference = 0, largest = 0;
  for (std::size_t c = 0; c < finer.size(); ++c)
    for (std::size_t face = 0; face < finer[c].size(); ++face) {
      if (!finer[c][face]) continue;
      largest = std::max(largest, *finer[c][face]);
      if (face < means[c].size() && means[c][face])
        difference = std::max(difference, std::abs(*means[c][face] - *finer[c][face]));
    }
  return difference == 0 ? 0 : difference / largest;
}

}  // namespace hottel
