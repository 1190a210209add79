// What a caller asks of a computation of view factors.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geometry/element.h"
#include "geometry/scene_table.h"

namespace hottel {

class ExchangeMatrix;

// A choice of rows, by sides and surfaces.
//
//   (1) the default chooses every row; equal choices choose the same
//   (2) it chooses all elements of a face or none
class RowChoice {
 public:
  RowChoice() = default;
  // Returns the choice that a word makes of the rows of a scene.
  //
  //   (3) "fronts": all but backs, also where a surface is called so
  //   (4) NAME or a pattern: both sides of the surfaces that surfaces_matching() finds; with ":back" at its end only
  //       their backs. Of groups: those that have such a surface
  //
  //   (5) what is chosen may have no row: then the matrix has no entries
  //
  // Throws UnknownName where no surface matches. COST: linear in the surfaces.
  static RowChoice of(const SceneTable& scene, const std::string& word, Granularity granularity);

  // The fronts of these surfaces. REQUIRES an ascending list that is not empty.
  static RowChoice fronts_of(std::vector<std::uint32_t> surfaces);

  bool is_all() const { return sides_ == Sides::kBoth && surfaces_.empty(); }
  bool has(const Element& element) const;
  // The elements that are chosen, ascending.
  std::vector<std::uint32_t> labels(const std::vector<Element>& elements) const;

  friend bool operator==(const RowChoice&, const RowChoice&) = default;

 private:
  enum class Sides : unsigned char { kBoth, kFronts, kBacks };

  Sides sides_ = Sides::kBoth;
  std::vector<std::uint32_t> surfaces_;  // ascending; empty: all
};

// Throws UsageError where a row is empty because it was not chosen.
void require_chosen(const RowChoice& rows, const ExchangeMatrix& matrix, std::uint32_t row);
// Throws UsageError unless all rows are chosen, which radiosities are computed from.
void require_all(const RowChoice& rows);

// How the factor from an element to the sky is computed.
enum class SkyBy : unsigned char {
  kIntegral,  // by integration, as all others are
  kClosure,   // as 1 less all others of its row; SkyByClosure says in which rows
};

// What is asked of a computation of view factors, by any method, in the plane or in space.
//
//   (1) a request chooses rows and columns, leaves out what is not needed, and limits memory. Numbers that are
//       computed with and without it are the same,
//       except for the tolerance, and for the sky by closure
//   (2) the memory limit is checked against an estimate before the work, and against the pairs found during it. Methods
//       that are not exact ignore it
//   (3) a method that has no visibilities or measures leaves them out
struct ExchangeRequest {
  Granularity granularity = Granularity::kFace;
  bool wants_visibility = true;  // else FactorEntry::visibility is NaN
  bool wants_measures = false;   // ExchangeMatrix::measures()
  bool always_sweeps = false;    // also where nothing can hide anything (a convex room): the same numbers, slower
  // What S may be off, relative to the smaller of both areas, where a method can choose. Those of the plane cannot: the
  // exact one rounds correctly, the others are as good as they are.
  double tolerance = 1e-9;
  // Whether the exact method in space proves bounds for every pair, as narrow as the tolerance where it can. It changes
  // a factor only where that lay outside of its bounds, or could not be measured otherwise.
  bool proves = false;
  SkyBy sky = SkyBy::kIntegral;  // of the exact method in space; that of the plane is exact
  // The rows that are computed by the exact methods: all others have no entries. Methods that are not exact compute
  // all.
  RowChoice rows = {};
  std::uint64_t memory = 0;  // bytes the sums and the matrix may take; 0: no limit. Beyond: RequestError
  std::function<void(double)> progress = {};  // fraction done, from any thread; may throw to stop
};

}  // namespace hottel
