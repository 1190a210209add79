// A hand on a viewer in space, without a screen.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "geometry/scene_names.h"
#include "io/scene/scene_json.h"
#include "tests/temporary_folder.h"
#include "viewer/window/recording_window.h"
#include "viewer/window/script_player.h"
#include "viewer/window/space/viewer.h"

namespace hottel::testing_viewer {

// A room of 2 x 2 x 2 with a solid box on its floor and a lamp below its ceiling.
inline constexpr const char* kRoom = R"({"hottel": 1, "dimension": 3,
  "materials": {"white": {"reflectivity": 0.5}, "lamp": {"emission": 4, "reflectivity": 0.1},
                "red": {"reflectivity": [0.6, 0.1, 0.1]}},
  "polygons": [
    {"name": "floor", "points": [[0,0,0],[2,0,0],[2,2,0],[0,2,0]], "material": "white", "elements": 2},
    {"name": "ceiling", "points": [[0,0,2],[0,2,2],[2,2,2],[2,0,2]], "material": "white"},
    {"name": "front", "points": [[0,0,0],[0,0,2],[2,0,2],[2,0,0]], "material": "white"},
    {"name": "rear", "points": [[0,2,0],[2,2,0],[2,2,2],[0,2,2]], "material": "white"},
    {"name": "left", "points": [[0,0,0],[0,2,0],[0,2,2],[0,0,2]], "material": "red"},
    {"name": "right", "points": [[2,0,0],[2,0,2],[2,2,2],[2,2,0]], "material": "white"},
    {"name": "lamp", "points": [[0.5,0.5,1.9],[0.5,1,1.9],[1,1,1.9],[1,0.5,1.9]], "material": "lamp"},
    {"name": "box.bottom", "group": "box", "points": [[1,1.2,0],[1,1.6,0],[1.4,1.6,0],[1.4,1.2,0]], "material": "white"},
    {"name": "box.top", "group": "box", "points": [[1,1.2,0.4],[1.4,1.2,0.4],[1.4,1.6,0.4],[1,1.6,0.4]], "material": "white"},
    {"name": "box.a", "group": "box", "points": [[1,1.2,0],[1.4,1.2,0],[1.4,1.2,0.4],[1,1.2,0.4]], "material": "white"},
    {"name": "box.b", "group": "box", "points": [[1.4,1.2,0],[1.4,1.6,0],[1.4,1.6,0.4],[1.4,1.2,0.4]], "material": "white"},
    {"name": "box.c", "group": "box", "points": [[1.4,1.6,0],[1,1.6,0],[1,1.6,0.4],[1.4,1.6,0.4]], "material": "white"},
    {"name": "box.d", "group": "box", "points": [[1,1.6,0],[1,1.2,0],[1,1.2,0.4],[1,1.6,0.4]], "material": "white"}],
  "camera": {"eye": [0.9, 0.1, 1.1], "target": [1, 2, 0.9], "field_of_view": 80, "pixels": [800, 600]}})";

class Hand {
 public:
  explicit Hand(const std::string& scene = kRoom) : window({400, 300}) {
    std::ofstream(file()) << scene;
    viewer.emplace(ViewerSource3{file(), [path = file()] { return read_scene_3(path); }}, window, FactorsRequest3{},
                   1.0);
    viewer->settle(kPatience);
  }

  std::filesystem::path file() const { return folder / "room.json"; }
  std::filesystem::path path(const std::string& name) const { return folder / name; }

  // Does the steps of a script; returns what it prints.
  std::string play(const std::string& script) {
    std::string printed;
    play_script(parse_script(script, "hand.txt"), "hand.txt", *viewer, window,
                {.print = [&printed](const std::string& line) { printed += line + "\n"; }});
    return printed;
  }
  const Material& material(const std::string& name) const {
    return *std::ranges::find(viewer->scene()->materials, name, &Material::name);
  }
  std::string picked() const {
    return viewer->request().face ? face_name(*viewer->scene(), *viewer->request().face) : "";
  }

  // All that can be asked of the viewer but the frame, in which times are written.
  std::string signature() const {
    const Camera3 camera = viewer->camera().camera({400, 300});
    std::string text = write_scene_3(*viewer->scene()) + "|" + viewer->message() + "|" +
                       (viewer->prompt() ? viewer->prompt()->question + viewer->prompt()->text : "") + "|" +
                       to_string(viewer->request().mode) + "|" + viewer->request().method + "|" +
                       to_string(viewer->request().solver) + picked() +
                       std::to_string(static_cast<int>(viewer->tone())) + " " + std::to_string(viewer->exposure()) +
                       (viewer->is_smooth() ? "smooth" : "flat") + (viewer->wants_quit() ? " quits" : "");
    for (const Point3& p : {camera.eye, camera.target})
      text += " " + to_string(p.x) + " " + to_string(p.y) + " " + to_string(p.z);
    const std::string here = (folder / "").string();
    for (auto at = text.find(here); at != std::string::npos; at = text.find(here))
      text.replace(at, here.size(), "HERE");
    return text;
  }

  static constexpr double kPatience = 300;
  TemporaryFolder folder;
  RecordingWindow window;
  std::optional<Viewer3> viewer;
};

}  // namespace hottel::testing_viewer
