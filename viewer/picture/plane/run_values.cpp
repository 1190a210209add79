#include "viewer/picture/plane/run_values.h"

#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "viewer/picture/bounded_mean.h"

namespace hottel {
namespace {

using Place = std::tuple<std::uint32_t, bool, std::uint32_t>;  // surface, whether it is its back, corner

Place place_on(const Face& face, std::uint32_t corner) { return {face.surface, face.is_back, corner}; }

std::vector<double> values_of(const std::vector<Element>& elements,
                              const std::vector<std::optional<double>>& by_element, Shading shading) {
  std::vector<double> values(elements.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < elements.size() && k < by_element.size(); ++k)
    if (by_element[k]) values[k] = *by_element[k];
  return shading == Shading::kParents ? values_from_parents(elements, values, 1) : values;
}

}  // namespace

double RunValue2::at(double share) const {
  return share < 0.5 ? std::lerp(from, middle, 2 * share) : std::lerp(middle, to, 2 * share - 1);
}

std::vector<std::optional<RunValue2>> run_values_2(const FaceRuns2& runs,
                                                   const std::vector<std::optional<double>>& by_element,
                                                   Shading shading) {
  const std::vector<double> values = values_of(runs.elements(), by_element, shading);
  const Corners2& corners = runs.corners();
  std::vector<std::optional<RunValue2>> result(corners.surfaces());
  std::map<Place, BoundedMean> means;
  for (std::uint32_t run = 0; run < result.size(); ++run) {
    const double value = values[runs.element(run)];
    if (std::isnan(value)) continue;
    result[run] = {value, value, value};
    for (const std::uint32_t end : {corners.from[run], corners.to[run]})
      means[place_on(runs.face(run), end)].add(value, runs.elements()[runs.element(run)].area.value);
  }
  if (shading == Shading::kFlat) return result;
  for (std::uint32_t run = 0; run < result.size(); ++run) {
    if (!result[run]) continue;
    result[run]->from = means[place_on(runs.face(run), corners.from[run])].value();
    result[run]->to = means[place_on(runs.face(run), corners.to[run])].value();
  }
  return result;
}

}  // namespace hottel
