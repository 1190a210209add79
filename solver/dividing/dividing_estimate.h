// What dividing every element once more would change about radiosities: an estimate from the solution at hand.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/scene_table.h"
#include "solver/radiosity/direct_light.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

struct ElementMerging;
struct SampledElement;

// Bounds of radiosities are those of the elements that there are. How far these are from a finer division no bound
// tells; this does, as a guess.
//
//   (1) pointwise: the root of the mean square, over the area, of what parts of elements gather from all elements, less
//       what their element has
//   (2) of face means: a quarter of the difference to the solution of elements merged in pairs along the faces (four to
//       one in space), the largest of any face; a quarter, since means converge with the square of the elements' size
//   (3) both are 0 where nothing is reflected
// It is blind to shadows finer than the parts, and to what elements that were not looked at hide.
struct DividingEstimate {
  struct Channel {
    std::string name;
    double largest = 0;                  // radiosity of an element
    std::optional<double> pointwise{};   // nothing: why_no_pointwise
    std::optional<double> face_means{};  // nothing: why_no_face_means
    std::string face{};                  // the one whose mean would change most
  };
  std::vector<Channel> channels{};
  std::uint32_t elements = 0;   // that have a row
  std::uint32_t looked_at = 0;  // of these, of which parts were looked at
  std::string why_no_pointwise{}, why_no_face_means{};
  double seconds = 0;  // what it took
};

// What is told of a solution to be estimated for, whatever the dimension.
struct SolvedElements {
  const SceneTable& scene;
  const ExchangeMatrix& matrix;  // by faces or elements
  const RadiositySolution& solution;
  std::span<const LightShares> lights{};  // of the elements of the matrix, one for each light
};

// What a part of an element gathers in each channel, direct light with it.
struct PartSight {
  double share = 1;  // of what was looked at of its element, any multiple
  std::vector<double> irradiance;
};

// What the parts of each sample gather.
using SightsOfParts = std::function<std::vector<std::vector<PartSight>>(std::span<const SampledElement>)>;

// Returns the estimates. sights: of elements to be looked at, `most` at the most; null where the factors of the
// solution are not exact: then there is no pointwise estimate, and it is said why; so where it throws RequestError.
// merging: which elements are merged; it is asked where something is reflected. COST: what these cost, a pass over the
// matrix, and a solution of what is merged.
DividingEstimate estimate_dividing(const SolvedElements& solved, std::uint32_t most, const SightsOfParts& sights,
                                   const std::function<ElementMerging()>& merging);

}  // namespace hottel
