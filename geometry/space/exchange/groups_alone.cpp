#include "geometry/space/exchange/groups_alone.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "geometry/space/between/pair_occluders.h"
#include "geometry/space/between/stopped_lines.h"
#include "geometry/space/exchange/facing.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"

namespace hottel {
namespace {

using Part = ElementTable3::Part;

// Some pieces of a scene, with nothing else there.
class PartOfScene {
 public:
  PartOfScene(const PreparedScene3& prepared, std::vector<std::uint32_t> pieces)
      : whole_(prepared.occluders()),
        pieces_(std::move(pieces)),
        occluders_(polygons_of(prepared, pieces_)),
        measurer_(occluders_) {
    const Vertices3 &whole = whole_.vertices(), &here = occluders_.vertices();
    const Rational ratio = scaled_by_power_of_two(here.scale() / whole.scale(), here.shift() - whole.shift());
    unit_ = to_double(ratio * ratio);
  }

  // REQUIRES patches of these pieces. The measure is in the unit of this part of the scene, the share in
  // that of the whole.
  PairResult3 measure(const Part& a, const Part& b, double share) const {
    return measurer_.measure(here(a), here(b), {.share = share / unit_});
  }
  double unit() const { return unit_; }  // in that of the whole scene

 private:
  static std::vector<Polygon3> polygons_of(const PreparedScene3& prepared, const std::vector<std::uint32_t>& pieces) {
    std::vector<Polygon3> polygons;
    for (const std::uint32_t p : pieces) polygons.push_back(prepared.arrangement().pieces()[p].polygon);
    return polygons;
  }
  Patch3 here(const Part& part) const {
    const auto place = std::lower_bound(pieces_.begin(), pieces_.end(), part.patch.surface);
    return patch_of(occluders_, static_cast<std::uint32_t>(place - pieces_.begin()),
                    corners_of(whole_.vertices(), part.patch), false);
  }

  const Occluders3& whole_;
  std::vector<std::uint32_t> pieces_;  // ascending
  Occluders3 occluders_;
  PairIntegrator3 measurer_;
  double unit_;
};

}  // namespace

GroupsAlone3::GroupsAlone3(const PreparedScene3& prepared, const ElementTable3& table, double tolerance)
    : prepared_(prepared),
      table_(table),
      boxes_(prepared.occluders()),
      shares_(table, prepared.occluders().vertices(), tolerance),
      members_(prepared.scene.groups.size()) {
  for (std::uint32_t s = 0; s < prepared.scene.surfaces.size(); ++s)
    members_[prepared.scene.surfaces[s].group].push_back(s);
}

std::vector<std::uint32_t> GroupsAlone3::pieces_of(std::uint32_t i, std::uint32_t j) const {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t label : {i, j}) {
    const std::uint32_t surface = table_.elements()[label].surface;
    const std::vector<std::uint32_t> alone(1, surface);
    for (const std::uint32_t s : table_.is_by_group() ? members_[prepared_.scene.surfaces[surface].group] : alone) {
      const auto pieces = prepared_.arrangement().pieces_on(s);
      result.insert(result.end(), pieces.begin(), pieces.end());
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Visits pairs of members that face each other, each once, until one says false.
template <class Visit>
bool GroupsAlone3::for_each_facing(std::uint32_t i, std::uint32_t j, const Visit& visit) const {
  for (const Part& a : table_.free_parts(i))
    for (const Part& b : table_.free_parts(j)) {
      if (i == j && &b <= &a) continue;
      throw_if_interrupted();
      if (face_each_other(prepared_.occluders(), a, b) && !visit(a, b)) return false;
    }
  return true;
}

bool GroupsAlone3::is_undisturbed(const Part& a, const Part& b, std::span<const std::uint32_t> own) const {
  const PairOccluders3 setting(prepared_.occluders(), boxes_, a.patch, b.patch);
  const auto is_own = [own](std::uint32_t piece) { return std::ranges::binary_search(own, piece); };
  if (setting.sight == PairVisibility3::kHidden) return is_own(setting.bodies.bodies.back().surface);
  std::vector<std::uint32_t> kept;
  for (std::uint32_t body = 2; body < setting.bodies.end_of_between(); ++body) {
    const std::uint32_t piece = setting.bodies.bodies[body].surface;
    if (is_own(piece)) continue;
    if (stops_lines_of_corners(setting.bodies, body)) return false;
    kept.push_back(piece);
  }
  if (kept.empty()) return true;
  kept.insert(kept.end(), {a.patch.surface, b.patch.surface});
  std::ranges::sort(kept);
  return PartOfScene(prepared_, std::move(kept)).measure(a, b, shares_.share(a, b)).is_whole;
}

bool GroupsAlone3::is_undisturbed(std::uint32_t i, std::uint32_t j) const {
  const std::vector<std::uint32_t> own = pieces_of(i, j);
  return for_each_facing(i, j, [&](const Part& a, const Part& b) { return is_undisturbed(a, b, own); });
}

void GroupsAlone3::refuse(std::uint32_t i, std::uint32_t j, const std::string& problem) const {
  throw RequestError(
      "the visibility of '" + table_.elements()[i].name + "' and '" + table_.elements()[j].name +
      "' is not known: S0, what they would exchange with nothing between them, was not measured within the "
      "tolerance (" +
      problem + "); take a wider one");
}

GroupsAlone3::Measure GroupsAlone3::measure(std::uint32_t i, std::uint32_t j) const {
  const PartOfScene part(prepared_, pieces_of(i, j));
  const double unit = (i == j ? 2 : 1) * part.unit();
  Measure sum;
  std::set<std::pair<std::uint32_t, std::uint32_t>> holders;
  std::string problem;
  for_each_facing(i, j, [&](const Part& a, const Part& b) {
    const PairResult3 pair = part.measure(a, b, shares_.share(a, b));
    if (pair.is_undecided) refuse(i, j, pair.problem);
    if (problem.empty()) problem = pair.problem;
    holders.emplace(a.holder, b.holder);
    sum.value += pair.measure * unit;
    sum.error += pair.error * unit;
    // Each product and sum rounds once; the unit is off by half a unit.
    constexpr double kOutward = 0x1p-50;
    sum.bounds.lower += pair.bounds.lower * unit * (1 - kOutward);
    sum.bounds.upper += pair.bounds.upper * unit * (1 + kOutward);
    return true;
  });
  double allowed = 0;
  for (const auto& [a, b] : holders) allowed += (i == j ? 2 : 1) * shares_.allowed(a, b);
  if (!problem.empty() && !(sum.error <= allowed)) refuse(i, j, problem);
  for (const ElementTable3::Contact& contact : table_.contacts()) {
    if (std::pair(contact.mask, contact.base) != std::pair(i, j) &&
        std::pair(contact.base, contact.mask) != std::pair(i, j))
      continue;
    const double times = i == j ? 2 : 1;
    sum.value += times * contact.extent.value;
    sum.bounds = sum_of_nonnegative(
        sum.bounds, {times * contact.extent.enclosure().lower, times * contact.extent.enclosure().upper});
  }
  return sum;
}

}  // namespace hottel
