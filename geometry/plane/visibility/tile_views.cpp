#include "geometry/plane/visibility/tile_views.h"

#include <algorithm>
#include <bit>

namespace hottel {
namespace {

using Set = EyeTile2::Set;
using EyeGroup = EyeTile2::Group;

// Where there are at most so many eyes in a triangle on average, they have too little in common to go together.
constexpr std::size_t kFew = 2;

// Calls visit(k) for each eye of the set.
template <class Visit>
void for_each_eye(Set eyes, const Visit& visit) {
  for (; eyes != 0; eyes &= eyes - 1) visit(static_cast<std::size_t>(std::countr_zero(eyes)));
}

EyeGroup part(const EyeTile2& tile, const EyeGroup& group, Set eyes) {
  return eyes == group.eyes ? group : tile.group(eyes);
}

}  // namespace

void TileViews2::look_around(const PointLocation2& location, const EyeTile2& tile) {
  const Triangulation2& triangulation = location.triangulation();
  openings_.clear();
  cones_.clear();
  locate(location, tile);
  while (!homes_.empty()) {
    join_homes(triangulation);
    if (are_few_in_joined_homes()) {
      look_around_alone(location, tile);
      continue;
    }
    leave_homes(triangulation, tile);
    for (const HalfEdgeId border : borders_) {
      open(border);
      for (const auto& [half_edge, cone] : crossed_)
        if (half_edge == border) add(tile, cone.right, cone.left, cone.group);
      expand(triangulation, tile);
    }
    begin_at_home(triangulation);
  }
}

// Eyes on edges, at vertices and outside look around by themselves. Where two in a row are in one triangle it is asked
// which others are.
void TileViews2::locate(const PointLocation2& location, const EyeTile2& tile) {
  homes_.clear();
  const Triangulation2& triangulation = location.triangulation();
  TriangleId near = TriangleId::none();
  Set placed = 0;
  const auto place = [&](std::size_t k, const Location2& where) {
    places_[k] = where;
    views_[k].seen.clear();
  };
  for (std::size_t row = 0; row < tile.rows(); ++row)
    for (std::size_t column = 0; column < tile.columns(); ++column) {
      const std::size_t k = EyeTile2::kSide * row + column;
      if ((placed >> k & 1) != 0) continue;
      const TriangleId before = near;
      const Location2 where = location.locate(tile.eye(k), near);
      place(k, where);
      if (where.kind != Location2::Kind::kInTriangle) {
        location.look_around(tile.eye(k), views_[k], near);
        continue;
      }
      const TriangleId triangle = triangle_of(where.half_edge);
      Set eyes = Set{1} << k;
      if (triangle == before) {
        eyes = tile.all() & ~placed & ~(eyes - 1);  // not those before, which are elsewhere
        for (const HalfEdgeId h : half_edges_of(triangle))
          if (eyes != 0)
            eyes = tile.seeing_left_turn(tile.group(eyes), triangulation.origin(h), triangulation.target(h));
        for_each_eye(eyes, [&](std::size_t other) { place(other, where); });
      }
      placed |= eyes;
      const auto home =
          std::find_if(homes_.begin(), homes_.end(), [&](const Home& h) { return h.triangle == triangle; });
      if (home == homes_.end())
        homes_.push_back({triangle, eyes});
      else
        home->eyes |= eyes;
    }
}

// Takes a home and those that can be reached from it through homes. Each is entered through one edge only, so that what
// is joined has no holes: every eye meets its borders in their order.
void TileViews2::join_homes(const Triangulation2& triangulation) {
  const auto largest = std::max_element(homes_.begin(), homes_.end(), [](const Home& a, const Home& b) {
    return std::popcount(a.eyes) < std::popcount(b.eyes);
  });
  joined_.assign(1, *largest);
  homes_.erase(largest);
  const auto first = half_edges_of(joined_.front().triangle);
  borders_.assign(first.begin(), first.end());
  for (std::size_t k = 0; k < borders_.size();) {
    const HalfEdgeId entry = triangulation.twin(borders_[k]);
    const auto home = std::find_if(homes_.begin(), homes_.end(),
                                   [&](const Home& h) { return !entry.is_none() && h.triangle == triangle_of(entry); });
    if (home == homes_.end()) {
      ++k;
      continue;
    }
    joined_.push_back(*home);
    homes_.erase(home);
    borders_[k] = previous_half_edge(entry);
    borders_.insert(borders_.begin() + static_cast<std::ptrdiff_t>(k), next_half_edge(entry));
  }
}

bool TileViews2::are_few_in_joined_homes() const {
  std::size_t eyes = 0;
  for (const Home& home : joined_) eyes += static_cast<std::size_t>(std::popcount(home.eyes));
  return eyes <= kFew * joined_.size();
}

void TileViews2::look_around_alone(const PointLocation2& location, const EyeTile2& tile) {
  for (const Home& home : joined_)
    for_each_eye(home.eyes, [&](std::size_t k) {
      TriangleId near = home.triangle;
      location.look_around(tile.eye(k), views_[k], near);
    });
}

// Looks from each of the joined homes up to their borders. Beyond, their eyes go together.
void TileViews2::leave_homes(const Triangulation2& triangulation, const EyeTile2& tile) {
  crossed_.clear();
  for (const Home& home : joined_)
    for (const HalfEdgeId exit : half_edges_of(home.triangle)) {
      open(exit);
      add(tile, triangulation.origin(exit), triangulation.target(exit), tile.group(home.eyes));
      while (!openings_.empty()) {
        const auto [half_edge, first] = openings_.back();
        if (std::find(borders_.begin(), borders_.end(), half_edge) == borders_.end()) {
          enter(triangulation, tile, triangulation.twin(half_edge));
          continue;
        }
        for (std::size_t c = first; c < cones_.size(); ++c) crossed_.push_back({half_edge, cones_[c]});
        cones_.resize(first);
        openings_.pop_back();
      }
    }
}

// Looks through the one opening there is, counter-clockwise, up to what the eyes see.
void TileViews2::expand(const Triangulation2& triangulation, const EyeTile2& tile) {
  while (!openings_.empty()) {
    const auto [half_edge, first] = openings_.back();
    const Beyond2 beyond = triangulation.beyond(half_edge);
    if (beyond.is_open()) {
      enter(triangulation, tile, beyond.entry());
      continue;
    }
    for (std::size_t k = first; k < cones_.size(); ++k) see(cones_[k], beyond.side());
    cones_.resize(first);
    openings_.pop_back();
  }
}

// Replaces the last opening by those beyond the triangle that it leads into.
void TileViews2::enter(const Triangulation2& triangulation, const EyeTile2& tile, HalfEdgeId entry) {
  const VertexId apex = triangulation.corner(entry);
  const auto first = cones_.begin() + static_cast<std::ptrdiff_t>(openings_.back().first_cone);
  Set any_left = 0, any_right = 0;  // of the apex
  for (auto cone = first; cone != cones_.end(); ++cone) {
    const Set eyes = cone->group.eyes, not_left = tile.seeing_left_turn(cone->group, cone->right, apex);
    cone->passing_left = eyes & ~not_left;
    cone->divided = not_left == 0 ? 0 : not_left & tile.seeing_left_turn(cone->group, apex, cone->left);
    any_left |= cone->passing_left | cone->divided;
    any_right |= not_left;
  }
  if (any_left == 0 || any_right == 0) {
    openings_.back().half_edge = any_right == 0 ? previous_half_edge(entry) : next_half_edge(entry);
    return;
  }
  entering_.assign(first, cones_.end());
  cones_.erase(first, cones_.end());
  openings_.pop_back();
  const auto add_part = [&](VertexId right, VertexId left, const EyeGroup& group, Set eyes) {
    if (eyes != 0) add(tile, right, left, part(tile, group, eyes));
  };
  open(previous_half_edge(entry));
  for (const auto& [right, left, group, passing_left, divided] : entering_) {
    add_part(right, left, group, passing_left);
    add_part(apex, left, group, divided);
  }
  open(next_half_edge(entry));
  for (const auto& [right, left, group, passing_left, divided] : entering_) {
    add_part(right, left, group, group.eyes & ~passing_left & ~divided);
    add_part(right, apex, group, divided);
  }
}

// Adds a cone to the last opening.
void TileViews2::add(const EyeTile2& tile, VertexId right, VertexId left, const EyeGroup& group) {
  for (std::size_t k = openings_.back().first_cone; k < cones_.size(); ++k)
    if (cones_[k].right == right && cones_[k].left == left) {
      cones_[k].group = tile.group(cones_[k].group.eyes | group.eyes);
      return;
    }
  cones_.push_back({right, left, group, 0, 0});
}

void TileViews2::see(const Cone& cone, PieceSideId behind) {
  const View2::Seen seen{cone.right, behind, kNoPiece, kNoPiece};
  for_each_eye(cone.group.eyes, [&](std::size_t k) { views_[k].seen.push_back(seen); });
}

// Lets each view begin with the corner of its own triangle that an eye alone would begin with.
void TileViews2::begin_at_home(const Triangulation2& triangulation) {
  for (const Home& home : joined_) {
    const VertexId corner = triangulation.origin(half_edge(home.triangle, 0));
    for_each_eye(home.eyes, [&](std::size_t k) {
      auto& seen = views_[k].seen;
      const auto first = std::find_if(seen.begin(), seen.end(), [&](const auto& s) { return s.vertex == corner; });
      std::rotate(seen.begin(), first, seen.end());
    });
  }
}

}  // namespace hottel
