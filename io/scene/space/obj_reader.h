// Meshes in OBJ files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "geometry/space/scene/scene.h"
#include "io/files/text_file.h"

namespace hottel {

// The material of faces of an OBJ file that name none, and the reflectivity of materials that no file defines, where
// the OBJ file is a scene by itself: it says neither. As for drawings (kSvgMaterial, kSvgReflectivity).
inline constexpr const char* kObjMaterial = "white";
inline const Rational kObjReflectivity{1, 2};

// A name in an OBJ file, and the line where it is first used.
struct ObjName3 {
  std::string name;
  int line = 0;
};

// A face as the file lists it.
struct ObjFace3 {
  Polygon3 polygon;
  std::optional<std::uint32_t> group;     // index into ObjMesh3::groups; none is named
  std::optional<std::uint32_t> material;  // index into ObjMesh3::materials; none is named
  int line = 0;
};

// What an OBJ file says.
//
//   (1) coordinates are exact; a face has three points or more and may be no polygon yet (polygon_problem)
//   (2) groups and materials are those that faces have, in the order of the faces
struct ObjMesh3 {
  std::string file;
  std::vector<ObjFace3> faces;
  std::vector<ObjName3> groups, materials;
  std::map<std::string, Material> library;  // of all its MTL files, by name
  bool has_library = false;                 // it names an MTL file
};

// Returns the mesh of an OBJ file. docs/scene_format.md says what is read (v, f, g, o, usemtl, mtllib), passed over
// because it says nothing of shape or light, and refused; nothing else is there.
//
// MTL files are found relative to the folder of `file`. Throws InputError with file and line.          COST: linear.
ObjMesh3 parse_obj_3(std::string_view text, const std::string& file, const TextSource& files = read_text_file);

// How a mesh enters a scene.
struct MeshEntry3 {
  std::string name;                       // of faces in no group
  Rational scale = 1;                     // of coordinates
  std::optional<std::uint32_t> material;  // of faces that name none; index into the scene's materials
  std::optional<std::uint32_t> back;      // of all backs
  std::uint32_t elements = 1;
  int line = 0;                    // of all faces; 0: each has its own, in the OBJ file
  bool invents_materials = false;  // what no file defines has kObjReflectivity
};

// Adds meshes to a scene.
//
//   (1) face k of a group is GROUP[k], k from 0 in the order of the file; those without a group are NAME[k]. Groups
//       become groups of the scene, numbered by their first faces
//   (2) a material is the one that the scene had of that name before any mesh, else that of the mesh's MTL files; only
//       those that faces have are added. Meshes may share one, if it is the same in both files
class MeshAdder3 {
 public:
  // REQUIRES that the scene outlives this, has all materials of its own, and gets others from here only.
  explicit MeshAdder3(Scene3& scene);

  // Throws InputError with the OBJ file and the line of the face, naming it, for a face that is no polygon
  // (polygon_problem), or has no material; for a group whose name cannot be one (name_problem), a material that is not
  // defined or is another one in another mesh. COST: linear.
  void add(const ObjMesh3& mesh, const MeshEntry3& entry);

  // The names of materials that no file defines, in the order in which faces had them.
  const std::vector<std::string>& invented() const { return invented_; }

 private:
  std::uint32_t material_of(const ObjMesh3& mesh, const ObjName3& name, bool invents);
  std::uint32_t added_material(const ObjMesh3& mesh, int line, Material material);

  Scene3& scene_;
  std::unordered_map<std::string, std::uint32_t> own_, added_;  // materials
  std::vector<std::string> invented_;
};

// An OBJ file as a scene, and the names of its materials that no file defines.
struct ObjScene3 {
  Scene3 scene;
  std::vector<std::string> invented;
};

// Returns the scene that an OBJ file is by itself, valid.
//
//   (1) materials are those of its MTL files; where it names none, all have kObjReflectivity. Faces that name no
//       material have kObjMaterial, which has kObjReflectivity too unless an MTL file defines it
//   (2) faces without a group are called after the file: "room[0]", ... for room.obj; "mesh[0]", ... where that cannot
//       be a name
//
// Throws InputError as parse_obj_3, MeshAdder3 and validate do.
ObjScene3 read_obj_3(const std::filesystem::path& file);
ObjScene3 parse_obj_scene_3(std::string_view text, const std::string& file, const TextSource& files = read_text_file);

}  // namespace hottel
