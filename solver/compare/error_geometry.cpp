#include "solver/compare/error_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "kernel/plain_functions.h"
#include "solver/compare/noise_bias.h"
#include "solver/compare/samples.h"

namespace hottel {
namespace {

constexpr std::size_t kAsked = 500, kCompared = 20000;
constexpr std::size_t kCoordinates = 7;

struct PlacedError {
  const JudgedPair* pair;
  std::array<double, kCoordinates> at;
  double error;  // over its standard deviation
};

double square_of_distance(const PlacedError& a, const PlacedError& b) {
  double sum = 0;
  for (std::size_t k = 0; k < kCoordinates; ++k) sum += (a.at[k] - b.at[k]) * (a.at[k] - b.at[k]);
  return sum;
}

bool is_closed(const JudgedPairs& judged) {
  std::size_t closed = 0, open = 0;
  for (std::uint32_t i = 0; i < judged.exact().size(); ++i) {
    double defect = 0, slack = 0;
    for (const JudgedPair& pair : judged.row(i)) {
      defect += pair.value - pair.exact;
      slack += judged.tolerance(pair.value);
    }
    if (!judged.row(i).empty()) ++(std::abs(defect) <= slack ? closed : open);
  }
  return closed >= open;
}

}  // namespace

GeometricShare geometric_share(const JudgedScene& scene, const JudgedPairs& judged,
                               std::span<const ScatteredPair> pairs) {
  const ExchangeMatrix& exact = judged.exact();
  std::vector<PlacedError> placed;
  for (const ScatteredPair& each : thinned(pairs, kCompared)) {
    const JudgedPair& pair = *each.pair;
    if (pair.to == exact.sky()) continue;
    const auto place = scene.place_of(pair.from, pair.to);
    if (!place || !(place->distance > 0)) continue;
    const auto area = [&](std::uint32_t i) { return same_bits::log(exact.elements()[i].area.value); };
    const double seen = pair.visibility > 0 ? pair.visibility : 0;
    placed.push_back({&pair,
                      {same_bits::log(place->distance), 2 * place->from_cosine, 2 * place->to_cosine, area(pair.from),
                       area(pair.to), 2 * seen, same_bits::log(pair.exact / std::max(seen, 1e-3))},
                      each.rest / std::sqrt(each.variance)});
  }
  // A few errors that are far larger than the others would be all that counts.
  std::vector<double> sizes;
  for (const PlacedError& each : placed) sizes.push_back(std::abs(each.error));
  if (sizes.size() < 3) return {};
  const double most = 4 * middle_of(sizes);
  for (PlacedError& each : placed) each.error = std::clamp(each.error, -most, most);
  double products = 0, squares = 0;
  std::size_t count = 0;
  for (const PlacedError& asked : thinned(placed, kAsked)) {
    const PlacedError* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const PlacedError& other : placed) {
      const bool is_same = other.pair->from == asked.pair->from && other.pair->to == asked.pair->to;
      const bool is_reverse = other.pair->from == asked.pair->to && other.pair->to == asked.pair->from;
      const double distance = square_of_distance(asked, other);
      if (is_same || is_reverse || !(distance < least)) continue;
      least = distance;
      nearest = &other;
    }
    if (nearest == nullptr) continue;
    products += asked.error * nearest->error;
    squares += (asked.error * asked.error + nearest->error * nearest->error) / 2;
    ++count;
  }
  if (!(squares > 0)) return {};
  // Of a symmetric matrix half of the numbers are new.
  const bool is_halved = is_symmetric(judged, pairs);
  const double numbers = static_cast<double>(count) / (is_halved ? 2 : 1);
  return {products / squares, 1 / std::sqrt(numbers), is_closed(judged), is_halved};
}

}  // namespace hottel
