// What elements look like in a picture: values, and what is shown where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/scene_table.h"
#include "solver/radiosity/radiosity_solution.h"
#include "viewer/picture/picture_options.h"
#include "viewer/picture/shown_values.h"

namespace hottel {

// A value of each element, and what is shown of values: the value itself, as many channels as it has; or, on a scale,
// its colour as r, g, b in linear light, so that means over pixels are those of light.
//
//   (1) light of two bands is that of the solar one
//   (2) what has no value, black sides and the sky show something of their own
struct ElementPaint3 {
  std::size_t channels = 1;            // of a value
  std::vector<double> values;          // by element and channel; NaN: none
  std::optional<ColourScale> scale;    // of values of one channel
  std::vector<double> unknown, black;  // what is shown of elements without a value, and of sides without a row
  std::vector<double> sky;

  std::size_t shown_channels() const { return sky.size(); }
  std::span<const double> value(std::uint32_t element) const {
    return std::span(values).subspan(element * channels, channels);
  }
  bool has_value(std::uint32_t element) const;
  // Writes what is shown of a value: shown_channels() numbers. COST: some 10 ns.
  void show(std::span<const double> value, std::span<double> shown) const;
};

// The light: radiosities, black sides 0, the sky what it emits.
ElementPaint3 light_paint_3(const SceneTable& scene, const RadiositySolution& solution);

// Colours of a scale.
ElementPaint3 scale_paint_3(const ShownValues& values);

}  // namespace hottel
