// Scenes of either dimension, as Python holds them.
#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <memory>
#include <string>
#include <variant>

#include "geometry/scene_table.h"
#include "io/scene/scene_json.h"

namespace hottel::python {

// A scene that never changes; copies share it.
class PythonScene {
 public:
  explicit PythonScene(ValidScene scene) : scene_(std::make_shared<const ValidScene>(std::move(scene))) {}

  const ValidScene& scene() const { return *scene_; }
  const SceneTable& table() const;
  bool is_plane() const { return std::holds_alternative<ValidScene2>(*scene_); }
  const Scene2& in_plane() const { return *std::get<ValidScene2>(*scene_); }  // REQUIRES is_plane()
  const Scene3& in_space() const { return *std::get<ValidScene3>(*scene_); }  // REQUIRES not is_plane()
  // Equal for scenes that say the same.
  std::string key() const;
  // The text of a scene file that reads back to the same. Throws RequestError where no file can hold it.
  std::string text() const;

 private:
  std::shared_ptr<const ValidScene> scene_;
};

// The scene of a dict; floats are their shortest decimals, or the doubles that they are; files of meshes are found in
// the folder. Throws as Scene() does.
PythonScene scene_of(const pybind11::dict& table, const std::filesystem::path& folder = "", bool is_binary = false);
// The scene of the text of a scene file. Throws InputError.
PythonScene scene_of_text(const std::string& text);

}  // namespace hottel::python
