// What is hidden behind solids all along a stretch, in doubles. Internal to geometry/space/exchange.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/space/between/pair_geometry.h"
#include "geometry/space/hiding/outward_plane.h"
#include "geometry/space/stretches/stretch.h"
#include "geometry/space/visibility/direction.h"

namespace hottel {

// Narrows lists of what may hide something from a stretch: what is within the cone of a solid, from every point of the
// stretch, hides nothing that the solid does not.
//
// The points from which a solid stands before a corner are a convex set, and so are those from which it stands beyond
// it: so what holds at both ends of a stretch holds between them. That a line meets the solid is told by a place on it
// that is deeper in the solid than doubles may be off.
//
//   (1) what is left hides all that the list hides
//   (2) what is left is in the order of how large it looks from the middle of the stretch
//
// Numbers are those of bodies, or, behind all of these, of solids. For one thread.
class SolidCover3 {
 public:
  // REQUIRES: the bodies outlive this.
  explicit SolidCover3(const PairGeometry3& bodies);

  // REQUIRES: all of the stretch is within the lids of the solids in the list. COST: some 10 ns for two of the list.
  void narrow(const Stretch3& stretch, double low, double high, std::vector<std::uint32_t>& list);

 private:
  // What is in a list, as a ball around it holds it.
  struct Item {
    Direction3 middle;
    double radius = 0;
    std::vector<std::uint32_t> corners;
    // Of solids.
    std::vector<OutwardPlane3> planes;
    std::vector<OutwardPlane3> lid;  // none or one
  };
  // As it looks from the middle of the stretch.
  struct Look {
    std::uint32_t number;
    double size;  // the square of the sine of half its width; above 1 from within
    Direction3 way;
  };
  const Item& item(std::uint32_t number);
  bool covers(std::uint32_t solid, std::uint32_t other, const std::array<Direction3, 2>& ends);
  bool is_within_lid(std::uint32_t solid, std::uint32_t other);

  const PairGeometry3& bodies_;
  std::vector<Direction3> places_;  // of points
  double deep_ = 0;
  std::vector<Item> items_;
  std::vector<signed char> within_lids_;  // of solids and items: 0 where it was not asked, 1 no, 2 yes
  std::vector<Look> looks_, kept_;
};

}  // namespace hottel
