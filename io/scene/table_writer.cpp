#include "io/scene/table_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_set>
#include <vector>

#include "geometry/face.h"
#include "geometry/gray_temperature.h"
#include "geometry/patch_bases.h"
#include "io/scene/exact_decimal.h"
#include "kernel/decimal.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// A number with more characters than this is written as a string.
constexpr std::size_t kMaxBareNumber = 24;

// The decimal without an exponent, or nothing when it is longer than kMaxBareNumber.
std::optional<std::string> bare_number(const Decimal& d) {
  const std::size_t places = static_cast<std::size_t>(std::labs(d.exponent));
  if (places > kMaxBareNumber || mpz_sizeinbase(d.digits.get_mpz_t(), 10) > kMaxBareNumber + 1) return std::nullopt;
  std::string text = Integer(abs(d.digits)).get_str();
  if (d.exponent >= 0) {
    text.append(places, '0');
  } else {
    if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
    text.insert(text.size() - places, 1, '.');
  }
  if (sgn(d.digits) < 0) text.insert(0, 1, '-');
  if (text.size() > kMaxBareNumber) return std::nullopt;
  return text;
}

std::string spectrum(const Spectrum& s) {
  if (s.is_scalar) return json_number(s.value[0]);
  return fmt::format("[{}, {}, {}]", json_number(s.value[0]), json_number(s.value[1]), json_number(s.value[2]));
}

Spectrum emissivity_of(const Material& m) {
  Spectrum result{{}, m.reflectivity.is_scalar};
  for (std::size_t c = 0; c < result.value.size(); ++c) result.value[c] = 1 - m.reflectivity.value[c];
  return result;
}

// The temperature of a material that, given by it, reads back the same.
std::optional<Spectrum> writable_temperature(const Material& m) {
  if (m.emission.is_zero() || (m.emission.is_scalar && !m.reflectivity.is_scalar)) return std::nullopt;
  const auto temperature = gray_temperature(m);
  if (!temperature) return std::nullopt;
  Spectrum result = Spectrum::scalar(*temperature);
  result.is_scalar = m.emission.is_scalar || !m.reflectivity.is_scalar;
  return result;
}

// What stands outside "solar".
Spectrum thermal_part(const Spectrum& of, bool has_bands) {
  return has_bands ? Spectrum::scalar(of.value[kThermalBand]) : of;
}
Material thermal_part(Material material) {
  material.reflectivity = thermal_part(material.reflectivity, material.has_bands);
  material.emission = thermal_part(material.emission, material.has_bands);
  material.has_bands = false;
  return material;
}

std::string solar_member(const Rational& reflectivity, const Rational& emission) {
  std::string text;
  if (reflectivity != 0) text += fmt::format("\"reflectivity\": {}", json_number(reflectivity));
  if (emission != 0) text += fmt::format("{}\"emission\": {}", text.empty() ? "" : ", ", json_number(emission));
  return fmt::format("\"solar\": {{{}}}", text);
}

// By material: whether it is two-sided, and read as that leaves every surface as it is.
std::vector<char> two_sided_materials(const SceneTable& table) {
  std::vector<char> result;
  for (const Material& material : table.materials) result.push_back(material.is_two_sided ? 1 : 0);
  for (const Surface& surface : table.surfaces)
    if (!surface.is_obstruction && !surface.on && !surface.back) result[surface.material] = 0;
  return result;
}

void write_materials(const SceneTable& table, std::string& out) {
  if (table.materials.empty()) return;
  std::unordered_set<std::string> names;
  const std::vector<char> says_two_sided = two_sided_materials(table);
  JsonBlock block(out, "materials", '{', '}');
  for (const Material& whole : table.materials) {
    const Material m = thermal_part(whole);
    HOTTEL_REQUIRE(!m.name.empty() && names.insert(m.name).second);
    std::string members;
    const auto add = [&](const char* key, const Spectrum& value) {
      if (value.is_zero() && value.is_scalar) return;
      members += fmt::format("{}\"{}\": {}", members.empty() ? "" : ", ", key, spectrum(value));
    };
    if (m.is_insulated()) {
      members = "\"insulated\": true";
      if (m.emissivity) members += fmt::format(", \"emissivity\": {}", json_number(*m.emissivity));
    } else if (m.has_given_flux()) {
      members =
          fmt::format("\"emissivity\": {}, \"flux\": {}", json_number(*m.emissivity), json_number(m.emission.value[0]));
    } else if (const auto temperature = writable_temperature(m)) {
      add("emissivity", emissivity_of(m));
      add("temperature", *temperature);
    } else {
      add("reflectivity", m.reflectivity);
      add("emission", m.emission);
    }
    if (whole.says_solar)
      members += (members.empty() ? "" : ", ") +
                 solar_member(whole.reflectivity.value[kSolarBand], whole.emission.value[kSolarBand]);
    if (says_two_sided[static_cast<std::size_t>(&whole - table.materials.data())] != 0)
      members += members.empty() ? "\"two_sided\": true" : ", \"two_sided\": true";
    block.add(fmt::format("{}: {{{}}}", json_string(m.name), members));
  }
  block.end();
}

}  // namespace

std::string json_string(const std::string& text) {
  const bool is_plain =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7F && c != '"' && c != '\\'; });
  return is_plain ? fmt::format("\"{}\"", text) : nlohmann::json(text).dump();
}

std::string json_number(const Rational& value) {
  if (value.get_den() == 1 && value.get_num().fits_slong_p()) return std::to_string(value.get_num().get_si());
  std::string text = "";
  if (const auto d = exact_decimal(value)) {
    if (auto bare = bare_number(*d)) return *std::move(bare);
    if (std::labs(d->exponent) <= kMaxNumberExponent) text = fmt::format("{}e{}", d->digits.get_str(), d->exponent);
  }
  const std::string fraction = to_string(value);
  if (text.empty() || text.size() > fraction.size()) text = fraction;
  if (text.size() > kMaxNumberLength)
    throw RequestError(
        fmt::format("a number of {} characters, about {}, does not fit into a scene file: at most {} are allowed",
                    text.size(), decimal_text(value), kMaxNumberLength));
  return fmt::format("\"{}\"", text);
}

JsonBlock::JsonBlock(std::string& out, const std::string& key, char open, char close) : out_(out), close_(close) {
  out_ += fmt::format(",\n  \"{}\": {}", key, open);
}

void JsonBlock::add(const std::string& entry) {
  out_ += is_empty_ ? "\n    " : ",\n    ";
  out_ += entry;
  is_empty_ = false;
}

void JsonBlock::end() {
  if (!is_empty_) out_ += "\n  ";
  out_ += close_;
}

void write_head(const SceneTable& table, int dimension, std::string& out) {
  out += fmt::format("{{\n  \"hottel\": 1,\n  \"dimension\": {}", dimension);
  if (!table.about.empty()) out += fmt::format(",\n  \"about\": {}", json_string(table.about));
  if (!table.unit.empty()) out += fmt::format(",\n  \"unit\": {}", json_string(table.unit));
  write_materials(table, out);
}

void write_sky(const SceneTable& table, std::string& out) {
  if (!table.sky_emission.is_zero() || !table.sky_emission.is_scalar) {
    Material black;
    black.emission = thermal_part(table.sky_emission, table.has_bands);
    const auto temperature = writable_temperature(black);
    out += fmt::format(",\n  \"sky\": {{\"{}\": {}{}}}", temperature ? "temperature" : "emission",
                       spectrum(temperature ? *temperature : black.emission),
                       table.has_bands ? ", " + solar_member(0, table.sky_emission.value[kSolarBand]) : "");
  }
  if (table.closed) out += ",\n  \"closed\": true";
}

void write_lights(const SceneTable& table, const std::function<std::string(std::size_t)>& place_members,
                  std::string& out) {
  if (table.lights.empty()) return;
  JsonBlock block(out, "lights", '[', ']');
  for (std::size_t k = 0; k < table.lights.size(); ++k) {
    const Light& light = table.lights[k];
    const char* const type = light.is_sun() ? "sun" : light.type == LightType::kSpot ? "spot" : "point";
    std::string text =
        fmt::format("{{\"type\": \"{}\", \"name\": {}, {}", type, json_string(light.name), place_members(k));
    if (light.focus != 180) text += fmt::format(", \"focus\": {}", json_number(light.focus));
    if (light.falloff != 0) text += fmt::format(", \"falloff\": {}", json_number(light.falloff));
    if (light.is_thermal) text += ", \"band\": \"thermal\"";
    const std::size_t band = light.is_thermal ? kThermalBand : kSolarBand;
    const Spectrum power = table.has_bands ? Spectrum::scalar(light.power.value[band]) : light.power;
    block.add(text + fmt::format(", \"{}\": {}}}", light.is_sun() ? "irradiance" : "power", spectrum(power)));
  }
  block.end();
}

void write_expectations(const SceneTable& table, std::string& out) {
  if (table.expect.empty()) return;
  JsonBlock block(out, "expect", '[', ']');
  for (const Expectation& e : table.expect) {
    std::string text = "{";
    if (!e.name.empty()) text += fmt::format("\"name\": {}, ", json_string(e.name));
    text += fmt::format("\"kind\": {}, \"quantity\": {}", json_string(e.kind), json_string(e.quantity));
    for (std::size_t k = 0; k < e.of.size(); ++k)
      text += fmt::format("{}{}", k == 0 ? ", \"of\": [" : ", ", json_string(e.of[k]));
    if (!e.of.empty()) text += "]";
    if (!e.at.empty()) text += fmt::format(", \"at\": {}", json_string(e.at));
    text += fmt::format(", \"value\": {}", json_string(e.value));
    if (!e.form.empty()) text += fmt::format(", \"form\": {}", json_string(e.form));
    if (!e.derivation.empty()) text += fmt::format(", \"derivation\": {}", json_string(e.derivation));
    block.add(text + "}");
  }
  block.end();
}

std::string surface_members(const SceneTable& table, const Surface& surface) {
  std::string text = surface.is_obstruction
                         ? "\"obstruction\": true"
                         : fmt::format("\"material\": {}", json_string(table.materials[surface.material].name));
  if (surface.back) text += fmt::format(", \"back\": {}", json_string(table.materials[*surface.back].name));
  if (const Behind behind = table.groups[surface.group].behind; behind != Behind::kByOutline)
    text += behind == Behind::kSolid ? ", \"behind\": \"solid\"" : ", \"behind\": \"open\"";
  if (const std::string& body = table.groups[surface.group].body; !body.empty())
    text += ", \"body\": " + json_string(body);
  if (surface.on) text += ", \"on\": " + json_string(side_text(table.bases[*surface.on]));
  if (surface.elements != 1) text += fmt::format(", \"elements\": {}", surface.elements);
  return text;
}

}  // namespace hottel
