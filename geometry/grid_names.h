// What the grids of a scene are called, in the plane and in space: of several each has a name, which is part of the
// names of its files.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "geometry/name.h"
#include "kernel/support/failure.h"

namespace hottel {

// Returns why a grid of several may not be called so, as the end of a sentence ("must not be empty"); empty when it
// may: a name is well-formed UTF-8 of at most 100 bytes, can be part of the name of a file (no control characters, none
// of / \ : * ? " < > |).
std::string grid_name_problem(const std::string& name);

// Returns what grids are called, for messages: 'floor', 'desk'.
template <class AnyGrid>
std::string names_of_grids(const std::vector<AnyGrid>& grids) {
  std::string names;
  for (const AnyGrid& grid : grids) names += (names.empty() ? "" : ", ") + quoted_name(grid.name);
  return names;
}

// Returns the grid of that name; null where there is none.
template <class AnyGrid>
const AnyGrid* grid_called(const std::vector<AnyGrid>& grids, const std::string& name) {
  const auto found = std::ranges::find(grids, name, &AnyGrid::name);
  return found == grids.end() ? nullptr : &*found;
}

// Returns why a grid may not be called so beside another one, as a sentence; empty when it may: names differ by more
// than A to Z for a to z, as on a disk without case their files would be one.
inline std::string grid_names_clash(const std::string& name, const std::string& other) {
  if (name == other) return "two are called " + quoted_name(name);
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  if (!std::ranges::equal(name, other, {}, lower, lower)) return "";
  return quoted_name(other) + " and " + quoted_name(name) +
         " differ in case only: on a disk without case their files would be one";
}

// Throws InputError naming the file unless
//
//   (1) no grid has a problem (grid_problem)
//   (2) names are good (grid_name_problem); one grid alone may be without
//   (3) no two names clash (grid_names_clash)
template <class AnyGrid>
void validate_grids(const std::vector<AnyGrid>& grids, const std::string& file) {
  for (std::size_t k = 0; k < grids.size(); ++k) {
    const AnyGrid& grid = grids[k];
    std::string problem = grid_problem(grid);
    if (problem.empty() && (grids.size() > 1 || !grid.name.empty()))
      if (const std::string of_name = grid_name_problem(grid.name); !of_name.empty()) problem = "a name " + of_name;
    for (std::size_t other = 0; other < k && problem.empty(); ++other)
      problem = grid_names_clash(grid.name, grids[other].name);
    if (!problem.empty()) throw InputError({file, 0}, "grid: " + problem);
  }
}

}  // namespace hottel
