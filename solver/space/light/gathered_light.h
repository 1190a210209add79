// What faces in space send to points of faces, where radiosity may run over the elements that send.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/element.h"
#include "geometry/face.h"
#include "geometry/space/point.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/direction.h"
#include "geometry/space/visibility/visibility_map.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// How radiosity runs over a part of an element: linearly over each of these triangles, which fill it; its mean over the
// part is that of the element. None: it is that of the element all over.
struct PartRun3 {
  struct Triangle {
    std::array<Direction3, 3> corners;            // in scene coordinates
    std::array<std::array<double, 3>, 3> values;  // by corner and channel
  };
  std::vector<Triangle> triangles;
};

// The irradiance of points of faces by the elements and the sky: sum_j F(x, j) B_j.
//
//   (1) what is seen is decided exactly, from the exact point (VisibilityMap3); angles are in doubles. Where each
//       element has one radiosity the mean over an element is the irradiance that the solution has, but for direct
//       light
//   (2) where radiosity runs over elements, it is summed over parts of them that are so small that this is off by some
//       thousandth at most, as a rule by much less; that is an estimate. Then nothing jumps at the borders of elements
//   (3) direct light of lights is not part of it
//
// REQUIRES that what it is made of outlives it, and the solution of the scene's matrix by that granularity; runs: one
// for each part of the table, or none at all. For several threads at once. COST: that of a map a point, some 100 ns for
// each element that is seen, and as much for each part of one that is near.
class GatheredLight3 {
 public:
  GatheredLight3(const PreparedScene3& prepared, Granularity granularity, const RadiositySolution& solution,
                 std::span<const PartRun3> runs = {});

  std::size_t channels() const { return solution_.channels.size(); }
  // Writes the irradiance at an inner point of what is free of a side of a piece, by channel.
  void irradiance(const Point3& point, const Face& side, std::span<double> result) const;

 private:
  // A point of the plane of a side, by two of its coordinates.
  struct Flat {
    double u, v;
  };
  using Outline = std::vector<Flat>;
  struct Box {
    double low_u, high_u, low_v, high_v;
    bool meets(const Box& other) const;
  };
  // A value that runs linearly, by channel.
  struct Linear {
    std::array<double, 3> one{}, by_u{}, by_v{};
    double at(std::size_t channel, const Flat& p) const {
      return one[channel] + p.u * by_u[channel] + p.v * by_v[channel];
    }
    double reach(const Box& box) const;  // how far it runs in a box, summed over channels
  };
  struct Run {
    Outline outline;
    Box box;
    Linear value;
  };
  struct Part {
    std::uint32_t label;
    Outline outline;  // counter-clockwise in the plane of u and v
    Box box;
    std::vector<Run> runs;
    double reach = 0;  // how far the runs go, summed over channels
  };
  struct Side {
    std::array<std::size_t, 3> axes{};   // of u, v and the third coordinate
    double by_u = 0, by_v = 0, one = 0;  // the third coordinate
    bool is_one_value = true;
    std::vector<Part> parts;
  };
  // Something seen of a part, over which radiosity runs.
  struct Seen {
    const Side* side;
    const Part* part;
    Outline outline;
    double factor;
  };
  // Who looks.
  struct Eye {
    Direction3 place, normal;
  };

  static Box box_of(const Outline& outline);
  static Outline common(const Outline& polygon, const Outline& convex);
  static Outline flat(const Side& side, std::span<const Direction3> corners);
  static Direction3 place(const Side& side, const Flat& p);
  static double factor(const Side& side, const Outline& outline, const Eye& eye);
  void add_side(const Patch3& patch, Side& side) const;
  void add_run(const PartRun3& run, const Side& side, Part& part) const;
  void add_fragment(const VisibilityMap3& map, const VisibilityMap3::Fragment& fragment, const Eye& eye,
                    std::span<double> result, std::vector<Seen>& near) const;
  void add(std::uint32_t label, double factor, std::span<double> result) const;
  void add_runs(const Seen& seen, const Eye& eye, double slack, std::span<double> result) const;
  struct Halving;

  const PreparedScene3& prepared_;
  const RadiositySolution& solution_;
  std::vector<Side> sides_;  // by side of a piece
  std::vector<double> sky_;
};

}  // namespace hottel
