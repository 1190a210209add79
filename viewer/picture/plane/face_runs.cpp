#include "viewer/picture/plane/face_runs.h"

#include "geometry/plane/exchange/element_table.h"

namespace hottel {

FaceRuns2::FaceRuns2(const PreparedScene2& prepared, const Frame2& frame) {
  const Vertices2& vertices = prepared.arrangement.vertices();
  for (const VertexId v : vertices.ids()) {
    const ExactPoint2 p = vertices.to_scene(vertices.exact(v));
    corners_.at.push_back(frame.at(Point2{p.x, p.y}));
  }
  const ElementTable2 labels(prepared.scene, prepared.arrangement, prepared.division, Granularity::kFace);
  begin_.assign(prepared.scene.surfaces.size() + 1, 0);
  for (std::uint32_t label = 0; label < labels.count(); ++label) {
    const Element& element = labels.elements()[label];
    for (const Segment2& run : labels.runs(label)) {
      corners_.from.push_back(static_cast<std::uint32_t>(run.a.index()));
      corners_.to.push_back(static_cast<std::uint32_t>(run.b.index()));
      face_.push_back({element.surface, element.is_back});
    }
    begin_[element.surface + 1] = static_cast<std::uint32_t>(face_.size());
  }
}

}  // namespace hottel
