// Small scenes for the tests of drawings.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/plane/scene/scene.h"
#include "viewer/picture/recording_canvas.h"

namespace hottel {

// A scene put together from polylines; material 0 reflects, material 1 emits.
class DrawnScene {
 public:
  DrawnScene() {
    scene.materials = {{"white", Spectrum::scalar(Rational(7, 10)), {}}, {"window", {}, Spectrum::scalar(5)}};
  }

  std::uint32_t edge(Point2 from, Point2 to, std::uint32_t material = 0, std::optional<std::uint32_t> back = {}) {
    const auto index = static_cast<std::uint32_t>(scene.surfaces.size());
    scene.add({.name = "edge[" + std::to_string(index) + "]",
               .material = material,
               .back = back,
               .group = static_cast<std::uint32_t>(scene.groups.size())},
              {std::move(from), std::move(to)});
    scene.groups.push_back(scene.surfaces.back().name);
    return index;
  }

  void closed(const std::vector<Point2>& corners) {
    const auto group = static_cast<std::uint32_t>(scene.groups.size());
    for (std::size_t k = 0; k < corners.size(); ++k) {
      edge(corners[k], corners[(k + 1) % corners.size()]);
      scene.groups.pop_back();
      scene.surfaces.back().group = group;
    }
    scene.groups.push_back("outline");
  }

  Scene2 scene;
};

// A room of 4 x 3 with a window below, listed edge by edge (0..5, the window is 4), a table (6..9) and a screen with
// two white sides (10).
inline Scene2 furnished_room() {
  DrawnScene room;
  room.edge({0, 0}, {0, 3});
  room.edge({0, 3}, {4, 3});
  room.edge({4, 3}, {4, 0});
  room.edge({4, 0}, {3, 0});
  room.edge({3, 0}, {1, 0}, 1);
  room.edge({1, 0}, {0, 0});
  room.closed({{2, 1}, {3, 1}, {3, 2}, {2, 2}});
  room.edge({1, 1}, {1, 2}, 0, 0);
  return room.scene;
}
inline constexpr std::uint32_t kWindow = 4, kTableBottom = 6, kScreen = 10;

inline bool inside(const RecordingCanvas& canvas) {
  for (const auto& call : canvas.calls()) {
    const bool round = call.kind == RecordingCanvas::Kind::kDisc || call.kind == RecordingCanvas::Kind::kCircle;
    const double reach = round ? call.size : call.kind == RecordingCanvas::Kind::kStroke ? call.size / 2 : 0;
    for (const Pixel& p : call.points)
      if (!(p.x - reach >= -1e-9 && p.x + reach <= canvas.width() + 1e-9 && p.y - reach >= -1e-9 &&
            p.y + reach <= canvas.height() + 1e-9))
        return false;
  }
  return true;
}

}  // namespace hottel
