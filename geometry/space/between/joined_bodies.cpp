#include "geometry/space/between/joined_bodies.h"

#include <algorithm>
#include <numbers>
#include <tuple>
#include <utility>

#include "kernel/plain_functions.h"

namespace hottel {
namespace {

// Sines below this are not surely those of a turn.
constexpr double kTurn = 1e-12;
// Cosines below this are not surely those of what is before the eye.
constexpr double kBefore = 1e-9;

}  // namespace

void JoinedBodies3::number_sides() {
  struct Place {
    std::uint32_t a, b, side;
  };
  std::vector<Place> places;
  first_.assign(3, 0);  // patches hide nothing
  for (std::uint32_t body = 2; body < bodies_.end_of_between(); ++body) {
    const std::vector<std::uint32_t>& corners = bodies_.bodies[body].corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto [a, b] = std::minmax(corners[k], corners[k + 1 == corners.size() ? 0 : k + 1]);
      places.push_back({a, b, static_cast<std::uint32_t>(body_of_.size())});
      same_next_.push_back(places.back().side);
      body_of_.push_back(body);
    }
    first_.push_back(static_cast<std::uint32_t>(body_of_.size()));
  }
  std::ranges::sort(places, {}, [](const Place& p) { return std::tuple(p.a, p.b, p.side); });
  for (std::size_t k = 1; k < places.size(); ++k)
    if (places[k].a == places[k - 1].a && places[k].b == places[k - 1].b)
      std::swap(same_next_[places[k].side], same_next_[places[k - 1].side]);
  seen_.resize(body_of_.size());
  facings_.assign(bodies_.end_of_between(), 0);
  sets_ = DisjointSets(bodies_.end_of_between());
  is_reached_.resize(bodies_.end_of_between());
}

// Whether an outline surely turns left from one side to the next.
bool JoinedBodies3::turns(std::uint32_t side, std::uint32_t next) const {
  const Direction3 normal = cross(way(seen_[side].from), way(seen_[side].to)), to = way(seen_[next].to);
  return dot(normal, to) > kTurn * length(normal) * length(to);
}

JoinedBodies3::Side JoinedBodies3::side_of(std::uint32_t side) const {
  return {body_of_[side], side - first_[body_of_[side]], seen_[side].from, seen_[side].to};
}

void JoinedBodies3::join(std::span<const std::uint32_t> list, std::span<const BoundedVector> toward,
                         std::vector<Group>& groups) {
  groups.clear();
  if (list.size() < 2) return;
  if (first_.empty()) number_sides();
  toward_ = toward;
  look(list);
  pair_sides(list);
  for (const std::uint32_t body : list) is_reached_[body] = 0;
  for (const std::uint32_t body : list) {
    if (facings_[body] == 0 || std::exchange(is_reached_[body], 1) != 0) continue;
    component_.assign(1, body);
    for (std::size_t k = 0; k < component_.size(); ++k)
      for (std::uint32_t side = first_[component_[k]]; side < first_[component_[k] + 1]; ++side) {
        if (seen_[side].partner == kNone) continue;
        const std::uint32_t next = body_of_[seen_[side].partner];
        if (std::exchange(is_reached_[next], 1) == 0) component_.push_back(next);
      }
    if (component_.size() > 1 && !join_all(groups)) join_some(groups);
  }
  for (const std::uint32_t body : list) facings_[body] = 0;
}

// Where the back is seen corners run counter-clockwise, seen along directions.
void JoinedBodies3::look(std::span<const std::uint32_t> list) {
  for (const std::uint32_t body : list) {
    const PairGeometry3::Body& b = bodies_.bodies[body];
    const double height = dot(Direction3{b.normal.x, b.normal.y, b.normal.z}, way(b.corners.front()));
    facings_[body] = static_cast<signed char>(height < 0 ? 1 : height > 0 ? -1 : 0);
    const std::uint32_t first = first_[body], count = first_[body + 1] - first;
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t a = b.corners[k], c = b.corners[k + 1 == count ? 0 : k + 1];
      const std::uint32_t after = first + (k + 1 == count ? 0 : k + 1), before = first + (k == 0 ? count : k) - 1;
      seen_[first + k] = facings_[body] < 0 ? Seen{a, c, kNone, after, before} : Seen{c, a, kNone, before, after};
    }
  }
}

void JoinedBodies3::pair_sides(std::span<const std::uint32_t> list) {
  for (const std::uint32_t body : list) {
    if (facings_[body] == 0) continue;
    for (std::uint32_t side = first_[body]; side < first_[body + 1]; ++side)
      for (std::uint32_t other = same_next_[side]; other != side && seen_[side].partner == kNone;
           other = same_next_[other])
        if (facings_[body_of_[other]] != 0 && seen_[other].partner == kNone && seen_[other].from == seen_[side].to) {
          seen_[side].partner = other;
          seen_[other].partner = side;
        }
  }
}

// The component as one group. False where its outline is not one convex polygon.
bool JoinedBodies3::join_all(std::vector<Group>& groups) {
  open_sides_.clear();
  for (const std::uint32_t body : component_)
    for (std::uint32_t side = first_[body]; side < first_[body + 1]; ++side)
      if (seen_[side].partner == kNone) open_sides_.push_back(side);
  if (open_sides_.size() < 3) return false;
  Group group;
  std::uint32_t side = open_sides_.front();
  do {
    if (group.outline.size() == open_sides_.size()) return false;
    group.outline.push_back(side_of(side));
    std::uint32_t next = kNone;
    for (const std::uint32_t other : open_sides_) {
      if (seen_[other].from != seen_[side].to) continue;
      if (next != kNone) return false;
      next = other;
    }
    if (next == kNone || !turns(side, next)) return false;
    side = next;
  } while (side != open_sides_.front());
  if (group.outline.size() != open_sides_.size()) return false;
  group.bodies = component_;
  for (const std::uint32_t body : component_) group.facings.push_back(facings_[body]);
  if (!is_before_once(group, toward_)) return false;
  groups.push_back(std::move(group));
  return true;
}

bool JoinedBodies3::is_before_once(const Group& group, std::span<const BoundedVector> toward) const {
  const auto to = [toward](std::uint32_t point) { return way_of(toward[point]); };
  Direction3 middle;
  for (const Side& side : group.outline) middle = middle + unit(to(side.from));
  if (!(length(middle) > kBefore)) return false;
  middle = unit(middle);
  for (const std::uint32_t body : group.bodies)
    for (const std::uint32_t corner : bodies_.bodies[body].corners)
      if (!(dot(middle, to(corner)) > kBefore * length(to(corner)))) return false;
  // In the plane across, at distance 1.
  const auto seen = [&](const Side& side) { return (1 / dot(middle, to(side.from))) * to(side.from); };
  double turn = 0;
  for (std::size_t k = 0; k < group.outline.size(); ++k) {
    const std::size_t count = group.outline.size();
    const Direction3 at = seen(group.outline[(k + 1) % count]);
    const Direction3 in = at - seen(group.outline[k]), out = seen(group.outline[(k + 2) % count]) - at;
    turn += same_bits::atan2(dot(middle, cross(in, out)), dot(in, out));
  }
  return turn < 3 * std::numbers::pi;
}

// Two convex outlines at a time, where both together are convex. Each is that of a convex polygon as seen, so all is
// before the eye, once.
void JoinedBodies3::join_some(std::vector<Group>& groups) {
  sets_.separate(component_);
  for (bool is_joined = true; is_joined;) {
    is_joined = false;
    for (const std::uint32_t body : component_)
      for (std::uint32_t side = first_[body]; side < first_[body + 1]; ++side)
        if (seen_[side].partner != kNone && seen_[side].next != kNone) is_joined |= join_at(side);
  }
  for (const std::uint32_t body : component_) {
    if (sets_.root(body) != body) continue;
    Group group;
    std::uint32_t start = kNone;
    for (const std::uint32_t other : component_) {
      if (sets_.root(other) != body) continue;
      group.bodies.push_back(other);
      group.facings.push_back(facings_[other]);
      for (std::uint32_t side = first_[other]; side < first_[other + 1]; ++side)
        if (seen_[side].next != kNone) start = side;
    }
    if (group.bodies.size() < 2) continue;
    std::uint32_t side = start;
    do {
      group.outline.push_back(side_of(side));
      side = seen_[side].next;
    } while (side != start);
    groups.push_back(std::move(group));
  }
}

// Joins two outlines along a side of both. False where they are one already, or what they make is not surely convex.
bool JoinedBodies3::join_at(std::uint32_t side) {
  const std::uint32_t other = seen_[side].partner;
  const std::uint32_t a = sets_.root(body_of_[side]), b = sets_.root(body_of_[other]);
  if (a == b) return false;
  const Seen first = seen_[side], second = seen_[other];
  if (!turns(first.previous, second.next) || !turns(second.previous, first.next)) return false;
  const auto link = [this](std::uint32_t from, std::uint32_t to) {
    seen_[from].next = to;
    seen_[to].previous = from;
  };
  link(first.previous, second.next);
  link(second.previous, first.next);
  for (const std::uint32_t gone : {side, other}) seen_[gone].next = seen_[gone].previous = kNone;
  sets_.join_to_smaller(a, b);
  return true;
}

}  // namespace hottel
