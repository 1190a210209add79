#include "viewer/picture/plane/film_frame.h"

#include "kernel/support/failure.h"
#include "viewer/picture/tone_curve.h"

namespace hottel {

void FilmPainter2::fit_to(const Simulation2& simulation, const StageProgress& progress) {
  const IlluminationGrid2& light = simulation.light(progress)->grid;
  picture_.curve = std::make_shared<const ToneCurve>(picture_.tone, picture_.exposure, light.values, light.channels);
}

std::string FilmPainter2::file(const Simulation2& simulation, Kept&, const StageProgress& progress) const {
  HOTTEL_REQUIRE(is_fitted());
  return illumination_picture_2(*simulation.prepared(progress), simulation.light(progress)->grid, picture_,
                                PictureFormat::kPng)
      .bytes;
}

}  // namespace hottel
