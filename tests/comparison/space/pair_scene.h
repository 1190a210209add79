// Pairs of patches of made-up scenes, and their measures in the units of these scenes.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/space/pairs/pair_integrator.h"
#include "tests/oracle/space/space_polygon.h"

namespace hottel::oracle {

// The polygons of a scene as occluders, and patches among them.
class PairScene3 {
 public:
  explicit PairScene3(const std::vector<SpacePolygon>& polygons);

  std::size_t size() const { return occluders_.size(); }
  const Occluders3& occluders() const { return occluders_; }

  // The front of polygon s, or its back.
  Patch3 patch(std::size_t s, bool is_back = false) const;
  // The four equal parts of the front of a triangle or a parallelogram. REQUIRES that it is one.
  std::vector<Patch3> quarters(std::size_t s) const;
  // The sides of a box that is larger than the scene by this many units of the integer form, seen from inside.
  std::vector<Patch3> sky(long margin) const;

  // Measures and areas in scene units.
  PairResult3 measure(const Patch3& i, const Patch3& j, const PairRequest3& request = {}) const;
  double unobstructed(const Patch3& i, const Patch3& j) const;
  double area(const Patch3& i) const;
  const PairIntegrator3& measurer() const { return measurer_; }
  // One of the squares of doubles of Vertices3, in scene units.
  double unit() const { return unit_; }

 private:
  Occluders3 occluders_;
  PairIntegrator3 measurer_;
  double unit_;
};

}  // namespace hottel::oracle
