// The direct exchange area of two patches, with all that stands between them.
#pragma once

#include <array>
#include <memory>

#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/arrangement/patch.h"
#include "geometry/space/unobstructed/pair_result.h"
#include "geometry/space/unobstructed/unobstructed.h"

namespace hottel {

struct PairDetails3;
struct PairOccluders3;
class FirstMet3;
class PairPatch3;
class PairRow3;

// Measures pairs of patches among the polygons of a scene.
//
// Where many surfaces may stand between, one of the patches is cut in two, again and again, while the hulls of each
// half with the other patch hold so many fewer surfaces that both halves together cost less than the whole. This pays
// because the cost of a pair grows faster than the number of surfaces between. A pair whose integrals do not converge
// is cut in two as well. The measures, errors and bounds of the parts are summed.
//
// Neighbours in one plane hide as one polygon where their union is convex (MergedOccluders3). Patches stay as they are.
//
// First it is asked whether convex bodies and large surfaces hide all (Hiders3), of halves too. Surfaces that no line
// from the first patch meets first are left out, all at once (FirstMet3).
//
// All of the sky is measured in cones of directions (sky_cones()), and so is a part of it that is given as one.
//
// For several threads at once: what is kept between calls is made beforehand; each call has working memory of its own.
class PairIntegrator3 {
 public:
  // REQUIRES: the occluders outlive this, and no two of them share an area of one plane (validate of Scene3).
  explicit PairIntegrator3(const Occluders3& occluders);
  ~PairIntegrator3();

  // REQUIRES: patches of these occluders, as Patch3 says; only the second may be of the sky. If `details` is not null,
  // it receives what the measure is made of (pair_details.h), and everything that may stand between is walked; it has
  // stretches only where the measure is a sum along edges. The number is the same bit for bit without them.
  PairResult3 measure(const Patch3& i, const Patch3& j, const PairRequest3& request = {},
                      PairDetails3* details = nullptr) const;

  // Returns how many surfaces may stand between two patches, in its hull: 0 where none does or one hides all; of all of
  // the sky the most in a cone. What such a pair costs grows with it, though several together may hide it.
  // COST: some 10 microseconds, and that of all its cones of the sky.
  std::size_t count_between(const Patch3& i, const Patch3& j) const;

 private:
  friend class PairPatch3;
  friend class PairRow3;
  struct Halves;
  struct Known;                            // what is known of a patch
  using Areas = std::array<Enclosure, 2>;  // of both patches; of a part of the sky any

  // Where `first_met`, of the first one, is null, everything that may stand between is walked.
  PairResult3 measure(const Known& i, const Known& j, const PairRequest3& request, PairDetails3* details,
                      FirstMet3* first_met) const;
  PairResult3 measure_sky(const Known& i, const PairRequest3& request, PairDetails3* details,
                          FirstMet3* first_met) const;
  bool may_be_hidden(const Known& first, const Known& second) const;
  // Of patches whose surfaces are numbered as by MergedOccluders3, like all that follow.
  bool are_hidden(const Patch3& i, const Patch3& j, int questions) const;
  // `cuts`: how often patches may still be cut.
  PairResult3 measure_set(const PairOccluders3& setting, const Patch3& i, const Patch3& j, const Areas& areas,
                          const PairRequest3& request, int cuts, PairDetails3* details,
                          const FirstMet3* first_met) const;
  // halves(): one patch is cut in two, the first where cuts_first. both_halves(): both ways. cheaper_halves(): the way
  // that costs less. least_work(): about what halves cost at least, if they are cut up to `cuts` times more.
  Halves halves(const PairOccluders3& setting, const Patch3& i, const Patch3& j, bool cuts_first,
                const FirstMet3* first_met) const;
  std::array<Halves, 2> both_halves(const PairOccluders3& setting, const Patch3& i, const Patch3& j,
                                    const FirstMet3* first_met) const;
  Halves cheaper_halves(const PairOccluders3& setting, const Patch3& i, const Patch3& j,
                        const FirstMet3* first_met) const;
  double least_work(const Halves& halves, const Patch3& i, const Patch3& j, int cuts, const FirstMet3* first_met) const;
  std::unique_ptr<Halves> worthwhile_halves(const PairOccluders3& setting, const Patch3& i, const Patch3& j,
                                            const FirstMet3* first_met) const;
  PairResult3 measure_halves(const Halves& halves, const Patch3& i, const Patch3& j, const Areas& areas,
                             const PairRequest3& request, int cuts, const FirstMet3* first_met) const;
  // What two patches exchange with nothing between them.
  UnobstructedMeasure3 measure_alone(const Patch3& i, const Patch3& j, const Areas& areas, double tolerance,
                                     Effort3 effort) const;
  Areas areas(const Patch3& i, const Patch3& j) const;
  PairResult3 measure_along(const PairOccluders3& setting, const Patch3& i, const Patch3& j, const Areas& areas,
                            const PairRequest3& request, PairDetails3* details) const;

  struct Prepared;
  std::unique_ptr<const Prepared> prepared_;
};

// A patch with all that its pairs take of it, whatever the other one is. For several threads at once.
class PairPatch3 {
 public:
  // REQUIRES: measurer and patch outlive this. COST: some microseconds; some 500 bytes beside the patch.
  PairPatch3(const PairIntegrator3& measurer, const Patch3& patch);
  ~PairPatch3();
  PairPatch3(PairPatch3&&) noexcept;
  PairPatch3& operator=(PairPatch3&&) noexcept;

 private:
  friend class PairRow3;
  std::unique_ptr<const PairIntegrator3::Known> known_;
};

// The pairs of one patch with others: the same numbers as those of PairIntegrator3, bit for bit, with what is known of
// the patch kept from one to the next. For one thread at a time.
class PairRow3 {
 public:
  // REQUIRES: measurer and patch outlive this. COST: a byte a surface.
  PairRow3(const PairIntegrator3& measurer, const Patch3& i);
  ~PairRow3();
  PairRow3(PairRow3&&) noexcept;
  PairRow3& operator=(PairRow3&&) noexcept;

  PairResult3 measure(const PairPatch3& j, const PairRequest3& request = {});
  PairResult3 measure(const Patch3& j, const PairRequest3& request = {});

 private:
  const PairIntegrator3* measurer_;
  PairPatch3 first_;
  std::unique_ptr<FirstMet3> first_met_;
};

}  // namespace hottel
