#include "viewer/picture/space/film_frame.h"

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "viewer/picture/png_file.h"
#include "viewer/picture/raster.h"

namespace hottel {

void FilmPainter3::fit_to(const Simulation3& simulation, const StageProgress& progress) {
  const auto prepared = simulation.prepared(progress);
  const auto solution = simulation.radiosities(progress);
  curve_ = RenderedView3(*prepared, simulation.request().factors.granularity, *solution, options_).tone();
}

std::string FilmPainter3::file(const Simulation3& simulation, Kept& kept, const StageProgress& progress) const {
  HOTTEL_REQUIRE(is_fitted());
  const auto prepared = simulation.prepared(progress);
  ElementPaint3 paint = light_paint_3(prepared->scene, *simulation.radiosities(progress));
  if (!kept.table) {
    kept.table = prepared->elements(simulation.request().factors.granularity);
    if (options_.shading != Shading::kFlat) kept.mesh.emplace(*prepared, *kept.table);
  }
  if (options_.shading == Shading::kParents)
    paint.values = values_from_parents(kept.table->elements(), paint.values, paint.channels);
  const SmoothMesh3* mesh = kept.mesh ? &*kept.mesh : nullptr;
  // Once shown anew a picture is drawn as any other that was: the first one too.
  if (!kept.seen || !kept.seen->show(paint, mesh)) {
    const Camera3 camera = camera_of_scene(*prepared, options_.wanted_width);
    kept.seen.emplace(SeenScene3{*prepared, *kept.table, paint, mesh}, camera);
    // Outlines, a run for each row of each part, pixels along borders; and the elements with their patches.
    kept.seen_bytes = kept.seen->parts().size() * (std::uint64_t{1} << 12) +
                      std::uint64_t{camera.width} * camera.height * 8 + kept.table->count() * (std::uint64_t{1} << 10);
    kept.seen->show(paint, mesh);
  }
  return png_file(kept.seen->raster(&*curve_));
}

}  // namespace hottel
