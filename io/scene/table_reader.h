// What the readers of scenes in the plane and in space have in common: all of a scene but its shape.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "geometry/scene_table.h"
#include "io/scene/exact_json.h"
#include "io/scene/json_fields.h"

namespace hottel {

// The members that a scene may have, in this order; what belongs to the other dimension is refused by its reader.
inline constexpr std::array<std::string_view, 15> kSceneKeys{"hottel",    "dimension", "about",  "materials", "edges",
                                                             "polylines", "polygons",  "mesh",   "sky",       "closed",
                                                             "grid",      "camera",    "lights", "expect",    "unit"};

// One item of "edges", "polylines" or "polygons", but for its points.
struct SceneEntry {
  JsonValue value, points, behind, on;
  std::string name;
  std::string owner;            // for messages: "edge 'lamp'"
  std::vector<JsonValue> more;  // members beyond those that all have, in the order of the keys asked for
  Surface surface;              // without its name and line
};

// One item of "lights", but for its geometry.
struct LightEntry {
  Light light;
  std::string owner;                              // for messages: "light 'torch'"
  JsonValue position, direction, rotation, path;  // as far as they are there
  JsonValue path_points;                          // of a path: a list
  Rational seconds = 1;                           // of a path
  bool is_closed = false;
};

// Fills the table of a scene. Every function throws InputError with file and line for what
// docs/scene_format.md does not allow.
//
//   (1) numbers are exact: what was typed, as a rational
//   (2) materials and groups are numbered in the order in which they were read
// Materials come first: an entry that names one that was not read is refused, with the names of those that were.
class TableReader {
 public:
  // REQUIRES that the table outlives this.
  explicit TableReader(SceneTable& table) : table_(table) {}

  // Appends the materials of an object. Reflectivities and emissivities are from 0 to 1, emissions and temperatures not
  // below 0; a gray body of emissivity e and temperature T has reflectivity 1 - e and emission e sigma T⁴; an insulated
  // material has reflectivity 1 and no other key; a flux of any sign stands beside an emissivity above 0 alone, both of
  // one number. REQUIRES that the document outlives this: names are looked up in its
  // texts.
  void read_materials(const JsonValue& materials);
  // Sets the emission of the sky, which is not below 0, or sigma T⁴ of its temperature; without one it stays dark.
  void read_sky(const JsonValue& sky);
  // Makes all spectra those of two bands, where some material or the sky says "solar"; called once all else is read.
  //
  //   (1) what stands outside "solar" is thermal; a material that says nothing of it is black there and emits nothing;
  //       lights are solar unless they say "band": "thermal"
  //   (2) refuses lists of three then; where nothing says "solar", a "band", and an emissivity of an insulated material
  void settle_bands();
  // Sets what one unit of length is called.
  void read_unit(const JsonValue& unit);
  // Appends what the scene says of its own answers: numbers are checked to be numbers and kept as typed.
  void read_expectations(const JsonValue& list);

  // Calls read_item(item, "edge[k]") for each item of a list, k from 0, in order; `key` and `noun` are for messages.
  // Refuses what is no list.
  void read_list(const JsonValue& list, std::string_view key, const std::string& noun,
                 const std::function<void(const JsonValue&, const std::string&)>& read_item);

  // Returns the index of the material of that name; refuses one that is not defined.
  std::uint32_t material_of(const JsonValue& value, const Subject& subject) const;

  // Reads an item and makes a group of its name. Keys beyond name, points, material, back, elements, about, behind and
  // on are those of `more`.
  //
  //   (1) `points` and `material` must be there; points are a list, which the caller reads. Where `more` has
  //       "obstruction" and it is true, `material` and `back` must not be there
  //   (2) an item without a name has the default one; a name that cannot be one is refused, and the reason is told
  //   (3) elements are from 1 to kMaxElements; "behind" is "solid" or "open", and left to the outline where
  //       it is not given. "on" is the name of a base; it does not stand beside "behind"
  SceneEntry read_entry(const JsonValue& value, const std::string& default_name, std::string_view noun,
                        std::span<const std::string_view> more = {});

  // Reads an item of "lights" but for what depends on the dimension.
  //
  //   (1) `type` and `power` must be there, of a spot `direction` too; a point light has neither direction nor focus
  //       nor falloff. There is a `position` or a `path`. Of a sun `direction` and `irradiance` must be there, and none
  //       of `position`, `path`, `power`, `focus` and `falloff` may be
  //   (2) a light without a name is called light[k]; its name is one that a surface could have
  LightEntry read_light(const JsonValue& value, const std::string& default_name);
  // Appends the lights of a list: read_place(entry) makes of an entry where it is, and puts both into the scene.
  void read_lights(const JsonValue& list, const std::function<void(LightEntry)>& read_place);

 private:
  // What a material, the sky or a light says that matters where there are two bands.
  struct BandWords {
    JsonValue value;      // all of it
    std::string owner;    // for messages
    JsonValue solar;      // "solar", as far as it is there
    JsonValue only_then;  // what goes with two bands alone: "band", an emissivity of an insulated material
  };
  std::uint32_t base_of(const JsonValue& on, const SceneEntry& entry);
  void refuse_what_needs_bands() const;
  void read_solar(const BandWords& words, Rational& reflectivity, Rational& emission) const;
  void read_expectation(const JsonValue& value, const std::string& owner);

  SceneTable& table_;
  std::unordered_map<std::string_view, std::uint32_t> material_index_;
  std::unordered_map<std::string, std::uint32_t> base_index_;
  std::vector<BandWords> of_materials_, of_lights_;  // in their order
  BandWords of_sky_{};
};

// Reads what is "behind" a group: "solid" or "open". Throws InputError.
Behind read_behind(const JsonValue& value, const Subject& subject);

}  // namespace hottel
