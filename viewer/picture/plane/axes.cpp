#include "viewer/picture/plane/axes.h"

#include <array>

#include "viewer/picture/frame_axes.h"

namespace hottel {

void draw_axes_2(PictureCanvas& canvas, const Frame2& frame, double unit, const std::string& length_unit) {
  const Pixel from = frame.top_left(), to = frame.bottom_right();
  const std::array<double, 2> lower = frame.place({from.x, to.y}), upper = frame.place({to.x, from.y});
  draw_frame_axes(canvas, {from, to, lower[0], upper[0], lower[1], upper[1], length_unit, {}}, unit);
}

}  // namespace hottel
