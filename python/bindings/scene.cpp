#include "python/bindings/scene.h"

#include <filesystem>

#include "geometry/planarity.h"
#include "geometry/space/scene/near_plane.h"
#include "geometry/space/scene/polygon.h"
#include "io/scene/table_writer.h"
#include "kernel/support/failure.h"
#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"
#include "python/bindings/scene_text.h"

namespace hottel::python {

namespace {

// Throws RequestError where a polygon that is plane but for the rounding of its file is not so near to a plane by the
// digits that a text has.
void require_planes_kept(const Scene3& scene) {
  FinestDigit finest;
  for (const Polygon3& polygon : scene.polygons)
    for (const Point3& p : corners_of(polygon))
      for (const Rational* coordinate : {&p.x, &p.y, &p.z}) {
        std::string number = json_number(*coordinate);
        std::erase(number, '"');
        finest.take(number);
      }
  for (std::size_t s = 0; s < scene.polygons.size(); ++s)
    if (Polygon3 polygon = scene.polygons[s]; polygon.is_nearly_plane && !accept_nearly_plane(polygon, finest.unit()))
      throw RequestError("polygon '" + scene.surfaces[s].name +
                         "' is plane but for the rounding of its file, which no text of a scene can say");
}

}  // namespace

const SceneTable& PythonScene::table() const {
  return std::visit([](const auto& scene) -> const SceneTable& { return *scene; }, *scene_);
}

std::string PythonScene::key() const { return is_plane() ? write_scene_2(in_plane()) : write_scene_3(in_space()); }

std::string PythonScene::text() const {
  if (!is_plane()) require_planes_kept(in_space());
  return key();
}

PythonScene scene_of_text(const std::string& text) { return PythonScene(parse_scene(text, std::string(kNoFile))); }

// Files that it names are found in the folder.
PythonScene scene_of(const py::dict& table, const std::filesystem::path& folder, bool is_binary) {
  const std::string text = scene_text(table, is_binary);
  const py::gil_scoped_release released;
  if (folder.empty()) return scene_of_text(text);
  return PythonScene(parse_scene(text, (folder / kNoFile).string()));
}

}  // namespace hottel::python
