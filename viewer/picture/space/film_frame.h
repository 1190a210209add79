// Frames of an animation in space as pictures.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "kernel/support/stage.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/space/render_picture.h"
#include "viewer/picture/space/seen_picture.h"
#include "viewer/picture/space/seen_sides.h"
#include "viewer/picture/space/smooth_mesh.h"

namespace hottel {

// What a camera sees of simulations of one scene at several times, all by one tone curve.
//
//   (1) the curve is fitted to the picture of the simulation that it is told first, so that light that moves does not
//       change what stays
//   (2) file() is a function of that picture and of the simulation: what is kept changes nothing. No level of a pixel
//       is off by more than one from what RenderedView3 has by the same curve
//   (3) where the same elements are active, what hides what from the camera is not looked at again; but where light is
//       gathered
//   (4) direct light of lamps and suns is that of each point, whatever the shading
class FilmPainter3 {
 public:
  // Beside a list of active elements: what is seen of them.
  struct Kept {
    std::shared_ptr<const ElementTable3> table;
    std::optional<SmoothMesh3> mesh;
    std::optional<SeenPicture3> seen;
    std::vector<SeenSide3> sides;  // where there are lights
    std::uint64_t seen_bytes = 0;  // about

    std::uint64_t bytes() const { return seen_bytes; }
  };

  explicit FilmPainter3(RenderOptions3 options) : options_(std::move(options)) {}

  bool is_fitted() const { return curve_.has_value(); }
  void fit_to(const Simulation3& simulation, const StageProgress& progress);
  // The bytes of a PNG file. REQUIRES is_fitted(), and what was kept of the same elements.
  std::string file(const Simulation3& simulation, Kept& kept, const StageProgress& progress) const;

 private:
  // The options for a simulation.
  RenderOptions3 options_for(const Simulation3& simulation, const StageProgress& progress) const;
  void look(const PreparedScene3& prepared, const ElementPaint3& paint, Kept& kept) const;

  RenderOptions3 options_;
  std::optional<ToneCurve> curve_;
};

}  // namespace hottel
