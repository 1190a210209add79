#include "geometry/space/exchange/pair_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "geometry/space/exchange/groups_alone.h"
#include "geometry/space/exchange/pair_shares.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/unobstructed/unobstructed.h"
#include "geometry/unit_of_length.h"
#include "kernel/doubles.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

constexpr double kLeast = std::numeric_limits<double>::denorm_min();

// Products of a proven number with a factor that is off by half a unit.
double down(double a, double b) { return std::max(0.0, std::nextafter(std::nextafter(a * b, -kInfinity), -kInfinity)); }
double up(double a, double b) { return a == 0 ? 0 : std::nextafter(std::nextafter(a * b, kInfinity), kInfinity); }

Estimate3 operator*(const Estimate3& a, double unit) {
  return {a.value * unit, a.error * unit, {down(a.bounds.lower, unit), up(a.bounds.upper, unit)}};
}

void add(const Estimate3& some, Estimate3& sum) {
  sum.value += some.value;
  sum.error += some.error;
  sum.bounds = sum_of_nonnegative(sum.bounds, some.bounds);
}

// Hidden before clear before mixed: of several pairs together.
PairVisibility3 together(PairVisibility3 a, PairVisibility3 b) { return std::max(a, b); }

using Part = ElementTable3::Part;

class Reporter {
 public:
  Reporter(const PreparedScene3& prepared, const std::optional<Face>& from, const std::optional<Face>& to,
           double tolerance, bool proves)
      : prepared_(prepared),
        table_(*prepared.elements(Granularity::kFace)),
        shares_(table_, prepared.occluders().vertices(), tolerance),
        from_(from),
        to_(to),
        proves_(proves) {
    const Vertices3& vertices = prepared.occluders().vertices();
    const Rational unit = scaled_by_power_of_two(vertices.scale(), vertices.shift()) * metres_per_unit(prepared.scene);
    length_ = to_double(unit);
    square_ = to_double(unit * unit);
    is_turned_ = !from_ || (to_ && *to_ < *from_);
    if (!std::isnormal(length_) || !std::isnormal(square_)) fail("its measures are beyond the range of doubles");
    report_.tolerance = tolerance;
  }

  PairReport3 make() {
    const bool are_both_covered =
        from_ && to_ && table_.is_partly_covered(from_->number()) && table_.is_partly_covered(to_->number());
    const std::vector<const Part*> of_from = patches(from_, false), of_to = patches(to_, are_both_covered);
    report_.is_whole = true;
    std::vector<PatchPair> pairs;
    for (const Part* i : of_from)
      for (const Part* j : of_to)
        if (i->patch.is_sky() || i->patch.surface != j->patch.surface)
          pairs.push_back({i, j, shares_.share(*i, *j), {}, {}});
    measure(pairs);
    for (PatchPair& pair : pairs) add_pair(pair);
    add_contacts();
    report_.is_whole = report_.is_whole && report_.exchange.bounds.upper > 0;
    auto& between = report_.between;
    std::sort(between.begin(), between.end());
    between.erase(std::unique(between.begin(), between.end()), between.end());
    set_unobstructed(of_from, of_to);
    set_factors();
    set_visibility();
    for (Estimate3* const measure : {&report_.exchange, &report_.unobstructed, &report_.along_edges})
      *measure = *measure * square_;
    return std::move(report_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    const auto name = [&](const std::optional<Face>& face) {
      return face ? quoted_name(face_name(prepared_.scene, *face)) : "the sky";
    };
    throw RequestError(name(from_) + " and " + name(to_) + ": " + problem);
  }

  // Two patches, the first of `from`.
  struct PatchPair {
    const Part *from, *to;
    double share;
    PairResult3 measure;
    PairDetails3 details;
  };

  std::vector<const Part*> patches(const std::optional<Face>& face, bool are_free) const {
    std::vector<const Part*> result;
    const std::uint32_t label = face ? face->number() : table_.sky();
    for (const Part& part : are_free ? table_.free_parts(label) : table_.parts(label)) result.push_back(&part);
    if (result.empty() && !table_.has_contact(label))
      throw RequestError(quoted_name(face_name(prepared_.scene, *face)) +
                         " has no area: it lies in solids, or others have all of its place");
    return result;
  }

  // As sum_pairs does: those that are not within their share come last, and more is tried for them where all together
  // are not within the tolerance.
  void measure(std::vector<PatchPair>& pairs) {
    for (PatchPair& pair : pairs) measure(pair, {.share = pair.share, .effort = Effort3::kUsual, .proves = proves_});
    const auto open = std::stable_partition(pairs.begin(), pairs.end(),
                                            [](const PatchPair& pair) { return pair.measure.problem.empty(); });
    if (open == pairs.end()) return;
    const double allowed = shares_.allowed(number_of(from_), number_of(to_));
    if (!(error_of(pairs) <= allowed) || is_undecided(pairs))
      for (auto pair = open; pair != pairs.end(); ++pair) measure(*pair, {.share = pair->share, .proves = proves_});
    if (!(error_of(pairs) <= allowed) || is_undecided(pairs)) fail(open->measure.problem);
  }

  static double error_of(const std::vector<PatchPair>& pairs) {
    double sum = 0;
    for (const PatchPair& pair : pairs) sum += pair.measure.error;
    return sum;
  }
  static bool is_undecided(const std::vector<PatchPair>& pairs) {
    return std::any_of(pairs.begin(), pairs.end(), [](const PatchPair& pair) { return pair.measure.is_undecided; });
  }
  std::uint32_t number_of(const std::optional<Face>& face) const { return face ? face->number() : table_.sky(); }

  // A mask and its base see each other all over, across no distance.
  void add_contacts() {
    if (!from_ || !to_) return;
    for (const ElementTable3::Contact& contact : table_.contacts()) {
      if (std::minmax(contact.mask, contact.base) != std::minmax(from_->number(), to_->number())) continue;
      report_.sight = together(report_.sight, PairVisibility3::kClear);
      add({contact.extent.value, 0, contact.extent.enclosure()}, report_.exchange);
    }
  }

  void add_pair(PatchPair& pair) {
    PairDetails3& details = pair.details;
    const PairResult3& found = pair.measure;
    report_.sight = together(report_.sight, found.sight);
    add({found.measure, found.error, found.bounds}, report_.exchange);
    if (found.sight == PairVisibility3::kHidden) {
      report_.is_whole &= details.hiders.empty();
      if (from_ && to_ && !details.hiders.empty()) report_.hiders = surfaces_of(std::move(details.hiders));
      return;
    }
    for (const std::uint32_t piece : details.between) report_.between.push_back(surface_of(piece));
    report_.is_whole &= found.is_whole;
    PairResult3 along = found;
    if (details.stretches.empty() && found.bounds.upper > 0) {
      PatchPair same{pair.from, pair.to, pair.share, {}, {}};
      measure(same, {.share = pair.share, .always_along_edges = true});
      along = std::move(same.measure);
      details = std::move(same.details);
      if (report_.problem.empty()) report_.problem = along.problem;
    }
    report_.maps += along.maps;
    report_.signs += along.signs;
    report_.pieces += along.pieces;
    report_.nodes += along.nodes;
    report_.residual = std::max(report_.residual, along.residual * length_);
    report_.residual_bound = std::max(report_.residual_bound, along.residual_bound * length_);
    add({along.measure, along.error, along.bounds}, report_.along_edges);
    take(std::move(details));
  }

  void measure(PatchPair& pair, const PairRequest3& request) const {
    const Patch3 &i = pair.from->patch, &j = pair.to->patch;
    pair.details = {};
    pair.measure = prepared_.measurer().measure(is_turned_ ? j : i, is_turned_ ? i : j, request, &pair.details);
  }

  std::uint32_t surface_of(std::uint32_t piece) const { return prepared_.arrangement().pieces()[piece].surface; }

  // Of pieces, ascending, each once.
  std::vector<std::uint32_t> surfaces_of(std::vector<std::uint32_t> pieces) const {
    for (std::uint32_t& piece : pieces) piece = surface_of(piece);
    std::sort(pieces.begin(), pieces.end());
    pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
    return pieces;
  }

  void take(PairDetails3 details) {
    report_.looked_at += details.looked_at;
    for (PairDetails3::Stretch& stretch : details.stretches) {
      const bool is_outline = stretch.role == StretchRole3::kOutline, is_first = (stretch.patch == 0) != is_turned_;
      PairReport3::Stretch& told = report_.stretches.emplace_back(PairReport3::Stretch{
          stretch.role, !is_outline && is_first, !is_outline && !is_first, place(stretch.from), place(stretch.to),
          surfaces_of(std::move(stretch.surfaces)), stretch.relied, std::move(stretch.pieces)});
      for (PairDetails3::Piece& piece : told.pieces) told.measure += piece.measure *= square_;
    }
  }

  Point3 place(const WeightedPoint3& p) const {
    const Vertices3& vertices = prepared_.occluders().vertices();
    const Rational unit = vertices.scale() / p.weight;
    const Point3& origin = vertices.origin();
    return {origin.x + unit * p.numerator.x, origin.y + unit * p.numerator.y, origin.z + unit * p.numerator.z};
  }

  void set_unobstructed(const std::vector<const Part*>& of_from, const std::vector<const Part*>& of_to) {
    if (!from_ || !to_) {
      const Rounded& area = table_.extent((from_ ? from_ : to_)->number());
      report_.unobstructed = {area.value, 0, area.enclosure()};
    } else if (!table_.is_one_patch(from_->number()) || !table_.is_one_patch(to_->number())) {
      const auto alone = GroupsAlone3(prepared_, table_, report_.tolerance).measure(from_->number(), to_->number());
      report_.unobstructed = {alone.value, alone.error, alone.bounds};
    } else if (from_->surface != to_->surface) {
      const UnobstructedMeasure3 alone = unobstructed_measure(prepared_.occluders().vertices(), of_from.front()->patch,
                                                              of_to.front()->patch, report_.tolerance);
      if (!alone.has_converged) fail("the integral over two patches that see each other did not converge");
      report_.unobstructed = {alone.measure, alone.error, alone.bounds};
    }
  }

  // The measure over an area.
  static Estimate3 quotient(const Estimate3& measure, double value, const Enclosure& area) {
    if (measure.bounds.upper == 0) return {};
    Estimate3 result;
    result.bounds.lower = measure.bounds.lower > 0 ? std::nextafter(measure.bounds.lower / area.upper, 0.0) : 0;
    result.bounds.upper =
        area.lower > 0 ? std::min(1.0, std::nextafter(measure.bounds.upper / area.lower, kInfinity)) : 1;
    result.value = measure.value / value;
    return result;
  }

  void set_factors() {
    const auto of_face = [&](const Face& face) {
      const Rounded& area = table_.extent(face.number());
      Estimate3 factor = quotient(report_.exchange, area.value, area.enclosure());
      if (report_.exchange.bounds.upper > 0)
        factor.value = std::clamp(std::max(factor.value, kLeast), factor.bounds.lower, factor.bounds.upper);
      return factor;
    };
    if (from_) {
      report_.area_from = table_.elements()[from_->number()].area;
      report_.factor_from = of_face(*from_);
    }
    if (to_) {
      report_.area_to = table_.elements()[to_->number()].area;
      report_.factor_to = of_face(*to_);
    }
  }

  void set_visibility() {
    if (!report_.is_facing()) return;
    if (!from_ || !to_) {
      report_.visibility = from_ ? report_.factor_from : report_.factor_to;
    } else if (report_.is_whole) {
      report_.visibility = {1, 0, {1, 1}};
    } else {
      Estimate3& part = report_.visibility.emplace(
          quotient(report_.exchange, report_.unobstructed.value, report_.unobstructed.bounds));
      if (report_.exchange.bounds.upper > 0) part.value = std::clamp(part.value, kLeast, std::nextafter(1.0, 0.0));
    }
  }

  const PreparedScene3& prepared_;
  const ElementTable3& table_;
  const PairShares3 shares_;
  const std::optional<Face> from_, to_;
  bool proves_;
  bool is_turned_ = false;          // pairs are measured from the face that comes first
  double length_ = 1, square_ = 1;  // of the doubles of Vertices3, in metres
  PairReport3 report_;
};

}  // namespace

bool PairReport3::is_enclosed() const {
  double least = area_from ? area_from->enclosure().lower : kInfinity;
  if (area_to) least = std::min(least, area_to->enclosure().lower);
  const double most = tolerance * least;
  return exchange.bounds.contains(exchange.value) && exchange.bounds.upper - exchange.value <= most &&
         exchange.value - exchange.bounds.lower <= most;
}

PairReport3 pair_report(const PreparedScene3& prepared, const std::optional<Face>& from, const std::optional<Face>& to,
                        double tolerance, bool proves) {
  HOTTEL_REQUIRE(tolerance > 0 && (from || to));
  const DefaultFloatingPoint arithmetic;
  return Reporter(prepared, from, to, tolerance, proves).make();
}

}  // namespace hottel
