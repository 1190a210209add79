// How values run along the faces of a plan.
#pragma once

#include <optional>
#include <vector>

#include "viewer/picture/plane/corners.h"
#include "viewer/picture/shading.h"

namespace hottel {

// Along a run: linear from its first end to its middle, and from there to its last end.
struct RunValue2 {
  double from = 0, middle = 0, to = 0;

  bool is_constant() const { return from == middle && middle == to; }
  double at(double share) const;  // REQUIRES 0 <= share <= 1, of the way along the run
  friend bool operator==(const RunValue2&, const RunValue2&) = default;
};

// Returns the value along each run of elements, whose values are given; nothing where they are nothing or NaN.
//
//   (1) Shading::kFlat: that of the element, all over
//   (2) else the middle has that of the element, and a point at which two runs of one face meet the mean of both
//       elements by their lengths: nothing jumps there. Other ends have that of the element: of a face, beside what
//       other surfaces or solids cover, and beside an element without a value
//   (3) no value leaves the range of the elements on both sides; equal ones stay, exactly
// REQUIRES runs of elements.
std::vector<std::optional<RunValue2>> run_values_2(const FaceRuns2& runs,
                                                   const std::vector<std::optional<double>>& by_element,
                                                   Shading shading);

}  // namespace hottel
