#include "viewer/picture/space/hanging_corners.h"

#include <cmath>
#include <unordered_map>

namespace hottel {
namespace {

using Needs = std::vector<std::vector<std::uint32_t>>;  // by place: the places that come before it

Needs needs_of(const std::vector<HangingCorner3>& hanging) {
  std::unordered_map<std::uint32_t, std::uint32_t> place;
  for (std::uint32_t k = 0; k < hanging.size(); ++k) place.emplace(hanging[k].corner, k);
  Needs result(hanging.size());
  for (std::size_t k = 0; k < hanging.size(); ++k)
    for (const std::uint32_t end : {hanging[k].from, hanging[k].to})
      if (const auto found = place.find(end); found != place.end()) result[k].push_back(found->second);
  return result;
}

Needs turned(const Needs& needs) {
  Needs result(needs.size());
  for (std::uint32_t k = 0; k < needs.size(); ++k)
    for (const std::uint32_t before : needs[k]) result[before].push_back(k);
  return result;
}

// All that wait for no circle, each after what it needs.
std::vector<std::uint32_t> in_turn(const Needs& needs) {
  const Needs waiting = turned(needs);
  std::vector<std::size_t> open;
  std::vector<std::uint32_t> result;
  for (std::uint32_t k = 0; k < needs.size(); ++k) {
    open.push_back(needs[k].size());
    if (needs[k].empty()) result.push_back(k);
  }
  for (std::size_t done = 0; done < result.size(); ++done)
    for (const std::uint32_t next : waiting[result[done]])
      if (--open[next] == 0) result.push_back(next);
  return result;
}

std::vector<HangingCorner3> without_circles(const std::vector<HangingCorner3>& hanging, const Needs& needs) {
  std::vector<bool> is_in_line(hanging.size(), false);
  for (const std::uint32_t k : in_turn(needs)) is_in_line[k] = true;
  for (const std::uint32_t k : in_turn(turned(needs))) is_in_line[k] = true;
  std::vector<HangingCorner3> result;
  for (std::size_t k = 0; k < hanging.size(); ++k)
    if (is_in_line[k]) result.push_back(hanging[k]);
  return result;
}

}  // namespace

std::vector<HangingCorner3> in_order(const std::vector<HangingCorner3>& hanging) {
  const std::vector<HangingCorner3> kept = without_circles(hanging, needs_of(hanging));
  std::vector<HangingCorner3> result;
  for (const std::uint32_t k : in_turn(needs_of(kept))) result.push_back(kept[k]);
  return result;
}

void hang(std::span<const HangingCorner3> ordered, std::size_t channels, std::vector<double>& values) {
  for (const HangingCorner3& hanging : ordered) {
    const double *from = &values[hanging.from * channels], *to = &values[hanging.to * channels];
    if (std::isnan(from[0]) || std::isnan(to[0])) continue;
    double* at = &values[hanging.corner * channels];
    for (std::size_t c = 0; c < channels; ++c) at[c] = std::lerp(from[c], to[c], hanging.share);
  }
}

}  // namespace hottel
