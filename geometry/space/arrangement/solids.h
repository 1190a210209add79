// The solids of a scene: what closed meshes with their fronts outward contain.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/space/scene/plane_frame.h"
#include "geometry/space/scene/scene.h"
#include "kernel/doubles.h"

namespace hottel {

// A group of polygons that is a closed mesh: its outlines, each in its sense, cancel; patches do not count. Or all
// groups of one body of which none is.
struct ClosedMesh3 {
  // kSolid:   winding numbers beside its faces are 0 and 1: fronts outward; it may touch itself
  // kRoom:    they are 0 and -1: fronts inward
  // kTangled: neither; it makes nothing solid
  enum class Kind : unsigned char { kSolid, kRoom, kTangled };

  // Holds what is in it, rounding included.
  struct Box {
    std::array<double, 3> low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};

    void include(const Point3& point);
    void include(const Box& other);
    bool meets(const Box& other) const;
  };
  struct Face {
    std::uint32_t surface;
    PlaneFrame3 frame;
    FlatRegion3 region;
    bool is_front_up;                         // its front is on the side of the frame's normal
    std::vector<std::vector<Point3>> pieces;  // convex ones that it consists of
    Box box;
  };

  std::uint32_t group = 0;  // of a body the first
  std::string name;         // of the group, or the body
  std::vector<Face> faces;
  Box box;
  Kind kind = Kind::kTangled;
};

// A side of a plane at a point: the point moved a little to that side.
struct PlaneSidePoint3 {
  const PlaneFrame3* frame;
  FlatPoint3 at;
  bool is_up;
};

// The closed meshes of a scene, and what is inside. A point is solid where a mesh of kind kSolid has winding number 1
// around it, unless it is within a mesh of kind kRoom that lies in that one: none of
// its points is outside.
//
//   (1) groups that have a back with a material, or say "behind": "open", make nothing solid
//   (2) a group that says "behind": "solid" is of kind kSolid, or its body is
//   (3) exact: winding numbers are counted along rays, by rational numbers
//
// COST: linear in the faces of meshes for each point, less where boxes tell; n^2 boxes for n faces of one mesh.
class Solids3 {
 public:
  // Throws InputError naming the group, and where it is open, for one that says "behind": "solid" and is none.
  // REQUIRES: polygons without a problem. The scene need not outlive this.
  explicit Solids3(const Scene3& scene);

  const std::vector<ClosedMesh3>& meshes() const { return meshes_; }
  bool is_empty() const { return !has_solid_; }
  // The mesh of a group, or of its body, or nothing.
  const ClosedMesh3* mesh_of(std::uint32_t group) const;

  // A point within a convex polygon of a plane, counter-clockwise, that no face of a mesh touches that is not in that
  // plane. REQUIRES that none meets it along a line.
  FlatPoint3 inner_point(const PlaneFrame3& frame, const std::vector<FlatPoint3>& polygon) const;

  // The solid mesh that a side of a plane looks into, the first one listed. REQUIRES: no face that is not in the plane
  // touches the point.
  std::optional<std::uint32_t> behind(const PlaneSidePoint3& side) const;  // index into meshes()

  // Whether a solid mesh is one that the side looks into. REQUIRES the same.
  bool is_behind(const PlaneSidePoint3& side, const ClosedMesh3& mesh) const;

  // The solid mesh in whose inside a point is; nothing for points of its faces.
  std::optional<std::uint32_t> around(const Point3& point) const;

  // The segments along which the faces of solids and rooms meet a plane other than their own, those that enter a convex
  // polygon there, which is counter-clockwise in the frame and in the box.
  void append_cuts(const PlaneFrame3& frame, const std::vector<FlatPoint3>& polygon, const ClosedMesh3::Box& box,
                   std::vector<FlatSegment3>& cuts) const;

 private:
  struct Candidate;
  bool add_if_closed(const Scene3& scene, const Candidate& candidate);
  void add_bodies(const Scene3& scene, std::vector<Candidate> groups);
  template <class Beside>
  bool is_within(std::size_t mesh, const Beside& beside) const;

  std::vector<ClosedMesh3> meshes_;
  std::vector<std::optional<std::uint32_t>> mesh_of_;  // by group
  std::vector<std::vector<std::uint32_t>> rooms_in_;   // by mesh
  bool has_solid_ = false;
};

}  // namespace hottel
