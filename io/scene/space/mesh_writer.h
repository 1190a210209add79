// Scenes as files of meshes.
#pragma once

#include <string>
#include <vector>

#include "geometry/space/scene/scene.h"
#include "io/scene/space/mesh_reader.h"

namespace hottel {

// A scene as the file of a mesh.
struct WrittenMesh3 {
  std::string bytes;
  std::string library;             // the MTL file that an OBJ file names; empty where it names none
  std::vector<std::string> notes;  // what is not in the file, or not exactly: a sentence each
};

// Returns a scene as a mesh: PLY and OFF as text, STL binary. `library` is the name of the MTL file for OBJ.
//
//   (1) the faces are those of the scene, in its order, with the same fronts; STL has triangles, so faces of more
//       points are cut into them, at their own points. Equal points are written once, but in STL
//   (2) a coordinate that is a decimal is written exactly (but in STL): who reads exactly reads it back. Others are
//       rounded to the nearest double; in STL all are rounded to the nearest float. Where that changes a value, a note
//       tells how many, which one most and by how much, and which polygons are none any more
//   (3) OBJ holds groups, and materials in its MTL file, which is left out where a mesh without one has the same ones.
//       The others hold neither. What is lost is noted: materials, backs, names, and what else a mesh does not say
//   (4) what patches leave of a front is cut into convex faces; patches are faces as all are. Where corners of them are
//       rounded they are cut into triangles, so that what lies back to back still does so (PatchedFaces3)
//   (5) what is solid in the scene and not in the file, as it is read again, is noted. OBJ has objects for what closes
//       only together with its patches, and for bodies (mesh_objects)
//
// REQUIRES: validate(scene) holds. Throws RequestError for a coordinate beyond the numbers of the format, names that an
// OBJ file cannot hold, obstructions, and no polygons. COST: n log n.
WrittenMesh3 write_mesh_3(const Scene3& scene, MeshFormat3 format, const std::string& library);

}  // namespace hottel
