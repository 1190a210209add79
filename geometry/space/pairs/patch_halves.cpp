#include "geometry/space/pairs/patch_halves.h"

#include <algorithm>

namespace hottel {
namespace {

// The place of the longest side; of equals, as doubles tell, the first.
std::size_t longest_side(const std::vector<IntegerVector>& corners) {
  std::vector<IntegerVector> ways;
  long top = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    ways.push_back(difference(corners[k], corners[(k + 1) % corners.size()]));
    top = std::max(top, bits(ways.back()));
  }
  std::size_t longest = 0;
  double most = 0;
  for (std::size_t k = 0; k < ways.size(); ++k)
    if (const double length = rounded_quotient(dot(ways[k], ways[k]), 1, 2 * top); length > most) {
      most = length;
      longest = k;
    }
  return longest;
}

}  // namespace

double longest_side_squared(const Patch3& patch, long shift) {
  double most = 0;
  for (std::size_t k = 0; k < patch.corners.size(); ++k) {
    const IntegerVector way = difference(patch.corners[k], patch.corners[(k + 1) % patch.corners.size()]);
    most = std::max(most, rounded_quotient(dot(way, way), patch.weight * patch.weight, 2 * shift));
  }
  return most;
}

std::array<Patch3, 2> halves_of(const Patch3& patch) {
  const std::vector<IntegerVector>& corners = patch.corners;
  const std::size_t n = corners.size();
  const std::size_t longest = longest_side(corners);
  const auto middle = [&](std::size_t k) { return sum(corners[k], corners[(k + 1) % n]); };
  const std::size_t opposite = (longest + (n + 1) / 2) % n;
  const IntegerVector from = middle(longest);
  const IntegerVector to = n % 2 == 0 ? middle(opposite) : multiple(2, corners[opposite]);
  std::array<Patch3, 2> halves;
  for (Patch3& half : halves) {
    half.surface = patch.surface;
    half.weight = 2 * patch.weight;
  }
  const auto add = [&](Patch3& half, std::size_t first, std::size_t last) {
    for (std::size_t k = first;; k = (k + 1) % n) {
      half.corners.push_back(multiple(2, corners[k]));
      if (k == last) break;
    }
  };
  // Of an odd number, the corner opposite is the end of the cut.
  halves[0].corners.push_back(from);
  add(halves[0], (longest + 1) % n, n % 2 == 0 ? opposite : (opposite + n - 1) % n);
  halves[0].corners.push_back(to);
  halves[1].corners.push_back(to);
  add(halves[1], (opposite + 1) % n, longest);
  halves[1].corners.push_back(from);
  return halves;
}

}  // namespace hottel
