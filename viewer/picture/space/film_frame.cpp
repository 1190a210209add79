#include "viewer/picture/space/film_frame.h"

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "viewer/picture/png_file.h"
#include "viewer/picture/raster.h"
#include "viewer/picture/space/direct_view.h"
#include "viewer/picture/space/pixel_raster.h"

namespace hottel {

RenderOptions3 FilmPainter3::options_for(const Simulation3& simulation, const StageProgress& progress) const {
  RenderOptions3 options = options_;
  options.light_shares = simulation.light_shares(progress);
  options.curve = curve_;
  return options;
}

void FilmPainter3::fit_to(const Simulation3& simulation, const StageProgress& progress) {
  const auto prepared = simulation.prepared(progress);
  const auto solution = simulation.radiosities(progress);
  curve_ =
      RenderedView3(*prepared, simulation.request().factors.granularity, *solution, options_for(simulation, progress))
          .tone();
}

std::string FilmPainter3::file(const Simulation3& simulation, Kept& kept, const StageProgress& progress) const {
  HOTTEL_REQUIRE(is_fitted());
  const auto prepared = simulation.prepared(progress);
  const auto solution = simulation.radiosities(progress);
  const Granularity granularity = simulation.request().factors.granularity;
  if (options_.shading == Shading::kGathered)
    return RenderedView3(*prepared, granularity, *solution, options_for(simulation, progress))
        .file(PictureFormat::kPng);
  if (!kept.table) {
    kept.table = prepared->elements(granularity);
    if (options_.shading != Shading::kFlat) kept.mesh.emplace(*prepared, *kept.table);
  }
  ElementPaint3 paint = reflected_paint_3(*prepared, *kept.table, *solution, *simulation.light_shares(progress));
  if (options_.shading == Shading::kParents)
    paint.values = values_from_parents(kept.table->elements(), paint.values, paint.channels);
  look(*prepared, paint, kept);
  if (prepared->scene.lights.empty()) return png_file(kept.seen->raster(&*curve_));
  PixelValues3 pixels = kept.seen->values();
  const Camera3 camera = camera_of_scene(*prepared, options_.wanted_width);
  add_direct_light_3(*prepared, *kept.table, *solution, camera, kept.sides, pixels);
  return png_file(pixel_raster_3(pixels, &*curve_));
}

// Once shown anew a picture is drawn as any other that was: the first one too.
void FilmPainter3::look(const PreparedScene3& prepared, const ElementPaint3& paint, Kept& kept) const {
  const SmoothMesh3* mesh = kept.mesh ? &*kept.mesh : nullptr;
  if (kept.seen && kept.seen->show(paint, mesh)) return;
  const Camera3 camera = camera_of_scene(prepared, options_.wanted_width);
  kept.seen.emplace(SeenScene3{prepared, *kept.table, paint, mesh}, camera);
  if (!prepared.scene.lights.empty()) kept.sides = seen_sides_3(prepared, camera);
  // Outlines, a run for each row of each part, pixels along borders; and the elements with their patches.
  kept.seen_bytes = (kept.seen->parts().size() + kept.sides.size()) * (std::uint64_t{1} << 12) +
                    std::uint64_t{camera.width} * camera.height * 8 + kept.table->count() * (std::uint64_t{1} << 10);
  kept.seen->show(paint, mesh);
}

}  // namespace hottel
