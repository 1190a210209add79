// Methods that look at two patches at a time: what they share.
#pragma once

#include <optional>
#include <utility>

#include "solver/methods/pair_rows.h"
#include "solver/space/methods/element_geometry.h"
#include "solver/space/methods/exchange_method.h"
#include "solver/space/methods/quadrature_claims.h"
#include "solver/space/methods/segment_visibility.h"

namespace hottel {

// A method whose factor of two elements depends on these two, and on what stands between them. The matrix is made by
// matrix_of_pairs; the sky gets what a row lacks of 1 where one of 256 directions from the centre of a patch is free.
class PairMethod3 : public ElementMethod3 {
 public:
  const MethodInfo& info() const final { return info_; }
  FactorsOfPairs factors_of_pairs(const PreparedScene3& prepared) const final;
  // Proven of pairs that see each other wholly, by its rule (quadrature_claims.h); nothing without one.
  std::optional<double> declared_error(const PreparedScene3& prepared) const final;
  ClaimedErrors claimed_errors(const PreparedScene3& prepared) const final;

 protected:
  // rule: by which pairs that see each other wholly are measured, on both patches.
  explicit PairMethod3(MethodInfo info, std::optional<PatchRule3> rule = {}) : info_(std::move(info)), rule_(rule) {}
  ExchangeMatrix compute_elements(const PreparedScene3& prepared, const std::function<void(double)>& progress,
                                  MethodReport& report) const final;

  // What a method computes from. All of it outlives what pairs() returns.
  struct Setting {
    const PreparedScene3& prepared;
    const ElementGeometry3& geometry;
    const SegmentVisibility3& visibility;
  };
  virtual PairsOfElements pairs(const Setting& setting) const = 0;

 private:
  // The same, and what lies on each other.
  PairsOfElements pairs_and_contacts(const Setting& setting) const;

  MethodInfo info_;
  std::optional<PatchRule3> rule_;
};

// The point that stands for all of a patch.
inline SurfacePoint3 centre_point(const ElementPatch3& patch) { return {patch.centre, patch.piece}; }

// Every later element is a partner of an element: for methods that find out by the factor.
std::function<void(std::uint32_t, std::vector<std::uint32_t>&)> all_later_elements(const ElementGeometry3& geometry);

// The factors that belong to a measure S(a, b) of two patches: F_ab = S / (area of a), summed over the patches of both
// elements. Both are 0 where the sum is not above 0. Patches of one piece, its front and its back, exchange nothing.
template <class Measure>
PairFactors sum_over_patches(const ElementGeometry3& geometry, std::uint32_t i, std::uint32_t j,
                             const Measure& measure) {
  double sum = 0;
  for (const ElementPatch3& a : geometry.patches(i))
    for (const ElementPatch3& b : geometry.patches(j))
      if (a.piece != b.piece) sum += measure(a, b);
  return sum > 0 ? PairFactors{sum / geometry.area(i), sum / geometry.area(j)} : PairFactors{};
}

}  // namespace hottel
