// A scene in the plane as an architect's plan, plain or with a value on each face.
//
//   const Simulation2 simulation(read_scene_2("scenes/showcase/apartment.json"));
//   const ScenePicture2 picture{.sheet = {.title = "Apartment"}};
//   const std::string bytes = scene_picture_2(*simulation.prepared(), picture, PictureFormat::kSvg);
//   std::ofstream("plan.svg", std::ios::binary) << bytes;
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/picture/picture_options.h"
#include "viewer/picture/shading.h"

namespace hottel {

struct PreparedScene2;
struct ScenePixels2;

// What stands on the sheet beside the drawing. A text that is empty takes no room.
struct SheetText2 {
  std::uint32_t width = 1600;  // of the picture in pixels
  std::string title{};         // large, may be empty
  std::string subtitle{};      // beneath it, may be empty
  bool has_axes = false;       // coordinates along the frame
};

// A value for each face that has one, or for each element.
struct FaceColouring2 {
  std::vector<std::optional<double>> front{}, back{};  // per surface; shorter: the rest has none
  std::vector<std::optional<double>> elements{};       // as ElementTable2 counts them; instead, where not empty
  Shading shading = Shading::kFlat;                    // how those of elements run along faces
  ColourScale scale{};
  std::string title{};  // of the legend, e.g. "fraction of the window seen"
};

// A plan as data: what is drawn beside floors, solids and walls.
struct ScenePicture2 {
  SheetText2 sheet{};
  std::vector<std::uint32_t> targets{};  // surfaces to highlight, e.g. the windows
  std::string target_label{};            // for the key, e.g. "window"; empty: no key
  std::optional<FaceColouring2> colouring{};
  std::shared_ptr<const ScenePixels2> pixels{};  // beneath the drawing; null: none (scene_painter.h)
};

// Returns the bytes of the picture file.
std::string scene_picture_2(const PreparedScene2& prepared, const ScenePicture2& picture, PictureFormat format);

}  // namespace hottel
