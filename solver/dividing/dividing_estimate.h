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

// The channels, with the largest radiosity of each; nothing is estimated yet.
DividingEstimate estimate_to_be(const SolvedElements& solved);

// True iff some face with a material reflects; else set_nothing_reflected() is all that there is to know.
bool reflects(const SceneTable& scene);
void set_nothing_reflected(DividingEstimate& estimate);

// Returns elements to be looked at, `most` at the most (sampled_elements). Of two halves that gather H in the mean none
// is further from it than H: so they are drawn by the square of what their element reflects, and no one of them says
// more than all others together.
std::vector<SampledElement> elements_to_look_at(const SolvedElements& solved, std::uint32_t most);

// Sets the pointwise estimates. sights: the parts of each sample. REQUIRES the elements of the samples to have rows.
void set_pointwise(const SolvedElements& solved, std::span<const SampledElement> samples,
                   std::span<const std::vector<PartSight>> sights, DividingEstimate& estimate);

// Sets those of face means, or why there are none. COST: a pass over the matrix, and a solution of what is merged.
void set_face_means(const SolvedElements& solved, const ElementMerging& merging, DividingEstimate& estimate);

}  // namespace hottel
