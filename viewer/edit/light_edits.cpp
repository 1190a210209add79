#include "viewer/edit/light_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "kernel/decimal.h"
#include "kernel/support/failure.h"
#include "kernel/support/trimmed.h"
#include "viewer/edit/decimals.h"
#include "viewer/edit/material_edits.h"
#include "viewer/edit/typed_numbers.h"

namespace hottel {
namespace {

Rational two_digits(const Rational& value) { return rounded_decimal(value, 2 - decades(value)); }

void step_focus(Light& light, int sign) {
  if (light.is_sun()) return;
  const Rational widest = light.falloff > 0 ? 90 : 180, narrowest(1, 10);
  const Rational from = std::min(light.focus, widest);
  light.focus = std::clamp(two_digits(sign > 0 ? from * 5 / 4 : from * 4 / 5), narrowest, widest);
  light.type = LightType::kSpot;
}

// One part of what is typed: a word, and what it says.
struct Part {
  std::string word, values;
};

std::vector<Part> parts_of(const std::string& text) {
  std::vector<Part> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    const std::string part(trimmed(std::string_view(text).substr(begin, end - begin), " "));
    begin = end + 1;
    if (part.empty()) continue;
    const std::size_t blank = std::min(part.find(' '), part.size());
    parts.push_back({part.substr(0, blank), part.substr(blank)});
  }
  return parts;
}

std::string texts_of(std::span<const Rational> numbers) {
  std::string text;
  for (const Rational& number : numbers) text += (text.empty() ? "" : " ") + short_text(number);
  return text;
}

// Reads as many numbers as there are, but for those that are typed as they are shown.
std::string read_numbers(const std::string& text, std::span<Rational> numbers) {
  if (text == " " + texts_of(numbers)) return "";
  const Typed<std::vector<Rational>> typed = typed_numbers(text);
  if (!typed.value) return typed.problem;
  if (typed.value->size() != numbers.size())
    return fmt::format("takes {} number{}, not {}", numbers.size(), numbers.size() == 1 ? "" : "s",
                       typed.value->size());
  std::ranges::copy(*typed.value, numbers.begin());
  return "";
}

std::string read_part(const Part& part, Light& light, std::span<Rational> rotation) {
  if (part.word == "power" || part.word == "irradiance") {
    if (part.values == " " + spectrum_text(light.power)) return "";
    const Typed<Spectrum> typed = typed_spectrum(part.values, SpectrumKind::kQuantity);
    if (typed.value) light.power = *typed.value;
    return typed.problem;
  }
  if (!light.is_sun()) light.type = LightType::kSpot;
  if (part.word == "focus") return read_numbers(part.values, {&light.focus, 1});
  if (part.word == "falloff") return read_numbers(part.values, {&light.falloff, 1});
  return read_numbers(part.values, rotation);
}

}  // namespace

void edit_light(Light& light, std::string_view name) {
  HOTTEL_REQUIRE(is_material_edit(name));
  const int sign = name.starts_with("more") ? 1 : -1;
  if (name.ends_with("reflectivity")) return step_focus(light, sign);
  name == "colour" ? next_colour(light.power) : step_quantity(light.power, sign);
}

void edit_light(Light& light, std::span<Rational> rotation, std::string_view name) {
  if (name != "spin") return edit_light(light, name);
  if (light.type == LightType::kPoint) return;
  const bool turns = std::ranges::any_of(rotation, [](const Rational& rate) { return rate != 0; });
  std::ranges::fill(rotation, Rational(0));
  if (!turns) rotation.back() = kSpin;
}

bool is_light_edit(std::string_view name) { return name == "spin" || is_material_edit(name); }

std::string why_light_stays(std::string_view name) {
  return name == "spin" ? "a point light has no axis to turn" : "it goes no further";
}

std::string light_text(const Light& light, std::span<const Rational> rotation) {
  if (light.is_sun()) return fmt::format("irradiance {}; rotation {}", spectrum_text(light.power), texts_of(rotation));
  std::string text = "power " + spectrum_text(light.power);
  if (light.type == LightType::kPoint) return text;
  return text + fmt::format("; focus {}; falloff {}; rotation {}", short_text(light.focus), short_text(light.falloff),
                            texts_of(rotation));
}

std::string read_light(const std::string& text, Light& light, std::span<Rational> rotation) {
  Light read = light;
  std::vector<Rational> turning(rotation.begin(), rotation.end());
  for (const Part& part : parts_of(text)) {
    if (light.is_sun() && part.word != "irradiance" && part.word != "rotation")
      return "a sun: say 'irradiance' or 'rotation', not '" + part.word + "'";
    if (!light.is_sun() && part.word != "power" && part.word != "focus" && part.word != "falloff" &&
        part.word != "rotation")
      return "say 'power', 'focus', 'falloff' or 'rotation', not '" + part.word + "'";
    if (const std::string problem = read_part(part, read, turning); !problem.empty()) return part.word + ": " + problem;
  }
  if (std::string problem = light_problem(read); !problem.empty()) return problem;
  light = std::move(read);
  std::ranges::copy(turning, rotation.begin());
  return "";
}

}  // namespace hottel
