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
#include "io/scene/passed_over.h"

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
//   (2) groups and materials are those that faces have, in the order of the faces; OBJ files name both, STL files of
//       several solids groups. Their names differ
struct Mesh3 {
  std::string file;
  std::vector<MeshFace3> faces;
  std::vector<MeshName3> groups, materials;
  std::map<std::string, Material> library;  // of all its MTL files, by name
  bool is_one_body = false;                 // its groups are parts of one (Group::body)
  std::vector<std::string> bodies;          // what groups are parts of, as the file calls it; empty: each of none
  bool has_library = false;                 // it names an MTL file that is there
  std::vector<std::string> library_files;   // those that were read
  std::string missing_library;              // the first that it names and that is not there; empty: none
  PassedOver passed_over;                   // what is no face
  // What the last digit of coordinates stands for: that of a decimal number, 0 where there is none; or, where they are
  // binary floating-point numbers, how many binary digits these have.
  Rational unit;
  int float_digits = 0;
};

}  // namespace hottel
