#include "geometry/space/pieces/stretch_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/space/arrangement/short_integers.h"
#include "kernel/wide_real.h"

namespace hottel {
namespace {

// Where in an interval to look: not where events are likely.
constexpr std::array<double, 8> kPlaces{0.4837, 0.3911, 0.6123, 0.2719, 0.7351, 0.1523, 0.8713, 0.5531};
// So near to an end of a piece a zero may be that of the end.
constexpr double kHarmless = 1e-13;
// So many times the width of what is nearly zero is away from there.
constexpr double kApart = 4;
// Parts of a stretch below this are left out.
constexpr double kLeast = 0x1p-51;
constexpr std::uint32_t kMostPieces = 20000;

constexpr std::uint32_t kNoGroup = 0xffffffff;
enum TakenGroup : char { kNotYet, kAsOne, kOneByOne };

// A place in an interval that has few bits.
double short_place(double low, double high, double share) {
  const double place = low + share * (high - low);
  const int exponent = std::ilogb(high - low) - 8;
  const double rounded = std::ldexp(std::nearbyint(std::ldexp(place, -exponent)), exponent);
  return low < rounded && rounded < high ? rounded : place;
}

constexpr std::uint64_t kPointLabel = std::uint64_t{1} << 63;

std::uint64_t label_of(const MovingCorner3& corner) {
  if (corner.point != MovingCorner3::kNoPoint)
    return kPointLabel | (static_cast<std::uint64_t>(corner.point) << 1) | (corner.is_antipode ? 1 : 0);
  const auto a = static_cast<std::uint64_t>(corner.first.plane.number());
  const auto b = static_cast<std::uint64_t>(corner.second.plane.number());
  const bool is_turned = (corner.first.is_opposite != corner.second.is_opposite) != (a > b);
  return (std::min(a, b) << 32) | (std::max(a, b) << 1) | (is_turned ? 1 : 0);
}

constexpr auto kPrecedes = [](const ArcEnd3& a, const ArcEnd3& b) {
  return a.plane != b.plane ? a.plane < b.plane : a.label < b.label;
};

}  // namespace

StretchMapper3::StretchMapper3(const PairGeometry3& bodies)
    : bodies_(bodies),
      planes_(bodies),
      cutter_(planes_),
      hull_(bodies),
      cover_(bodies),
      joined_(bodies),
      solid_of_(bodies.count(), PairGeometry3::Solid::kNone) {
  for (std::uint32_t solid = 0; solid < bodies.solids.size(); ++solid)
    for (const std::uint32_t face : bodies.solids[solid].faces) solid_of_[face] = solid;
}

bool StretchMapper3::walk(const PairStretch3& stretch, std::vector<StretchPiece3>& pieces,
                          std::vector<SurePart3>* parts) {
  not_looked_at_.clear();
  take(stretch);
  hints_.assign(4 * (bodies_.bodies.size() + bodies_.solids.size()), 0);
  if (!find_sides(stretch)) return true;
  find_bodies(stretch);
  hiders_ = {};
  waiting_.assign(1, {stretch.low, stretch.high});
  for (std::uint32_t count = 0; !waiting_.empty(); ++count) {
    const auto [low, high] = waiting_.back();
    waiting_.pop_back();
    if (!(high - low > kLeast)) {
      if (high > low) not_looked_at_.push_back(low);
      continue;
    }
    StretchPiece3 piece;
    if (count > kMostPieces || !look(stretch, low, high, piece)) return false;
    waiting_.emplace_back(piece.high, high);
    waiting_.emplace_back(low, piece.low);
    if (parts) add_sure_part(piece, *parts);
    pieces.push_back(std::move(piece));
  }
  return true;
}

bool StretchMapper3::divide(const PairStretch3& stretch, std::vector<StretchPiece3>& pieces,
                            std::vector<SurePart3>* parts) {
  const std::size_t first = pieces.size();
  if (parts) begin_sure_parts(*parts);
  if (!walk(stretch, pieces, parts)) return false;
  if (parts) end_sure_parts(*parts);
  const auto begin = pieces.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(begin, pieces.end(), [](const StretchPiece3& a, const StretchPiece3& b) { return a.low < b.low; });
  // What was too short to be looked at belongs to what follows, the last of it to what is before.
  double end = stretch.low;
  for (std::size_t k = first; k < pieces.size(); ++k) {
    pieces[k].low = end;
    end = pieces[k].high;
  }
  if (pieces.size() > first) pieces.back().high = stretch.high;
  // Neighbours that are bounded by the same arcs are one piece: what ended between them did not matter.
  std::size_t kept = first;
  for (std::size_t k = first; k < pieces.size(); ++k) {
    if (kept > first && pieces[kept - 1].signature == pieces[k].signature) {
      pieces[kept - 1].high = pieces[k].high;
    } else if (kept != k) {
      pieces[kept++] = std::move(pieces[k]);
    } else {
      ++kept;
    }
  }
  pieces.resize(kept);
  pieces.erase(std::remove_if(pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.end(),
                              [](const StretchPiece3& piece) { return piece.signature.empty(); }),
               pieces.end());
  return true;
}

void StretchMapper3::make_arcs(const PairStretch3& stretch, StretchPiece3& piece) {
  take(stretch);
  piece.unpack_signature();
  set_arcs(piece);
}

void StretchMapper3::take(const PairStretch3& stretch) {
  if (taken_ != &stretch) planes_.take(stretch.line());
  taken_ = &stretch;
}

// Sets sides_seen_: whether directions may be left, or right, of all surfaces at the stretch. As it lies in their
// planes, this is told by where the patches lie of these. False where there are no such directions.
bool StretchMapper3::find_sides(const PairStretch3& stretch) {
  sides_seen_ = {true, true};
  if (stretch.role == StretchRole3::kSource) return true;
  const bool is_outline = stretch.role == StretchRole3::kOutline;
  const std::uint32_t target = is_outline ? 1 : 1 - stretch.own;
  for (const bool is_left : {false, true})
    for (const PairStretch3::Face& face : stretch.faces) {
      const bool is_front = face.is_forward == is_left;
      const auto& patches = bodies_.of_patch[face.body];
      if (!(is_front ? patches[target].has_front : patches[target].has_behind)) sides_seen_[is_left] = false;
      if (is_outline && !(is_front ? patches[0].has_behind : patches[0].has_front)) sides_seen_[is_left] = false;
    }
  return sides_seen_[0] || sides_seen_[1];
}

void StretchMapper3::find_bodies(const PairStretch3& stretch) {
  for (std::uint32_t patch = 0; patch < 2; ++patch) {
    between_[patch].clear();
    if (stretch.role != StretchRole3::kOutline && patch == stretch.own) continue;
    hull_.take(stretch.line(), stretch.low, stretch.high, patch);
    if (stretch.role == StretchRole3::kOutline) hull_.take_lines_from(1 - patch);
    std::vector<std::uint32_t> as_one;  // solids, whether they are or not
    std::vector<char> is_one;
    for (std::uint32_t body = 2; body < bodies_.end_of_between(); ++body) {
      const bool is_at = std::any_of(stretch.faces.begin(), stretch.faces.end(),
                                     [body](const PairStretch3::Face& face) { return face.body == body; });
      if (is_at || hull_.hides_nothing(body)) continue;
      const std::uint32_t solid = solid_of_[body];
      if (solid == PairGeometry3::Solid::kNone) {
        between_[patch].push_back(body);
        continue;
      }
      auto known = std::ranges::find(as_one, solid);
      const bool is_new = known == as_one.end();
      if (is_new) {
        as_one.push_back(solid);
        is_one.push_back(hides_as_one(bodies_.solids[solid], stretch, patch));
        known = as_one.end() - 1;
      }
      const bool hides = is_one[static_cast<std::size_t>(known - as_one.begin())] != 0;
      if (!hides)
        between_[patch].push_back(body);
      else if (is_new)
        between_[patch].push_back(bodies_.count() + solid);
    }
    cover_.narrow(stretch.line(), stretch.low, stretch.high, between_[patch]);
  }
  is_joined_ = {};
}

// As seen from where the stretch is looked at: of what is before all of a patch, so that it hides wherever it is seen.
void StretchMapper3::join_bodies() {
  for (std::uint32_t patch = 0; patch < 2; ++patch) {
    if (is_joined_[patch]) continue;
    is_joined_[patch] = true;
    whole_.clear();
    for (const std::uint32_t number : between_[patch])
      if (bodies_.hides_joined && number < bodies_.end_of_between() && !bodies_.of_body[number][patch].has_behind)
        whole_.push_back(number);
    joined_.join(whole_, planes_.toward(), groups_[patch]);
    group_of_[patch].assign(bodies_.count() + bodies_.solids.size(), kNoGroup);
    for (std::uint32_t g = 0; g < groups_[patch].size(); ++g)
      for (const std::uint32_t body : groups_[patch][g].bodies) group_of_[patch][body] = g;
  }
}

// Not where a part of it may be behind the patch; and the stretch is to be within its lid, so that lines do not come in
// there.
bool StretchMapper3::hides_as_one(const PairGeometry3::Solid& solid, const PairStretch3& stretch,
                                  std::uint32_t patch) const {
  if (!solid.may_hide[patch]) return false;
  if (!solid.exact->lid) return true;
  const Stretch3& s = stretch.line();
  const BodyPlane3& lid = *solid.exact->lid;
  const IntegerVector& at = bodies_.vertices().exact(lid.at);
  const auto is_within = [&](const IntegerVector& p) { return plane_side_3(lid.outward, p, s.weight, at) <= 0; };
  return is_within(s.from) && is_within(sum(s.from, s.way));
}

bool StretchMapper3::look(const PairStretch3& stretch, double low, double high, StretchPiece3& piece) {
  for (const double share : kPlaces) {
    const double t = short_place(low, high, share);
    ++maps_;
    const bool was_hidden = is_anything_hidden_;
    planes_.move_to(t, t - low, high - t);
    find_view(stretch);
    if (planes_.is_unlucky()) {
      is_anything_hidden_ = was_hidden;
      continue;
    }
    piece.low = planes_.left() < t - low ? t - planes_.left() : low;
    piece.high = planes_.right() < high - t ? t + planes_.right() : high;
    piece.base = t;
    set_signature(piece);
    return true;
  }
  return false;
}

void StretchMapper3::find_view(const PairStretch3& stretch) {
  seen_count_ = 0;
  if (!find_start(stretch)) return;
  join_bodies();
  if (stretch.role != StretchRole3::kSource) return see_on_both_sides(stretch);
  for (const PairStretch3::Face& face : stretch.faces) {
    PlaneSide3 side = planes_.face(face.body);
    side.is_opposite = !face.patch_is_forward;
    const auto cut = cutter_.clip(start_, side);
    is_anything_hidden_ |= cut != MovingCutter3::Cut::kNothing;
    if (cut == MovingCutter3::Cut::kAll) return;
  }
  see(stretch, start_, 1);
}

// Sets start_ to the directions to one patch, and from the other one where the stretch is on none.
bool StretchMapper3::find_start(const PairStretch3& stretch) {
  using Cut = MovingCutter3::Cut;
  const std::uint32_t target = stretch.role == StretchRole3::kOutline ? 1 : 1 - stretch.own;
  if (planes_.facing(target) <= 0) return false;
  if (stretch.role == StretchRole3::kOutline && planes_.facing(0) <= 0) return false;
  cutter_.set_cone(target, 1, false, cone_);
  cutter_.set_fragment(cone_, 1, start_);
  if (stretch.role != StretchRole3::kOutline)
    return !bodies_.patch_sides[target].has_behind || cutter_.clip(start_, planes_.face(stretch.own)) != Cut::kAll;
  cutter_.set_cone(0, 1, true, cone_);
  if (cutter_.is_apart(start_, cone_, hints_[0])) return false;
  return std::none_of(cone_.sides.begin(), cone_.sides.end(),
                      [this](PlaneSide3 side) { return cutter_.clip(start_, side) == Cut::kAll; });
}

// Where all surfaces at the stretch lie left, what is seen counts negative; where all lie right, positive.
void StretchMapper3::see_on_both_sides(const PairStretch3& stretch) {
  for (const bool is_left : {true, false}) {
    if (!sides_seen_[is_left]) continue;
    copy_ = start_;
    const bool is_empty = std::any_of(stretch.faces.begin(), stretch.faces.end(), [&](const PairStretch3::Face& face) {
      PlaneSide3 side = planes_.face(face.body);
      side.is_opposite = face.is_forward != is_left;
      return cutter_.clip(copy_, side) == MovingCutter3::Cut::kAll;
    });
    if (!is_empty) see(stretch, copy_, is_left ? -1 : 1);
  }
}

void StretchMapper3::see(const PairStretch3& stretch, MovingFragment3& start, int sign) {
  pieces_.clear();
  std::swap(pieces_.add(), start);
  // First the body that hid the rest when it was looked last: where it hides all, nothing else is relied on.
  Hider& hider = hiders_[sign > 0];
  const Hider first = hider;
  for (std::uint32_t patch = 0; patch < 2; ++patch) is_taken_[patch].assign(groups_[patch].size(), 0);
  if (first.number != 0) take_away(stretch, first.number, first.patch, sign);
  for (std::uint32_t patch = 0; patch < 2; ++patch)
    for (const std::uint32_t number : between_[patch]) {
      if (pieces_.size() == 0 || (number == first.number && patch == first.patch)) continue;
      take_away(stretch, number, patch, sign);
      if (pieces_.size() == 0) hider = {number, patch};
    }
  if (stretch.role != StretchRole3::kSource) is_anything_hidden_ |= pieces_.size() > 0;
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    if (seen_count_ == seen_.size()) seen_.emplace_back();
    seen_[seen_count_].first = sign;
    std::swap(seen_[seen_count_++].second, pieces_[p]);
  }
}

StretchMapper3::Hides StretchMapper3::hides(std::uint32_t body, int facing, std::uint32_t patch) const {
  if (!bodies_.of_body[body][patch].has_front) return Hides::kNever;
  if (!bodies_.of_body[body][patch].has_behind) return Hides::kWhole;
  const PairGeometry3::Side& side = bodies_.of_patch[body][patch];
  const bool is_before = facing > 0 ? side.has_front : side.has_behind;
  const bool is_beyond = facing > 0 ? side.has_behind : side.has_front;
  if (!is_before) return Hides::kWhole;
  return is_beyond ? Hides::kWhereNearer : Hides::kNever;
}

namespace {

// Whether what is between is seen backward: where the stretch is on no patch, before the first one.
bool is_backward(const PairStretch3& stretch, std::uint32_t patch) {
  return stretch.role == StretchRole3::kOutline && patch == 0;
}

}  // namespace

// Takes away from pieces_ what a body or a solid hides of a patch.
void StretchMapper3::take_away(const PairStretch3& stretch, std::uint32_t hider, std::uint32_t patch, int sign) {
  if (hider >= bodies_.count()) return take_away_solid(stretch, hider - bodies_.count(), patch, sign);
  const std::uint32_t group = group_of_[patch][hider];
  if (group == kNoGroup) return take_away_body(stretch, hider, patch, sign);
  // As one, the first time; by itself where they are not one from here.
  const char taken = is_taken_[patch][group];
  if (taken == kAsOne) return;
  if (taken == kNotYet && take_away_group(stretch, groups_[patch][group], patch, sign)) {
    is_taken_[patch][group] = kAsOne;
    return;
  }
  is_taken_[patch][group] = kOneByOne;
  take_away_body(stretch, hider, patch, sign);
}

bool StretchMapper3::take_away_group(const PairStretch3& stretch, const JoinedBodies3::Group& group,
                                     std::uint32_t patch, int sign) {
  if (!joined_.is_before_once(group, planes_.toward()) ||
      !cutter_.set_cone(group, is_backward(stretch, patch), cone_)) {
    is_joined_[patch] = false;
    return false;
  }
  take_away_cone(stretch, group.bodies.front(), patch, sign, {});
  return true;
}

void StretchMapper3::take_away_body(const PairStretch3& stretch, std::uint32_t body, std::uint32_t patch, int sign) {
  const int facing = planes_.facing(body);
  if (facing == 0) return;
  const Hides part = hides(body, facing, patch);
  if (part == Hides::kNever) return;
  cutter_.set_cone(body, facing, is_backward(stretch, patch), cone_);
  if (part == Hides::kWhole) return take_away_cone(stretch, body, patch, sign, {});
  PlaneSide3 crossing = planes_.crossing(body, patch);
  crossing.is_opposite = is_backward(stretch, patch);
  take_away_cone(stretch, body, patch, sign, {&crossing, 1});
}

// From within, none of its faces is seen from outside: then each hides by itself.
void StretchMapper3::take_away_solid(const PairStretch3& stretch, std::uint32_t number, std::uint32_t patch, int sign) {
  const PairGeometry3::Solid& solid = bodies_.solids[number];
  facings_.clear();
  bool is_outside = false;
  for (std::size_t k = 0; k < solid.faces.size(); ++k) {
    facings_.push_back(static_cast<signed char>(planes_.facing(solid.faces[k])));
    is_outside |= facings_.back() * solid.outward[k] > 0;
  }
  if (is_outside) {
    cutter_.set_cone(solid, facings_, is_backward(stretch, patch), cone_);
    return take_away_cone(stretch, bodies_.count() + number, patch, sign, {});
  }
  for (const std::uint32_t face : solid.faces)
    if (face < bodies_.end_of_between()) take_away_body(stretch, face, patch, sign);
}

// What is in cone_, and on the positive sides of planes beside it.
void StretchMapper3::take_away_cone(const PairStretch3& stretch, std::uint32_t hider, std::uint32_t patch, int sign,
                                    std::span<const PlaneSide3> beside) {
  std::uint32_t& hint = hints_[4 * hider + (is_backward(stretch, patch) ? 2 : 0) + (sign > 0 ? 1 : 0)];
  std::size_t first = 0;
  while (first < pieces_.size() && cutter_.is_apart(pieces_[first], cone_, hint)) ++first;
  if (first == pieces_.size()) return;
  sides_.assign(beside.begin(), beside.end());
  sides_.insert(sides_.end(), cone_.sides.begin(), cone_.sides.end());
  rest_.clear();
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    const bool is_apart = p != first && (p < first || cutter_.is_apart(pieces_[p], cone_, hint));
    if (is_apart)
      std::swap(rest_.add(), pieces_[p]);
    else if (cutter_.subtract(pieces_[p], sides_, rest_))
      is_anything_hidden_ |= stretch.role == StretchRole3::kSource;
  }
  swap(pieces_, rest_);
}

void StretchMapper3::set_signature(StretchPiece3& piece) {
  std::vector<ArcEnd3>& all = all_ends_;
  all.clear();
  for (std::size_t f = 0; f < seen_count_; ++f) {
    const auto& [sign, fragment] = seen_[f];
    for (std::size_t k = 0; k < fragment.size(); ++k) {
      const MovingCorner3 &begin = fragment[k], &end = fragment[k + 1 == fragment.size() ? 0 : k + 1];
      all.push_back({begin.plane.plane, label_of(begin), -sign});
      all.push_back({begin.plane.plane, label_of(end), sign});
    }
  }
  std::sort(all.begin(), all.end(), kPrecedes);
  std::size_t kept = 0;
  for (const ArcEnd3& end : all) {
    if (kept > 0 && all[kept - 1].plane == end.plane && all[kept - 1].label == end.label)
      all[kept - 1].count += end.count;
    else
      all[kept++] = end;
  }
  all.resize(kept);
  std::erase_if(all, [](const ArcEnd3& end) { return end.count == 0; });
  piece.signature.assign(all.begin(), all.end());  // no longer than it is: edges between fragments are many, and gone
}

// Where a vector is zero at an end of a piece its direction goes on analytically. Within a piece it is never zero: it
// passes by, however close, and its direction turns over. A vector that is quadratic in t may do so twice; away from
// the first time, s = 0, it points as slope + s third, or the opposite, whose own zero tells of the other one: also
// where the first is at an end.
void StretchMapper3::add_near_zero(const MovingVector3& vector, StretchPiece3& piece) {
  const auto add = [&piece](double at, double width) {
    const bool is_within = at - piece.low > kHarmless && piece.high - at > kHarmless;
    if ((width > kHarmless || is_within) && width < piece.high - piece.low) piece.near_zeros.push_back({at, width});
  };
  const double at = vector.base + nearest_to_zero(vector, piece.low - vector.base, piece.high - vector.base);
  const Direction3 value = vector.at(at, 0), slope = vector.second + (2 * (at - vector.base)) * vector.third;
  const double speed = std::sqrt(dot(slope, slope));
  const double width = speed > 0 ? std::sqrt(dot(value, value)) / speed : 0;
  if (speed > 0) add(at, width);
  const double square = dot(vector.third, vector.third);
  if (!(square > 0)) return;
  const double way = -dot(slope, vector.third) / square;
  const Direction3 passing = slope + way * vector.third;
  const double other_width = std::sqrt(dot(passing, passing) / square);
  if (kApart * width < std::max(std::fabs(way), other_width)) add(at + way, other_width);
}

// The corner that a label tells of.
MovingCorner3 StretchMapper3::corner_of(std::uint64_t label) {
  if (label & kPointLabel)
    return planes_.corner_at(static_cast<std::uint32_t>((label & ~kPointLabel) >> 1), (label & 1) != 0, {});
  const PlaneId3 a(label >> 32), b((label & 0xffffffff) >> 1);
  return planes_.corner({a, false}, {b, (label & 1) != 0});
}

std::vector<SightCorner3> StretchMapper3::corners_of(const PairStretch3& stretch, const StretchPiece3& piece) {
  take(stretch);
  std::vector<SeenArc3> arcs;
  list_arcs(piece.signature, arcs);
  std::vector<SightCorner3> result;
  for (const std::uint64_t label : labels_) {
    const MovingCorner3 corner = corner_of(label);
    SightCorner3& told = result.emplace_back();
    told.label = label;
    if (corner.point != MovingCorner3::kNoPoint)
      told.point = corner.point;
    else
      for (const PlaneSide3& side : {corner.first, corner.second}) planes_.tell(side.plane, told);
  }
  return result;
}

// Sets labels_ and planes_of_arcs_ too.
void StretchMapper3::list_arcs(const std::vector<ArcEnd3>& signature, std::vector<SeenArc3>& arcs) {
  const std::size_t count = signature.size();
  arcs.reserve(count / 2);  // as a rule one begins and one ends
  labels_.clear();
  planes_of_arcs_.clear();
  const auto place_of = [&](std::uint64_t label) {
    const auto known = std::find(labels_.begin(), labels_.end(), label);
    if (known != labels_.end()) return static_cast<std::uint32_t>(known - labels_.begin());
    labels_.push_back(label);
    return static_cast<std::uint32_t>(labels_.size() - 1);
  };
  // On each plane as many arcs begin as end: any begin with any end.
  for (std::size_t k = 0; k < count;) {
    std::size_t end = k;
    while (end < count && signature[end].plane == signature[k].plane) ++end;
    const auto plane = static_cast<std::uint32_t>(planes_of_arcs_.size());
    planes_of_arcs_.push_back(signature[k].plane);
    begins_.clear();
    ends_.clear();
    for (; k < end; ++k) (signature[k].count < 0 ? begins_ : ends_).push_back(signature[k]);
    for (std::size_t b = 0, e = 0; b < begins_.size() && e < ends_.size();) {
      const int arcs_here = std::min(-begins_[b].count, ends_[e].count);
      const std::uint32_t first = place_of(begins_[b].label), last = place_of(ends_[e].label);
      arcs.push_back({plane, first, last, static_cast<double>(arcs_here), 0});
      if ((begins_[b].count += arcs_here) == 0) ++b;
      if ((ends_[e].count -= arcs_here) == 0) ++e;
    }
  }
}

void StretchMapper3::set_arcs(StretchPiece3& piece) {
  planes_.move_to(piece.base, 0, 0);
  list_arcs(piece.signature, piece.arcs);
  piece.corners.reserve(labels_.size());
  piece.planes.reserve(planes_of_arcs_.size());
  for (const std::uint64_t label : labels_)
    piece.corners.push_back(planes_.fine_direction(corner_of(label), piece.low, piece.high));
  for (const PlaneId3 plane : planes_of_arcs_)
    piece.planes.push_back(planes_.fine_normal(plane, piece.low, piece.high));
  for (const std::uint32_t k : piece.find_turns()) {
    StretchPiece3::Arc& arc = piece.arcs[k];
    const PlaneId3 plane = planes_of_arcs_[arc.plane];
    const int sign = planes_.angle_sign(corner_of(labels_[arc.begin]), plane, corner_of(labels_[arc.end]));
    if (sign != 0) arc.turn = sign;
  }
  for (const std::vector<MovingVector3>* vectors : {&piece.planes, &piece.corners})
    for (const MovingVector3& vector : *vectors) add_near_zero(vector, piece);
}

template <class Real>
WidePiece3<Real> StretchMapper3::widened(const PairStretch3& stretch, const StretchPiece3& piece) {
  take(stretch);
  planes_.move_to(piece.base, 0, 0);
  WidePiece3<Real> wide;
  wide.low = piece.low;
  wide.high = piece.high;
  wide.near_zeros = piece.near_zeros;
  list_arcs(piece.signature, wide.arcs);
  wide.arcs = piece.arcs;
  wide.corners.reserve(labels_.size());
  wide.planes.reserve(planes_of_arcs_.size());
  for (const std::uint64_t label : labels_)
    wide.corners.push_back(planes_.wide_direction<Real>(corner_of(label), piece.low, piece.high));
  for (const PlaneId3 plane : planes_of_arcs_)
    wide.planes.push_back(planes_.wide_normal<Real>(plane, piece.low, piece.high));
  return wide;
}

template WidePiece3<long double> StretchMapper3::widened(const PairStretch3&, const StretchPiece3&);
template WidePiece3<LongerReal> StretchMapper3::widened(const PairStretch3&, const StretchPiece3&);
template WidePiece3<WideReal> StretchMapper3::widened(const PairStretch3&, const StretchPiece3&);

}  // namespace hottel
