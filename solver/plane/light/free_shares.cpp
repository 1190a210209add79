#include "solver/plane/light/free_shares.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "geometry/plane/visibility/point_location.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "solver/plane/light/cell_views.h"
#include "solver/plane/light/cells_near.h"

namespace hottel {
namespace {

constexpr double kLargest = 0x1p200;  // of coordinates in cells; what is farther away may come near any cell
constexpr double kUnknown = -1;       // a share

Rational rational(std::uint32_t n) { return Rational(Integer(static_cast<unsigned long>(n))); }

// The part of a convex polygon on the left of a -> b, or on it.
std::vector<Point2> left_part(const std::vector<Point2>& polygon, const Point2& a, const Point2& b) {
  const Rational dx = b.x - a.x, dy = b.y - a.y;
  std::vector<Rational> heights;
  for (const Point2& p : polygon) heights.push_back(dx * (p.y - a.y) - dy * (p.x - a.x));
  if (std::all_of(heights.begin(), heights.end(), [](const Rational& height) { return height >= 0; })) return polygon;
  std::vector<Point2> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::size_t next = k + 1 == polygon.size() ? 0 : k + 1;
    const Point2 &p = polygon[k], &q = polygon[next];
    if (heights[k] >= 0) kept.push_back(p);
    if (sgn(heights[k]) * sgn(heights[next]) >= 0) continue;
    const Rational t = heights[k] / (heights[k] - heights[next]);
    kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
  }
  return kept;
}

Rational doubled_area(const std::vector<Point2>& polygon) {
  Rational sum = 0;
  for (std::size_t k = 2; k < polygon.size(); ++k)
    sum += (polygon[k - 1].x - polygon[0].x) * (polygon[k].y - polygon[0].y) -
           (polygon[k].x - polygon[0].x) * (polygon[k - 1].y - polygon[0].y);
  return sum;
}

class FreeShares {
 public:
  FreeShares(const Arrangement2& arrangement, const FreeParts2& parts, const Grid2& grid, const CellFrame2& frame)
      : arrangement_(arrangement),
        triangulation_(arrangement.triangulation()),
        parts_(parts),
        grid_(grid),
        frame_(frame),
        width_((grid.max.x - grid.min.x) / rational(grid.nx)),
        height_((grid.max.y - grid.min.y) / rational(grid.ny) / width_),
        shares_(std::size_t{grid.nx} * grid.ny, kUnknown) {
    const Vertices2& vertices = arrangement.vertices();
    for (const VertexId v : vertices.ids()) {
      const Point2 p = vertices.to_scene(vertices.exact(v));
      exact_.push_back({(p.x - grid.min.x) / width_, (p.y - grid.min.y) / width_});
    }
  }

  std::vector<double> find() {
    find_cells_at_borders();
    find_triangles_in_them();
    parallel_for(at_border_.size(), [&](std::size_t k) {
      throw_if_interrupted();
      shares_[at_border_[k]] = measured(at_border_[k], triangles_[k]);
    });
    fill_up();
    return std::move(shares_);
  }

 private:
  template <class Visit>
  void for_each_cell_of(const std::array<VertexId, 3>& corners, const Visit& visit) const {
    const Vector2 places[3] = {rounded(frame_.vertex(corners[0])), rounded(frame_.vertex(corners[1])),
                               rounded(frame_.vertex(corners[2]))};
    double far = frame_.extent();
    for (const VertexId v : corners) far += size_of(frame_.vertex(v));
    if (far < kLargest) {
      for_each_cell_near(places, 0x1p-40 * far, frame_, 0, frame_.ny(), visit);
      return;
    }
    for (std::uint32_t iy = 0; iy < frame_.ny(); ++iy)
      for (std::uint32_t ix = 0; ix < frame_.nx(); ++ix) visit(ix, iy);
  }

  void find_cells_at_borders() {
    std::vector<char> is_near(shares_.size(), 0);
    for (const HalfEdgeId h : triangulation_.half_edges()) {
      if (parts_.has(h) == parts_.has_beyond(triangulation_, h)) continue;
      const VertexId a = triangulation_.origin(h), b = triangulation_.target(h);
      for_each_cell_of({a, b, b},
                       [&](std::uint32_t ix, std::uint32_t iy) { is_near[std::size_t{iy} * grid_.nx + ix] = 1; });
    }
    place_.assign(shares_.size(), 0);
    for (std::size_t cell = 0; cell < is_near.size(); ++cell) {
      if (is_near[cell] == 0) continue;
      at_border_.push_back(cell);
      place_[cell] = static_cast<std::uint32_t>(at_border_.size());
    }
  }

  void find_triangles_in_them() {
    triangles_.resize(at_border_.size());
    for (const TriangleId t : triangulation_.triangles()) {
      if (parts_.has(t) == parts_.has_outside()) continue;
      for_each_cell_of(corners(t), [&](std::uint32_t ix, std::uint32_t iy) {
        const std::uint32_t place = place_[std::size_t{iy} * grid_.nx + ix];
        if (place != 0) triangles_[place - 1].push_back(t);
      });
    }
  }

  std::array<VertexId, 3> corners(TriangleId t) const {
    return {triangulation_.corner(half_edge(t, 0)), triangulation_.corner(half_edge(t, 1)),
            triangulation_.corner(half_edge(t, 2))};
  }

  double measured(std::size_t cell, const std::vector<TriangleId>& triangles) const {
    const Rational left(Integer(static_cast<unsigned long>(cell % grid_.nx))),
        bottom = height_ * Rational(Integer(static_cast<unsigned long>(cell / grid_.nx)));
    const Rational right = left + 1, top = bottom + height_;
    const std::vector<Point2> whole{{left, bottom}, {right, bottom}, {right, top}, {left, top}};
    Rational counted = 0;
    for (const TriangleId t : triangles) {
      const std::array<VertexId, 3> of_triangle = corners(t);
      const Point2 &a = exact_[of_triangle[0].index()], &b = exact_[of_triangle[1].index()],
                   &c = exact_[of_triangle[2].index()];
      counted += doubled_area(left_part(left_part(left_part(whole, a, b), b, c), c, a));
    }
    const Rational free = parts_.has_outside() ? Rational(2 * height_ - counted) : counted;
    if (free == 0) return 0;
    return std::max(to_double(free / (2 * height_)), std::numeric_limits<double>::min());
  }

  // Neighbours that no border comes near are alike: one look serves them all.
  void fill_up() {
    const Vertices2& vertices = arrangement_.vertices();
    const PointLocation2 location(vertices, triangulation_);
    parallel_for(grid_.ny, [&](std::size_t iy) {
      throw_if_interrupted();
      const std::span<double> row = std::span(shares_).subspan(iy * grid_.nx, grid_.nx);
      for (std::uint32_t ix = 0; ix < grid_.nx; ++ix) {
        if (row[ix] != kUnknown) continue;
        const bool is_like_the_last = ix > 0 && place_[iy * grid_.nx + ix - 1] == 0;
        const auto centre = [&] { return cell_centre(grid_, ix, static_cast<std::uint32_t>(iy)); };
        row[ix] = is_like_the_last                                                          ? row[ix - 1]
                  : is_free(location.locate(Eye2(vertices, vertices.from_scene(centre())))) ? 1
                                                                                            : 0;
      }
    });
  }

  bool is_free(const Location2& at) const {
    HalfEdgeId h = at.half_edge;
    if (at.kind == Location2::Kind::kOutside) return parts_.has_outside();
    if (at.kind == Location2::Kind::kOnVertex) h = triangulation_.star(at.vertex).front().opposite;
    return h.is_none() ? parts_.has_outside() : parts_.has(h);
  }

  const Arrangement2& arrangement_;
  const Triangulation2& triangulation_;
  const FreeParts2& parts_;
  const Grid2& grid_;
  const CellFrame2& frame_;
  const Rational width_, height_;  // of a cell: in the scene; in its own width
  std::vector<Point2> exact_;      // vertices, in cells from the first corner of the grid
  std::vector<double> shares_;
  std::vector<std::size_t> at_border_;              // cells that a border may come near
  std::vector<std::uint32_t> place_;                // by cell: 1 + where it is in at_border_, else 0
  std::vector<std::vector<TriangleId>> triangles_;  // by place: those unlike the outside that may reach into it
};

}  // namespace

std::vector<double> free_shares(const Arrangement2& arrangement, const FreeParts2& parts, const Grid2& grid,
                                const CellFrame2& frame) {
  if (parts.has_all()) return {};
  return FreeShares(arrangement, parts, grid, frame).find();
}

}  // namespace hottel
