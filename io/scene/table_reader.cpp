#include "io/scene/table_reader.h"

#include <algorithm>

#include "geometry/name.h"
#include "geometry/patch_bases.h"
#include "geometry/scene_names.h"

namespace hottel {
namespace {

// A spectrum that is not negative, and a fraction not above one.
Spectrum read_spectrum_in_range(const JsonValue& value, const Subject& subject, SpectrumKind kind) {
  Spectrum result = read_spectrum(value, subject);
  if (const auto problem = spectrum_problem(result, kind); !problem.empty())
    refuse(value, subject.text() + " " + std::string(problem));
  return result;
}

// What stands beside a flux, and the flux.
struct FluxMembers {
  JsonValue emissivity, temperature, flux;
};

Rational read_positive_emissivity(const JsonValue& value, const std::string& owner, const std::string& where) {
  const Rational emissivity = read_number(value, {owner, "emissivity"});
  if (!(0 < emissivity && emissivity <= 1))
    refuse(value, owner + ": emissivity " + where + " must be above 0, at most 1");
  return emissivity;
}

void read_given_flux(const JsonValue& value, const std::string& owner, const FluxMembers& members, Material& material) {
  if (members.temperature)
    refuse(members.temperature, owner + " has a temperature and a flux: one of them is given, the other comes out",
           {"with a flux hottel solve writes the temperature to temperature.csv"});
  if (!members.emissivity)
    refuse(value, owner + " has a flux but no emissivity",
           {"its temperature follows from both; a face whose flux is 0 may be \"insulated\" instead"});
  for (const auto& [member, key] : {std::pair(members.emissivity, "emissivity"), {members.flux, "flux"}})
    if (member.kind() == JsonKind::kArray) refuse(member, owner + ": " + key + " is one number where a flux is given");
  const Rational emissivity = read_positive_emissivity(members.emissivity, owner, "beside flux");
  set_given_flux(emissivity, read_number(members.flux, {owner, "flux"}), material);
}

template <class Words>
Material read_material(const JsonValue& key, const JsonValue& value, Words& words) {
  const std::string owner = "material " + quoted_name(key.text());
  words.value = value;
  words.owner = owner;
  const auto [about, reflectivity, emission, emissivity, temperature, insulated, flux, solar, two_sided] =
      read_members(value, {owner},
                   std::array<std::string_view, 9>{"about", "reflectivity", "emission", "emissivity", "temperature",
                                                   "insulated", "flux", "solar", "two_sided"});
  words.solar = solar;
  Material material;
  material.name = key.text();
  material.is_two_sided = two_sided && read_boolean(two_sided, {owner, "two_sided"});
  if (about) read_string(about, {owner, "about"});
  if (insulated && read_boolean(insulated, {owner, "insulated"})) {
    if (reflectivity || emission || temperature || flux)
      refuse(value, owner + " is insulated, which is reflectivity 1 and emission 0: it has no other values",
             {"its temperature is what comes out: hottel solve writes temperature.csv"});
    set_insulated(material);
    words.only_then = emissivity;
    return material;
  }
  if ((reflectivity || emission) && (emissivity || temperature))
    refuse(value, owner + " mixes two ways to say what it emits",
           {"give either reflectivity and emission, or emissivity and temperature"});
  if (flux && (reflectivity || emission))
    refuse(value, owner + " has a flux beside reflectivity or emission", {"a flux goes with an emissivity alone"});
  if (temperature && !emissivity) refuse(value, owner + " has a temperature but no emissivity");
  if (flux) {
    read_given_flux(value, owner, {emissivity, temperature, flux}, material);
    return material;
  }
  if (reflectivity)
    material.reflectivity = read_spectrum_in_range(reflectivity, {owner, "reflectivity"}, SpectrumKind::kFraction);
  if (emission) material.emission = read_spectrum_in_range(emission, {owner, "emission"}, SpectrumKind::kQuantity);
  if (emissivity) {
    const Spectrum e = read_spectrum_in_range(emissivity, {owner, "emissivity"}, SpectrumKind::kFraction);
    const Spectrum t =
        temperature ? read_spectrum_in_range(temperature, {owner, "temperature"}, SpectrumKind::kQuantity) : Spectrum();
    set_gray_body(e, t, material);
  }
  return material;
}

bool read_is_thermal(const JsonValue& band, const std::string& owner) {
  const std::string name = read_string(band, {owner, "band"});
  if (name != "solar" && name != "thermal")
    refuse(band, owner + ": band is " + quoted_name(name) + R"(; it may be "solar" or "thermal")");
  return name == "thermal";
}

// Where the keys have "obstruction".
bool is_obstruction(const std::vector<std::string_view>& keys, const std::vector<JsonValue>& members,
                    const std::string& owner) {
  const auto key = std::find(keys.begin(), keys.end(), "obstruction");
  if (key == keys.end()) return false;
  const JsonValue& value = members[static_cast<std::size_t>(key - keys.begin())];
  return value && read_boolean(value, {owner, "obstruction"});
}

// The number as it is typed.
std::string number_text(const JsonValue& value, const Subject& subject) {
  read_number(value, subject);
  return std::string(value.text());
}

}  // namespace

void TableReader::read_materials(const JsonValue& materials) {
  require_kind(materials, JsonKind::kObject, {"materials"});
  for (const auto [key, value] : materials.members()) {
    if (const auto problem = material_name_problem(key.text()); !problem.empty()) refuse(key, problem);
    material_index_.emplace(key.text(), static_cast<std::uint32_t>(table_.materials.size()));
    table_.materials.push_back(read_material(key, value, of_materials_.emplace_back()));
  }
}

void TableReader::read_sky(const JsonValue& sky) {
  const auto [emission, temperature, solar] =
      read_members(sky, {"sky"}, std::array<std::string_view, 3>{"emission", "temperature", "solar"});
  of_sky_ = {sky, "sky", solar, {}};
  if (emission && temperature)
    refuse(sky, "sky has both emission and temperature", {"give one: a temperature T means the emission sigma T^4"});
  if (emission) table_.sky_emission = read_spectrum_in_range(emission, {"sky", "emission"}, SpectrumKind::kQuantity);
  if (temperature)
    table_.sky_emission =
        black_emission(read_spectrum_in_range(temperature, {"sky", "temperature"}, SpectrumKind::kQuantity));
}

void TableReader::read_solar(const BandWords& words, Rational& reflectivity, Rational& emission) const {
  if (!words.solar) return;
  const std::string owner = words.owner + ": solar";
  const auto [of_reflectivity, of_emission] =
      read_members(words.solar, {owner}, std::array<std::string_view, 2>{"reflectivity", "emission"});
  if (of_reflectivity && &words == &of_sky_) refuse(of_reflectivity, "sky: solar has an emission only");
  const auto read = [&](const JsonValue& member, const char* key, SpectrumKind kind) {
    const Spectrum spectrum = read_spectrum_in_range(member, {owner, key}, kind);
    if (!spectrum.is_scalar) refuse(member, owner + ": " + key + " is one number");
    return spectrum.value[0];
  };
  if (of_reflectivity) reflectivity = read(of_reflectivity, "reflectivity", SpectrumKind::kFraction);
  if (of_emission) emission = read(of_emission, "emission", SpectrumKind::kQuantity);
}

void TableReader::refuse_what_needs_bands() const {
  for (const BandWords& words : of_materials_)
    if (words.only_then)
      refuse(words.value, words.owner + " is insulated, which is reflectivity 1 and emission 0: it has no other values",
             {"an emissivity beside it is for two bands, where some material or the sky has \"solar\""});
  for (const BandWords& words : of_lights_)
    if (words.only_then)
      refuse(words.only_then, words.owner + " has a band, and the scene no two: no material and no sky has \"solar\"");
}

void TableReader::settle_bands() {
  const auto says_solar = [](const BandWords& words) { return static_cast<bool>(words.solar); };
  table_.has_bands = says_solar(of_sky_) || std::any_of(of_materials_.begin(), of_materials_.end(), says_solar);
  if (!table_.has_bands) return refuse_what_needs_bands();
  const auto require_scalar = [](const BandWords& words, bool is_scalar) {
    if (!is_scalar)
      refuse(words.value, words.owner + " has a list of three, and the scene two bands, solar and thermal");
  };
  for (std::size_t m = 0; m < of_materials_.size(); ++m) {
    Material& material = table_.materials[m];
    require_scalar(of_materials_[m], material.reflectivity.is_scalar && material.emission.is_scalar);
    Rational reflectivity = 0, emission = 0;
    read_solar(of_materials_[m], reflectivity, emission);
    set_bands(reflectivity, emission, material);
    if (const JsonValue& own = of_materials_[m].only_then)
      material.emissivity = read_positive_emissivity(own, of_materials_[m].owner, "beside insulated");
    material.says_solar = says_solar(of_materials_[m]);
  }
  for (std::size_t m = of_materials_.size(); m < table_.materials.size(); ++m) {  // of meshes
    Material& material = table_.materials[m];
    if (!material.reflectivity.is_scalar || !material.emission.is_scalar)
      throw InputError({table_.file, 0},
                       "material " + quoted_name(material.name) +
                           " of a mesh has three channels, and the scene two bands, solar and thermal");
    set_bands(0, 0, material);
  }
  require_scalar(of_sky_, table_.sky_emission.is_scalar);
  Rational none = 0, of_sky = 0;
  read_solar(of_sky_, none, of_sky);
  table_.sky_emission = in_bands(of_sky, table_.sky_emission.value[0]);
  for (std::size_t k = 0; k < table_.lights.size(); ++k) {
    Light& light = table_.lights[k];
    require_scalar(of_lights_[k], light.power.is_scalar);
    light.power = light.is_thermal ? in_bands(0, light.power.value[0]) : in_bands(light.power.value[0], 0);
  }
}

void TableReader::read_unit(const JsonValue& unit) {
  table_.unit = read_string(unit, {"unit"});
  if (const auto problem = unit_problem(table_.unit); !problem.empty()) refuse(unit, "unit " + std::string(problem));
}

void TableReader::read_list(const JsonValue& list, std::string_view key, const std::string& noun,
                            const std::function<void(const JsonValue&, const std::string&)>& read_item) {
  require_kind(list, JsonKind::kArray, {key});
  std::size_t k = 0;
  for (const JsonValue item : list.items()) read_item(item, noun + "[" + std::to_string(k++) + "]");
}

SceneEntry TableReader::read_entry(const JsonValue& value, const std::string& default_name, std::string_view noun,
                                   std::span<const std::string_view> more) {
  SceneEntry entry;
  entry.value = value;
  entry.name = default_name;
  require_kind(value, JsonKind::kObject, {default_name});
  for (const auto [key, member] : value.members())
    if (key.text() == "name") {
      entry.name = read_string(member, {default_name, "name"});
      if (const auto problem = name_problem(entry.name); !problem.empty())
        refuse(member, default_name + ": the name " + quoted_name(entry.name) + " " + std::string(problem));
    }
  entry.owner = std::string(noun) + " " + quoted_name(entry.name);

  constexpr std::array<std::string_view, 8> kCommon{"name",     "points", "material", "back",
                                                    "elements", "about",  "behind",   "on"};
  std::vector<std::string_view> keys(kCommon.begin(), kCommon.end());
  keys.insert(keys.end(), more.begin(), more.end());
  std::vector<JsonValue> members(keys.size());
  read_members(value, {entry.owner}, keys, members);
  const JsonValue material = members[2], back = members[3], elements = members[4], about = members[5];
  entry.points = members[1];
  entry.behind = members[6];
  entry.on = members[7];
  entry.more.assign(members.begin() + kCommon.size(), members.end());
  require_member(entry.points, "points", value, {entry.owner});
  entry.surface.is_obstruction = is_obstruction(keys, members, entry.owner);
  if (entry.surface.is_obstruction && (material || back))
    refuse(material ? material : back, entry.owner + " is an obstruction: it has no material, on either side");
  if (!entry.surface.is_obstruction) {
    require_member(material, "material", value, {entry.owner});
    entry.surface.material = material_of(material, {entry.owner, "material"});
  }
  require_kind(entry.points, JsonKind::kArray, {entry.owner, "points"});
  if (back) entry.surface.back = material_of(back, {entry.owner, "back"});
  if (elements) entry.surface.elements = read_count(elements, kMaxElements, {entry.owner, "elements"});
  if (about) read_string(about, {entry.owner, "about"});
  if (entry.on) entry.surface.on = base_of(entry.on, entry);

  entry.surface.group = static_cast<std::uint32_t>(table_.groups.size());
  table_.groups.emplace_back(entry.name,
                             entry.behind ? read_behind(entry.behind, {entry.owner, "behind"}) : Behind::kByOutline);
  return entry;
}

std::uint32_t TableReader::base_of(const JsonValue& on, const SceneEntry& entry) {
  if (entry.behind)
    refuse(entry.behind,
           entry.owner + " lies on another surface (\"on\"): it makes nothing solid, and has no \"behind\"");
  const std::string name = read_string(on, {entry.owner, "on"});
  if (const auto [place, is_new] = base_index_.emplace(name, static_cast<std::uint32_t>(table_.bases.size())); !is_new)
    return place->second;
  table_.bases.push_back(side_named(name));
  return static_cast<std::uint32_t>(table_.bases.size()) - 1;
}

Behind read_behind(const JsonValue& value, const Subject& subject) {
  const std::string text = read_string(value, subject);
  if (text == "solid") return Behind::kSolid;
  if (text == "open") return Behind::kOpen;
  refuse(value, subject.text() + " is " + quoted_name(text) + "; it may be \"solid\" or \"open\"");
}

void TableReader::read_lights(const JsonValue& list, const std::function<void(LightEntry)>& read_place) {
  read_list(list, "lights", "light",
            [&](const JsonValue& value, const std::string& name) { read_place(read_light(value, name)); });
}

LightEntry TableReader::read_light(const JsonValue& value, const std::string& default_name) {
  const auto [type, name, position, direction, focus, falloff, power, rotation, path, about, band, irradiance] =
      read_members(value, {default_name},
                   std::array<std::string_view, 12>{"type", "name", "position", "direction", "focus", "falloff",
                                                    "power", "rotation", "path", "about", "band", "irradiance"});
  LightEntry entry;
  Light& light = entry.light;
  light.name = name ? read_string(name, {default_name, "name"}) : default_name;
  light.line = value.line();
  entry.owner = "light " + quoted_name(light.name);
  if (!type) refuse(value, entry.owner + " has no \"type\"", {R"(it may be "point", "spot" or "sun")"});
  const std::string kind = read_string(type, {entry.owner, "type"});
  if (kind != "point" && kind != "spot" && kind != "sun")
    refuse(type, entry.owner + ": type is " + quoted_name(kind) + R"(; it may be "point", "spot" or "sun")");
  light.type = kind == "spot" ? LightType::kSpot : kind == "sun" ? LightType::kSun : LightType::kPoint;
  if (light.is_sun())
    for (const auto& [member, key] :
         {std::pair(position, "position"), {path, "path"}, {power, "power"}, {focus, "focus"}, {falloff, "falloff"}})
      if (member)
        refuse(member, entry.owner + " is a sun, infinitely far away: it has no " + key,
               {"it has a direction and an irradiance, of a surface that faces it, and may have a rotation"});
  if (!light.is_sun() && irradiance) refuse(irradiance, entry.owner + " is no sun: it has no irradiance, but a power");
  if (light.type == LightType::kPoint)
    for (const auto& [member, key] : {std::pair(direction, "direction"), {focus, "focus"}, {falloff, "falloff"}})
      if (member) refuse(member, entry.owner + " is a point light: it has no " + key, {R"(a beam has "type": "spot")"});
  if (light.type != LightType::kPoint) require_member(direction, "direction", value, {entry.owner});
  const char* const how_much = light.is_sun() ? "irradiance" : "power";
  const JsonValue strength = light.is_sun() ? irradiance : power;
  require_member(strength, how_much, value, {entry.owner});
  light.power = read_spectrum_in_range(strength, {entry.owner, how_much}, SpectrumKind::kQuantity);
  of_lights_.push_back({value, entry.owner, {}, band});
  if (band) light.is_thermal = read_is_thermal(band, entry.owner);
  if (focus) light.focus = read_number(focus, {entry.owner, "focus"});
  if (falloff) light.falloff = read_number(falloff, {entry.owner, "falloff"});
  if (about) read_string(about, {entry.owner, "about"});
  if (const std::string problem = light_problem(light); !problem.empty()) refuse(value, entry.owner + ": " + problem);
  if (!path && !light.is_sun()) require_member(position, "position", value, {entry.owner});
  entry.position = position;
  entry.direction = direction;
  entry.rotation = rotation;
  entry.path = path;
  if (!path) return entry;
  const std::string of_path = entry.owner + ": path";
  const auto [points, seconds, closed] =
      read_members(path, {of_path}, std::array<std::string_view, 3>{"points", "seconds", "closed"});
  require_member(points, "points", path, {of_path});
  require_member(seconds, "seconds", path, {of_path});
  require_kind(points, JsonKind::kArray, {of_path, "points"});
  if (points.size() < 2) refuse(points, of_path + " has fewer than two points");
  entry.path_points = points;
  entry.seconds = read_number(seconds, {of_path, "seconds"});
  if (entry.seconds <= 0) refuse(seconds, of_path + ": seconds must be greater than 0");
  entry.is_closed = closed && read_boolean(closed, {of_path, "closed"});
  return entry;
}

void TableReader::read_expectations(const JsonValue& list) {
  read_list(list, "expect", "expectation",
            [this](const JsonValue& value, const std::string& owner) { read_expectation(value, owner); });
}

std::uint32_t TableReader::material_of(const JsonValue& value, const Subject& subject) const {
  require_kind(value, JsonKind::kString, subject);
  if (const auto found = material_index_.find(value.text()); found != material_index_.end()) return found->second;
  refuse(value, subject.text() + " " + quoted_name(value.text()) + " is not defined",
         undefined_material_hints(table_, value.text()));
}

void TableReader::read_expectation(const JsonValue& value, const std::string& owner) {
  const auto [name, kind, quantity, of, at, expected, form, derivation] = read_members(
      value, {owner},
      std::array<std::string_view, 8>{"name", "kind", "quantity", "of", "at", "value", "form", "derivation"});
  require_member(kind, "kind", value, {owner});
  require_member(quantity, "quantity", value, {owner});
  require_member(expected, "value", value, {owner});
  Expectation result;
  result.line = value.line();
  result.kind = read_string(kind, {owner, "kind"});
  result.quantity = read_string(quantity, {owner, "quantity"});
  if (of) {
    require_kind(of, JsonKind::kArray, {owner, "of"});
    for (const JsonValue item : of.items()) result.of.push_back(read_string(item, {owner, "of"}));
  }
  if (name) result.name = read_string(name, {owner, "name"});
  if (at) result.at = number_text(at, {owner, "at"});
  result.value = number_text(expected, {owner, "value"});
  if (form) result.form = read_string(form, {owner, "form"});
  if (derivation) result.derivation = read_string(derivation, {owner, "derivation"});
  table_.expect.push_back(std::move(result));
}

}  // namespace hottel
