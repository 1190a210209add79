#include "geometry/unit_of_length.h"

#include <algorithm>
#include <utility>

#include "geometry/name.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

std::array<double, 3> power_over(const Light& light, const Rational& metres) {
  std::array<double, 3> power;
  for (std::size_t c = 0; c < 3; ++c) power[c] = to_double(Rational(light.power.value[c] / metres));
  return power;
}

std::optional<std::string> unknown_unit_note(const SceneTable& table, const char* areas) {
  if (has_known_unit(table)) return std::nullopt;
  return std::string(areas) + ", as " + quoted_name(table.unit) + " is none of " + kKnownUnits +
         ": nothing can be told in W";
}

}  // namespace

std::optional<Rational> metres_of(std::string_view unit) {
  const std::pair<std::string_view, Rational> known[] = {{"", 1},
                                                         {"m", 1},
                                                         {"mm", Rational(1, 1000)},
                                                         {"cm", Rational(1, 100)},
                                                         {"km", 1000},
                                                         {"in", Rational(127, 5000)},
                                                         {"ft", Rational(381, 1250)}};
  const auto* const found = std::ranges::find(known, unit, &std::pair<std::string_view, Rational>::first);
  return found == std::end(known) ? std::nullopt : std::optional(found->second);
}

Rational metres_per_unit(const SceneTable& table) { return metres_of(table.unit).value_or(1); }

bool has_known_unit(const SceneTable& table) { return metres_of(table.unit).has_value(); }

Rational square_metres_per_unit(const SceneTable& table) {
  const Rational metres = metres_per_unit(table);
  return metres * metres;
}

std::array<double, 3> power_by_typed_distance_2(const SceneTable& table, const Light& light) {
  require_told_lamps(table);
  return power_over(light, light.is_sun() ? Rational(1) : metres_per_unit(table));
}

std::array<double, 3> power_by_typed_distance_3(const SceneTable& table, const Light& light) {
  require_told_lamps(table);
  return power_over(light, light.is_sun() ? Rational(1) : square_metres_per_unit(table));
}

std::string untold_lamp(const SceneTable& table) {
  if (has_known_unit(table)) return "";
  for (const Light& light : table.lights)
    if (!light.is_sun() && std::ranges::any_of(light.power.value, [](const Rational& power) { return power > 0; }))
      return "light " + quoted_name(light.name) + " cannot be told in W/m²: the unit of length " +
             quoted_name(table.unit) + " is none of " + kKnownUnits;
  return "";
}

void require_told_lamps(const SceneTable& table) {
  if (std::string problem = untold_lamp(table); !problem.empty()) throw RequestError(std::move(problem));
}

std::optional<std::string> unknown_unit_note_2(const SceneTable& table) {
  return unknown_unit_note(table, ("areas are lengths in " + table.unit).c_str());
}

std::optional<std::string> unknown_unit_note_3(const SceneTable& table) {
  return unknown_unit_note(table, ("areas are in " + table.unit + "²").c_str());
}

}  // namespace hottel
