// What the unit of length of a scene is worth: the one place where what is typed and the SI meet.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/scene_table.h"
#include "kernel/rational.h"

namespace hottel {

// Returns how many metres a unit of that name is, exactly: m, mm, cm, km, in, ft, and no name, which is m. Nothing for
// any other name.
std::optional<Rational> metres_of(std::string_view unit);

// Returns how many metres the unit of a scene is; 1 where nobody can tell: its lengths and areas are in its own unit
// then, and has_known_unit() is false.
Rational metres_per_unit(const SceneTable& table);
bool has_known_unit(const SceneTable& table);

// What areas are multiplied by to be in m²; lengths of the plane, which are its areas, by metres_per_unit().
Rational square_metres_per_unit(const SceneTable& table);

// The power of a lamp over what a distance in the unit of the scene is in metres, to the power of 1 in the plane and 2
// in space: over a distance as typed, to the same power, it makes W/m². Of a sun its irradiance, which no length
// changes.
// Throws RequestError where it takes the unit and nobody can tell that (require_told_lamps).
std::array<double, 3> power_by_typed_distance_2(const SceneTable& table, const Light& light);
std::array<double, 3> power_by_typed_distance_3(const SceneTable& table, const Light& light);

// Returns why the light of a lamp cannot be told, naming the lamp and the unit; empty where it can: there are suns
// only, or lamps without power, or the unit is known.
std::string untold_lamp(const SceneTable& table);
// Throws RequestError with untold_lamp() where there is one.
void require_told_lamps(const SceneTable& table);
inline constexpr const char* kKnownUnits = "m, mm, cm, km, in or ft";

// What is to be said of a unit that nobody knows: what areas are in, and that nothing is told in W. Nothing where it is
// known.
std::optional<std::string> unknown_unit_note_2(const SceneTable& table);
std::optional<std::string> unknown_unit_note_3(const SceneTable& table);

}  // namespace hottel
