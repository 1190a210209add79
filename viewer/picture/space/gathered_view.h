// What a camera sees, its light gathered point by point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/scene.h"
#include "solver/space/light/gathered_light.h"
#include "solver/space/light/scene_lights.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/shown_values.h"
#include "viewer/picture/space/element_paint.h"
#include "viewer/picture/space/pixel_values.h"

namespace hottel {

// How what is shown of a face follows from the irradiance of a point of it, element by element:
// value = constant + per_irradiance * irradiance.
struct Responses3 {
  std::size_t channels = 1, of_light = 1;  // of values, and of the irradiance
  std::vector<double> constant;            // by element and channel
  std::vector<double> per_irradiance;      // by element, channel and channel of the light

  // Writes the value at a point of an element.
  void value(std::uint32_t element, std::span<const double> irradiance, std::span<double> result) const;
};

// What an element sends out besides what it reflects; of a face from which a flux is withdrawn it is below 0.
double sent_by_itself_3(const ElementRadiosity& element);

// The radiosity in its channels: emission, and reflectivity times irradiance; of two bands the solar one.
Responses3 light_responses_3(const RadiositySolution& solution);
// The irradiance in its channels; of two bands both.
Responses3 irradiance_responses_3(const RadiositySolution& solution);
// Throws UsageError for quantities that are not gathered: all but light, radiosity, irradiance and net.
void require_gathered_3(const Shown& shown);
// Of light as above; radiosity, irradiance or net by the channel that is asked for, else their mean; of two bands their
// sum. Throws as require_gathered_3.
Responses3 responses_3(const Shown& shown, const RadiositySolution& solution);

// What is looked at.
struct GatheredScene3 {
  const PreparedScene3& prepared;
  const ElementTable3& table;
  const ElementPaint3& paint;  // what is shown of values, of black sides and of the sky
  const Responses3& responses;
  const GatheredLight3& light;
  const SceneLights3* lights = nullptr;  // whose direct light is gathered too; null: it is left out
};

// How far what is shown at one place is from what is shown at another, in steps of a screen or of whatever counts.
using StepsBetween3 = std::function<double(std::span<const double>, std::span<const double>)>;

// The same of colours: the largest step of a channel, of 256.
double steps_between_3(const Colour& a, const Colour& b);

struct Gathering3 {
  PixelValues3 pixels;
  std::uint64_t points = 0;  // that were asked for
};

// Returns the picture of a camera; a pixel is the mean of what is shown over its area.
//
//   (1) what hides what, for the camera and for each point, is decided exactly: a shadow ends where it does
//   (2) each polygon that is seen is cut along lines between pixels, down to squares of a pixel, until what points
//       around a part and in its middle tell of points halfway between them is off by at most half of so many steps, as
//       those points say themselves. The error elsewhere is an estimate
//   (3) direct light, where it is gathered, has its borders within a pixel
//   (4) the same for any number of threads
//
// progress: fraction done; may throw to stop. Throws Interrupted when asked to stop, RequestError where the eye is in a
// solid. REQUIRES a camera without a problem. COST: that of GatheredLight3 for each point.
Gathering3 gathered_view_3(const GatheredScene3& scene, const Camera3& camera, const StepsBetween3& steps_between,
                           double most_steps, const std::function<void(double)>& progress = {});

// Pixels of a picture from a place on.
struct PixelTile3 {
  std::uint32_t left = 0, top = 0;
  PixelValues3 pixels;
};

// The same in squares of 64 pixels, those nearest to the middle first: each is taken as soon as it is done. Together
// they are the picture of gathered_view_3 but for rounding. take: is called on the thread of the caller; may throw to
// stop.
void gathered_tiles_3(const GatheredScene3& scene, const Camera3& camera, const StepsBetween3& steps_between,
                      double most_steps, const std::function<void(PixelTile3)>& take);

}  // namespace hottel
