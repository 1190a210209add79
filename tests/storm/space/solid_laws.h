// What must hold of scenes of closed bodies, rooms and sheets in space.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "tests/storm/space/solid_scene.h"

namespace hottel::storm {

// S of two faces by their numbers (Face::number), or of a face and the sky.
using FaceMeasures3 = std::map<std::pair<std::uint32_t, std::uint32_t>, double>;
inline constexpr std::uint32_t kSkyFace = 0xffffffff;

// A scene under test: its view factors, or why it is refused.
class SolidSubject3 {
 public:
  // `chance` is what laws draw from.
  SolidSubject3(SolidBodies3 bodies, std::uint64_t chance);

  const SolidBodies3& bodies() const { return bodies_; }
  std::uint64_t chance() const { return chance_; }
  const std::string& refusal() const { return refusal_; }
  // REQUIRE that the scene is not refused.
  const PreparedScene3& prepared() const { return *prepared_; }
  const ExchangeMatrix& matrix() const { return matrix_; }
  const FaceMeasures3& measures() const { return measures_; }

 private:
  SolidBodies3 bodies_;
  std::uint64_t chance_;
  std::string refusal_;
  std::optional<PreparedScene3> prepared_;
  ExchangeMatrix matrix_;
  FaceMeasures3 measures_;
};

struct SolidLaw3 {
  const char* name;
  std::string (*broken)(const SolidSubject3& subject);  // what is wrong, or nothing
  unsigned every;                                       // tried in one of so many scenes
  bool takes_refused = false;                           // scenes that are refused too
};

// The laws, in order. Measures are asked for within 1e-12 of the smaller area, and compared within 1e-10.
//
//   places          at random points the sides of each polygon have the owner that the oracle finds, and are covered
//                   where it finds a solid; a scene is refused where it finds that two materials claim a side, and
//                   nowhere else
//   rows            rows sum to 1; 0 < F and 0 < Vis <= 1; bounds hold the factors; S is the same from both faces
//   areas           areas are the unit squares whose middle the oracle gives to a face; of scenes that are parallel to
//                   the axes
//   by hand         S is that of the scene in which each uncovered part is a polygon of its own, and nothing is covered
//   moved           factors are the same bit for bit for x + 2^53 + 1, y - 2^60 + 7, z + 3, and for 2^20 and 2^-20 x
//   axes            S is the same for the axes in other order, and reflected
//   order           S is the same for bodies in another order, where none overlaps another in one plane
//   split           S of polygons cut in two, or into strips where they are not convex, sum to those of the whole
//   two sides       a sheet with a material on its back is two sheets back to back
//   elements        S of elements sum to those of their faces, and so do areas
//   groups          S of groups are the sums of those of their faces
const std::vector<SolidLaw3>& solid_laws_3();

}  // namespace hottel::storm
