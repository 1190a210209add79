// Draws what a view mode shows.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "viewer/picture/canvas.h"
#include "viewer/picture/picture_options.h"
#include "viewer/picture/plane/frame.h"
#include "viewer/picture/tone_curve.h"
#include "viewer/window/plane/view_mode.h"

namespace hottel {

// The light of a state as pixels: one a cell, or `pixels_per_cell` across and up, blended without leaking through the
// scene's edges. The tone curve is fitted as `solve` fits it. REQUIRES a state with light, pixels_per_cell >= 1.
Raster light_texture_2(const LiveState2& state, const ToneChoice& tone, std::uint32_t pixels_per_cell = 1);

// The same as fast as it can be had: one pixel a cell, a few where cells are coarse.
Raster first_texture_2(const LiveState2& state, const ToneChoice& tone);

// The light of a state as pixels, with the state that it is of.
struct LightTexture2 {
  std::shared_ptr<const LiveState2> state;
  ToneChoice tone;
  std::uint32_t pixels_per_cell = 1;
  Raster raster;
};

// Everything that the drawing of a view mode depends on.
struct ViewDrawing2 {
  const LiveState2* state;
  const ViewRequest2* request;
  const ViewResult2* result = nullptr;  // null: there is none yet
  ToneChoice tone{};
  const LightTexture2* texture = nullptr;  // not made anew where it is of this state and this tone
  double split = 0.5;                      // of kErrors: where the bar is, a fraction of the width
};

// Draws a view mode on the whole canvas, without the texts beside it: paper, light, solids, edges; legends at the
// bottom.
//
//   (1) the marks are those of the pictures of viewer/picture/plane in the same frame
//   (2) without a prepared scene only its edges are drawn; without light, the plan
//   (3) a result of another version of the scene is not drawn
//   (4) light of which there is none is not drawn: there is the plan
//   (5) kFloor: each cell a rectangle of one colour, floor colour times light, so that the brightest is the floor's own
//       colour at exposure 1
// REQUIRES a state with a scene; frame and canvas of one size. unit: as SceneSheet2 takes it.
void draw_view(PictureCanvas& canvas, const Frame2& frame, double unit, const ViewDrawing2& drawing);

// The light that draw_view shows; null if the view mode shows no light.
std::shared_ptr<const SolvedLight2> shown_light_2(const ViewDrawing2& drawing);

// Whether any light is not 0.
bool shines(const IlluminationGrid2& light);

// Draws the edges of a scene alone, which need not be valid.
void draw_edges(PictureCanvas& canvas, const Frame2& frame, const Scene2& scene, const Colour& colour,
                double line_width);

}  // namespace hottel
