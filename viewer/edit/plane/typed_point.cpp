#include "viewer/edit/plane/typed_point.h"

#include <string>
#include <utility>

namespace hottel {

Typed<Point2> typed_point_2(std::string_view text) {
  auto [numbers, problem] = typed_numbers(text);
  if (!numbers) return {{}, std::move(problem)};
  if (numbers->size() != 2)
    return {{}, "a point has two coordinates, x and y; there are " + std::to_string(numbers->size())};
  return {Point2{(*numbers)[0], (*numbers)[1]}, ""};
}

}  // namespace hottel
