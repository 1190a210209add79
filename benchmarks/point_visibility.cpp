// What it costs to ask what a point sees: ours, and CGAL's triangular expansion with an exact and an inexact kernel.
//
// The maps of the first two variants are a square of 1000 with 100 holes, each a star of ten corners: 1004 vertices.
// Coordinates are doubles: `short` (multiples of 1/1024) and `double` (all 53 bits in use). `town` is a square
// kilometre with 1600 buildings, whose corners are given in whole centimetres, as a map of a land register gives them:
// some 8000 vertices, and long views between the buildings. 1000 points are drawn at random outside the holes (`town`:
// 200). The counter is microseconds per query.
//
// With HOTTEL_MAP=FILE in the environment one more map, `file`, is the scene of that file, its polylines taken as
// rings, the first one around the others, with 200 points outside the holes: docs/maps.md has `tools/coastline`.
//
//   view              ours: point location and the exact combinatorial view (which vertices, which edge between them)
//   view-and-corners  the same, and the corners of the region in doubles, as an inexact code delivers them
//   rounded           ours: the region with all its corners as correctly rounded doubles (VisibilityPolygons2); `exact`
//                     counts the corners a query that took rational arithmetic
//   polygon           ours: location, and the region with all its corners and its area as exact rationals
//   cgal-epeck        the region as an arrangement over exact numbers; their exact values are computed when asked for
//   cgal-epeck-exact  the same, with the exact value of every corner and the area, as `polygon` delivers them
//   cgal-epick        the same over doubles; `failed` counts queries that end in an exception
//
// CGAL is handed the face of the point, so point location costs it nothing. `vertices` is the mean number of vertices
// in the answer. Before the timing, the areas of the first 100 regions of `polygon` and `cgal-epeck` must be equal.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // g++ 12 suspects the inexact kernel's cached lines, falsely
#endif
#ifndef CGAL_NDEBUG
#define CGAL_NDEBUG 1  // CGAL without its internal checks, as one would run it for speed
#endif
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangular_expansion_visibility_2.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <stdexcept>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/visibility_polygon.h"
#include "geometry/plane/visibility/visibility_polygons.h"
#include "io/scene/scene_json.h"

namespace hottel::benchmarks {
namespace {

struct Spot {
  double x, y;
};
using Ring = std::vector<Spot>;

struct Map {
  std::vector<Ring> rings;  // the square, then the holes
  std::vector<Spot> queries;
};

bool contains(const Ring& ring, const Spot& p) {
  bool inside = false;
  for (std::size_t k = 0, before = ring.size() - 1; k < ring.size(); before = k++) {
    const Spot &a = ring[before], &b = ring[k];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

enum class Variant { kShort, kDouble, kTown, kFile };
constexpr const char* kVariantNames[] = {"short", "double", "town", "file"};

// `town`: on a place of 25 m by 25 m each a building of four to six corners, turned a little, or none.
Map make_town() {
  std::mt19937_64 engine(1);
  const auto uniform = [&engine](double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  Map map{{{{0, 0}, {100000, 0}, {100000, 100000}, {0, 100000}}}, {}};
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 40; ++column) {
      const double x = 2500 * column + uniform(1100, 1400), y = 2500 * row + uniform(1100, 1400);
      const double half_width = uniform(150, 350), half_depth = uniform(150, 350), turn = uniform(-0.4, 0.4);
      Ring outline{{half_width, half_depth}, {-half_width, half_depth}, {-half_width, -half_depth}};
      if (engine() % 2 == 0) {
        outline.push_back({half_width / 3, -half_depth});
        outline.push_back({half_width / 3, -half_depth / 4});
        outline.push_back({half_width, -half_depth / 4});
      } else {
        outline.push_back({half_width, -half_depth});
      }
      for (Spot& p : outline)
        p = {std::round(x + p.x * std::cos(turn) - p.y * std::sin(turn)),
             std::round(y + p.x * std::sin(turn) + p.y * std::cos(turn))};
      map.rings.push_back(std::move(outline));
    }
  while (map.queries.size() < 200) {
    const Spot p{std::round(uniform(100, 99900)), std::round(uniform(100, 99900))};
    if (std::none_of(map.rings.begin() + 1, map.rings.end(), [&](const Ring& hole) { return contains(hole, p); }))
      map.queries.push_back(p);
  }
  return map;
}

// The rings of a scene file, and points between them.
Map read_map(const std::string& file) {
  const Scene2 scene = read_scene_2(file);
  Map map;
  map.rings.resize(scene.groups.size());
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
    map.rings[scene.surfaces[s].group].push_back({to_double(scene.edges[s].from.x), to_double(scene.edges[s].from.y)});
  if (map.rings.empty()) throw std::runtime_error(file + " has no rings");
  const auto [left, right] = std::minmax_element(map.rings[0].begin(), map.rings[0].end(),
                                                 [](const Spot& p, const Spot& q) { return p.x < q.x; });
  const auto [low, high] = std::minmax_element(map.rings[0].begin(), map.rings[0].end(),
                                               [](const Spot& p, const Spot& q) { return p.y < q.y; });
  std::mt19937_64 engine(1);
  const auto whole = [&engine](double from, double to) {
    return std::floor(from + 1 + (to - from - 2) * static_cast<double>(engine() >> 11) * 0x1p-53);
  };
  while (map.queries.size() < 200) {
    const double x = whole(left->x, right->x), y = whole(low->y, high->y);
    const Spot p{x + 0.5, y + 0.5};
    if (std::none_of(map.rings.begin() + 1, map.rings.end(), [&](const Ring& hole) { return contains(hole, p); }))
      map.queries.push_back(p);
  }
  return map;
}

Map make_map(Variant variant) {
  if (variant == Variant::kFile) return read_map(std::getenv("HOTTEL_MAP"));
  if (variant == Variant::kTown) return make_town();
  const bool is_short = variant == Variant::kShort;
  std::mt19937_64 engine(1);
  const auto uniform = [&engine](double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  const auto spot = [is_short](double x, double y) {
    return is_short ? Spot{std::floor(x * 1024) / 1024, std::floor(y * 1024) / 1024} : Spot{x, y};
  };
  Map map{{{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}}, {}};
  for (int row = 0; row < 10; ++row)
    for (int column = 0; column < 10; ++column) {
      const double x = 100 * column + uniform(30, 70), y = 100 * row + uniform(30, 70), turn = uniform(0, 6.28);
      Ring star;
      for (int k = 0; k < 10; ++k) {
        const double radius = k % 2 == 0 ? uniform(22, 30) : uniform(9, 15), angle = turn + k * 0.62831853;
        star.push_back(spot(x + radius * std::cos(angle), y + radius * std::sin(angle)));
      }
      map.rings.push_back(std::move(star));
    }
  while (map.queries.size() < 1000) {
    const Spot p = spot(uniform(1, 999), uniform(1, 999));
    if (std::none_of(map.rings.begin() + 1, map.rings.end(), [&](const Ring& hole) { return contains(hole, p); }))
      map.queries.push_back(p);
  }
  return map;
}

// Ours: the map as a scene.
struct Ours {
  explicit Ours(const Map& map)
      : prepared(prepare(scene_of(map))),
        location(prepared.arrangement.vertices(), prepared.arrangement.triangulation()) {}

  static Scene2 scene_of(const Map& map) {
    Scene2 scene;
    scene.materials.push_back({"black", {}, {}});
    for (const Ring& ring : map.rings) {
      const auto group = static_cast<std::uint32_t>(scene.groups.size());
      scene.groups.emplace_back("ring" + std::to_string(group), Behind::kOpen);  // walls: nothing is solid
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Spot &a = ring[k], &b = ring[(k + 1) % ring.size()];
        Surface surface;
        surface.name = scene.groups.back().name + "[" + std::to_string(k) + "]";
        surface.group = group;
        scene.add(std::move(surface), {{Rational(a.x), Rational(a.y)}, {Rational(b.x), Rational(b.y)}});
      }
    }
    return scene;
  }

  // The query in integer form: part of every query's time.
  Eye2 eye(const Spot& p) const {
    const Vertices2& vertices = prepared.arrangement.vertices();
    return {vertices, vertices.from_scene({Rational(p.x), Rational(p.y)})};
  }

  PreparedScene2 prepared;
  PointLocation2 location;
};

// Corners of the region in doubles, in the units of Vertices2::approximate().
void round_corners(const Arrangement2& arrangement, const Eye2& eye, const View2& view, std::vector<Spot>& corners) {
  const Vertices2& vertices = arrangement.vertices();
  corners.clear();
  const std::size_t m = view.seen.size();
  for (std::size_t k = 0; k < m; ++k) {
    if (view.seen[k].behind == kSky) continue;
    const Segment2& piece = arrangement.piece(view.seen[k].behind);
    const auto &a = vertices.approximate(piece.a), &b = vertices.approximate(piece.b);
    for (const VertexId v : {view.seen[k].vertex, view.seen[k + 1 == m ? 0 : k + 1].vertex}) {
      const auto& p = vertices.approximate(v);
      if (v == piece.a || v == piece.b) {
        corners.push_back({p.x, p.y});
        continue;
      }
      const double dx = p.x - eye.x(), dy = p.y - eye.y(), ux = b.x - a.x, uy = b.y - a.y;
      const double t = ((a.x - eye.x()) * uy - (a.y - eye.y()) * ux) / (dx * uy - dy * ux);
      corners.push_back({eye.x() + t * dx, eye.y() + t * dy});
    }
  }
}

template <class Kernel>
struct Theirs {
  using Traits = CGAL::Arr_segment_traits_2<Kernel>;
  using Arrangement = CGAL::Arrangement_2<Traits>;
  using Visibility = CGAL::Triangular_expansion_visibility_2<Arrangement, CGAL::Tag_true>;
  using Point = typename Kernel::Point_2;

  explicit Theirs(const Map& map) {
    std::vector<typename Traits::X_monotone_curve_2> curves;
    for (const Ring& ring : map.rings)
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Spot &a = ring[k], &b = ring[(k + 1) % ring.size()];
        curves.emplace_back(Point(a.x, a.y), Point(b.x, b.y));
      }
    CGAL::insert_non_intersecting_curves(arrangement, curves.begin(), curves.end());
    for (auto f = arrangement.faces_begin(); f != arrangement.faces_end(); ++f)
      if (!f->is_unbounded() && f->holes_begin() != f->holes_end()) face = f;
    visibility.attach(arrangement);
  }

  Arrangement region(const Spot& p) const {
    Arrangement result;
    visibility.compute_visibility(Point(p.x, p.y), face, result);
    return result;
  }

  Arrangement arrangement;
  typename Arrangement::Face_const_handle face;
  Visibility visibility;
};

using Exact = Theirs<CGAL::Exact_predicates_exact_constructions_kernel>;
using Inexact = Theirs<CGAL::Exact_predicates_inexact_constructions_kernel>;

Rational exact_area(const Exact::Arrangement& region) {
  Rational twice = 0;
  for (auto f = region.faces_begin(); f != region.faces_end(); ++f) {
    if (f->is_unbounded()) continue;
    std::vector<Point2> corners;
    auto e = f->outer_ccb();
    const auto first = e;
    do corners.push_back({CGAL::exact(e->source()->point().x()), CGAL::exact(e->source()->point().y())});
    while (++e != first);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Point2 &p = corners[k], &q = corners[(k + 1) % corners.size()];
      twice += p.x * q.y - p.y * q.x;
    }
  }
  return twice / 2;
}

// Runs ask(query) for all queries in each iteration; ask returns the number of vertices of the answer.
template <class Ask>
void run(benchmark::State& state, const Map& map, const Ask& ask) {
  double vertices = 0, failed = 0;
  for (auto _ : state) {
    vertices = failed = 0;
    for (const Spot& query : map.queries) {
      try {
        vertices += static_cast<double>(ask(query));
      } catch (const std::exception&) {
        ++failed;
      }
    }
  }
  const auto queries = static_cast<double>(map.queries.size());
  state.counters["us_per_query"] =
      benchmark::Counter(1e-6 * queries, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["vertices"] = vertices / (queries - failed);
  state.counters["failed"] = failed;
  state.counters["exact"] = 0;
}

void view(benchmark::State& state, const Map& map) {
  const Ours ours(map);
  View2 seen;
  run(state, map, [&](const Spot& query) {
    ours.location.look_around(ours.eye(query), seen);
    return seen.seen.size();
  });
}

void view_and_corners(benchmark::State& state, const Map& map) {
  const Ours ours(map);
  View2 seen;
  std::vector<Spot> corners;
  run(state, map, [&](const Spot& query) {
    const Eye2 eye = ours.eye(query);
    ours.location.look_around(eye, seen);
    round_corners(ours.prepared.arrangement, eye, seen, corners);
    benchmark::DoNotOptimize(corners.data());
    return corners.size();
  });
}

void rounded(benchmark::State& state, const Map& map) {
  const Ours ours(map);
  const VisibilityPolygons2 polygons(ours.prepared.arrangement);
  RoundedPolygon2 region;
  RoundingCounts2 counts;
  run(state, map, [&](const Spot& query) {
    polygons.look({Rational(query.x), Rational(query.y)}, false, region, counts);
    return region.corners.size();
  });
  state.counters["exact"] =
      static_cast<double>(counts.exact) / static_cast<double>(map.queries.size() * state.iterations());
}

void polygon(benchmark::State& state, const Map& map) {
  const Ours ours(map);
  const Exact theirs(map);
  for (std::size_t k = 0; k < 100; ++k) {
    const Spot& q = map.queries[k];
    const auto ours_area =
        visibility_polygon(ours.prepared.arrangement, ours.location, {Rational(q.x), Rational(q.y)}).area;
    if (!ours_area || *ours_area != exact_area(theirs.region(q))) {
      state.SkipWithError("the areas differ");
      return;
    }
  }
  run(state, map, [&](const Spot& query) {
    return visibility_polygon(ours.prepared.arrangement, ours.location, {Rational(query.x), Rational(query.y)})
        .corners()
        .size();
  });
}

template <class Code>
void theirs(benchmark::State& state, const Map& map) {
  const Code code(map);
  run(state, map, [&](const Spot& query) { return code.region(query).number_of_vertices(); });
}

void theirs_exact(benchmark::State& state, const Map& map) {
  const Exact code(map);
  run(state, map, [&](const Spot& query) {
    const Exact::Arrangement region = code.region(query);
    benchmark::DoNotOptimize(exact_area(region));
    return region.number_of_vertices();
  });
}

void add(const std::string& name, Variant variant, void (*measure)(benchmark::State&, const Map&)) {
  const std::string full = "point_visibility/" + name + "/" + kVariantNames[static_cast<int>(variant)];
  benchmark::RegisterBenchmark(full.c_str(), [=](benchmark::State& state) {
    measure(state, make_map(variant));
  })->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  std::vector<Variant> variants{Variant::kShort, Variant::kDouble, Variant::kTown};
  if (std::getenv("HOTTEL_MAP")) variants.push_back(Variant::kFile);
  for (const Variant variant : variants) {
    add("view", variant, view);
    add("view-and-corners", variant, view_and_corners);
    add("rounded", variant, rounded);
    add("polygon", variant, polygon);
    add("cgal-epeck", variant, theirs<Exact>);
    add("cgal-epeck-exact", variant, theirs_exact);
    add("cgal-epick", variant, theirs<Inexact>);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
