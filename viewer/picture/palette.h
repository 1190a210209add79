// The colours of all drawings, in one place.
#pragma once

#include <array>

#include "viewer/picture/canvas.h"

namespace hottel::palette {

// Paper and ink, and what lies on the ground: floors are light and warm, solids grey with a darker hatch.
inline constexpr Colour kPaper{0.992, 0.988, 0.980};
inline constexpr Colour kInk{0.145, 0.153, 0.180};
inline constexpr Colour kSoftInk{0.40, 0.405, 0.43};
inline constexpr Colour kFloor{0.965, 0.938, 0.893};
inline constexpr Colour kSolid{0.875, 0.872, 0.868};
inline constexpr Colour kHatch{0.755, 0.752, 0.750};
inline constexpr Colour kUnlitSolid{0.235, 0.235, 0.250};  // in pictures of light
inline constexpr Colour kUnlitHatch{0.330, 0.330, 0.345};
inline constexpr Colour kSky{0.80, 0.88, 0.95};  // where there is no light to show
// What is told apart by its colour: a face that emits, an edge that is highlighted, the light and the rays of a view.
inline constexpr Colour kEmitter{0.98, 0.72, 0.10};
inline constexpr Colour kTarget{0.02, 0.62, 0.83};
inline constexpr Colour kLight{1.0, 0.80, 0.30, 0.55};
inline constexpr Colour kRay{0.85, 0.46, 0.10, 0.75};
inline constexpr Colour kFirst{0.02, 0.62, 0.83};   // edge A of a pair
inline constexpr Colour kSecond{0.83, 0.18, 0.42};  // edge B of a pair

// What is exactly 0 on a logarithmic scale.
inline constexpr Colour kZero{0.845, 0.860, 0.875};

// Curves of a plot, in this order: hues far apart, neighbours of different lightness (after Okabe and Ito, "Color
// Universal Design", 2008).
inline constexpr std::array<Colour, 10> kCurves{{{0.00, 0.45, 0.70},
                                                 {0.84, 0.37, 0.00},
                                                 {0.00, 0.62, 0.45},
                                                 {0.62, 0.20, 0.55},
                                                 {0.90, 0.62, 0.00},
                                                 {0.34, 0.71, 0.91},
                                                 {0.55, 0.32, 0.18},
                                                 {0.85, 0.45, 0.65},
                                                 {0.40, 0.48, 0.10},
                                                 {0.45, 0.47, 0.55}}};

}  // namespace hottel::palette
