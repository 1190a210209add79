// A furnished room, all of triangles: for each place a table with two chairs, a shelf and two lamps.
#include <string>

#include "geometry/space/generate/furniture.h"
#include "geometry/space/generate/generate_kinds.h"
#include "geometry/space/generate/generator_canvas.h"

namespace hottel {
namespace {

constexpr std::uint64_t kRoomTriangles = 12;

}  // namespace

Scene3 generate_furnished_room_3(const GeneratorRequest3& request) {
  const auto places = static_cast<std::int64_t>((request.n - kRoomTriangles) / kPlaceTriangles);
  const std::int64_t columns = side_of_square(static_cast<std::uint64_t>(places));
  const std::int64_t rows = (places + columns - 1) / columns;
  const Dot3 size{columns * kPlaceWidth, rows * kPlaceDepth, kPlaceHeight};
  Chance chance(request.seed);
  GeneratorCanvas3 canvas(request, 3);
  canvas.draw_triangles();
  canvas.add_inward("room", upright_block({0, 0, 0}, size), {kGrey, kWhite, kRed, kBlue, kWhite, kWhite});
  canvas.look({size.x - 200, 200, 2200}, {size.x / 2, size.y / 2, 600});
  for (std::int64_t k = 0; k < places; ++k)
    furnish(canvas, std::to_string(k), {k % columns * kPlaceWidth, k / columns * kPlaceDepth, 0}, chance);
  return canvas.finish(true);
}

}  // namespace hottel
