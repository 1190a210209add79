#include "geometry/space/hiding/hiders.h"

#include <algorithm>
#include <array>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "geometry/space/arrangement/short_integers.h"
#include "geometry/space/arrangement/surface_boxes.h"
#include "geometry/space/arrangement/whole_patch.h"
#include "geometry/space/hiding/outward_plane.h"
#include "kernel/exact_double.h"

namespace hottel {
namespace {

// Deeper in a body than this part of the largest coordinate is deep. Places of corners, and of middles between them,
// are told within 2^-48 of it, heights over planes within 2^-46.
constexpr double kDeep = 0x1p-34;

constexpr int kMostHalvings = 16;
constexpr int kQuestionsOfNeverFirst = 128;
constexpr std::size_t kMostTried = 8;  // hiders at a line

using Corners = boost::container::small_vector<Direction3, 8>;

using Plane = OutwardPlane3;

Direction3 place_of(const BoundedVector& v) { return {v.x, v.y, v.z}; }
double size_of(const Direction3& p) { return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}); }

Direction3 unit_of(const IntegerVector& v) { return unit(place_of(rounded(v, std::max(0L, bits(v) - 53)))); }

Direction3 middle_of(const Corners& corners) {
  Direction3 sum;
  for (const Direction3& p : corners) sum = sum + p;
  return (1 / static_cast<double>(corners.size())) * sum;
}

// The longest side, squared, and where it begins.
std::pair<double, std::size_t> longest_side(const Corners& corners) {
  std::pair<double, std::size_t> longest{-1, 0};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Direction3 way = corners[(k + 1) % corners.size()] - corners[k];
    if (const double square = dot(way, way); square > longest.first) longest = {square, k};
  }
  return longest;
}

// Cut from the middle of side `from` to the middle of the side opposite, or the corner opposite.
std::array<Corners, 2> halves_of(const Corners& corners, std::size_t from) {
  const std::size_t n = corners.size(), opposite = (from + (n + 1) / 2) % n;
  const auto at = [&](std::size_t k) { return corners[k % n]; };
  const Direction3 begin = 0.5 * (at(from) + at(from + 1));
  const Direction3 end = n % 2 == 0 ? 0.5 * (at(opposite) + at(opposite + 1)) : at(opposite);
  std::array<Corners, 2> halves;
  halves[0].push_back(begin);
  for (std::size_t k = from + 1;; ++k) {
    if (n % 2 != 0 && k % n == opposite) break;
    halves[0].push_back(at(k));
    if (n % 2 == 0 && k % n == opposite) break;
  }
  halves[0].push_back(end);
  halves[1].push_back(end);
  for (std::size_t k = opposite + 1;; ++k) {
    halves[1].push_back(at(k));
    if (k % n == from) break;
  }
  halves[1].push_back(begin);
  return halves;
}

// The part of a polygon that is not deeper than `slack` behind a plane.
Corners cut(const Corners& corners, const Plane& plane, double slack) {
  Corners result;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Direction3 &a = corners[k], &b = corners[(k + 1) % corners.size()];
    const double at_a = plane.height(a) + slack, at_b = plane.height(b) + slack;
    if (at_a >= 0) result.push_back(a);
    if ((at_a < 0) != (at_b < 0)) result.push_back(a + (at_a / (at_a - at_b)) * (b - a));
  }
  return result;
}

// Where a line from 0 to 1 is, and shortened by half spaces.
struct Interval {
  double low = 0, high = 1;
  // Keeps where a height that is linear, of ends `from` and `to`, is below `most`. False where that is nowhere.
  bool keep_below(double from, double to, double most) {
    if (from < most && to < most) return true;
    if (from >= most && to >= most) return false;
    const double zero = (from - most) / (from - to);
    if (from >= most)
      low = std::max(low, zero);
    else
      high = std::min(high, zero);
    return low < high;
  }
};

}  // namespace

struct Hiders3::Body {
  const ConvexBody3* exact;
  std::vector<Plane> planes;
  std::optional<Plane> lid;

  // Whether no point of a polygon is in the body, or nearly: the lid bounds nothing.
  template <class Points>
  bool is_apart_from(const Points& corners, double deep) const {
    const auto is_beyond = [&](const Plane& plane) {
      return std::ranges::all_of(corners, [&](const Direction3& p) { return plane.height(p) > deep; });
    };
    if (std::ranges::any_of(planes, is_beyond)) return true;
    const auto is_within = [&](const Direction3& p) {
      return std::ranges::all_of(planes, [&](const Plane& plane) { return plane.height(p) <= deep; });
    };
    if (std::ranges::any_of(corners, is_within)) return false;
    Corners rest(corners.begin(), corners.end());
    for (const Plane& plane : planes) {
      if (rest.empty()) return true;
      rest = cut(rest, {-plane.outward, -plane.offset}, deep);
    }
    return rest.empty();
  }

  bool meets(const Direction3& p, const Direction3& q, double deep) const {
    Interval inside;
    for (const Plane& plane : planes)
      if (!inside.keep_below(plane.height(p), plane.height(q), -deep)) return false;
    return true;
  }
};

struct Hiders3::Flat {
  Plane plane;
  std::vector<Direction3> corners;  // counter-clockwise, seen from where heights are positive
  std::uint32_t surface;

  bool hides(const Direction3& p, const Direction3& q, double deep) const {
    const double at_p = plane.height(p), at_q = plane.height(q);
    if (!((at_p > deep && at_q < -deep) || (at_p < -deep && at_q > deep))) return false;
    const Direction3 &from = at_p > 0 ? p : q, &to = at_p > 0 ? q : p;
    const Direction3 way = to - from;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Direction3 &a = corners[k], &b = corners[(k + 1) % corners.size()];
      // The volume between from, to, a and b: positive where the line passes on the inner side of the edge. The ways
      // are off by 2^-13 deep each, the volume by three times that and twice its own rounding, times two lengths.
      const Direction3 to_a = a - from, to_b = b - from;
      const double longest = std::max({length(way), length(to_a), length(to_b)});
      if (!(dot(way, cross(to_b, to_a)) > 0x1p-6 * deep * longest * longest)) return false;
    }
    return true;
  }
};

// Boxes around hiders, halved again and again. A hider is a body, or, behind these, a flat surface.
struct Hiders3::Tree {
  struct Node {
    Box3 box;
    std::uint32_t begin = 0, end = 0;
    std::uint32_t left = 0, right = 0;
  };

  std::vector<Body> bodies;
  std::vector<Flat> flats;
  std::vector<Box3> boxes;
  std::vector<Patch3> surfaces;  // whole
  std::vector<PlacedPatch3> placed;
  std::vector<std::uint32_t> order;
  std::vector<Node> nodes;
  double size = 0;  // the largest coordinate of the scene

  void build() {
    order.resize(boxes.size());
    std::iota(order.begin(), order.end(), 0u);
    if (!order.empty()) add_node(0, static_cast<std::uint32_t>(order.size()));
  }

  std::uint32_t add_node(std::uint32_t begin, std::uint32_t end) {
    const auto number = static_cast<std::uint32_t>(nodes.size());
    Node node;
    node.begin = begin;
    node.end = end;
    for (std::uint32_t k = begin; k < end; ++k) node.box.include(boxes[order[k]]);
    nodes.push_back(node);
    constexpr std::uint32_t kLeaf = 2;
    if (end - begin <= kLeaf) return number;
    int axis = 0;
    for (int a = 1; a < 3; ++a)
      if (node.box.high[a] - node.box.low[a] > node.box.high[axis] - node.box.low[axis]) axis = a;
    const auto middle = [&](std::uint32_t h) { return boxes[h].low[axis] / 2 + boxes[h].high[axis] / 2; };
    std::stable_sort(order.begin() + begin, order.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) { return middle(a) < middle(b); });
    const std::uint32_t half = begin + (end - begin) / 2;
    const std::uint32_t left = add_node(begin, half), right = add_node(half, end);
    nodes[number].left = left;
    nodes[number].right = right;
    return number;
  }

  // Calls visit(hider) for hiders whose boxes a line meets, or passes within `slack`. Ends where it returns false.
  template <class Visit>
  void find(const Direction3& p, const Direction3& q, double slack, const Visit& visit) const {
    if (nodes.empty()) return;
    const double from[] = {p.x, p.y, p.z}, to[] = {q.x, q.y, q.z};
    const auto meets = [&](const Box3& box) {
      Interval inside;
      for (int a = 0; a < 3; ++a)
        if (!inside.keep_below(box.low[a] - from[a], box.low[a] - to[a], slack) ||
            !inside.keep_below(from[a] - box.high[a], to[a] - box.high[a], slack))
          return false;
      return true;
    };
    boost::container::small_vector<std::uint32_t, 64> open{0};
    while (!open.empty()) {
      const Node& node = nodes[open.back()];
      open.pop_back();
      if (!meets(node.box)) continue;
      if (node.left != 0) {
        open.push_back(node.right);
        open.push_back(node.left);
        continue;
      }
      for (std::uint32_t k = node.begin; k < node.end; ++k)
        if (meets(boxes[order[k]]) && !visit(order[k])) return;
    }
  }
};

// One question. What is asked of signs of whole patches is remembered.
class Hiders3::Proof {
 public:
  Proof(const Hiders3& hiders, const PlacedPatch3& i, const PlacedPatch3& j, int most)
      : hiders_(hiders), tree_(*hiders.tree_), patches_{&i, &j}, left_(most) {
    deep_ = kDeep * std::max({tree_.size, i.size, j.size});
  }

  // Lines end on both sides of the second patch.
  void take_both_sides() { faces_both_ = true; }

  // Whether all lines between a part of the first patch and one of the second are hidden.
  bool holds(const Corners& a, const Corners& b) { return holds(a, b, kMostHalvings); }

  // Whether one flat surface stands between the patches, whole, that lines may touch at its border: plates of one size
  // behind each other. Exact.
  bool is_behind_one(const Corners& a, const Corners& b) const {
    bool result = false;
    tree_.find(middle_of(a), middle_of(b), deep_, [&](std::uint32_t hider) {
      result = hider >= tree_.bodies.size() && stands_between(tree_.flats[hider - tree_.bodies.size()]);
      return !result;
    });
    return result;
  }

  Corners corners(int of, std::optional<Plane> before) const {
    Corners result(patches_[of]->corners.begin(), patches_[of]->corners.end());
    return before ? cut(result, *before, deep_) : result;
  }
  Plane plane(int of) const {
    const PlacedPatch3& patch = *patches_[of];
    double sum = 0;
    for (const Direction3& p : patch.corners) sum += dot(patch.normal, p);
    return {patch.normal, sum / static_cast<double>(patch.corners.size())};
  }

  // The sides of a plane of a body on which the corners of a whole patch lie.
  struct Sides {
    bool has_outside = false, has_inside = false;
  };
  Sides sides(int of, const BodyPlane3& exact, const Plane& plane) const {
    Sides result;
    const Patch3& patch = *patches_[of]->patch;
    for (std::size_t k = 0; k < patch.corners.size(); ++k) {
      int sign = 0;
      if (const double height = plane.height(patches_[of]->corners[k]); std::fabs(height) > deep_)
        sign = height > 0 ? 1 : -1;
      else
        sign =
            plane_side_3(exact.outward, patch.corners[k], patch.weight, hiders_.occluders_.vertices().exact(exact.at));
      result.has_outside |= sign > 0;
      result.has_inside |= sign < 0;
    }
    return result;
  }
  // Whether a patch is outside a body, the lid taken away: apart from it, or beyond a plane other than `but`, where no
  // corner is within that plane, and one is beyond.
  bool is_outside(int of, const Body& body, std::uint32_t but = ConvexBody3::kNone) const {
    if (body.is_apart_from(patches_[of]->corners, deep_)) return true;
    for (std::uint32_t k = 0; k < body.planes.size(); ++k) {
      if (k == but) continue;
      const Sides found = sides(of, body.exact->planes[k], body.planes[k]);
      if (found.has_outside && !found.has_inside) return true;
    }
    return false;
  }
  bool is_within_lid(int of, const Body& body) const {
    return !body.lid || !sides(of, *body.exact->lid, *body.lid).has_outside;
  }

 private:
  bool stands_between(const Flat& flat) const {
    const double side = flat.plane.height(patches_[0]->corners.front()) > 0 ? 1 : -1;
    const auto is_off = [&](int of, double on_side) {
      return std::ranges::all_of(patches_[of]->corners,
                                 [&](const Direction3& p) { return on_side * flat.plane.height(p) > deep_; });
    };
    if (!is_off(0, side) || !is_off(1, -side)) return false;
    // Seen from where heights are positive its corners run counter-clockwise.
    const int from = side > 0 ? 0 : 1;
    for (std::size_t p = 0; p < patches_[from]->corners.size(); ++p)
      for (std::size_t q = 0; q < patches_[1 - from]->corners.size(); ++q)
        for (std::size_t k = 0; k < flat.corners.size(); ++k)
          if (volume_sign(from, p, q, flat, k) < 0) return false;
    return true;
  }

  // The sign of Flat::hides for a line between corners, and side k: exact.
  int volume_sign(int from, std::size_t p, std::size_t q, const Flat& flat, std::size_t k) const {
    const std::size_t next = (k + 1) % flat.corners.size();
    const Direction3 &eye = patches_[from]->corners[p], way = patches_[1 - from]->corners[q] - eye;
    const Direction3 to_a = flat.corners[k] - eye, to_b = flat.corners[next] - eye;
    const double volume = dot(way, cross(to_b, to_a)), longest = std::max({length(way), length(to_a), length(to_b)});
    if (std::fabs(volume) > 0x1p-6 * deep_ * longest * longest) return volume > 0 ? 1 : -1;
    const Patch3 &first = *patches_[from]->patch, &second = *patches_[1 - from]->patch;
    const IntegerVector& at = first.corners[p];
    const auto outline = hiders_.occluders_.outline(flat.surface);
    const auto offset = [&](const IntegerVector& point, const Integer& weight) {
      return difference(multiple(first.weight, point), multiple(weight, at));
    };
    const auto corner = [&](std::size_t c) { return offset(hiders_.occluders_.vertices().exact(outline[c]), 1); };
    return determinant_sign(offset(second.corners[q], second.weight), corner(next), corner(k));
  }

  // What is told of whole patches beside a body, each when it is first asked for.
  struct Facts {
    std::uint32_t body;
    std::optional<bool> both_within_lid, is_outside[2], is_outside_or_beyond_lid[2];
  };

  Facts& facts(std::uint32_t number) {
    for (Facts& known : facts_)
      if (known.body == number) return known;
    return facts_.emplace_back(Facts{number, {}, {}, {}});
  }
  bool are_within_lid(std::uint32_t number) {
    std::optional<bool>& known = facts(number).both_within_lid;
    if (known) return *known;
    const Body& body = tree_.bodies[number];
    if (!body.lid) return *(known = true);
    const Sides beside[] = {sides(0, *body.exact->lid, *body.lid), sides(1, *body.exact->lid, *body.lid)};
    // What lies in the lid's plane and looks up sends lines up alone.
    const auto looks_up = [&](int of) {
      return !beside[of].has_outside && !beside[of].has_inside && is_front(of) &&
             dot(patches_[of]->normal, body.lid->outward) < 0;
    };
    return *(known = (!beside[0].has_outside && !beside[1].has_outside) || looks_up(0) || looks_up(1));
  }
  bool is_outside(int of, std::uint32_t number) {
    std::optional<bool>& known = facts(number).is_outside[of];
    return known ? *known : *(known = is_outside(of, tree_.bodies[number]));
  }
  bool is_outside_or_beyond_lid(int of, std::uint32_t number) {
    std::optional<bool>& known = facts(number).is_outside_or_beyond_lid[of];
    if (known) return *known;
    const Body& body = tree_.bodies[number];
    const Sides beside = sides(of, *body.exact->lid, *body.lid);
    const bool result = (beside.has_outside && !beside.has_inside) || is_outside(of, number);
    return *(facts(number).is_outside_or_beyond_lid[of] = result);
  }
  // Whether lines are on its front alone.
  bool is_front(int of) const { return of == 0 || !faces_both_; }

  // Whether a patch is within a body and looks into it, and the other one is outside one of its planes.
  bool looks_into(int of, const Body& body) const {
    // Most patches are clearly outside of a plane.
    const auto is_outside_of = [&](const Plane& plane) {
      return std::ranges::any_of(patches_[of]->corners, [&](const Direction3& p) { return plane.height(p) > deep_; });
    };
    if (std::ranges::any_of(body.planes, is_outside_of)) return false;
    for (std::uint32_t k = 0; k < body.planes.size(); ++k) {
      const Sides found = sides(of, body.exact->planes[k], body.planes[k]);
      if (found.has_outside) return false;
      if (!found.has_inside && !(is_front(of) && dot(patches_[of]->normal, body.planes[k].outward) < 0)) return false;
    }
    return is_within_lid(of, body) && is_within_lid(1 - of, body) && is_outside(1 - of, body);
  }

  // Whether a line between both is free, of some that end near corners. Where one is, there is nothing to prove.
  bool is_one_free(const Corners& a, const Corners& b, const Direction3& p, const Direction3& q) const {
    constexpr double kNear = 0.875;
    for (std::size_t k = 0; k < a.size(); ++k)
      for (const std::size_t turn : {std::size_t{0}, b.size() / 2})
        if (is_free(p + kNear * (a[k] - p), q + kNear * (b[(k + turn) % b.size()] - q))) return true;
    return false;
  }
  bool is_free(const Direction3& p, const Direction3& q) const {
    bool result = true;
    tree_.find(p, q, deep_, [&](std::uint32_t hider) { return result = !meets(hider, p, q); });
    return result;
  }

  bool holds(const Corners& a, const Corners& b, int halvings) {
    if (left_-- <= 0) return false;
    const Direction3 p = middle_of(a), q = middle_of(b);
    boost::container::small_vector<std::uint32_t, kMostTried> tried;
    tree_.find(p, q, deep_, [&](std::uint32_t hider) {
      if (meets(hider, p, q)) tried.push_back(hider);
      return tried.size() < kMostTried;
    });
    if (tried.empty()) return false;
    if (halvings == kMostHalvings)
      for (const std::uint32_t hider : tried)
        if (hider < tree_.bodies.size() && (looks_into(0, tree_.bodies[hider]) || looks_into(1, tree_.bodies[hider])))
          return true;
    for (const std::uint32_t hider : tried)
      if (hides(hider, a, b)) return true;
    if (halvings == 0 || (halvings == kMostHalvings && is_one_free(a, b, p, q))) return false;
    const auto [of_a, at_a] = longest_side(a);
    const auto [of_b, at_b] = longest_side(b);
    if (of_a >= of_b) {
      const auto halves = halves_of(a, at_a);
      return holds(halves[0], b, halvings - 1) && holds(halves[1], b, halvings - 1);
    }
    const auto halves = halves_of(b, at_b);
    return holds(a, halves[0], halvings - 1) && holds(a, halves[1], halvings - 1);
  }

  bool meets(std::uint32_t hider, const Direction3& p, const Direction3& q) const {
    if (hider < tree_.bodies.size()) return tree_.bodies[hider].meets(p, q, deep_);
    return tree_.flats[hider - tree_.bodies.size()].hides(p, q, deep_);
  }

  bool hides(std::uint32_t hider, const Corners& a, const Corners& b) {
    if (hider < tree_.bodies.size()) return body_hides(hider, a, b);
    const Flat& flat = tree_.flats[hider - tree_.bodies.size()];
    return std::all_of(a.begin(), a.end(), [&](const Direction3& p) {
      return std::all_of(b.begin(), b.end(), [&](const Direction3& q) { return flat.hides(p, q, deep_); });
    });
  }

  // The heights of corners over all planes of a body.
  using Heights = boost::container::small_vector<double, 64>;
  static Heights heights(const Body& body, const Corners& corners) {
    Heights result(body.planes.size() * corners.size(), boost::container::default_init);
    auto next = result.begin();
    for (const Plane& plane : body.planes)
      for (const Direction3& p : corners) *next++ = plane.height(p);
    return result;
  }
  // Whether all lines between a part of each patch meet the inside of a body. `within`: the lid bounds nothing.
  bool all_meet(const Body& body, const Corners& a, const Corners& b, bool within) const {
    const Heights of_a = heights(body, a), of_b = heights(body, b);
    for (std::size_t p = 0; p < a.size(); ++p)
      for (std::size_t q = 0; q < b.size(); ++q) {
        Interval inside;
        if (!within && !inside.keep_below(body.lid->height(a[p]), body.lid->height(b[q]), -deep_)) return false;
        for (std::size_t k = 0; k < body.planes.size(); ++k)
          if (!inside.keep_below(of_a[k * a.size() + p], of_b[k * b.size() + q], -deep_)) return false;
      }
    return true;
  }

  bool body_hides(std::uint32_t number, const Corners& a, const Corners& b) {
    const Body& body = tree_.bodies[number];
    // Most that is not hidden is told by one line of corners.
    if (!body.meets(a[0], b[0], deep_) || !body.meets(a[a.size() / 2], b[b.size() / 2], deep_)) return false;
    const auto all_heights = [&](const Corners& corners, const auto& is_so) {
      return std::all_of(corners.begin(), corners.end(),
                         [&](const Direction3& p) { return is_so(body.lid->height(p)); });
    };
    const auto is_deep = [this](double height) { return height < -deep_; };
    if (!all_meet(body, a, b, true)) return false;
    const bool within = are_within_lid(number) || (all_heights(a, is_deep) && all_heights(b, is_deep));
    if (!within && !all_meet(body, a, b, false)) return false;
    if (within)
      return is_outside(0, number) || is_outside(1, number) || body.is_apart_from(a, deep_) ||
             body.is_apart_from(b, deep_);
    const auto is_off = [this](double height) { return height > deep_; };
    const auto may_come_in = [&](int of, const Corners& corners) {
      return is_outside_or_beyond_lid(of, number) || all_heights(corners, is_off) || body.is_apart_from(corners, deep_);
    };
    return may_come_in(0, a) && may_come_in(1, b);
  }

  const Hiders3& hiders_;
  const Tree& tree_;
  std::array<const PlacedPatch3*, 2> patches_;
  bool faces_both_ = false;  // the second one
  double deep_;
  int left_;  // questions
  boost::container::small_vector<Facts, 8> facts_;
};

Hiders3::Hiders3(const Occluders3& occluders) : occluders_(occluders), bodies_(occluders) {
  const Vertices3& vertices = occluders.vertices();
  auto tree = std::make_unique<Tree>();
  for (std::size_t v = 0; v < vertices.size(); ++v)
    tree->size = std::max(tree->size, vertices.approximate(VertexId3(v)).size);
  const auto plane_of = [&](const BodyPlane3& exact) {
    const Direction3 outward = unit_of(exact.outward);
    return Plane{outward, dot(outward, place_of(vertices.approximate(exact.at)))};
  };
  for (const ConvexBody3& exact : bodies_.bodies()) {
    Body body{&exact, {}, {}};
    for (const BodyPlane3& plane : exact.planes) body.planes.push_back(plane_of(plane));
    if (exact.lid) body.lid = plane_of(*exact.lid);
    tree->bodies.push_back(std::move(body));
    Box3 box;
    for (const VertexId3 v : exact.corners) box.include(vertices.approximate(v));
    tree->boxes.push_back(box);
  }
  for (std::uint32_t s = 0; s < occluders.size(); ++s) {
    if (bodies_.body_of(s) != ConvexBody3::kNone) continue;
    Flat flat{plane_of({occluders.outline(s).front(), occluders.exact_normal(s)}), {}, s};
    Box3 box;
    for (const VertexId3 v : occluders.outline(s)) {
      flat.corners.push_back(place_of(vertices.approximate(v)));
      box.include(vertices.approximate(v));
    }
    tree->flats.push_back(std::move(flat));
    tree->boxes.push_back(box);
  }
  tree->build();
  for (std::uint32_t s = 0; s < occluders.size(); ++s) tree->surfaces.push_back(whole_patch(occluders, s));
  for (const Patch3& whole : tree->surfaces) tree->placed.push_back(placed(whole));
  tree_ = std::move(tree);
}

Hiders3::~Hiders3() = default;

PlacedPatch3 Hiders3::placed(const Patch3& patch) const {
  PlacedPatch3 result{&patch, {}, {}, 0, !patch.is_far()};
  if (patch.is_far()) return result;
  const int shift = static_cast<int>(occluders_.vertices().shift());
  const double factor = std::ldexp(1 / truncated_double(patch.weight), -shift);
  for (const IntegerVector& corner : patch.corners) {
    const Direction3 p{truncated_double(corner.x) * factor, truncated_double(corner.y) * factor,
                       truncated_double(corner.z) * factor};
    result.is_told = result.is_told && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    result.size = std::max(result.size, size_of(p));
    result.corners.push_back(p);
  }
  result.is_told = result.is_told && std::isnormal(factor);
  if (!result.is_told) return result;
  if (patch.is_sky()) {
    result.normal = unit_of(normal_of(patch));
    return result;
  }
  result.normal = unit(place_of(occluders_.normal(patch.surface)));
  Direction3 around;
  for (std::size_t k = 1; k + 1 < result.corners.size(); ++k)
    around = around + cross(result.corners[k] - result.corners[0], result.corners[k + 1] - result.corners[0]);
  const double along = dot(around, result.normal);
  const bool is_sure = std::fabs(along) > 0x1p-40 * result.size * result.size;
  if (is_sure ? along < 0 : dot_sign(normal_of(patch), occluders_.exact_normal(patch.surface)) < 0)
    result.normal = -result.normal;
  return result;
}

bool Hiders3::hide(const PlacedPatch3& i, const PlacedPatch3& j, int most) const {
  if (!i.is_told || !j.is_told) return false;
  Proof proof(*this, i, j, most);
  const Corners a = proof.corners(0, proof.plane(1)), b = proof.corners(1, proof.plane(0));
  if (a.size() < 3 || b.size() < 3) return a.empty() || b.empty();
  return proof.holds(a, b);
}

bool Hiders3::is_never_first(const PlacedPatch3& i, std::uint32_t surface) const {
  if (!i.is_told) return false;
  const PlacedPatch3& whole = tree_->placed[surface];
  if (!whole.is_told) return false;
  Proof proof(*this, i, whole, kQuestionsOfNeverFirst);
  proof.take_both_sides();
  if (const std::uint32_t number = bodies_.body_of(surface); number != ConvexBody3::kNone) {
    // It is met from within its body, into which lines come through another surface.
    const Body& body = tree_->bodies[number];
    const auto at = std::ranges::lower_bound(body.exact->surfaces, surface) - body.exact->surfaces.begin();
    const std::uint32_t own = body.exact->plane_of[static_cast<std::size_t>(at)];
    const bool is_turned_away =
        own == ConvexBody3::kNone || !proof.sides(0, body.exact->planes[own], body.planes[own]).has_outside;
    if (is_turned_away && proof.is_within_lid(0, body) && proof.is_outside(0, body, own)) return true;
  }
  const Corners a = proof.corners(0, std::nullopt), b = proof.corners(1, proof.plane(0));
  if (b.size() < 3) return b.empty();
  return proof.holds(a, b) || proof.is_behind_one(a, b);
}

FirstMet3::FirstMet3(const Hiders3& hiders, const Patch3& patch, std::size_t surfaces)
    : hiders_(hiders), patch_(patch), placed_(hiders.placed(patch_)), known_(surfaces, Known::kNothing) {}

bool FirstMet3::is_never_first(std::uint32_t surface) {
  if (surface == patch_.surface) return false;
  Known& known = known_[surface];
  if (known == Known::kNothing)
    known = hiders_.is_never_first(placed_, surface) ? Known::kNeverFirst : Known::kMayBeFirst;
  return known == Known::kNeverFirst;
}

}  // namespace hottel
