#include "geometry/space/visibility/visibility_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/space/visibility/cone_fragment.h"
#include "geometry/space/visibility/view_cones.h"
#include "geometry/space/visibility/view_shells.h"
#include "geometry/space/visibility/view_tree.h"
#include "kernel/coprime_integers.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

// Relative error from which a direction or a distance is computed from integers.
constexpr double kIllConditioned = 1e-12;

Direction3 unit(const BoundedVector& a) {
  const double x = a.x / a.size, y = a.y / a.size, z = a.z / a.size;
  const double length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

BoundedVector rounded_well(const IntegerVector& a) { return rounded(a, bits(a) - 53); }

// Makes the map: one target after another, near ones first, each with all that can hide it taken away.
class MapMaker {
 public:
  MapMaker(const Occluders3& occluders, const Look3& look)
      : MapMaker(occluders, Eye3(occluders.vertices(), look.eye), look.always_exact) {
    eye_ = {to_double(look.eye.x), to_double(look.eye.y), to_double(look.eye.z)};
    if (!look.normal) return;
    const auto [x, y, z] = coprime_integers<3>({look.normal->x, look.normal->y, look.normal->z});
    const IntegerVector normal{x, y, z};
    HOTTEL_REQUIRE(!is_zero(normal));
    horizon_ = planes_.add_horizon(normal);
    normal_ = unit(rounded_well(normal));
  }

  MapMaker(const Occluders3& occluders, Eye3 eye, bool always_exact)
      : planes_(occluders, std::move(eye), always_exact),
        cutter_(planes_),
        cones_(planes_),
        shells_(planes_, cones_),
        tree_(planes_, shells_) {
    hidings_.resize(shells_.size());
    hidden_counts_.resize(shells_.size());
  }

  VisibilityMap3 make() {
    see_all();
    sort_by_face();
    keep_planes();
    add_shares();
    map_.signs = planes_.counts();
    return std::move(map_);
  }

 private:
  // A shell that may hide a part of what is at hand, and how promising it is: the smaller the better; the best one
  // covers most.
  struct Candidate {
    std::uint32_t shell;
    double promise;
    bool operator<(const Candidate& other) const {
      return promise != other.promise ? promise > other.promise : shell > other.shell;
    }
  };
  // A piece of the target, in pieces_, and those of candidates_ that may hide something of it.
  struct Task {
    std::size_t begin, end;
  };
  // Which part of what a shell covers of the target it hides, as far as planes tell: kEach where its polygons differ.
  enum class Hides : unsigned char { kNever, kWhole, kWhereNearer, kEach };
  struct Hiding {
    std::uint32_t target = 0xffffffff;  // of which it is known
    Hides hides = Hides::kNever;
  };
  struct Places {
    bool before = false, beyond = false;
  };

  // Whether corners are on the side of the eye, and beyond, of the plane of polygon j.
  Places places(std::span<const VertexId3> corners, std::uint32_t j) {
    Places result;
    for (const VertexId3 v : corners) {
      const int sign = planes_.nearness(v, j);
      result.before |= sign > 0;
      result.beyond |= sign < 0;
    }
    return result;
  }

  // Which part of polygon k hides polygon j.
  Hides hides(std::uint32_t k, std::uint32_t j) {
    const Occluders3& occluders = planes_.occluders();
    const Places of_k = places(occluders.outline(k), j);
    if (!of_k.before) return Hides::kNever;
    if (!of_k.beyond) return Hides::kWhole;
    const Places of_j = places(occluders.outline(j), k);
    if (!of_j.before) return Hides::kWhole;
    return of_j.beyond ? Hides::kWhereNearer : Hides::kNever;
  }

  // What is before the plane of a polygon of a round shell is before all of the shell.
  Hides find_hides(const ViewShell3& shell, std::uint32_t target) {
    if (shell.polygons.size() == 1) return hides(shell.polygons[0], target);
    const Places of_shell = places(shell.cone.corners, target);
    if (!of_shell.before) return Hides::kNever;
    if (!of_shell.beyond) return Hides::kWhole;
    Hides result = Hides::kWhole;
    for (const std::uint32_t k : shell.polygons) {
      if (shell.is_round && !places(planes_.occluders().outline(target), k).beyond) return Hides::kNever;
      if (hides(k, target) != Hides::kWhole) result = Hides::kEach;
    }
    return result;
  }

  Hides hides_target(std::uint32_t shell) {
    Hiding& known = hidings_[shell];
    if (known.target != target_) known = {target_, find_hides(shells_[shell], target_)};
    return known.hides;
  }

  // Goes through the tree from near to far: what is found to be hidden as a whole need not be asked what it hides.
  void see_all() {
    const Occluders3& occluders = planes_.occluders();
    std::vector<std::pair<double, std::uint32_t>> waiting;
    const auto add = [&](std::uint32_t n) {
      if (tree_.node(n).is_empty()) return;
      waiting.emplace_back(-tree_.node(n).nearest, n);
      std::push_heap(waiting.begin(), waiting.end());
    };
    if (!occluders.nodes().empty()) add(0);
    while (!waiting.empty()) {
      std::pop_heap(waiting.begin(), waiting.end());
      const std::uint32_t n = waiting.back().second;
      waiting.pop_back();
      if (is_hidden_by_hiders(tree_.node(n))) {
        tree_.drop_node(n);
        continue;
      }
      const Occluders3::Node& node = occluders.nodes()[n];
      if (node.left != 0) {
        add(node.left);
        add(node.right);
      } else {
        see_leaf(n);
      }
    }
  }

  void see_leaf(std::uint32_t n) {
    const Occluders3::Node& node = planes_.occluders().nodes()[n];
    is_around_known_ = false;
    for (std::uint32_t k = node.begin; k < node.end; ++k) {
      const std::uint32_t s = planes_.occluders().order()[k];
      if (planes_.facing(s) == 0) continue;
      if (!shells_.is_buried(s) && see(s, n)) continue;
      const std::uint32_t shell = shells_.shell_of(s);
      if (++hidden_counts_[shell] == shells_[shell].polygons.size()) tree_.drop_shell(shell);
    }
  }

  // Whether one of the shells that hid something as a whole hides all of this.
  bool is_hidden_by_hiders(const ViewCone3& cone) {
    for (std::size_t k = 0; k < hiders_.size(); ++k)
      if (hides_all(shells_[hiders_[k]], cone)) {
        std::rotate(hiders_.begin(), hiders_.begin() + static_cast<std::ptrdiff_t>(k),
                    hiders_.begin() + static_cast<std::ptrdiff_t>(k) + 1);
        return true;
      }
    return false;
  }

  void remember_hider(std::uint32_t shell) {
    constexpr std::size_t kMostHiders = 8;
    const auto known = std::find(hiders_.begin(), hiders_.end(), shell);
    if (known != hiders_.end())
      std::rotate(hiders_.begin(), known, known + 1);
    else
      hiders_.insert(hiders_.begin(), shell);
    if (hiders_.size() > kMostHiders) hiders_.pop_back();
  }

  // Takes away from pieces_[0], and what is left of it, what hides it. Returns whether anything is left.
  bool take_away_all(const ViewCone3& cone, std::uint32_t leaf) {
    if (!is_around_known_) tree_.find_shells(tree_.node(leaf), around_);
    is_around_known_ = true;
    candidates_.clear();
    for (const std::uint32_t shell : around_)
      if (shell != shells_.shell_of(target_) && may_hide(shells_[shell].around, cone))
        candidates_.push_back({shell, 0});
    tasks_.assign(1, {0, candidates_.size()});
    bool is_anything_left = false;
    while (!tasks_.empty()) {
      std::swap(piece_, pieces_[pieces_.size() - 1]);
      pieces_.drop_last();
      const Task task = tasks_.back();
      tasks_.pop_back();
      if (take_away_one(task)) {
        add_fragment(target_, piece_);
        is_anything_left = true;
      }
    }
    return is_anything_left;
  }

  // Takes one shell away from piece_: the one that covers most of it, as far as round cones tell, among those that hide
  // something of it. What is left waits for the others. Returns whether there is no such shell.
  bool take_away_one(const Task& task) {
    const ViewCone3 cone = ViewCones3::around(piece_);
    candidates_.resize(task.end);
    for (std::size_t k = task.begin; k < task.end; ++k) {
      const std::uint32_t shell = candidates_[k].shell;
      const ViewCone3& other = shells_[shell].around;
      if (!may_overlap(cone, other)) continue;
      const double x = other.x - cone.x, y = other.y - cone.y, z = other.z - cone.z;
      candidates_.push_back({shell, other.is_wide() ? -2 : std::sqrt(x * x + y * y + z * z) - other.sine});
    }
    const auto begin = candidates_.begin() + static_cast<std::ptrdiff_t>(task.end);
    std::make_heap(begin, candidates_.end());
    while (candidates_.size() > task.end) {
      std::pop_heap(begin, candidates_.end());
      const std::uint32_t shell = candidates_.back().shell;
      candidates_.pop_back();
      if (cutter_.is_apart(piece_, cone.axis(), shells_[shell].cone)) continue;
      const Hides part = hides_target(shell);
      if (part == Hides::kNever || !cut(shell, part)) continue;
      for (std::size_t p = tasks_.size(); p < pieces_.size(); ++p) tasks_.push_back({task.end, candidates_.size()});
      return false;
    }
    return true;
  }

  // Appends to pieces_ what a shell leaves of piece_. False where that is all of it: then nothing is appended.
  bool cut(std::uint32_t shell, Hides part) {
    const std::size_t before = pieces_.size();
    const ViewShell3& occluder = shells_[shell];
    if (part == Hides::kEach) return cut_each(occluder);
    sides_.assign(occluder.cone.sides.begin(), occluder.cone.sides.end());
    // First, so that a piece that is nearer stays whole.
    if (part == Hides::kWhereNearer) sides_.insert(sides_.begin(), planes_.add_crossing(occluder.polygons[0], target_));
    if (!cutter_.subtract(piece_, sides_, pieces_)) {
      pieces_.drop_last();
      return false;
    }
    if (part == Hides::kWhole && pieces_.size() == before) remember_hider(shell);
    return true;
  }

  bool cut_each(const ViewShell3& occluder) {
    bool is_anything_hidden = false;
    kept_.clear();
    kept_.add() = piece_;
    for (const std::uint32_t k : occluder.polygons) {
      const Hides part = hides(k, target_);
      if (part == Hides::kNever) continue;
      cone_sides(planes_, k, sides_);
      if (part == Hides::kWhereNearer) sides_.insert(sides_.begin(), planes_.add_crossing(k, target_));
      rest_.clear();
      for (std::size_t p = 0; p < kept_.size(); ++p) is_anything_hidden |= cutter_.subtract(kept_[p], sides_, rest_);
      std::swap(kept_, rest_);
    }
    if (!is_anything_hidden) return false;
    for (std::size_t p = 0; p < kept_.size(); ++p) std::swap(pieces_.add(), kept_[p]);
    return true;
  }

  // Whether the shell that hid all of another one last hides all of this one: neighbours often share their fate.
  bool is_hidden_as_before(const Direction3& axis) {
    if (hiders_.empty() || hiders_.front() == shells_.shell_of(target_)) return false;
    return cutter_.is_inside(pieces_[0], axis, shells_[hiders_.front()].cone) &&
           hides_target(hiders_.front()) == Hides::kWhole;
  }

  // Adds what is seen of a polygon, which is in this leaf of the tree. Returns whether anything is.
  bool see(std::uint32_t target, std::uint32_t leaf) {
    target_ = target;
    const ViewCone3 cone = cones_.around({&target, 1}, planes_.occluders().outline(target));
    if (is_hidden_by_hiders(cone)) return false;
    pieces_.clear();
    if (!horizon_) {
      cone_of_polygon(planes_, target, pieces_.add());
    } else {
      cone_of_polygon(planes_, target, piece_);
      if (!cutter_.clip(piece_, *horizon_, pieces_.add())) return true;
    }
    return !is_hidden_as_before(cone.axis()) && take_away_all(cone, leaf);
  }

  Direction3 direction(const ConeCorner3& corner) {
    if (corner.direction.error <= kIllConditioned * corner.direction.size) return unit(corner.direction);
    return unit(rounded_well(planes_.exact_direction(corner)));
  }

  // The vector from the eye to where a corner meets the plane of a polygon; of a sun, zero.
  Direction3 way_to(std::uint32_t target, const ConeCorner3& corner) {
    if (planes_.eye().sun()) return {};
    const Occluders3& occluders = planes_.occluders();
    const VertexId3 anchor = occluders.outline(target).front();
    const BoundedVector& normal = occluders.normal(target);
    const BoundedVector& d = corner.direction;
    const double unit_length = planes_.eye().unit();
    const BoundedValue height = dot(normal, planes_.eye().toward(anchor)), slope = dot(normal, d);
    if (height.error <= kIllConditioned * std::fabs(height.value) &&
        slope.error <= kIllConditioned * std::fabs(slope.value) && d.error <= kIllConditioned * d.size) {
      const double t = height.value / slope.value * unit_length;
      return {t * d.x, t * d.y, t * d.z};
    }
    const IntegerVector exact = planes_.exact_direction(corner);
    const IntegerVector& n = occluders.exact_normal(target);
    Rational t(dot(n, planes_.eye().exact_toward(anchor)), dot(n, exact));
    t.canonicalize();
    t *= planes_.eye().exact_unit();
    return {to_double(t * exact.x), to_double(t * exact.y), to_double(t * exact.z)};
  }

  void add_fragment(std::uint32_t target, const ConeFragment3& fragment) {
    const auto begin = static_cast<std::uint32_t>(map_.corners.size());
    directions_.clear();
    for (const ConeCorner3& corner : fragment) {
      const Direction3 way = way_to(target, corner);
      directions_.push_back(direction(corner));
      map_.corners.push_back({directions_.back(), eye_.x + way.x, eye_.y + way.y, eye_.z + way.z, corner.plane});
    }
    VisibilityMap3::Fragment& added = map_.fragments.emplace_back(VisibilityMap3::Fragment{
        {target, planes_.facing(target) < 0}, begin, static_cast<std::uint32_t>(map_.corners.size()), 0, 0});
    if (planes_.eye().sun()) return;
    if (!has_opposite_corners_3(directions_)) {
      added.fraction = solid_angle_fraction_3(directions_);
      if (horizon_) added.factor = view_factor_3(directions_, normal_);
      return;
    }
    inward_.clear();
    for (const ConeCorner3& corner : fragment) inward_.push_back(inward(corner.plane));
    added.fraction = solid_angle_fraction_by_normals_3(inward_);
    if (horizon_) added.factor = view_factor_by_normals_3(directions_, inward_, normal_);
  }

  Direction3 inward(PlaneSide3 side) {
    const BoundedVector& normal = planes_.normal(side.plane);
    const bool is_good = normal.error <= kIllConditioned * normal.size;
    const Direction3 result = unit(is_good ? normal : rounded_well(planes_.exact_normal(side.plane)));
    return side.is_opposite ? -result : result;
  }

  void sort_by_face() {
    std::stable_sort(
        map_.fragments.begin(), map_.fragments.end(),
        [](const VisibilityMap3::Fragment& a, const VisibilityMap3::Fragment& b) { return a.face < b.face; });
    std::vector<VisibilityMap3::Corner> sorted;
    sorted.reserve(map_.corners.size());
    for (VisibilityMap3::Fragment& fragment : map_.fragments) {
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
    for (VisibilityMap3::Corner& corner : map_.corners) {
      PlaneId3& number = numbers[corner.side.plane.index()];
      if (number.is_none()) {
        number = PlaneId3(map_.planes.size());
        map_.planes.push_back(planes_.definitions()[corner.side.plane.index()]);
      }
      corner.side.plane = number;
    }
  }

  void add_shares() {
    double fraction = horizon_ ? 0.5 : 1, factor = horizon_ ? 1 : 0;
    for (const VisibilityMap3::Fragment& fragment : map_.fragments) {
      if (map_.shares.empty() || map_.shares.back().face != fragment.face) map_.shares.push_back({fragment.face, 0, 0});
      map_.shares.back().fraction += fragment.fraction;
      map_.shares.back().factor += fragment.factor;
    }
    for (const VisibilityMap3::Share& share : map_.shares) {
      fraction -= share.fraction;
      factor -= share.factor;
    }
    if (planes_.eye().sun()) return;
    map_.sky_fraction = fraction;
    map_.sky_factor = factor;
  }

  EyePlanes3 planes_;
  ConeCutter3 cutter_;
  ViewCones3 cones_;
  ViewShells3 shells_;
  ViewTree3 tree_;
  Direction3 eye_;
  std::optional<PlaneSide3> horizon_;
  Direction3 normal_;
  std::vector<std::uint32_t> around_;  // what may hide something of the leaf at hand, where that is known
  bool is_around_known_ = false;
  std::vector<std::uint32_t> hidden_counts_;  // of shells: how many of their polygons are hidden as a whole
  std::vector<std::uint32_t> hiders_;         // shells that hid something as a whole, the latest first
  std::uint32_t target_ = 0;
  std::vector<Hiding> hidings_;  // of shells
  std::vector<Candidate> candidates_;
  std::vector<Task> tasks_;  // with pieces_
  FragmentList3 pieces_, kept_, rest_;
  ConeFragment3 piece_;
  std::vector<PlaneSide3> sides_;
  std::vector<Direction3> directions_, inward_;  // of the fragment at hand
  VisibilityMap3 map_;
};

}  // namespace

VisibilityMap3 map_from(const Occluders3& occluders, const Look3& look) {
  const DefaultFloatingPoint environment;
  return MapMaker(occluders, look).make();
}

VisibilityMap3 map_of_sun(const Occluders3& occluders, const Vector3& direction) {
  const DefaultFloatingPoint environment;
  return MapMaker(occluders, Eye3::of_sun(occluders.vertices(), direction), false).make();
}

}  // namespace hottel
