// What a point in space sees, as drawings of the sphere of directions.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/visibility/direction.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/picture_options.h"

namespace hottel {

struct Look3;
struct VisibilityMap3;
struct Scene3;

// A part of the sphere between arcs of great circles: convex, smaller than a hemisphere; its corners in order.
struct MapPiece3 {
  std::vector<Direction3> corners;
  std::uint32_t face = 0;
};

// What is drawn of a map. Directions that no piece holds are the sky.
struct MapDrawing3 {
  std::vector<MapPiece3> pieces;
  std::vector<Colour> colours;               // by face
  Direction3 forward{0, 1, 0}, up{0, 0, 1};  // the middle of the picture, and what is above it; not parallel
  std::string title{};
  std::uint32_t width = 1600;
};

// Draws all directions twice: unfolded as a cube (from its middle, as one looks at it from inside: left, forward,
// right, back, with up and down above and below forward), and as two discs, in front and behind, on which equal areas
// are equal solid angles (Lambert's azimuthal projection).
//
//   (1) on the cube arcs of great circles are straight; on the discs they are drawn within a tenth of a pixel
//   (2) nothing leaves the picture; pieces are cut where the cube folds and where the discs end
//   (3) there is a line wherever one face ends, and none between two pieces of one face
// Throws UsageError for a width out of range. REQUIRES that the drawing outlives this.
class MapPainter3 {
 public:
  explicit MapPainter3(const MapDrawing3& drawing);

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }
  void draw(PictureCanvas& canvas) const;

  // Where a direction lies on the disc that shows it, and on the cube.
  Pixel on_disc(const Direction3& direction) const;
  Pixel on_cube(const Direction3& direction) const;

 private:
  struct Axes {
    Direction3 right, up, out;  // of a side of the cube as it is seen, or of a disc
  };
  struct Side {
    Axes axes;
    Pixel middle;
  };

  void draw_cube_side(PictureCanvas& canvas, const Side& side) const;
  void draw_disc(PictureCanvas& canvas, const Side& disc) const;
  Pixel cube_pixel(const Side& side, const Direction3& direction) const;
  Pixel disc_pixel(const Side& disc, const Direction3& direction) const;

  const MapDrawing3& drawing_;
  std::uint32_t width_, height_;
  double unit_, half_side_, radius_;  // half the side of the cube, radius of a disc, in pixels
  std::vector<Side> sides_, discs_;
  std::vector<std::pair<Direction3, Direction3>> lines_;  // arcs where something ends
};

// What is drawn of a map: each face in the colour of its material, darker the flatter it is seen; grey where solids
// are. Forward is where the normal of the look points, else along y; up is z, or y where forward is along z.
MapDrawing3 drawing_of(const Scene3& scene, const Look3& look, const VisibilityMap3& map);

// Returns the bytes of the picture file.
std::string map_picture_3(const MapDrawing3& drawing, PictureFormat format);

}  // namespace hottel
