#include "viewer/picture/shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "kernel/support/failure.h"
#include "viewer/picture/bounded_mean.h"

namespace hottel {
namespace {

constexpr std::array<std::string_view, 4> kShadings{"flat", "smooth", "parents", "gathered"};

bool is_same_tree(const Element& a, const Element& b) {
  return a.surface == b.surface && a.is_back == b.is_back && a.part == b.part;
}

// Gives those from `begin` to `end` their mean.
void level_out(std::span<const Element> elements, std::size_t begin, std::size_t end, std::size_t channels,
               std::vector<double>& values) {
  for (std::size_t c = 0; c < channels; ++c) {
    BoundedMean mean;
    for (std::size_t k = begin; k < end; ++k)
      if (!std::isnan(values[k * channels + c])) mean.add(values[k * channels + c], elements[k].area.value);
    for (std::size_t k = begin; k < end; ++k) {
      double& value = values[k * channels + c];
      if (!std::isnan(value) && !std::isnan(mean.value())) value = mean.value();
    }
  }
}

}  // namespace

std::optional<Shading> shading_of(std::string_view name) {
  const auto found = std::ranges::find(kShadings, name);
  if (found == kShadings.end()) return std::nullopt;
  return static_cast<Shading>(found - kShadings.begin());
}

std::vector<double> values_from_parents(std::span<const Element> elements, std::span<const double> values,
                                        std::size_t channels) {
  HOTTEL_REQUIRE(values.size() == elements.size() * channels);
  std::vector<double> result(values.begin(), values.end());
  for (std::size_t begin = 0, end = 0; begin < elements.size(); begin = end) {
    int deepest = 0;
    for (; end < elements.size() && is_same_tree(elements[end], elements[begin]); ++end)
      deepest = std::max(deepest, elements[end].path.depth());
    for (std::size_t k = begin, next = begin; deepest > 0 && k < end; k = next) {
      next = k + 1;
      if (elements[k].path.depth() < deepest) continue;
      const TreePath parent = elements[k].path.parent();
      while (next < end && parent.holds(elements[next].path)) ++next;
      level_out(elements, k, next, channels, result);
    }
  }
  return result;
}

}  // namespace hottel
