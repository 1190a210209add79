// A quantity of a solution as a picture: a plan whose faces are coloured by it.
#pragma once

#include <cstdint>
#include <string>

#include "geometry/plane/scene/scene.h"
#include "viewer/picture/plane/scene_picture.h"
#include "viewer/picture/shown_values.h"

namespace hottel {

// Values at the centres of the cells of a grid, in the order of IlluminationGrid2.
struct ShownCells2 {
  Grid2 grid;
  ShownValues values;
};

// The plan of a scene with the values on its faces, or on their elements; with scale, unit and range. width: in
// pixels; 0: the usual one.
struct ShownPlan2 {
  std::uint32_t width = 0;
  bool has_axes = false;
  Shading shading = Shading::kFlat;
  int contours = 0;  // of the cells: about so many lines of equal values, at most (light_contours)
};
ScenePicture2 shown_plan_2(const ShownValues& values, const ShownPlan2& plan);

// Returns the bytes of the picture file. cells: beneath the plan, in the same scale; where they have no value the floor
// shows. REQUIRES values by faces or elements, of the scene as it is prepared; of cells with that scale.
std::string shown_picture_2(const PreparedScene2& prepared, const ShownValues& values, const ShownPlan2& plan,
                            PictureFormat format, const ShownCells2* cells = nullptr);

}  // namespace hottel
