// Materials changed by a key, or as they are typed.
#pragma once

#include <string>
#include <string_view>

#include "geometry/material.h"

namespace hottel {

// Whether a name is one that edit_material takes: "less reflectivity", "more reflectivity", "less emission", "more
// emission", "colour".
bool is_material_edit(std::string_view name);

// Changes a material as it is called: reflectivity by 0.05, within 0 and 1; emission by a quarter, to two digits, from
// nothing to 1 and below a thousandth to nothing; the colour to the next of six paints, in which what emits emits as
// strongly. REQUIRES is_material_edit(name).
void edit_material(Material& material, std::string_view name);

// Makes an emission or a power a quarter more (sign > 0) or less, to two digits, as edit_material does.
void step_quantity(Spectrum& quantity, int sign);

// Gives an emission or a power the colour of the next of six paints after the one that it has, as strong as it was.
// What is 0 stays 0.
void next_colour(Spectrum& quantity);

// Returns a spectrum as it is typed: "0.5", or "1 0.9 0.8", in short decimals.
std::string spectrum_text(const Spectrum& spectrum);

// Returns what read_material reads: "reflectivity 0.5; emission 1 0.9 0.8".
std::string material_text(const Material& material);

// Reads that into a material, one of the two or both; returns what is wrong with it. A number that is typed as it is
// shown keeps all the digits that it has.
std::string read_material(const std::string& text, Material& material);

}  // namespace hottel
