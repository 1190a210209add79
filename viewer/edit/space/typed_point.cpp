#include "viewer/edit/space/typed_point.h"

#include <string>
#include <utility>

namespace hottel {

Typed<Point3> typed_point_3(std::string_view text) {
  auto [numbers, problem] = typed_numbers(text);
  if (!numbers) return {{}, std::move(problem)};
  if (numbers->size() != 3)
    return {{}, "a place has three coordinates, x, y and z; there are " + std::to_string(numbers->size())};
  return {Point3{(*numbers)[0], (*numbers)[1], (*numbers)[2]}, ""};
}

}  // namespace hottel
