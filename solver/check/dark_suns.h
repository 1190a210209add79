// Suns that shine on nothing.
#pragma once

#include <string>

#include "geometry/exchange_matrix.h"
#include "solver/radiosity/direct_light.h"

namespace hottel {

// What is to be said of a sun that has an irradiance and lights no face with a material; empty where it does, and for
// all other lights. REQUIRES its shares, of the elements of the matrix.
std::string dark_sun_text(const Light& light, const LightShares& shares, const ExchangeMatrix& matrix);

inline constexpr const char* kDarkSunSuggestion =
    "its direction is the one in which its rays travel, away from the sun; turn it around where that was not meant";

}  // namespace hottel
