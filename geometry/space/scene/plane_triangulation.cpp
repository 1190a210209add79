#include "geometry/space/scene/plane_triangulation.h"

#define CGAL_NO_CDT_2_WARNING  // builds with assertions say that crossings cost much: there are few
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <map>
#include <utility>

#include "kernel/kernels.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

using Kernel = RationalKernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<std::uint32_t, Kernel,
                                                           CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_intersections_tag>;

constexpr std::uint32_t kNone = PlaneTriangulation3::kNone;

struct IsBefore {
  bool operator()(const FlatPoint3& a, const FlatPoint3& b) const {
    if (const int order = cmp(a.u, b.u)) return order < 0;
    return a.v < b.v;
  }
};

// Joins triangles to convex polygons, as loops of points by number.
class Joining {
 public:
  Joining(const PlaneTriangulation3& triangulation, const std::vector<char>& is_in)
      : t_(triangulation), polygon_of_(t_.triangles().size(), kNone) {
    for (std::uint32_t k = 0; k < polygon_of_.size(); ++k) {
      if (is_in[k] == 0) continue;
      polygon_of_[k] = static_cast<std::uint32_t>(loops_.size());
      const auto& corners = t_.triangles()[k].corners;
      loops_.emplace_back(corners.begin(), corners.end());
      triangles_.push_back({k});
    }
  }

  std::vector<std::vector<FlatPoint3>> join() {
    for (std::uint32_t k = 0; k < polygon_of_.size(); ++k)
      for (std::size_t side = 0; polygon_of_[k] != kNone && side < 3; ++side) try_across(k, side);
    std::vector<std::vector<FlatPoint3>> result;
    for (const auto& loop : loops_)
      if (!loop.empty()) result.push_back(without_straight_points(points_of(loop)));
    return result;
  }

 private:
  using Loop = std::vector<std::uint32_t>;

  void try_across(std::uint32_t triangle, std::size_t side) {
    const std::uint32_t other = t_.triangles()[triangle].neighbours[side];
    if (other == kNone || polygon_of_[other] == kNone || polygon_of_[other] == polygon_of_[triangle]) return;
    const std::uint32_t one = polygon_of_[triangle], two = polygon_of_[other];
    const auto& corners = t_.triangles()[triangle].corners;
    Loop joined = joined_across(loops_[one], loops_[two], corners[(side + 1) % 3], corners[(side + 2) % 3]);
    if (!is_convex(joined)) return;
    loops_[one] = std::move(joined);
    loops_[two].clear();
    for (const std::uint32_t t : triangles_[two]) polygon_of_[t] = one;
    triangles_[one].insert(triangles_[one].end(), triangles_[two].begin(), triangles_[two].end());
  }

  // The loop around both, of which one goes from p to q and the other one back.
  static Loop joined_across(Loop a, Loop b, std::uint32_t p, std::uint32_t q) {
    std::rotate(a.begin(), std::find(a.begin(), a.end(), q), a.end());
    std::rotate(b.begin(), std::find(b.begin(), b.end(), p), b.end());
    a.insert(a.end(), b.begin() + 1, b.end() - 1);
    // Where they share more than that side, the loop runs there and back.
    for (std::size_t k = 0; a.size() > 2 && k < a.size();) {
      const std::size_t before = (k + a.size() - 1) % a.size(), after = (k + 1) % a.size();
      if (a[before] != a[after]) {
        ++k;
        continue;
      }
      a.erase(a.begin() + static_cast<std::ptrdiff_t>(std::max(k, after)));
      a.erase(a.begin() + static_cast<std::ptrdiff_t>(std::min(k, after)));
      k = k > 1 ? k - 2 : 0;
    }
    return a;
  }

  bool is_convex(const Loop& loop) const {
    for (std::size_t k = 0; k < loop.size(); ++k)
      if (doubled_area(t_.points()[loop[k]], t_.points()[loop[(k + 1) % loop.size()]],
                       t_.points()[loop[(k + 2) % loop.size()]]) < 0)
        return false;
    return true;
  }

  std::vector<FlatPoint3> points_of(const Loop& loop) const {
    std::vector<FlatPoint3> points;
    for (const std::uint32_t p : loop) points.push_back(t_.points()[p]);
    return points;
  }

  const PlaneTriangulation3& t_;
  std::vector<std::uint32_t> polygon_of_;  // by triangle
  std::vector<Loop> loops_;                // by polygon; empty where it was joined to another one
  std::vector<std::vector<std::uint32_t>> triangles_;
};

}  // namespace

PlaneTriangulation3::PlaneTriangulation3(const std::vector<Segment>& segments) {
  std::map<FlatPoint3, std::uint32_t, IsBefore> numbers;
  const auto number_of = [&](const FlatPoint3& point) {
    const auto [place, is_new] = numbers.try_emplace(point, static_cast<std::uint32_t>(points_.size()));
    if (is_new) points_.push_back(point);
    return place->second;
  };
  std::vector<std::array<std::uint32_t, 2>> ends;
  ends.reserve(segments.size());
  for (const Segment& segment : segments) {
    const std::uint32_t a = number_of(segment[0]), b = number_of(segment[1]);
    ends.push_back({a, b});
  }
  given_ = points_.size();

  Delaunay delaunay;
  std::vector<Delaunay::Vertex_handle> vertices;
  for (const FlatPoint3& point : points_) {
    const Delaunay::Face_handle near = vertices.empty() ? Delaunay::Face_handle() : vertices.back()->face();
    vertices.push_back(delaunay.insert({Kernel::FT(point.u), Kernel::FT(point.v)}, near));
    vertices.back()->info() = static_cast<std::uint32_t>(vertices.size());
  }
  for (const auto& [a, b] : ends) delaunay.insert_constraint(vertices[a], vertices[b]);
  // Numbers begin with 1; those of crossings are not set yet.
  for (auto v = delaunay.finite_vertices_begin(); v != delaunay.finite_vertices_end(); ++v) {
    const Rational u(v->point().x()), w(v->point().y());
    v->info() = number_of({u, w});
  }
  std::uint32_t count = 0;
  for (auto f = delaunay.all_faces_begin(); f != delaunay.all_faces_end(); ++f) f->info() = kNone;
  for (auto f = delaunay.finite_faces_begin(); f != delaunay.finite_faces_end(); ++f) f->info() = count++;
  triangles_.reserve(count);
  for (auto f = delaunay.finite_faces_begin(); f != delaunay.finite_faces_end(); ++f) {
    Triangle& triangle = triangles_.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const auto place = static_cast<std::size_t>(k);
      triangle.corners[place] = f->vertex(k)->info();
      triangle.neighbours[place] = f->neighbor(k)->info();
      triangle.is_border[place] = f->is_constrained(k);
    }
  }
}

FlatPoint3 PlaneTriangulation3::centre(std::uint32_t triangle) const {
  const auto& [a, b, c] = triangles_[triangle].corners;
  return {(points_[a].u + points_[b].u + points_[c].u) / 3, (points_[a].v + points_[b].v + points_[c].v) / 3};
}

std::vector<FlatPoint3> PlaneTriangulation3::corners_of(std::uint32_t triangle) const {
  const auto& [a, b, c] = triangles_[triangle].corners;
  return {points_[a], points_[b], points_[c]};
}

Rational PlaneTriangulation3::doubled_area_of(std::uint32_t triangle) const {
  const auto& [a, b, c] = triangles_[triangle].corners;
  return doubled_area(points_[a], points_[b], points_[c]);
}

std::vector<std::vector<FlatPoint3>> convex_pieces(const PlaneTriangulation3& triangulation,
                                                   const std::vector<char>& is_in) {
  return Joining(triangulation, is_in).join();
}

std::vector<std::vector<FlatPoint3>> convex_pieces(const FlatRegion3& region) {
  std::vector<PlaneTriangulation3::Segment> sides;
  region.append_sides(sides);
  const PlaneTriangulation3 triangulation(sides);
  std::vector<char> is_in(triangulation.triangles().size());
  for (std::uint32_t k = 0; k < is_in.size(); ++k) is_in[k] = region.contains(triangulation.centre(k)) ? 1 : 0;
  return convex_pieces(triangulation, is_in);
}

FlatRegion3 region_of(const PlaneTriangulation3& triangulation, const std::vector<char>& is_in) {
  const auto& triangles = triangulation.triangles();
  const auto is_outer = [&](std::uint32_t triangle, std::size_t side) {
    const std::uint32_t beyond = triangles[triangle].neighbours[side];
    return beyond == kNone || is_in[beyond] == 0;
  };
  std::vector<std::array<bool, 3>> is_done(triangles.size());
  std::vector<std::vector<FlatPoint3>> loops;
  for (std::uint32_t first = 0; first < triangles.size(); ++first)
    for (std::size_t first_side = 0; is_in[first] != 0 && first_side < 3; ++first_side) {
      if (!is_outer(first, first_side) || is_done[first][first_side]) continue;
      std::vector<FlatPoint3> loop;
      std::uint32_t triangle = first;
      std::size_t side = first_side;
      do {
        is_done[triangle][side] = true;
        loop.push_back(triangulation.points()[triangles[triangle].corners[(side + 1) % 3]]);
        // Around the end of the side, through the inside, to the next outer one.
        std::size_t next = (side + 1) % 3;
        const std::uint32_t end = triangles[triangle].corners[(side + 2) % 3];
        while (!is_outer(triangle, next)) {
          triangle = triangles[triangle].neighbours[next];
          const auto& corners = triangles[triangle].corners;
          const auto place = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), end) - corners.begin());
          next = (place + 2) % 3;
        }
        side = next;
      } while (triangle != first || side != first_side);
      loops.push_back(without_straight_points(loop));
    }
  return FlatRegion3(std::move(loops));
}

}  // namespace hottel
