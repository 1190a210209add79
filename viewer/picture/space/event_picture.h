// The event surfaces between two faces, as a drawing of where they meet the second one.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "geometry/face.h"
#include "geometry/space/exchange/event_surfaces.h"
#include "viewer/picture/canvas.h"
#include "viewer/picture/picture_options.h"

namespace hottel {

struct Scene3;

// Draws the polygon of a face in its plane, its first side to the right, seen from the side of the face; the lines
// along which event surfaces meet it, EV in one colour and EEE in another; and the edges that they are through, as they
// lie over it. A legend below names both.
//
//   (1) parts of traces beyond the polygon, by less than the last digits of its size, are drawn as they are
class EventPainter3 {
 public:
  // REQUIRES that the scene and the events outlive this.
  EventPainter3(const Scene3& scene, const Face& to, std::span<const EventSurface3> events, double width = 900);

  double width() const { return width_; }
  double height() const;
  void draw(PictureCanvas& canvas) const;

 private:
  Pixel place(const std::array<double, 3>& p) const;
  void draw_edges(PictureCanvas& canvas) const;
  void draw_traces(PictureCanvas& canvas) const;
  void draw_legend(PictureCanvas& canvas) const;

  std::span<const EventSurface3> events_;
  std::vector<std::array<double, 3>> corners_;
  std::array<std::array<double, 3>, 2> axes_{};  // of length 1
  std::array<double, 2> low_{}, high_{};         // of the polygon along them
  double width_, scale_ = 1;
};

// Returns the bytes of the drawing.
std::string event_picture_3(const Scene3& scene, const Face& to, std::span<const EventSurface3> events,
                            PictureFormat format);

}  // namespace hottel
