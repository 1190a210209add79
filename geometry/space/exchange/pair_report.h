// What two faces of a scene in space, or a face and the sky, exchange, and how that is known.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/face.h"
#include "geometry/space/between/pair_visibility.h"
#include "geometry/space/pairs/pair_details.h"
#include "geometry/space/point.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/enclosure.h"

namespace hottel {

// A number with what is proven of it, and with what it may be off, as an estimate.
struct Estimate3 {
  double value = 0, error = 0;
  Enclosure bounds{0, 0};
};

// A pair of faces, or a face and the sky, which are the six walls of a box around the scene. Measures are in m², or in
// squares of the unit of the scene where that is unknown.
//
//   (1) exchange is S, unobstructed is S0, with everything else taken away; of the sky that is the area of the face.
//       They are what exact_exchange has of the pair, bit for bit, and so are visibility and factors
//   (2) visibility is S / S0, below 1 whenever something hides a part, above 0 whenever something is seen; nothing
//       where S0 is 0. Its error is 0: it is no estimate of its own
//   (3) stretches are those of the sum along edges, also where the measure has a closed form: along_edges is their sum.
//       Of a pair that is hidden there are none
struct PairReport3 {
  struct Stretch {
    StretchRole3 role;
    bool is_on_from, is_on_to;                // the face that it is on: an edge of it, or where something stands on it
    Point3 from, to;                          // exact, scene coordinates
    std::vector<std::uint32_t> surfaces;      // that may stand between and end there, ascending
    std::uint32_t relied;                     // polynomials of which signs were relied on
    std::vector<PairDetails3::Piece> pieces;  // measures as of the pair
    double measure = 0;                       // their sum
  };

  PairVisibility3 sight = PairVisibility3::kHidden;
  bool is_whole = false;  // nothing hides any part
  // Surfaces that may stand between, with those that are one convex polygon with such a one, ascending.
  std::vector<std::uint32_t> between;
  // One that hides everything, or several that do so as one convex polygon, ascending; else none.
  std::vector<std::uint32_t> hiders;
  Estimate3 exchange, unobstructed;
  std::optional<Estimate3> visibility;
  std::optional<Rounded> area_from, area_to;        // none of the sky
  std::optional<Estimate3> factor_from, factor_to;  // view factors from each to the other
  double tolerance = 0;                             // on S, relative to the smaller area

  std::uint32_t looked_at = 0;  // stretches
  std::vector<Stretch> stretches;
  Estimate3 along_edges;
  std::string problem;  // of the sum along edges where the measure has a closed form, as PairResult3; else empty
  double residual = 0, residual_bound = 0;  // of translation, in metres as measures are in their squares
  std::uint32_t maps = 0, pieces = 0, nodes = 0;
  SignCounts signs;

  bool is_facing() const { return unobstructed.bounds.upper > 0; }
  // Whether the bounds of S are within the tolerance.
  bool is_enclosed() const;
};

// Returns the report of a pair; nothing stands for the sky. Where it `proves`, bounds of sums along edges are as narrow
// as the tolerance, as a rule.
//
// Throws RequestError, naming the pair, where it cannot be measured, or its measures are beyond the range of doubles.
// REQUIRES: a face at least. COST: that of measuring the pair twice; some times that where it proves.
PairReport3 pair_report(const PreparedScene3& prepared, const std::optional<Face>& from, const std::optional<Face>& to,
                        double tolerance, bool proves = false);

}  // namespace hottel
