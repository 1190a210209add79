// Pixels of gathered pictures the slow and obvious way: every point by its own exact map, nothing between points.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/face.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/scene/scene.h"
#include "solver/radiosity/radiosity_solution.h"
#include "viewer/picture/space/gathered_view.h"
#include "viewer/picture/space/pixel_values.h"
#include "viewer/picture/space/projection.h"
#include "viewer/picture/space/seen_sides.h"
#include "viewer/picture/space/side_plane.h"

namespace hottel {

// What borders a pixel has, where one point does not tell its light.
struct PixelBorders3 {
  bool has_edge = false;    // of something that is seen
  bool has_shadow = false;  // of a lamp or a sun, or the border of its beam
  bool has_event = false;   // of what the face there sees of a face that emits (event_surfaces)
  bool any() const { return has_edge || has_shadow || has_event; }
};

// Points of pixels.
//
//   (1) each side that is seen in a pixel has a point in every square of across x across in it, in the middle of what
//       the side has of that square, and counts there by the area of that: edges are exact, light within is sampled
//   (2) direct light, where the scene has lights to gather, is sampled likewise by lights_across x lights_across
//
// REQUIRES light as what is shown (light_paint_3), that the scene outlives this, and a camera without a problem.
// COST: that of GatheredLight3 for every point.
class FullSampling3 {
 public:
  FullSampling3(const GatheredScene3& scene, const Camera3& camera);

  const Camera3& camera() const { return camera_; }

  // Returns what is shown of the pixels of these numbers, from the top and the left by rows; channels side by side.
  std::vector<double> values(std::span<const std::uint32_t> pixels, std::uint32_t across,
                             std::uint32_t lights_across) const;

  // Returns what borders each pixel has, by its number. Shadows are told by lights_across x lights_across points: one
  // that passes between them is not told. Events are those of faces that emit.
  std::vector<PixelBorders3> borders(const RadiositySolution& solution, std::uint32_t lights_across) const;

 private:
  // What one side has of a square of a pixel.
  struct Sample {
    std::size_t place;  // of the pixel in what was asked for
    std::uint32_t seen;
    double part;  // of the pixel
    Pixel at;
  };

  std::vector<Sample> samples(std::span<const std::uint32_t> pixels, std::uint32_t across) const;
  Point3 point(const Sample& sample) const;
  std::vector<double> irradiance(const Sample& sample) const;
  void mark_edges(std::vector<PixelBorders3>& result) const;
  void mark_shadows(std::uint32_t across, std::vector<PixelBorders3>& result) const;
  void mark_events(const RadiositySolution& solution, std::vector<PixelBorders3>& result) const;

  GatheredScene3 scene_;
  Camera3 camera_;
  Projection3 projection_;
  std::vector<SeenSide3> seen_;
  std::vector<SidePlane3> planes_;                      // of what is seen
  std::vector<std::optional<std::uint32_t>> elements_;  // of what is seen
};

}  // namespace hottel
