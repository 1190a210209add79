// How a face reflects and emits.
#pragma once

#include <array>
#include <string>

#include "kernel/rational.h"

namespace hottel {

// A quantity per channel, exact. A scalar holds for every channel.
//
//   (1) equal where the three values are: is_scalar says how it was given, and is not compared
//   (2) the default is the scalar 0
struct Spectrum {
  std::array<Rational, 3> value{0, 0, 0};
  bool is_scalar = true;

  static Spectrum scalar(const Rational& v) { return {{v, v, v}, true}; }
  bool is_zero() const { return value[0] == 0 && value[1] == 0 && value[2] == 0; }
  friend bool operator==(const Spectrum& a, const Spectrum& b) { return a.value == b.value; }
};

// A diffuse material: 0 <= reflectivity <= 1 in every channel, emission >= 0 [W/m in 2D, W/m² in 3D]. The readers
// check these ranges. Emissivity e and temperature T are read as reflectivity 1 - e and emission e sigma T⁴, exactly.
//
//   (1) the default is black and emits nothing
struct Material {
  std::string name;
  Spectrum reflectivity;
  Spectrum emission;

  // The name is not compared: two materials are equal when they act alike.
  friend bool operator==(const Material& a, const Material& b) {
    return a.reflectivity == b.reflectivity && a.emission == b.emission;
  }
};

}  // namespace hottel
