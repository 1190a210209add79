// What a file of a mesh says, whatever its format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/material.h"
#include "geometry/space/scene/polygon.h"

namespace hottel {

// A name in a file of a mesh, and the line where it is first used.
struct MeshName3 {
  std::string name;
  int line = 0;
};

// A face as the file lists it.
struct MeshFace3 {
  Polygon3 polygon;
  std::optional<std::uint32_t> group;     // index into Mesh3::groups; none is named
  std::optional<std::uint32_t> material;  // index into Mesh3::materials; none is named
  int line = 0;                           // 0 in a binary file
  std::optional<std::size_t> byte;        // where it begins in a binary file
};

// What a file of a mesh says.
//
//   (1) coordinates are exact; a face has three points or more, some perhaps equal, and may be no polygon yet
//       (polygon_problem)
//   (2) groups and materials are those that faces have, in the order of the faces; only OBJ files name any
struct Mesh3 {
  std::string file;
  std::vector<MeshFace3> faces;
  std::vector<MeshName3> groups, materials;
  std::map<std::string, Material> library;  // of all its MTL files, by name
  bool has_library = false;                 // it names an MTL file
  // What the last digit of coordinates stands for: that of a decimal number, 0 where there is none; or, where they are
  // binary floating-point numbers, how many binary digits these have.
  Rational unit;
  int float_digits = 0;
};

}  // namespace hottel
