// What a picture of a solution shows, as a value of each element.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/scene_table.h"
#include "solver/radiosity/oriented_light.h"
#include "solver/radiosity/radiosity_solution.h"
#include "viewer/picture/fitted_scale.h"
#include "viewer/picture/picture_options.h"

namespace hottel {

// kLight: the light itself, in its colours. All others: one number of each element, as a colour of a scale.
enum class Quantity : unsigned char { kLight, kRadiosity, kIrradiance, kNet, kTemperature, kFactor };

// What is asked for.
struct Shown {
  Quantity quantity = Quantity::kLight;
  std::string toward{};                  // of kFactor: "sky", or what `factor:` names
  std::optional<std::size_t> channel{};  // of radiosity, irradiance, net; nothing: the mean of all
  AskedScale scale{};
  bool is_of_band = false;  // the channel was asked for as a band: solar or thermal

  bool is_light() const { return quantity == Quantity::kLight; }
  friend bool operator==(const Shown&, const Shown&) = default;
};

// Returns what a word of --show asks for: light, radiosity, irradiance, net, temperature, sky, or factor:NAME. Throws
// UnknownName for other words.
Shown shown_by(const std::string& word);

// The words that shown_by takes: "radiosity, irradiance, ..., factor:NAME (view factor to a face, ...)", without the
// light; and those of them that a grid can show.
std::string words_to_show();
std::string words_to_show_at_points();

// Returns the ends of a scale that a text asks for: LOW:HIGH, LOW:HIGH:log or log; either end may be left out. Throws
// UsageError for other texts.
AskedScale scale_by(const std::string& text);

// Sets the channel by its name: r, g, b, solar or thermal. Throws UnknownName for other words.
void choose_channel(Shown& shown, const std::string& word);

// Throws UsageError where a scene has nothing of the kind: a temperature where no face is warm by its material,
// insulated or of a given net flux, a channel where there is one only, or of what has none; for a scale whose ends are
// in the wrong order, or a logarithmic one of a net flux or from 0 or less; UnknownName for names that are not there.
// COST: some of the names.
void require_shown(const Shown& shown, const SceneTable& scene);

// Values as a picture shows them.
struct ShownValues {
  std::vector<std::optional<double>> elements;  // by element of the matrix; nothing for those without a row or a value
  std::vector<double> areas;                    // by element; none: all count alike
  ColourScale scale;                            // fitted to the values, or as asked
  double least = 0, greatest = 0;               // of all values (fitted_scale)
  std::string title;                            // of the scale, with unit and range: "irradiance [W/m²]: 1.2 to 34.5"
  std::string name, unit;                       // "irradiance", "W/m²"; "1" where there is none

  // The values of elements, NaN where there is none.
  std::vector<double> numbers() const;
};

// Returns the values of a quantity that is not the light.
//
//   (1) radiosity, irradiance and net are the doubles of radiosity.csv, where there are three channels and none was
//       asked for their mean, of two bands their sum
//   (2) a temperature is that of the surface, which its material says (gray_temperature); where a face neither absorbs
//       nor emits (reflectivity 1), the one it would have by itself: that of a black body with its radiosity; of
//       a given net flux that which solve writes (ElementTemperatures). Faces whose material has no temperature have no
//       value
//   (3) a factor is the double of factors.csv from the element to the sky, to the face NAME or NAME:back, or the sum of
//       those to the fronts (with ":back" the backs) of all that surfaces_matching() finds: of a group, or by a pattern
//   (4) the colours of a net flux part at 0: faces that gain and faces that lose are told apart at sight
//   (5) the scale is that of fitted_scale(), by the areas of elements: the same whatever a camera sees. Net fluxes
//       below 1e-9 of the largest radiosity are 0 to it
//   (6) the title has the ends of the scale, and where it cuts some off how far the values go
//
// REQUIRES what require_shown takes; the solution of this matrix, of this scene.
ShownValues shown_values(const Shown& shown, const SceneTable& scene, const ExchangeMatrix& matrix,
                         const RadiositySolution& solution);

// Returns what ShownValues calls so of radiosity, irradiance and net; nothing for other names.
std::optional<Shown> shown_called(const std::string& name, const std::vector<std::string>& channel_names);

// Whether a quantity is one of points too, so that a grid can show it: irradiance, temperature (the mean radiant one),
// and the view factor to the sky.
bool is_of_points(const Shown& shown);

// Whether it is one of points for areas that look some way: irradiance, and the view factor to the sky. A volume has
// none.
bool needs_a_side(const Shown& shown);

// Makes two scales, of values on faces and at points, one that is fitted to both: all faces together count as much as
// all points. The title of the first tells it.
void share_scale(const Shown& shown, ShownValues& faces, ShownValues& points);

// Returns the values of such a quantity at points, in the place of elements: of irradiance that on the area at each, by
// the channel that was asked for, else the mean of three channels, the sum of two bands. Nothing where there is no
// light to tell. Scale and title as shown_values() has them. REQUIRES is_of_points(shown); lights of these channels.
ShownValues shown_at_points(const Shown& shown, const std::vector<OrientedLight>& lights,
                            const std::vector<std::string>& channel_names);

}  // namespace hottel
