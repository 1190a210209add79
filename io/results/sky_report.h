// What is told of skies that come from the sums of rows, as text for people and as JSON.
#pragma once

#include <string>

#include "geometry/exchange_report.h"

namespace hottel {

// "the sky of 377 rows is what their other pairs leave: ...", with what these state that they are off, what they may
// be, and what integrals say; one line, and one more where rows differ by more than is stated.
std::string sky_text(const SkyByClosure& sky);
// The same as one line of JSON: an object.
std::string sky_json(const SkyByClosure& sky);

}  // namespace hottel
