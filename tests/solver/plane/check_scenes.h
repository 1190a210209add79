// Tiny scenes to be checked, and what is found in them.
#pragma once

#include <string>
#include <vector>

#include "io/scene/scene_json.h"
#include "solver/plane/check/scene_check.h"
#include "solver/plane/simulation/simulation.h"

namespace hottel::check_scenes {

// A scene of white (0.5), black (0), mirror (1), bright (1 - 1e-6), red (0.5, 0.25, 0) and a lamp that emits 1.
inline Scene2 scene_of(const std::string& edges, const std::string& rest = "") {
  return parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"white": {"reflectivity": 0.5}, "black": {},
      "mirror": {"reflectivity": 1}, "bright": {"reflectivity": 0.999999, "emission": 1}, "red": {"reflectivity": [0.5, 0.25, 0]},
      "lamp": {"emission": 1, "reflectivity": 0.5}, "glowing mirror": {"emission": 1, "reflectivity": 1}},
      "edges": [)" + edges +
                           "]" + rest + "}",
                       "test.json");
}

inline std::string edge(const std::string& name, const std::string& points, const std::string& material = "white",
                        const std::string& back = "") {
  return R"({"name": ")" + name + R"(", "points": [)" + points + R"(], "material": ")" + material + "\"" +
         (back.empty() ? "" : R"(, "back": ")" + back + "\"") + "}";
}

// "polylines" with one closed ring, white.
inline std::string ring(const std::string& points, const std::string& material = "white") {
  return R"({"name": "ring", "points": [)" + points + R"(], "closed": true, "material": ")" + material + "\"}";
}
inline std::string rings(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& one : list) text += (text.empty() ? "" : ", ") + one;
  return ", \"polylines\": [" + text + "]";
}
inline const std::string kRoom =
    R"({"name": "room", "points": [[0,0],[0,3],[4,3],[4,0]], "closed": true, "material": "white"})";
inline const std::string kLamp = edge("lamp", "[1, 2], [1.5, 2]", "lamp", "lamp");

// Findings of all kinds but unused-material, of which every scene here has some.
inline Findings2 found(const Scene2& scene) {
  Findings2 findings = Simulation2(scene).check()->findings;
  std::erase_if(findings, [](const Finding2& finding) { return finding.kind == "unused-material"; });
  return findings;
}

inline std::vector<std::string> kinds(const Findings2& findings) {
  std::vector<std::string> result;
  for (const Finding2& finding : findings)
    result.push_back(std::string(to_string(finding.severity)) + " " + finding.kind);
  return result;
}

inline std::vector<std::string> names(const Scene2& scene, const Finding2& finding) {
  std::vector<std::string> result;
  for (const std::uint32_t s : finding.surfaces) result.push_back(scene.surfaces[s].name);
  return result;
}

// A closed polyline of its own.
inline std::string outline(const std::string& name, const std::string& points, const std::string& rest = "",
                           const std::string& material = "white") {
  return R"({"name": ")" + name + R"(", "points": [)" + points + R"(], "closed": true, "material": ")" + material +
         "\"" + (rest.empty() ? "" : ", " + rest) + "}";
}
// One that is open.
inline std::string path(const std::string& name, const std::string& points, const std::string& rest = "") {
  return R"({"name": ")" + name + R"(", "points": [)" + points + R"(], "material": "white")" +
         (rest.empty() ? "" : ", " + rest) + "}";
}

}  // namespace hottel::check_scenes
