#include "geometry/space/pairs/pair_integrator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <list>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "geometry/space/arrangement/merged_occluders.h"
#include "geometry/space/arrangement/surface_boxes.h"
#include "geometry/space/arrangement/whole_patch.h"
#include "geometry/space/between/pair_occluders.h"
#include "geometry/space/hiding/hiders.h"
#include "geometry/space/integrals/moment_origin.h"
#include "geometry/space/pairs/edge_sum.h"
#include "geometry/space/pairs/pair_details.h"
#include "geometry/space/pairs/pair_stretches.h"
#include "geometry/space/pairs/patch_halves.h"
#include "geometry/space/proven/edge_enclosure.h"
#include "geometry/space/sky/no_sky.h"
#include "geometry/space/sky/sky_cones.h"
#include "geometry/space/stretches/surface_stretches.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

// How much less is tried where the residual is not zero: by steps, down to that.
constexpr double kNextShare = 0x1p-8, kLeastShare = 0x1p-16;

// What ends of pieces may be off is made less than this part of what is allowed, by cutting where one makes this part
// of that; and how often.
constexpr double kShareOfJumps = 0.25, kManyJumps = 64;
// Where something may have been missed that is more than this part of what is allowed, the residual is to be so little
// that it is not.
constexpr double kShareOfWhatLacks = 0.25;
constexpr int kMostCutsAtJumps = 4, kMostCutsAtEnds = 3;

// So many surfaces between two patches are taken at once. Where there are more, the pair is cut if its halves cost less
// than this times the whole. And how often patches are cut, together.
constexpr std::size_t kMostBetween = 30;
constexpr double kWorthwhile = 1.2;
constexpr int kMostCuts = 12, kCutsWhereItFails = 3;
// Where all that fails a pair is asked once more for these parts of what is allowed.
constexpr double kCloserShares[] = {0x1p-6, 0x1p-10};

// What is asked of a pair before it is known what is between, and then of each surface between, where these are many.
constexpr int kFirstQuestions = 3, kQuestionsABody = 20;
constexpr std::size_t kManyBetween = 5;

// What a pair costs, about, with so many surfaces between: measured exponents are from 1.6 (plates, slats) to 3 (boxes,
// soup).
double work_between(std::size_t surfaces) {
  const auto n = static_cast<double>(surfaces);
  return n * n * n;
}

constexpr double kOfDouble = 0x1p-51;  // what a measure as a double is told within, of itself

constexpr const char* kNotConverged = "the integral along edges did not converge";

// What is seen is not nothing, however little it is.
constexpr double kLittle = 0x1p-200;

// The smaller area of two patches; the sky has none.
double least_area(const std::array<Enclosure, 2>& areas, const Patch3& second) {
  return second.is_far() ? areas[0].lower : std::min(areas[0].lower, areas[1].lower);
}

// What is allowed as a part of an area; `otherwise` where the area is too small for doubles.
double relative(double allowed, double area, double otherwise) { return area > 0 ? allowed / area : otherwise; }

// Nothing hides anything: the measure is that of the two alone.
void take_alone(const UnobstructedMeasure3& alone, double allowed, PairResult3& result) {
  result.is_whole = true;
  result.measure = alone.measure;
  result.error = alone.error;
  result.bounds = alone.bounds;
  if (!(alone.error <= allowed)) result.problem = "the integral over two patches that see each other did not converge";
}

// What is known is what is proven: the number is half-way between the bounds.
void take_bounds(PairResult3& result) {
  const Enclosure& bounds = result.bounds;
  result.measure = bounds.lower + (bounds.upper - bounds.lower) / 2;
  result.error = std::max(bounds.upper - result.measure, result.measure - bounds.lower);
  result.residual = 0;
}

// Adds what a part of a pair exchanges.
void add_part(const PairResult3& part, PairResult3& sum) {
  sum.is_whole = sum.is_whole && part.is_whole;
  sum.is_undecided = sum.is_undecided || part.is_undecided;
  if (sum.problem.empty()) sum.problem = part.problem;
  sum.measure += part.measure;
  sum.error += part.error;
  sum.bounds = sum_of_nonnegative(sum.bounds, part.bounds);
  sum.residual = std::max(sum.residual, part.residual);
  sum.residual_bound = std::max(sum.residual_bound, part.residual_bound);
  sum.maps += part.maps;
  sum.pieces += part.pieces;
  sum.nodes += part.nodes;
  sum.proof += part.proof;
  sum.signs += part.signs;
}

// Ends a sum of parts, with what all would exchange if nothing hid anything.
void end_sum(const UnobstructedMeasure3& alone, double allowed, PairResult3& sum) {
  if (sum.bounds.upper == 0) {
    sum.is_whole = false;
    sum.measure = sum.error = 0;
  } else if (sum.is_whole) {
    sum.problem.clear();
    take_alone(alone, allowed, sum);
  } else if (sum.error <= allowed) {
    sum.problem.clear();
  } else if (sum.problem.empty()) {
    sum.problem = kNotConverged;
  }
}

// Returns what is hidden of a pair at most: every line that is stopped leaves the patch and meets a side of something
// between, so that no more is hidden than the patch and those sides would exchange alone.
double most_hidden(const PairOccluders3& setting, const Occluders3& occluders, const Patch3& patch, double tolerance) {
  double sum = 0;
  const auto& bodies = setting.bodies.bodies;
  for (std::size_t body = 2; body < setting.bodies.end_of_between(); ++body) {
    Patch3 side = whole_patch(occluders, bodies[body].surface);
    for (int k = 0; k < 2; ++k, std::reverse(side.corners.begin(), side.corners.end()))
      sum += unobstructed_measure(occluders.vertices(), patch, side, tolerance, Effort3::kUsual).bounds.upper;
  }
  constexpr double kRoundings = 0x1p-40;  // of the sum
  return sum * (1 + kRoundings);
}

// Raises the lower bound to the measure of the two alone less what is hidden at most.
void bound_what_is_hidden(const PairOccluders3& setting, const Occluders3& occluders, const Patch3& i, const Patch3& j,
                          double tolerance, const UnobstructedMeasure3& alone, PairResult3& result) {
  double hidden = most_hidden(setting, occluders, i, tolerance);
  if (!j.is_far()) hidden = std::min(hidden, most_hidden(setting, occluders, j, tolerance));
  result.bounds.lower = std::max(0.0, std::nextafter(alone.bounds.lower - hidden, 0.0));
}

bool is_sure(const PairResult3& result) { return result.residual <= result.residual_bound; }

// The sum along edges, to what is allowed. Sets measure, error and residual.
void integrate(double allowed, EdgeSum3& sum, PairResult3& result) {
  const double full = 2 * std::numbers::pi;
  // What is missing, or wrong, at a place moves the measure by its part of the residual times its way from the origin.
  const bool may_lack = sum.may_lack() > kShareOfWhatLacks * full * allowed;
  const double residual_tolerance = (may_lack ? kShareOfWhatLacks / 2 : 1) * full * allowed / sum.reach();
  const double tolerance = (may_lack ? 1 - 2 * kShareOfWhatLacks : 1) * full * allowed;
  // Two rules may agree by chance; the residual tells.
  for (double share = 1; share >= kLeastShare; share *= kNextShare) {
    sum.refine(share * tolerance, share * residual_tolerance);
    const EdgeValues3& values = sum.values();
    result.measure = values.value / full;
    result.error = values.error / full + kOfDouble / 4 * std::fabs(result.measure);
    result.residual = length(values.residual);
    result.residual_bound = std::max(values.residual_error, residual_tolerance);
    if (may_lack)
      result.error += std::min(sum.may_lack(), result.residual * sum.reach()) / full;
    else  // a small part of what is allowed, of which the residual need not tell
      result.error = std::max(result.error, std::min(allowed, result.error + sum.may_lack() / full));
    if (is_sure(result)) break;
  }
  result.nodes = sum.nodes();
}

// The sum along the same edges, cut anew where ends of pieces are not told well enough.
struct FinerSum {
  std::vector<PairStretch3> stretches;
  EdgeSum3 sum;

  FinerSum(std::vector<PairStretch3> s, const PairOccluders3& setting, const MomentOrigin3& origin, long shift)
      : stretches(std::move(s)), sum(setting.bodies, origin, shift) {}
};

// The sums along edges of one pair, each with short stretches cut out of those of the one before.
class FinerSums {
 public:
  FinerSums(const PairOccluders3& setting, const MomentOrigin3& origin, long shift, EdgeSum3& sum)
      : setting_(setting), origin_(origin), shift_(shift), all_(&sum), best_(&sum) {}

  EdgeSum3& best() const { return *best_; }

  // Cuts stretches where ends of pieces are not told well enough, until they are, or nearly so.
  void cut_at_jumps(double allowed, PairResult3& result) {
    const double enough = kShareOfJumps * 2 * std::numbers::pi * allowed;
    for (int round = 0; round < kMostCutsAtJumps && best_->jumps() > enough; ++round) {
      EdgeSum3* const next = add(best_->cut_at_jumps(enough / kManyJumps), result);
      const bool is_better = next != nullptr && next->jumps() < best_->jumps() / 2;
      if (is_better) best_ = next;
      drop_others();
      if (!is_better) break;
    }
  }

  // Cuts all stretches around ends near which something may have been missed that makes the residual. False where they
  // could not be divided.
  bool cut_at_ends(double residual, PairResult3& result) {
    EdgeSum3* const next = add(all_->cut_at_ends(residual / kManyJumps), result);
    if (next != nullptr) all_ = best_ = next;
    drop_others();
    return next != nullptr;
  }

 private:
  EdgeSum3* add(std::vector<PairStretch3> stretches, PairResult3& result) {
    FinerSum& next = finer_.emplace_back(std::move(stretches), setting_, origin_, shift_);
    PairResult3 counts;
    const bool is_divided = next.sum.add(next.stretches, counts);
    result.maps += counts.maps;
    result.signs += counts.signs;
    if (!is_divided) return nullptr;
    result.pieces = counts.pieces;
    return &next.sum;
  }

  void drop_others() {
    finer_.remove_if([this](const FinerSum& one) { return &one.sum != all_ && &one.sum != best_; });
  }

  const PairOccluders3& setting_;
  const MomentOrigin3& origin_;
  long shift_;
  EdgeSum3* all_;  // of all stretches, not only of those along which something is seen
  EdgeSum3* best_;
  std::list<FinerSum> finer_;
};

// Narrows the bounds of a sum along edges to what is proven of it. What is no better than them is taken for the number.
void prove(const PairOccluders3& setting, const MomentOrigin3& origin, long shift,
           const std::vector<PairStretch3>& stretches, double allowed, EdgeSum3& sum, PairResult3& result) {
  EdgeEnclosure3 enclosure(setting.bodies, origin, shift, sum.mapper());
  const Enclosure proven = enclosure.enclose(stretches, sum.sure_stretches(), allowed);
  result.bounds = {std::max(result.bounds.lower, proven.lower), std::min(result.bounds.upper, proven.upper)};
  result.proof += enclosure.counts();
  if (!(result.bounds.lower <= result.bounds.upper)) throw std::logic_error("what is proven of a pair excludes itself");
  PairResult3 bounded = result;
  take_bounds(bounded);
  const bool is_better = bounded.error < result.error;
  if (is_better && !result.problem.empty()) result = std::move(bounded);
  if (is_better && result.error <= allowed) result.problem.clear();
  result.measure = std::clamp(result.measure, result.bounds.lower, result.bounds.upper);
}

void tell_between(const PairOccluders3& setting, PairDetails3& details) {
  const auto& bodies = setting.bodies.bodies;
  for (std::size_t body = 2; body < setting.bodies.end_of_between(); ++body)
    details.between.push_back(bodies[body].surface);
  if (setting.sight == PairVisibility3::kHidden && bodies.size() > 2) details.hiders.assign(1, bodies.back().surface);
}

// Whether a point in the plane of a polygon is in its closure.
bool holds(const Occluders3& occluders, std::uint32_t s, const WeightedPoint3& point) {
  const Vertices3& vertices = occluders.vertices();
  const auto corners = occluders.outline(s);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const IntegerVector& from = vertices.exact(corners[k]);
    const IntegerVector side = difference(vertices.exact(corners[(k + 1) % corners.size()]), from);
    const IntegerVector offset = difference(point.numerator, multiple(point.weight, from));
    if (sgn(dot(occluders.exact_normal(s), cross(side, offset))) < 0) return false;
  }
  return true;
}

}  // namespace

struct PairIntegrator3::Prepared {
  const Occluders3& polygons;
  MergedOccluders3 merged;
  const Occluders3& occluders;
  SurfaceBoxes3 boxes;
  SurfaceStretches3 stretches;
  Hiders3 hiders;
  NoSky3 no_sky;
  explicit Prepared(const Occluders3& p)
      : polygons(p),
        merged(p),
        occluders(merged.occluders()),
        boxes(occluders),
        stretches(occluders, boxes),
        hiders(occluders),
        no_sky(polygons, merged, stretches) {}

  // Whether it is known at once that a patch of one of the surfaces sees no sky.
  bool sees_no_sky(const Patch3& patch) const {
    return no_sky.has(patch.surface, dot_sign(normal_of(patch), occluders.exact_normal(patch.surface)) < 0);
  }

  // A patch as one of the surface that its polygon is part of, where that has another number.
  std::optional<Patch3> moved(const Patch3& patch) const {
    if (patch.is_sky() || merged.surface_of(patch.surface) == patch.surface) return {};
    Patch3 copy = patch;
    copy.surface = merged.surface_of(patch.surface);
    return copy;
  }

  // Names polygons where surfaces are named.
  void tell_polygons(PairDetails3& details) const {
    const auto all_members = [this](std::vector<std::uint32_t>& surfaces) {
      std::vector<std::uint32_t> result;
      for (const std::uint32_t surface : surfaces)
        for (const std::uint32_t polygon : merged.members(surface)) result.push_back(polygon);
      std::sort(result.begin(), result.end());
      surfaces = std::move(result);
    };
    all_members(details.between);
    all_members(details.hiders);
    for (PairDetails3::Stretch& stretch : details.stretches) {
      all_members(stretch.surfaces);
      for (PairDetails3::Piece& piece : stretch.pieces)
        for (PairDetails3::Corner& corner : piece.corners) all_members(corner.surfaces);
      std::erase_if(stretch.surfaces, [&](std::uint32_t s) {
        return !holds(polygons, s, stretch.from) || !holds(polygons, s, stretch.to);
      });
    }
  }
};

struct PairIntegrator3::Known {
  const std::optional<Patch3> moved;
  const Patch3& patch;  // whose surface is numbered as by MergedOccluders3
  const KnownPatch3 known;
  const PlacedPatch3 placed;
  const Enclosure area;  // of a part of the sky none

  Known(const Prepared& prepared, const Patch3& its)
      : moved(prepared.moved(its)),
        patch(moved ? *moved : its),
        known(prepared.occluders, patch),
        placed(prepared.hiders.placed(patch)),
        area(patch.is_far() ? Enclosure{0, 0} : patch_area(prepared.occluders.vertices(), patch)) {}
  Known(const Known&) = delete;  // what is known points to the patch
  Known& operator=(const Known&) = delete;
};

// One of both patches cut in two, and how each half and the other patch are settled: null where they exchange nothing.
struct PairIntegrator3::Halves {
  std::unique_ptr<const std::array<Patch3, 2>> patches;  // settings point into them
  std::array<std::unique_ptr<const PairOccluders3>, 2> settings;
  bool are_of_first = false;
  double work = 0;  // of both together

  // A half in the place of the patch that it is of, with the other one, in order.
  std::pair<const Patch3&, const Patch3&> pair(std::size_t half, const Patch3& i, const Patch3& j) const {
    const Patch3& part = (*patches)[half];
    return {are_of_first ? part : i, are_of_first ? j : part};
  }
};

PairIntegrator3::PairIntegrator3(const Occluders3& occluders) : prepared_(std::make_unique<Prepared>(occluders)) {}
PairIntegrator3::~PairIntegrator3() = default;

namespace {

// Where walking what is between costs much, more is asked before.
int questions_about(const PairOccluders3& setting) {
  const std::size_t between = setting.sight == PairVisibility3::kMixed ? setting.count_between() : 0;
  if (between < kManyBetween) return 0;
  return static_cast<int>(std::min<std::size_t>(kQuestionsABody * between, Hiders3::kMostQuestions));
}

// Whether a pair is to be measured as it usually is.
bool is_usual(const PairRequest3& request) {
  return !request.is_reversed && !request.always_along_edges &&
         std::all_of(std::begin(request.origin_shift), std::end(request.origin_shift),
                     [](double shift) { return shift == 0; });
}

}  // namespace

PairResult3 PairIntegrator3::measure(const Patch3& i, const Patch3& j, const PairRequest3& request,
                                     PairDetails3* details) const {
  const DefaultFloatingPoint environment;
  const bool asks = is_usual(request) && request.asks_hiders;
  if (details == nullptr && asks) return PairRow3(*this, i).measure(j, request);
  PairResult3 result = measure(Known(*prepared_, i), Known(*prepared_, j), request, details, nullptr);
  if (details != nullptr && !prepared_->merged.is_plain()) prepared_->tell_polygons(*details);
  if (!asks) return result;
  // Details are of everything that may stand between; the number is that without them.
  PairResult3 told = PairRow3(*this, i).measure(j, request);
  result.measure = told.measure;
  result.error = told.error;
  result.bounds = told.bounds;
  result.is_whole = told.is_whole;
  result.is_undecided = told.is_undecided;
  result.problem = std::move(told.problem);
  return result;
}

// Not where there is no other surface in the box around both.
bool PairIntegrator3::may_be_hidden(const Known& first, const Known& second) const {
  if (second.patch.is_far()) return true;
  Box3 box = first.known.box;
  box.include(second.known.box);
  return prepared_->boxes.is_any_but(first.patch.surface, second.patch.surface, box);
}

PairResult3 PairIntegrator3::measure(const Known& first, const Known& second, const PairRequest3& request,
                                     PairDetails3* details, FirstMet3* first_met) const {
  const Patch3 &i = first.patch, &j = second.patch;
  if (j.is_all_of_the_sky()) return measure_sky(first, request, details, first_met);
  const auto are_hidden_by = [&](int questions) {
    return prepared_->hiders.hide(first.placed, second.placed, questions);
  };
  if (first_met != nullptr && may_be_hidden(first, second) &&
      ((!j.is_sky() && first_met->is_never_first(j.surface)) || are_hidden_by(kFirstQuestions)))
    return {};
  const Areas areas{first.area, second.area};
  PairRequest3 shared = request;
  if (!shared.share) shared.share = request.tolerance * least_area(areas, j);
  const PairOccluders3 setting(prepared_->occluders, prepared_->boxes, request.is_reversed ? second.known : first.known,
                               request.is_reversed ? first.known : second.known, first_met);
  if (first_met != nullptr)
    if (const int questions = questions_about(setting); questions > 0 && are_hidden_by(questions)) return {};
  return measure_set(setting, i, j, areas, shared, is_usual(request) ? kMostCuts : 0, details, first_met);
}

PairResult3 PairIntegrator3::measure_sky(const Known& first, const PairRequest3& request, PairDetails3* details,
                                         FirstMet3* first_met) const {
  const Patch3& i = first.patch;
  if (is_usual(request) && request.asks_hiders && prepared_->sees_no_sky(i)) return {};
  const Enclosure& area = first.area;
  const double allowed = request.share.value_or(request.tolerance * area.lower);
  const std::vector<Patch3> cones = sky_cones(i);
  bool is_any_clear = false, is_any_hidden = false;
  PairResult3 sum;
  sum.is_whole = true;
  for (const Patch3& cone : cones) {
    const Enclosure alone = unobstructed_sky(prepared_->occluders.vertices(), i, cone).bounds;
    if (alone.upper == 0) continue;
    // Half of what is allowed goes to all alike.
    PairRequest3 part = request;
    part.share = allowed / 2 * (std::min(1.0, alone.upper / area.upper) + 1 / static_cast<double>(cones.size()));
    const KnownPatch3 known(prepared_->occluders, cone);
    const PairOccluders3 setting(prepared_->occluders, prepared_->boxes, first.known, known, first_met);
    const PairResult3 found = measure_set(setting, i, cone, {area, {0, 0}}, part, kMostCuts, details, first_met);
    (found.sight == PairVisibility3::kHidden ? is_any_hidden : is_any_clear) = true;
    sum.sight = std::max(sum.sight, found.sight);
    add_part(found, sum);
    if (sum.is_undecided) return sum;
  }
  if (is_any_clear && is_any_hidden) sum.sight = PairVisibility3::kMixed;
  sum.bounds.upper = std::min(sum.bounds.upper, area.upper);
  end_sum({area.lower, area.upper - area.lower, area}, allowed, sum);
  return sum;
}

bool PairIntegrator3::are_hidden(const Patch3& i, const Patch3& j, int questions) const {
  const Hiders3& hiders = prepared_->hiders;
  return hiders.hide(hiders.placed(i), hiders.placed(j), questions);
}

PairResult3 PairIntegrator3::measure_set(const PairOccluders3& setting, const Patch3& i, const Patch3& j,
                                         const Areas& areas, const PairRequest3& request, int cuts,
                                         PairDetails3* details, const FirstMet3* first_met) const {
  const bool is_mixed = setting.sight == PairVisibility3::kMixed;
  // A cone of the sky is cut nowhere: from all of its parts most of what stands about is seen.
  if (is_mixed && cuts > 0 && !j.is_far() && setting.count_between() > kMostBetween)
    if (const std::unique_ptr<Halves> halves = worthwhile_halves(setting, i, j, first_met))
      if (PairResult3 sum = measure_halves(*halves, i, j, areas, request, cuts, first_met); sum.problem.empty()) {
        if (details != nullptr) measure_along(setting, i, j, areas, request, details);
        return sum;
      }
  PairResult3 whole = measure_along(setting, i, j, areas, request, details);
  const bool may_cut = request.effort == Effort3::kAll && cuts > kMostCuts - kCutsWhereItFails;
  if (!is_mixed || whole.problem.empty() || !may_cut) return whole;
  PairResult3 halves = measure_halves(cheaper_halves(setting, i, j, first_met), i, j, areas, request, cuts, first_met);
  const auto rank = [](const PairResult3& a) { return std::tuple(a.is_undecided, !a.problem.empty(), a.error); };
  PairResult3& better = rank(halves) < rank(whole) ? halves : whole;
  if (better.problem.empty() || better.is_undecided || cuts < kMostCuts) return better;
  // Ends of pieces may be exact enough for the measure and still too far off for the residual.
  for (const double part : kCloserShares) {
    PairRequest3 closer = request;
    closer.share = *request.share * part;
    PairResult3 again = measure_along(setting, i, j, areas, closer, nullptr);
    if (again.problem.empty()) return again;
  }
  return better;
}

std::size_t PairIntegrator3::count_between(const Patch3& i, const Patch3& j) const {
  const DefaultFloatingPoint environment;
  const std::optional<Patch3> moved[] = {prepared_->moved(i), prepared_->moved(j)};
  const Patch3 &first = moved[0] ? *moved[0] : i, &second = moved[1] ? *moved[1] : j;
  const auto count = [&](const Patch3& other) {
    const PairOccluders3 setting(prepared_->occluders, prepared_->boxes, first, other);
    return setting.sight == PairVisibility3::kMixed ? setting.count_between() : 0;
  };
  if (!second.is_all_of_the_sky()) return count(second);
  std::size_t most = 0;
  for (const Patch3& cone : sky_cones(first)) most = std::max(most, count(cone));
  return most;
}

PairIntegrator3::Halves PairIntegrator3::halves(const PairOccluders3& setting, const Patch3& i, const Patch3& j,
                                                bool cuts_first, const FirstMet3* first_met) const {
  Halves halves{std::make_unique<const std::array<Patch3, 2>>(halves_of(cuts_first ? i : j)), {}, cuts_first, 0};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto [a, b] = halves.pair(k, i, j);
    if (first_met != nullptr && are_hidden(a, b, Hiders3::kMostQuestions)) continue;
    auto of_half = std::make_unique<const PairOccluders3>(prepared_->occluders, setting, a, b);
    if (of_half->sight == PairVisibility3::kHidden) continue;  // S = 0, and S0 where one does not face the other
    halves.work += work_between(of_half->count_between());
    halves.settings[k] = std::move(of_half);
  }
  return halves;
}

std::array<PairIntegrator3::Halves, 2> PairIntegrator3::both_halves(const PairOccluders3& setting, const Patch3& i,
                                                                    const Patch3& j, const FirstMet3* first_met) const {
  // Of two that cost alike the longer one comes first.
  const long shift = prepared_->occluders.vertices().shift();
  const bool is_first_longer = longest_side_squared(i, shift) >= longest_side_squared(j, shift);
  return {halves(setting, i, j, is_first_longer, first_met), halves(setting, i, j, !is_first_longer, first_met)};
}

PairIntegrator3::Halves PairIntegrator3::cheaper_halves(const PairOccluders3& setting, const Patch3& i, const Patch3& j,
                                                        const FirstMet3* first_met) const {
  if (j.is_far()) return halves(setting, i, j, false, first_met);
  auto both = both_halves(setting, i, j, first_met);
  return std::move(both[both[0].work <= both[1].work ? 0 : 1]);
}

double PairIntegrator3::least_work(const Halves& halves, const Patch3& i, const Patch3& j, int cuts,
                                   const FirstMet3* first_met) const {
  double work = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    if (halves.settings[k] == nullptr) continue;
    const PairOccluders3& setting = *halves.settings[k];
    const double whole = work_between(setting.count_between());
    if (cuts == 0 || setting.count_between() <= kMostBetween) {
      work += whole;
      continue;
    }
    const auto [a, b] = halves.pair(k, i, j);
    work += std::min(whole, least_work(cheaper_halves(setting, a, b, first_met), a, b, cuts - 1, first_met));
  }
  return work;
}

std::unique_ptr<PairIntegrator3::Halves> PairIntegrator3::worthwhile_halves(const PairOccluders3& setting,
                                                                            const Patch3& i, const Patch3& j,
                                                                            const FirstMet3* first_met) const {
  auto both = both_halves(setting, i, j, first_met);
  const double enough = kWorthwhile * work_between(setting.count_between());
  // Where one cut is not worth its while, several may be: the more surfaces there are, the more of them are tried.
  for (const auto& [cuts, least] : {std::pair(0, std::size_t{0}), {1, 0}, {2, 100}, {3, 300}}) {
    if (setting.count_between() < least) break;
    const double work[] = {least_work(both[0], i, j, cuts, first_met), least_work(both[1], i, j, cuts, first_met)};
    const std::size_t better = work[0] <= work[1] ? 0 : 1;
    if (work[better] < enough) return std::make_unique<Halves>(std::move(both[better]));
  }
  return nullptr;
}

PairResult3 PairIntegrator3::measure_halves(const Halves& halves, const Patch3& i, const Patch3& j, const Areas& whole,
                                            const PairRequest3& request, int cuts, const FirstMet3* first_met) const {
  const double allowed = *request.share, tolerance = relative(allowed, least_area(whole, j), request.tolerance);
  PairResult3 sum;
  sum.sight = PairVisibility3::kMixed;
  sum.is_whole = true;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto [a, b] = halves.pair(k, i, j);
    if (halves.settings[k] == nullptr) {
      const auto sides = PairGeometry3(prepared_->occluders, a, b).patch_sides;
      if (sides[0].has_front && sides[1].has_front) sum.is_whole = false;  // else S0 = 0
      continue;
    }
    const Areas of_parts = areas(a, b);
    PairRequest3 part = request;
    part.share = std::max(allowed / 2, tolerance / 8 * least_area(of_parts, b));
    add_part(measure_set(*halves.settings[k], a, b, of_parts, part, cuts - 1, nullptr, first_met), sum);
    if (sum.is_undecided) return sum;
  }
  end_sum(sum.is_whole ? measure_alone(i, j, whole, tolerance / 4, Effort3::kAll) : UnobstructedMeasure3{}, allowed,
          sum);
  return sum;
}

PairPatch3::PairPatch3(const PairIntegrator3& measurer, const Patch3& patch)
    : known_(std::make_unique<const PairIntegrator3::Known>(*measurer.prepared_, patch)) {}
PairPatch3::~PairPatch3() = default;
PairPatch3::PairPatch3(PairPatch3&&) noexcept = default;
PairPatch3& PairPatch3::operator=(PairPatch3&&) noexcept = default;

PairRow3::PairRow3(const PairIntegrator3& measurer, const Patch3& i) : measurer_(&measurer), first_(measurer, i) {
  const PairIntegrator3::Prepared& prepared = *measurer.prepared_;
  first_met_ = std::make_unique<FirstMet3>(prepared.hiders, first_.known_->patch, prepared.occluders.size());
}
PairRow3::~PairRow3() = default;
PairRow3::PairRow3(PairRow3&&) noexcept = default;
PairRow3& PairRow3::operator=(PairRow3&&) noexcept = default;

PairResult3 PairRow3::measure(const Patch3& j, const PairRequest3& request) {
  return measure(PairPatch3(*measurer_, j), request);
}

PairResult3 PairRow3::measure(const PairPatch3& j, const PairRequest3& request) {
  const DefaultFloatingPoint environment;
  const bool asks = is_usual(request) && request.asks_hiders;
  return measurer_->measure(*first_.known_, *j.known_, request, nullptr, asks ? first_met_.get() : nullptr);
}

UnobstructedMeasure3 PairIntegrator3::measure_alone(const Patch3& i, const Patch3& j, const Areas& areas,
                                                    double tolerance, Effort3 effort) const {
  const Vertices3& vertices = prepared_->occluders.vertices();
  return j.is_far() ? unobstructed_sky(vertices, i, j) : unobstructed_measure(vertices, i, j, areas, tolerance, effort);
}

PairIntegrator3::Areas PairIntegrator3::areas(const Patch3& i, const Patch3& j) const {
  const Vertices3& vertices = prepared_->occluders.vertices();
  return {patch_area(vertices, i), j.is_far() ? Enclosure{0, 0} : patch_area(vertices, j)};
}

PairResult3 PairIntegrator3::measure_along(const PairOccluders3& setting, const Patch3& i, const Patch3& j,
                                           const Areas& areas, const PairRequest3& request,
                                           PairDetails3* details) const {
  const bool is_reversed = request.is_reversed && !j.is_far();
  const Patch3 &first = is_reversed ? j : i, &second = is_reversed ? i : j;
  const Occluders3& occluders = prepared_->occluders;
  PairResult3 result;
  result.sight = setting.sight;
  if (details) tell_between(setting, *details);
  if (setting.sight == PairVisibility3::kHidden) return result;
  const double allowed = *request.share;
  const double tolerance = relative(allowed, least_area(areas, j), request.tolerance) / 4;
  if (setting.sight == PairVisibility3::kClear && !request.always_along_edges) {
    take_alone(measure_alone(i, j, areas, tolerance, Effort3::kAll), allowed, result);
    return result;
  }
  const UnobstructedMeasure3 alone = measure_alone(i, j, areas, tolerance, Effort3::kUsual);
  if (alone.has_converged) result.alone = alone.measure;
  const long shift = occluders.vertices().shift();
  const MomentOrigin3 origin(setting.bodies, request.origin_shift, shift);
  EdgeSum3 sum(setting.bodies, origin, shift, kMostBytesOfArcs3, request.proves);
  const std::vector<PairStretch3> stretches = pair_stretches(setting, prepared_->stretches, first, second);
  if (details) details->looked_at += static_cast<std::uint32_t>(stretches.size());
  result.bounds = {0, alone.bounds.upper};
  if (!sum.add(stretches, result)) {
    take_bounds(result);
    result.is_undecided = true;
    result.problem = "a stretch of an edge is cut into too many pieces";
    return result;
  }
  if (sum.is_empty()) {
    result.is_whole = false;
    result.bounds = {0, 0};
    return result;
  }
  if (result.is_whole && !request.always_along_edges) {
    take_alone(alone.has_converged ? alone : measure_alone(i, j, areas, tolerance, Effort3::kAll), allowed, result);
    return result;
  }
  FinerSums sums(setting, origin, shift, sum);
  integrate(allowed, sum, result);
  const auto is_done = [&] { return is_sure(result) && result.error <= allowed; };
  PairResult3 bounded = result;
  if (!is_done()) {
    // Where the upper bound, or what may be hidden, is below the tolerance, the value does not matter: patches that see
    // each other at grazing angles, needles, something small and far away.
    if (alone.bounds.upper / 2 > allowed) bound_what_is_hidden(setting, occluders, i, j, tolerance, alone, bounded);
    take_bounds(bounded);
    // What no double can tell is not asked of wider numbers.
    if (request.effort == Effort3::kAll && bounded.error > allowed &&
        kOfDouble * std::fabs(result.measure) <= allowed) {
      sums.cut_at_jumps(allowed, result);
      if (&sums.best() != &sum) integrate(allowed, sums.best(), result);
      for (int cuts_at_ends = 0; !is_done();) {
        if (!is_sure(result) && cuts_at_ends++ < kMostCutsAtEnds && sums.cut_at_ends(result.residual, result))
          sums.cut_at_jumps(allowed, result);
        else if (!sums.best().take_more_digits())
          break;
        integrate(allowed, sums.best(), result);
      }
    }
  }
  if (details) sums.best().tell(*details);
  // Something is seen.
  result.measure = std::clamp(result.measure, kLittle * alone.bounds.upper, alone.bounds.upper);
  const auto end = [&] {
    if (request.proves) prove(setting, origin, shift, stretches, allowed, sum, result);
    return result;
  };
  if (is_done()) return end();
  const char* const problem = is_sure(result) ? kNotConverged : "the residual of translation is not zero";
  if (!is_sure(result) || bounded.error <= std::max(allowed, result.error)) result = std::move(bounded);
  if (!(result.error <= allowed)) result.problem = problem;
  return end();
}

}  // namespace hottel
