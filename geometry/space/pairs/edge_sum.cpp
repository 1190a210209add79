#include "geometry/space/pairs/edge_sum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/space/stretches/stretch_parts.h"
#include "geometry/space/vectors/integer_reals.h"
#include "kernel/exact_double.h"

namespace hottel {
namespace {

// Where a piece ends is told within this part of the stretch (MovingPlanes3); what is left out between two is less.
constexpr double kRootError = 0x1p-46;
// Short stretches are cut out between numbers with few bits; what is seen begins and ends a little beyond theirs.
constexpr double kGrid = 0x1p24, kSlack = 1e-6;
// What is seen at the end of a piece is looked at from this part of it inside.
constexpr double kInside = 0x1p-20;

Direction3 ratio(const IntegerVector& numerator, const Integer& denominator, long shift) {
  return integer_reals::quotient<Direction3>(numerator, denominator, shift);
}

}  // namespace

EdgeSum3::EdgeSum3(const PairGeometry3& bodies, const MomentOrigin3& origin, long shift, std::size_t most_bytes,
                   bool proves)
    : bodies_(bodies),
      origin_(origin),
      shift_(shift),
      most_bytes_(most_bytes),
      mapper_(bodies),
      doubles_([this](std::uint32_t k, StretchPiece3& piece) { mapper_.make_arcs(*stretch_of(k).stretch, piece); },
               most_bytes),
      proves_(proves),
      extents_{extent(0), extent(1)} {}

template <class Real>
std::uint32_t EdgeSum3::add_stretch(const Stretch3& s, const IntegerVector& way_to,
                                    EdgeIntegral3<Real>& integral) const {
  using integer_reals::quotient;
  const MomentOrigin3::Moment moment = origin_.moment_of(s, way_to);
  return integral.add_stretch(quotient<ArcVector3<Real>>(s.way, s.weight, shift_),
                              quotient<ArcVector3<Real>>(moment.numerator, moment.denominator, 2 * shift_));
}

// Where both patches reach the line that their planes share, it adds pi / 2 times both unit normals and its length.
template <class Real>
void EdgeSum3::set_expected_residual(EdgeIntegral3<Real>& integral) const {
  if (origin_.is_on_common_line()) integral.expect_residual(direction_of_both_normals<Real>(bodies_));
}

bool EdgeSum3::divide(const PairStretch3& stretch, std::vector<StretchPiece3>& pieces) {
  if (!proves_) return mapper_.divide(stretch, pieces);
  SureStretch3& sure = sure_.emplace_back();
  if (!mapper_.divide(stretch, pieces, &sure.parts)) return false;
  sure.sees_nothing = sure.parts.empty() && mapper_.sees_nothing(stretch);
  for (SurePart3& part : sure.parts) part.piece.give_up_arcs();
  return true;
}

bool EdgeSum3::add(const std::vector<PairStretch3>& stretches, PairResult3& result) {
  std::vector<StretchPiece3> pieces;
  stretches_ = &stretches;
  for (const PairStretch3& stretch : stretches) {
    const std::uint32_t relied = mapper_.relied_polynomials();
    pieces.clear();
    if (!divide(stretch, pieces)) return false;
    const auto number = static_cast<std::size_t>(&stretch - stretches.data());
    for (const double t : mapper_.not_looked_at()) ends_.push_back({number, t});
    for (const StretchPiece3& piece : pieces) {
      ends_.push_back({number, piece.low});
      ends_.push_back({number, piece.high});
    }
    const Stretch3& s = stretch.line();
    const IntegerVector way_to = origin_.way_to(s);
    const Direction3 from = ratio(way_to, s.weight * origin_.point().weight, shift_);
    const Direction3 way = ratio(s.way, s.weight, shift_), moment = cross(from, way);
    may_lack_ += kRootError * length(moment) * most_seen(stretch);
    if (pieces.empty()) continue;
    seen_.push_back({&stretch, pieces_in_doubles().size(), mapper_.relied_polynomials() - relied});
    const std::uint32_t place = add_stretch(s, way_to, doubles_);
    reach_ = std::max({reach_, length(from), length(from + way)});
    for (std::size_t k = 0; k < pieces.size(); ++k) {  // the arcs of two at a time
      mapper_.make_arcs(stretch, pieces[k]);
      add_jumps(pieces, k, moment);
      if (k > 0) doubles_.add(std::move(pieces[k - 1]), place);
    }
    doubles_.add(std::move(pieces.back()), place);
  }
  doubles_.add_error(jumps_);
  set_expected_residual(doubles_);
  result.is_whole = !mapper_.is_anything_hidden();
  result.maps = mapper_.maps();
  result.pieces = static_cast<std::uint32_t>(pieces_in_doubles().size());
  result.signs = mapper_.counts();
  return true;
}

void EdgeSum3::add_jumps(const std::vector<StretchPiece3>& pieces, std::size_t k, const Direction3& moment) {
  // What is seen at an end of a piece, and how much that changes as far from it as the end may be off.
  struct AtEnd {
    Direction3 lambda;
    double change;
  };
  const auto number = static_cast<std::size_t>(seen_.back().stretch - stretches_->data());
  const auto at_end = [&](const StretchPiece3& piece, bool is_high) {
    // At an end itself a vector may be zero.
    const double width = piece.high - piece.low, inside = kInside * width;
    const Direction3 here = piece.lambda(piece.low, is_high ? width - inside : inside);
    if (inside > kRootError) return AtEnd{here, 0};
    const double far = std::min(width - inside, kRootError);
    const Direction3 there = piece.lambda(piece.low, is_high ? width - far : far);
    return AtEnd{here, std::fabs(dot(moment, here - there))};
  };
  const auto add = [&](double t, const Direction3& jump, double change) {
    const double size = kRootError * (std::fabs(dot(moment, jump)) + change);
    jump_list_.push_back({number, t, size});
    jumps_ += size;
  };
  const StretchPiece3& piece = pieces[k];
  if (k > 0 && piece.low - pieces[k - 1].high <= kRootError) {
    const AtEnd low = at_end(piece, false), before = at_end(pieces[k - 1], true);
    add(piece.low, low.lambda - before.lambda, low.change + before.change);
  } else if (piece.low > 0) {
    const AtEnd low = at_end(piece, false);
    add(piece.low, low.lambda, low.change);
  }
  const bool is_followed = k + 1 < pieces.size() && pieces[k + 1].low - piece.high <= kRootError;
  if (is_followed || !(piece.high < 1)) return;
  const AtEnd high = at_end(piece, true);
  add(piece.high, high.lambda, high.change);
}

template <class Real>
WidePiece3<Real> EdgeSum3::widened(std::uint32_t piece) {
  return mapper_.widened<Real>(*stretch_of(piece).stretch, doubles_.with_arcs(piece));
}

template <class Real>
void EdgeSum3::widen(std::optional<EdgeIntegral3<Real>>& integral) {
  integral.emplace([this](std::uint32_t k, WidePiece3<Real>& piece) { piece = widened<Real>(k); }, most_bytes_);
  integral->add_error(jumps_);
  set_expected_residual(*integral);
  for (std::size_t s = 0; s < seen_.size(); ++s) {
    const Stretch3& line = seen_[s].stretch->line();
    const std::uint32_t place = add_stretch(line, origin_.way_to(line), *integral);
    for (std::size_t p = seen_[s].first_piece; p < end_of_pieces(s); ++p)
      integral->add(widened<Real>(static_cast<std::uint32_t>(p)), place);
  }
}

bool EdgeSum3::take_more_digits() {
  if (!long_doubles_)
    widen(long_doubles_);
  else if (!longer_)
    widen(longer_);
  else if (!wide_)
    widen(wide_);
  else
    return false;
  return true;
}

// Cuts a short stretch out of another one around each of `ends`.
void EdgeSum3::cut(const PairStretch3& stretch, const std::vector<double>& ends, std::vector<PairStretch3>& result) {
  std::vector<double> cuts{0, 1};
  for (const double t : ends) {
    const double place = t * kGrid;
    cuts.push_back(std::max(0.0, (std::floor(place) - 1) / kGrid));
    cuts.push_back(std::min(1.0, (std::ceil(place) + 1) / kGrid));
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const double from = cuts[k], to = cuts[k + 1], width = to - from;
    PairStretch3 part = stretch;
    if (cuts.size() > 2) {
      part.made = part_of(stretch.line(), exact_value(from), exact_value(to));
      part.known = nullptr;
      part.low = std::clamp((part.low - from) / width - kSlack, 0.0, 1.0);
      part.high = std::clamp((part.high - from) / width + kSlack, 0.0, 1.0);
    }
    if (part.low < part.high) result.push_back(std::move(part));
  }
}

std::vector<PairStretch3> EdgeSum3::cut_at_jumps(double most) const {
  std::vector<std::vector<double>> ends(stretches_->size());
  for (const Jump& jump : jump_list_)
    if (jump.size > most) ends[jump.stretch].push_back(jump.t);
  std::vector<PairStretch3> result;
  for (const Seen& seen : seen_)
    cut(*seen.stretch, ends[static_cast<std::size_t>(seen.stretch - stretches_->data())], result);
  return result;
}

EdgeSum3::Extent EdgeSum3::extent(std::uint32_t patch) const {
  if (bodies_.is_far(patch)) return {};
  const std::vector<std::uint32_t>& corners = bodies_.bodies[patch].corners;
  Extent result{bodies_.place(corners.front()), 0, 0};
  Direction3 before{}, sum{};
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const Direction3 side = bodies_.place(corners[k]) - result.first;
    result.reach = std::max(result.reach, length(side));
    sum = sum + cross(before, side);
    before = side;
  }
  result.area = length(sum) / 2;
  return result;
}

// The area of a patch by the square of its distance; half of all directions where that is not known.
double EdgeSum3::most_seen(const PairStretch3& stretch) const {
  const Stretch3& s = stretch.line();
  const Direction3 from = ratio(s.from, s.weight, bodies_.shift()), way = ratio(s.way, s.weight, bodies_.shift());
  const double square = dot(way, way);
  double most = std::numbers::pi;
  for (std::uint32_t patch = 0; patch < 2; ++patch) {
    if (bodies_.is_far(patch) || (stretch.role != StretchRole3::kOutline && patch == stretch.own)) continue;
    const Extent& extent = extents_[patch];
    const double t = square > 0 ? std::clamp(dot(extent.first - from, way) / square, 0.0, 1.0) : 0;
    const double distance = length(extent.first - (from + t * way)) - extent.reach;
    if (distance > 0) most = std::min(most, extent.area / (distance * distance));
  }
  return most;
}

std::vector<PairStretch3> EdgeSum3::cut_at_ends(double most) const {
  std::vector<std::vector<double>> ends(stretches_->size());
  for (const End& end : ends_) ends[end.stretch].push_back(end.t);
  std::vector<PairStretch3> result;
  for (std::size_t k = 0; k < stretches_->size(); ++k) {
    const PairStretch3& stretch = (*stretches_)[k];
    const Stretch3& s = stretch.line();
    if (length(ratio(s.way, s.weight, shift_)) * kRootError * most_seen(stretch) > most) {
      ends[k].push_back(stretch.low);
      ends[k].push_back(stretch.high);
    } else {
      ends[k].clear();
    }
    cut(stretch, ends[k], result);
  }
  return result;
}

template <class Visit>
auto EdgeSum3::of_most_digits(const Visit& visit) {
  return wide_ ? visit(*wide_) : longer_ ? visit(*longer_) : long_doubles_ ? visit(*long_doubles_) : visit(doubles_);
}

void EdgeSum3::refine(double tolerance, double residual_tolerance) {
  values_ = of_most_digits([&](auto& integral) { return integral.refine(tolerance, residual_tolerance); });
}

std::uint32_t EdgeSum3::nodes() const {
  return doubles_.nodes() + (long_doubles_ ? long_doubles_->nodes() : 0) + (longer_ ? longer_->nodes() : 0) +
         (wide_ ? wide_->nodes() : 0);
}

std::size_t EdgeSum3::end_of_pieces(std::size_t seen) const {
  return seen + 1 < seen_.size() ? seen_[seen + 1].first_piece : pieces_in_doubles().size();
}

const EdgeSum3::Seen& EdgeSum3::stretch_of(std::uint32_t piece) const {
  return *(std::ranges::upper_bound(seen_, std::size_t{piece}, {}, &Seen::first_piece) - 1);
}

// Whether a point is a corner of one of both patches and of nothing else.
bool EdgeSum3::is_of_patches_alone(std::uint32_t point) const {
  const auto has = [&](const PairGeometry3::Body& body) {
    return std::ranges::find(body.corners, point) != body.corners.end();
  };
  return std::none_of(bodies_.bodies.begin() + 2, bodies_.bodies.end(), has);
}

std::vector<PairDetails3::Corner> EdgeSum3::told_corners(const PairStretch3& stretch, const StretchPiece3& piece) {
  constexpr int kWays = 9;
  const auto place = [this](std::uint32_t point) {
    return WeightedPoint3{bodies_.points[point].exact(), bodies_.points[point].weight()};
  };
  std::vector<PairDetails3::Corner> result;
  const std::vector<SightCorner3> corners = mapper_.corners_of(stretch, piece);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    PairDetails3::Corner& told = result.emplace_back(PairDetails3::Corner{corners[k].label, {}, {}, {}, false, {}});
    if (corners[k].point) {
      told.vertex = place(*corners[k].point);
      told.is_of_others = !is_of_patches_alone(*corners[k].point);
    }
    for (const auto& [a, b] : corners[k].edges) {
      told.edges.push_back({place(a), place(b)});
      told.is_of_others |= !is_of_patches_alone(a) || !is_of_patches_alone(b);
    }
    for (const std::uint32_t body : corners[k].bodies) {
      told.surfaces.push_back(bodies_.bodies[body].surface);
      told.is_of_others |= body > 1;
    }
    const double width = piece.high - piece.low;
    for (int step = 0; step < kWays; ++step) {
      const double share = std::clamp(step / (kWays - 1.0), kInside, 1 - kInside);  // at an end it may be zero
      told.ways.push_back(piece.corners[k].at(piece.low, share * width));
    }
  }
  return result;
}

void EdgeSum3::tell(PairDetails3& details) {
  const std::vector<double> of_piece = of_most_digits([](const auto& integral) { return integral.of_pieces(); });
  for (std::size_t s = 0; s < seen_.size(); ++s) {
    const PairStretch3& stretch = *seen_[s].stretch;
    const Stretch3& line = stretch.line();
    PairDetails3::Stretch& told = details.stretches.emplace_back(PairDetails3::Stretch{
        stretch.role, stretch.own, {line.from, line.weight}, end_of(line), {}, seen_[s].relied, {}});
    for (const PairStretch3::Face& face : stretch.faces) told.surfaces.push_back(bodies_.bodies[face.body].surface);
    std::sort(told.surfaces.begin(), told.surfaces.end());
    for (std::size_t p = seen_[s].first_piece; p < end_of_pieces(s); ++p) {
      const StretchPiece3& piece = doubles_.with_arcs(static_cast<std::uint32_t>(p));
      told.pieces.push_back({piece.low,
                             piece.high,
                             static_cast<std::uint32_t>(piece.arcs.size()),
                             of_piece[p] / (2 * std::numbers::pi),
                             piece.signature,
                             {}});
      if (details.wants_corners) told.pieces.back().corners = told_corners(stretch, piece);
    }
  }
}

}  // namespace hottel
