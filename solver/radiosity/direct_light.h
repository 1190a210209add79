// Light that comes from no element: how the power of lights is spread over the elements, as sources of a system.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/scene_table.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/radiosity_sources.h"

namespace hottel {

// Which shares of its power a light sends to what it meets first: each element, black backs among them, and the sky.
//
//   (1) numbers within these bounds, not below 0, sum to 1
//   (2) a light in a solid sends nothing out: all shares are 0, and `solid` is the group that makes it
//   (3) shares of elements by another test than kExact are estimates: no bounds of anything, and (1) is not true of
//       them
//   (4) of a sun they are areas: of what it lights of each element, as its rays see it, so that irradiance times share
//       is what arrives there. They sum to `whole`; what passes by, to the sky, has no number, and its share is 0
//       [m²; in the plane m]
struct LightShares {
  std::vector<Enclosure> of_element;  // by element
  Enclosure sky{0, 0};
  std::string solid;  // empty: it is in none
  LightTest test = LightTest::kExact;
  Enclosure whole{1, 1};  // what the shares by the exact test sum to
};

// The power of lights that meets first what has no row, within bounds, by channel: of black backs and of the sky, which
// is matrix.sky(), wherever there is any. What is lost in solids is in none.
// REQUIRES one entry of `shares` for each light, each of the elements of the matrix.
std::map<std::uint32_t, std::array<RationalEnclosure, 3>> power_without_rows(const ExchangeMatrix& matrix,
                                                                             std::span<const Light> lights,
                                                                             std::span<const LightShares> shares);

// Adds what lights send to the sources of a matrix: D_i = sum over lights of share times power over area, within
// bounds; and what meets no row, to RadiositySources::besides. Channels are told apart where the power of a light is.
// What estimated shares lack of the power is unaccounted for.
// Throws RequestError, naming an element, where the light of lamps is too much for doubles. REQUIRES one entry of
// `shares` for each light, each of the elements of the matrix.
void add_lights(const ExchangeMatrix& matrix, std::span<const Light> lights, std::span<const LightShares> shares,
                RadiositySources& sources);

// The sources of a scene: what its materials and its sky emit, and its lights.
RadiositySources sources_of(const ExchangeMatrix& matrix, const SceneTable& scene, std::span<const LightShares> lights);

// What is to be said of a light in a solid.
std::string lost_light_text(const Light& light, const LightShares& shares);
// Returns a text for each light in a solid, and for each lamp that lights no row, as one that is outside of a room.
std::vector<std::string> lost_light_notes(const ExchangeMatrix& matrix, std::span<const Light> lights,
                                          std::span<const LightShares> shares);

// What is to be said of estimated shares, all by one test; nothing where there are none.
std::optional<std::string> estimated_light_note(std::span<const Light> lights, std::span<const LightShares> shares);

}  // namespace hottel
