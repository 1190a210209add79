// Any bytes as a scene file, in the plane or in space: refused with InputError, or read; what is read is written and
// reads back the same.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

bool same_surfaces(const hottel::Scene2& a, const hottel::Scene2& b) {
  if (a.surfaces.size() != b.surfaces.size()) return false;
  for (std::size_t k = 0; k < a.surfaces.size(); ++k) {
    const hottel::Surface &s = a.surfaces[k], &t = b.surfaces[k];
    if (s.name != t.name || a.edges[k] != b.edges[k] || s.elements != t.elements) return false;
    if (a.materials[s.material] != b.materials[t.material] || s.back.has_value() != t.back.has_value()) return false;
    if (s.back && a.materials[*s.back] != b.materials[*t.back]) return false;
  }
  return true;
}

void read_and_write_3(std::string_view text) {
  const auto mesh = [](const std::filesystem::path&) { return std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); };
  hottel::Scene3 scene;
  try {
    scene = hottel::parse_scene_3(text, "fuzz.json", mesh);
  } catch (const hottel::InputError&) {
    return;
  }
  std::string written;
  try {
    written = hottel::write_scene_3(scene);
  } catch (const hottel::RequestError&) {
    return;
  }
  const hottel::Scene3 again = hottel::parse_scene_3(written, "written.json", mesh);
  require(again.polygons == scene.polygons && again.groups == scene.groups && again.camera == scene.camera);
  require(again.materials == scene.materials && again.sky_emission == scene.sky_emission);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  read_and_write_3(text);
  hottel::Scene2 scene;
  try {
    scene = hottel::parse_scene_2(text, "fuzz.json");
  } catch (const hottel::InputError& error) {
    require(std::string_view(error.what()).starts_with("fuzz.json"));
    return 0;
  }
  std::string written;
  try {
    written = hottel::write_scene_2(scene);
  } catch (const hottel::RequestError&) {
    return 0;  // a value that is exact has more digits than a file may hold
  }
  const hottel::Scene2 again = hottel::parse_scene_2(written, "written.json");
  require(same_surfaces(scene, again));
  require(again.sky_emission == scene.sky_emission && again.closed == scene.closed);
  return 0;
}
