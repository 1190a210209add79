// Meshes become surfaces of a scene.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry/space/scene/triangulator.h"
#include "io/scene/passed_over.h"
#include "io/scene/space/mesh.h"

namespace hottel {

// The material of faces of a mesh that name none, and the reflectivity of materials that no file defines, where the
// mesh is a scene by itself: it says neither. As for drawings (kSvgMaterial, kSvgReflectivity).
inline constexpr const char* kMeshMaterial = "white";
inline const Rational kMeshReflectivity{1, 2};

// How a mesh enters a scene.
struct MeshEntry3 {
  std::string name;                                        // of faces in no group
  Rational scale = 1;                                      // of coordinates
  std::optional<std::uint32_t> material;                   // of faces that name none; index into the scene's materials
  std::optional<std::uint32_t> back;                       // of all backs but those of `backs`
  std::unordered_map<std::string, std::uint32_t> backs{};  // of backs by their group: a group of the mesh, or `name`
  std::uint32_t elements = 1;
  Behind behind = Behind::kByOutline;  // of all groups
  int line = 0;                        // of the mesh in the file of the scene; 0: faces have their own there
  bool invents_materials = false;      // what no file defines has kMeshReflectivity
};

// Adds meshes to a scene.
//
//   (1) face k of a group is GROUP[k], k from 0 in the order of the file; those without a group are NAME[k]. Groups
//       become groups of the scene, numbered by their first faces
//   (2) a material is the one that the scene had of that name before any mesh, else that of the mesh's MTL files; only
//       those that faces have are added. Meshes may share one, if it is the same in both files
//   (3) a corner of a face that repeats the one before, or the first, is passed over, and counted; so is a face that
//       then has no area, unless none has any. It keeps its number
//   (4) a face that runs to its holes and back along seams has these holes (open_seams)
//   (5) surfaces know where they stand in the file (Surface::in_mesh)
//   (6) groups of one body of the mesh are of one of the scene, called as that, or NAME~2 where another mesh or
//       the scene itself has one of the name
//   (7) faces that are plane but for the last digits of the file are nearly plane (accept_nearly_plane)
class MeshAdder3 {
 public:
  // Faces that are not plane are refused, or cut by the triangulator. REQUIRES that all outlive this, and that the
  // scene has all materials of its own, and gets others from here only.
  explicit MeshAdder3(Scene3& scene, Triangulator3* triangulator = nullptr, PassedOver* passed_over = nullptr);

  // Throws InputError with the file of the mesh and the line of the face (or its byte, in a binary file), naming it,
  // for a face that is no polygon (polygon_problem), or has no material; where none has an area, for the first; for a
  // group whose name cannot be one (name_problem), a material that is not defined or is another one in another mesh.
  // COST: linear.
  void add(const Mesh3& mesh, const MeshEntry3& entry);

  // The names of materials that no file defines, in the order in which faces had them.
  const std::vector<std::string>& invented() const { return invented_; }

 private:
  struct Adding;
  void add_face(Adding& adding, const MeshFace3& face);
  void pass_over(const Mesh3& mesh, const MeshFace3& face, PassedKind kind, const std::string& name,
                 std::size_t count = 1);
  std::uint32_t group_of(Adding& adding, const MeshFace3& face);
  std::uint32_t material_of(Adding& adding, const MeshFace3& face, const std::string& surface);
  std::uint32_t material_of(const Mesh3& mesh, const MeshName3& name, bool invents);
  std::uint32_t added_material(const Mesh3& mesh, int line, Material material);

  Scene3& scene_;
  Triangulator3* triangulator_;
  std::unordered_map<std::string, std::uint32_t> own_, added_;  // materials
  std::vector<std::string> invented_;
  PassedOver* passed_over_;
};

// A mesh as a scene, and the names of its materials that no file defines.
struct MeshScene3 {
  ValidScene3 scene;
  std::vector<std::string> invented;
};

// Returns the scene that a mesh is by itself.
//
//   (1) materials are those of its MTL files; where it names none, all have kMeshReflectivity. Faces that name no
//       material have kMeshMaterial, which has kMeshReflectivity too unless an MTL file defines it
//   (2) faces without a group are called after the file: "room[0]", ... for room.obj; "mesh[0]", ... where that cannot
//       be a name
//
// A triangulator cuts faces that are not plane. Throws InputError as MeshAdder3 and validate do.
MeshScene3 scene_of(const Mesh3& mesh, Triangulator3* triangulator = nullptr, PassedOver* passed_over = nullptr);

}  // namespace hottel
