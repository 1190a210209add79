// What a ray meets first, in doubles where they can tell.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tests/oracle/space/nearest_polygon.h"
#include "tests/oracle/space/rough_number.h"

namespace hottel::oracle {

// Tells the same as RayCaster. It goes through the same steps with numbers that know their errors (rough_number.h), and
// asks a RayCaster wherever they do not tell a sign that it needs: that a ray is not plain it never tells by itself.
// For one thread at a time.
class FilteredRayCaster {
 public:
  // REQUIRES: the polygons outlive this.
  FilteredRayCaster(const std::vector<SpacePolygon>& polygons, const SpacePoint& eye);
  NearestPolygon operator()(const SpacePoint& direction);

  // How many rays were asked of the RayCaster.
  std::uint64_t undecided() const { return undecided_; }

 private:
  struct Target {
    int number;
    RoughVector normal;
    RoughNumber height;
    int side = 0;  // the sign of height
    std::vector<RoughVector> sides;
  };
  enum class Meets : unsigned char { kNo, kYes, kMaybe };
  static Meets meets(const Target& target, const RoughVector& direction, const RoughNumber& slope);
  // Nothing where it cannot tell.
  std::optional<NearestPolygon> told(const RoughVector& direction) const;

  const std::vector<SpacePolygon>& polygons_;
  SpacePoint eye_;
  std::vector<Target> targets_;
  std::optional<RayCaster> exact_;
  std::uint64_t undecided_ = 0;
};

}  // namespace hottel::oracle
