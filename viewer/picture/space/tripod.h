// The axes of a scene as a camera sees them, with how far the scene reaches along each.
#pragma once

#include <array>
#include <string>

#include "geometry/space/scene/scene.h"
#include "viewer/picture/canvas.h"

namespace hottel {

// Three arrows from one point, along x, y and z, as a camera would see them from far away in the middle of its picture;
// beside them a line for each axis with the box of the scene: "x 0 to 5.56 m".
class Tripod3 {
 public:
  // The box is that of the corners of all polygons, rounded to six digits; of a scene without polygons the lines are
  // empty. length_unit: as the scene calls it.
  Tripod3(const Scene3& scene, const Camera3& camera, const std::string& length_unit);

  // How wide it is, some 60 units high. unit: a text is some 14 of it high.
  double width(const PictureCanvas& canvas, double unit) const;
  void draw(PictureCanvas& canvas, Pixel top_left, double unit) const;

 private:
  struct Axis {
    double right, up, away;  // of the unit vector along it: in the picture, and from the eye
    std::string name, reach;
  };
  double aside_of(const Axis& axis) const;
  void draw_axis(PictureCanvas& canvas, const Axis& axis, Pixel centre, double unit) const;

  std::array<Axis, 3> axes_;
};

}  // namespace hottel
