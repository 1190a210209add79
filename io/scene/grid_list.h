// The grids of a scene file, in the plane and in space: one, or a list of some with names.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/grid_names.h"
#include "io/scene/json_fields.h"

namespace hottel {

// Returns the grids that a value says: an object with these keys, or a list of such objects, each with a `name` too.
// grid_of: from an object and its members, in the order of the keys, to a grid without a name. Refuses an empty list,
// an entry without a name, a name that grid_name_problem refuses, and one that clashes with another (grid_names_clash).
template <class AnyGrid, std::size_t kKeys, class Make>
std::vector<AnyGrid> read_grids(const JsonValue& value, const std::array<std::string_view, kKeys>& keys,
                                const Make& grid_of) {
  if (value.kind() != JsonKind::kArray) return {grid_of(value, read_members(value, {"grid"}, keys))};
  if (value.size() == 0) refuse(value, "grid: the list is empty");
  std::array<std::string_view, kKeys + 1> with_name{"name"};
  std::ranges::copy(keys, with_name.begin() + 1);
  std::vector<AnyGrid> grids;
  for (const JsonValue item : value.items()) {
    const std::array<JsonValue, kKeys + 1> members = read_members(item, {"grid"}, with_name);
    const JsonValue& name = members[0];
    require_member(name, "name", item, {"grid"});
    std::array<JsonValue, kKeys> others;
    std::copy(members.begin() + 1, members.end(), others.begin());
    AnyGrid grid = grid_of(item, others);
    grid.name = read_string(name, {"grid", "name"});
    if (const std::string problem = grid_name_problem(grid.name); !problem.empty())
      refuse(name, "grid: a name " + problem);
    for (const AnyGrid& other : grids)
      if (const std::string clash = grid_names_clash(grid.name, other.name); !clash.empty())
        refuse(name, "grid: " + clash);
    grids.push_back(std::move(grid));
  }
  return grids;
}

}  // namespace hottel
