#include "geometry/space/visibility/point_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/space/visibility/cone_fragment.h"
#include "geometry/space/visibility/sight_cones.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

// Relative error from which a direction or a distance is computed from integers.
constexpr double kIllConditioned = 1e-12;

// Coprime integers in the direction of a vector.
IntegerVector integer_direction(const Point3& a) {
  const Integer denominator = lcm(lcm(a.x.get_den(), a.y.get_den()), a.z.get_den());
  const auto integer = [&denominator](const Rational& value) -> Integer {
    return value.get_num() * (denominator / value.get_den());
  };
  return primitive({integer(a.x), integer(a.y), integer(a.z)});
}

Direction3 unit(const BoundedVector& a) {
  const double x = a.x / a.size, y = a.y / a.size, z = a.z / a.size;
  const double length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

BoundedVector rounded_well(const IntegerVector& a) { return rounded(a, bits(a) - 53); }

// Makes the map: one target after another, each with all that can hide it taken away.
class MapMaker {
 public:
  MapMaker(const Blockers3& blockers, const Look3& look)
      : planes_(blockers, look.eye, look.always_exact),
        cutter_(planes_),
        cones_(planes_),
        eye_{to_double(look.eye.x), to_double(look.eye.y), to_double(look.eye.z)} {
    if (!look.normal) return;
    const IntegerVector normal = integer_direction(*look.normal);
    HOTTEL_REQUIRE(!is_zero(normal));
    horizon_ = planes_.add_horizon(normal);
    normal_ = unit(rounded_well(normal));
  }

  PointMap3 make() {
    const Blockers3& blockers = planes_.blockers();
    for (std::size_t n = 0; n < blockers.nodes().size(); ++n) {
      const Blockers3::Node& node = blockers.nodes()[n];
      if (node.left != 0 || cones_.node(n).is_empty()) continue;
      is_around_known_ = false;
      for (std::uint32_t k = node.begin; k < node.end; ++k)
        if (planes_.facing(blockers.order()[k]) != 0) see(blockers.order()[k], n);
    }
    sort_by_face();
    keep_planes();
    add_shares();
    map_.signs = planes_.counts();
    return std::move(map_);
  }

 private:
  // A polygon that may hide a part of the target, and how promising it is to begin with: the smaller the better;
  // the best one is the largest.
  struct Blocker {
    std::uint32_t surface;
    double promise;
    bool operator<(const Blocker& other) const {
      return promise != other.promise ? promise > other.promise : surface > other.surface;
    }
  };
  enum class Hides { kNever, kWhole, kWhereNearer };

  // Which part of polygon k hides polygon j, as far as the planes of both tell.
  Hides hides(std::size_t k, std::size_t j) {
    const auto [k_before, k_beyond] = places(k, j);
    if (!k_before) return Hides::kNever;
    if (!k_beyond) return Hides::kWhole;
    const auto [j_before, j_beyond] = places(j, k);
    if (!j_before) return Hides::kWhole;
    return j_beyond ? Hides::kWhereNearer : Hides::kNever;
  }

  // Whether corners of polygon k are on the side of the eye, and beyond, of the plane of polygon j.
  std::pair<bool, bool> places(std::size_t k, std::size_t j) {
    bool before = false, beyond = false;
    for (const VertexId3 v : planes_.blockers().outline(k)) {
      const int sign = planes_.nearness(v, j);
      before |= sign > 0;
      beyond |= sign < 0;
    }
    return {before, beyond};
  }

  // Sets blockers_ to a heap: the most promising first.
  void find_blockers(std::uint32_t target, std::size_t leaf) {
    if (!is_around_known_) cones_.find_blockers(cones_.node(leaf), around_);
    is_around_known_ = true;
    const SightCone3& cone = cones_.polygon(target);
    blockers_.clear();
    for (const std::uint32_t k : around_) {
      const SightCone3& other = cones_.polygon(k);
      if (k == target || !may_hide(other, cone) || !cones_.may_overlap(k, target)) continue;
      const double x = other.x - cone.x, y = other.y - cone.y, z = other.z - cone.z;
      blockers_.push_back({k, other.is_wide() ? -2 : std::sqrt(x * x + y * y + z * z) - other.sine});
    }
    std::make_heap(blockers_.begin(), blockers_.end());
  }

  // Takes away from pieces_ what a polygon hides.
  void take_away(std::uint32_t blocker, std::uint32_t target) {
    cone_sides(planes_, blocker, sides_);
    std::size_t first = 0;
    while (first < pieces_.size() && cutter_.is_apart(pieces_[first], blocker, sides_)) ++first;
    if (first == pieces_.size()) return;
    const Hides part = hides(blocker, target);
    if (part == Hides::kNever) return;
    part_sides_ = sides_;
    // First, so that a piece that is nearer stays whole.
    if (part == Hides::kWhereNearer) part_sides_.insert(part_sides_.begin(), planes_.add_crossing(blocker, target));
    rest_.clear();
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const bool is_apart = p != first && (p < first || cutter_.is_apart(pieces_[p], blocker, sides_));
      if (is_apart)
        std::swap(rest_.add(), pieces_[p]);
      else
        cutter_.subtract(pieces_[p], part_sides_, rest_);
    }
    std::swap(pieces_, rest_);
  }

  // Whether the polygon that hid the rest of another one hides all of this one: neighbours often share their fate.
  bool is_hidden_as_before(std::uint32_t target) {
    if (!latest_ || *latest_ == target) return false;
    cone_sides(planes_, *latest_, sides_);
    return cutter_.is_inside(pieces_[0], sides_) && hides(*latest_, target) == Hides::kWhole;
  }

  // Adds what is seen of a polygon, which is in this leaf of the tree.
  void see(std::uint32_t target, std::size_t leaf) {
    pieces_.clear();
    cone_of_polygon(planes_, target, whole_);
    if (!horizon_)
      pieces_.add() = whole_;
    else if (!cutter_.clip(whole_, *horizon_, pieces_.add()))
      return;
    if (is_hidden_as_before(target)) return;
    find_blockers(target, leaf);
    for (auto end = blockers_.end(); end != blockers_.begin() && pieces_.size() > 0; --end) {
      std::pop_heap(blockers_.begin(), end);
      take_away((end - 1)->surface, target);
      if (pieces_.size() == 0) latest_ = (end - 1)->surface;
    }
    for (std::size_t p = 0; p < pieces_.size(); ++p) add_fragment(target, pieces_[p]);
  }

  Direction3 direction(const ConeCorner3& corner) {
    if (corner.direction.error <= kIllConditioned * corner.direction.size) return unit(corner.direction);
    return unit(rounded_well(planes_.exact_direction(corner)));
  }

  // The vector from the eye to where a corner meets the plane of a polygon.
  Direction3 way_to(std::uint32_t target, const ConeCorner3& corner) {
    const Blockers3& blockers = planes_.blockers();
    const VertexId3 anchor = blockers.outline(target).front();
    const BoundedVector& normal = blockers.normal(target);
    const BoundedVector& d = corner.direction;
    const double unit_length = planes_.eye().unit();
    const BoundedValue height = dot(normal, planes_.eye().toward(anchor)), slope = dot(normal, d);
    if (height.error <= kIllConditioned * std::fabs(height.value) &&
        slope.error <= kIllConditioned * std::fabs(slope.value) && d.error <= kIllConditioned * d.size) {
      const double t = height.value / slope.value * unit_length;
      return {t * d.x, t * d.y, t * d.z};
    }
    const IntegerVector exact = planes_.exact_direction(corner);
    const IntegerVector& n = blockers.exact_normal(target);
    Rational t(dot(n, planes_.eye().exact_toward(anchor)), dot(n, exact));
    t.canonicalize();
    t *= planes_.eye().exact_unit();
    return {to_double(t * exact.x), to_double(t * exact.y), to_double(t * exact.z)};
  }

  void add_fragment(std::uint32_t target, const ConeFragment3& fragment) {
    const auto begin = static_cast<std::uint32_t>(map_.corners.size());
    for (const ConeCorner3& corner : fragment) {
      const Direction3 way = way_to(target, corner);
      map_.corners.push_back({direction(corner), eye_.x + way.x, eye_.y + way.y, eye_.z + way.z, corner.plane});
    }
    map_.fragments.push_back(
        {{target, planes_.facing(target) < 0}, begin, static_cast<std::uint32_t>(map_.corners.size())});
  }

  void sort_by_face() {
    std::stable_sort(map_.fragments.begin(), map_.fragments.end(),
                     [](const PointMap3::Fragment& a, const PointMap3::Fragment& b) { return a.face < b.face; });
    std::vector<PointMap3::Corner> sorted;
    sorted.reserve(map_.corners.size());
    for (PointMap3::Fragment& fragment : map_.fragments) {
      const auto from = map_.corners.begin() + fragment.begin, to = map_.corners.begin() + fragment.end;
      fragment.begin = static_cast<std::uint32_t>(sorted.size());
      sorted.insert(sorted.end(), from, to);
      fragment.end = static_cast<std::uint32_t>(sorted.size());
    }
    map_.corners = std::move(sorted);
  }

  // Numbers the planes that fragments have from 0.
  void keep_planes() {
    std::vector<PlaneId3> numbers(planes_.definitions().size(), PlaneId3::none());
    for (PointMap3::Corner& corner : map_.corners) {
      PlaneId3& number = numbers[corner.side.plane.index()];
      if (number.is_none()) {
        number = PlaneId3(map_.planes.size());
        map_.planes.push_back(planes_.definitions()[corner.side.plane.index()]);
      }
      corner.side.plane = number;
    }
  }

  void add_shares() {
    std::vector<Direction3> directions;
    double fraction = horizon_ ? 0.5 : 1, factor = horizon_ ? 1 : 0;
    for (const PointMap3::Fragment& fragment : map_.fragments) {
      if (map_.shares.empty() || map_.shares.back().face != fragment.face) map_.shares.push_back({fragment.face, 0, 0});
      directions.clear();
      for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) directions.push_back(map_.corners[c].direction);
      map_.shares.back().fraction += solid_angle_fraction_3(directions);
      if (horizon_) map_.shares.back().factor += view_factor_3(directions, normal_);
    }
    for (const PointMap3::Share& share : map_.shares) {
      fraction -= share.fraction;
      factor -= share.factor;
    }
    map_.sky_fraction = fraction;
    map_.sky_factor = factor;
  }

  EyePlanes3 planes_;
  ConeCutter3 cutter_;
  SightCones3 cones_;
  Direction3 eye_;
  std::optional<PlaneSide3> horizon_;
  Direction3 normal_;
  std::vector<std::uint32_t> around_;  // what may hide something of the leaf at hand, where that is known
  bool is_around_known_ = false;
  std::optional<std::uint32_t> latest_;         // the polygon that hid the rest of another one last
  std::vector<Blocker> blockers_;               // what may hide something of the target at hand
  std::vector<PlaneSide3> sides_, part_sides_;  // of the polygon that hides, and of the part of it that does
  ConeFragment3 whole_;
  FragmentList3 pieces_, rest_;
  PointMap3 map_;
};

}  // namespace

PointMap3 map_from(const Blockers3& blockers, const Look3& look) {
  const DefaultFloatingPoint environment;
  return MapMaker(blockers, look).make();
}

}  // namespace hottel
