// Which elements a point of space sees, and how large they are there.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/direction.h"
#include "geometry/space/visibility/visibility_map.h"

namespace hottel {

// Whether what is black is told too.
enum class Blacks3 : bool { kLeftOut, kListed };

// The elements on the sides of pieces, to be looked for in what points see.
//
//   (1) what is seen is decided exactly, from the exact point (VisibilityMap3); angles are in doubles. Of a face that
//       is divided each element has its part
//   (2) nothing is seen through a solid on whose border a point is
//   (3) with blacks listed the fractions of what is seen and that of the sky sum to 1 but for rounding, but of a point
//       on the border of a solid
//
// REQUIRES that what it is made of outlives it. COST: that of a map a point, and for each face that is seen and divided
// the product of its fragments and elements. For several threads at once.
class SeenElements3 {
 public:
  // Takes an element, as its table numbers it, and a fraction above 0. What is seen in several places is told of each.
  using Take = std::function<void(std::uint32_t, double)>;

  SeenElements3(const PreparedScene3& prepared, const ElementTable3& table, Blacks3 blacks);

  // Tells what fraction of all directions each element has, and returns that of the sky; nothing where several solids
  // meet around the point, and without blacks outside a closed scene, where no face with a material is seen.
  std::optional<double> around(const Point3& eye, const Take& take) const;
  // Tells the view factor of a small area at the point to each element, its front to the normal (not zero, of any
  // length), and returns that to the sky.
  double toward(const Point3& eye, const Vector3& normal, const Take& take) const;

 private:
  struct Part {
    std::uint32_t label;
    std::vector<Direction3> corners;  // in scene coordinates
  };
  struct Side {
    bool is_divided = false;  // its parts are of several elements
    std::vector<Part> parts;
    bool is_covered = false;  // but for these, it looks into solids; none where all of it does
    std::vector<std::vector<Direction3>> free{};
  };

  void add_parts(const ElementTable3& table, Blacks3 blacks);
  void add_covers();
  bool is_in_solids(const VisibilityMap3& map, const Point3& eye) const;
  template <class FractionOf, class Measure>
  void tell(const VisibilityMap3& map, const Point3& eye, const FractionOf& fraction_of, const Measure& measure,
            const Take& take) const;
  template <class Measure>
  void tell_free(const std::vector<Direction3>& cone, const Side& side, const Direction3& eye, const Measure& measure,
                 const Take& take) const;
  template <class Measure>
  void tell_divided(const std::vector<Direction3>& cone, double fraction, const Side& side, const Direction3& eye,
                    const Measure& measure, const Take& take) const;

  const PreparedScene3& prepared_;
  Blacks3 blacks_;
  std::vector<Side> parts_;  // by side of a piece
};

}  // namespace hottel
