#include "tests/storm/space/lattice_scene.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/space/arrangement/coplanar_clusters.h"
#include "tests/comparison/space/map_comparison.h"

namespace hottel::storm {

using oracle::SpacePoint;
using oracle::SpacePolygon;

namespace {

constexpr int kTries = 30;  // of a polygon that fits

SpacePoint operator+(const SpacePoint& a, const SpacePoint& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

class Scenes {
 public:
  explicit Scenes(std::uint64_t number) : random_(number * 1009 + 3) {}

  Polygons3 draw() {
    if (below(4) == 0)
      add_boxes();
    else
      add_triangles();
    if (below(4) == 0) choose_pair();
    if (below(4) == 0) std::swap(polygons_[0], polygons_[1]);
    return std::move(polygons_);
  }

 private:
  long below(long count) { return static_cast<long>(random_() % static_cast<std::uint64_t>(count)); }
  long between(long low, long high) { return low + below(high - low + 1); }
  SpacePoint point(long low, long high) { return {between(low, high), between(low, high), between(low, high)}; }
  const SpacePolygon& any() { return polygons_[static_cast<std::size_t>(below(static_cast<long>(polygons_.size())))]; }

  bool add(SpacePolygon polygon) {
    if (!stays_valid_3(polygons_, polygon)) return false;
    polygons_.push_back(std::move(polygon));
    return true;
  }

  void add_triangles() {
    do {
      polygons_.clear();
      add(first());
      add(second());
    } while (polygons_.size() < 2);
    if (below(6) == 0) add_screen();
    const long count = below(16) == 0 ? between(5, 8) : 1 + (below(8) + 3) / 3;
    for (long k = 0; k < count; ++k)
      for (int tries = 0; tries < kTries; ++tries) {
        SpacePolygon polygon = obstacle();
        if (below(2) == 0) std::reverse(polygon.begin(), polygon.end());
        if (add(std::move(polygon))) break;
      }
  }

  // Triangles or strips of one plane between opposite squares, or across a corner; one of them may be left out.
  void add_screen() {
    const bool is_level = polygons_[1][0].z == polygons_[1][1].z && polygons_[1][1].z == polygons_[1][2].z;
    const long high = is_level ? polygons_[1][0].z.get_num().get_si() : between(1, 6);
    const long left = between(-1, 0), right = between(4, 5);
    const auto at = [&](long across, long along) {  // of the plane z = high / 2, or x + z = high
      return is_level ? SpacePoint{across, along, mpq_class(high) / 2}
                      : SpacePoint{mpq_class(high * across) / 4, along, mpq_class(high * (4 - across)) / 4};
    };
    const long cut = between(1, 3), open = below(3);
    const std::vector<SpacePolygon> strips{{at(left, left), at(cut, left), at(cut, right), at(left, right)},
                                           {at(cut, left), at(right, left), at(right, right), at(cut, right)}};
    const std::vector<SpacePolygon> halves{{at(left, left), at(right, left), at(right, right)},
                                           {at(left, left), at(right, right), at(left, right)}};
    const std::vector<SpacePolygon>& parts = below(2) == 0 ? strips : halves;
    for (long k = 0; k < 2; ++k)
      if (k != open) add(parts[static_cast<std::size_t>(k)]);
  }

  SpacePolygon first() {
    switch (below(8)) {
      case 0:
        return {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
      case 1:
        return {{1, 0, 0}, {3, 0, 0}, {3, 4, 0}, {1, 4, 0}};
      default:
        return {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    }
  }

  // Opposite at a height, shifted.
  static SpacePolygon above(long x, long y, long z) {
    return {{x, y, z}, {x, y + 4, z}, {x + 4, y + 4, z}, {x + 4, y, z}};
  }
  // Adjacent along the y axis or in a plane parallel to it, with its upper side at (x, ., z).
  static SpacePolygon wall(long foot, long y, long bottom, long x, long z) {
    return {{foot, y, bottom}, {foot, y + 4, bottom}, {foot + x, y + 4, bottom + z}, {foot + x, y, bottom + z}};
  }

  SpacePolygon second() {
    switch (below(10)) {
      case 0:
      case 1:
      case 2:
        return above(0, 0, 4);
      case 3:
        return above(between(-2, 2), between(-2, 2), between(1, 4));
      case 4:
      case 5:
        return wall(0, 0, 0, 0, 4);
      case 6:
        return wall(between(-1, 0), between(0, 3), between(0, 1), 0, 4);
      case 7:
        return wall(between(1, 3), between(-1, 1), between(-2, 0), between(-1, 1), 4);
      case 8:
        return wall(0, 0, 0, between(-3, 3), between(1, 4));
      default:
        return {point(0, 4), point(0, 4), point(1, 4)};
    }
  }

  SpacePolygon obstacle() {
    switch (below(13)) {
      case 0:
      case 1:
        return {point(0, 4), point(0, 4), point(0, 4)};
      case 2:
        return hexagon();
      case 3:
      case 4:
        return {point(-1, 5), point(-1, 5), point(-1, 5)};
      case 5:
        return standing();
      case 6:
        return {corner_of(any()), corner_of(any()), point(0, 4)};
      case 7:
        return hinged(any());
      case 8:
        return continued(any());
      case 9:
        return touching(any());
      case 10:
        return in_line_with(any());
      default:
        return parallelogram();
    }
  }

  SpacePoint corner_of(const SpacePolygon& polygon) {
    return polygon[static_cast<std::size_t>(below(static_cast<long>(polygon.size())))];
  }

  SpacePolygon standing() {
    SpacePolygon polygon{point(0, 4), point(0, 4), point(0, 4)};
    polygon[0].z = polygon[1].z = 0;
    return polygon;
  }

  // With a side of another one.
  SpacePolygon hinged(const SpacePolygon& other) {
    const auto k = static_cast<std::size_t>(below(static_cast<long>(other.size())));
    return {other[(k + 1) % other.size()], other[k], point(0, 4)};
  }

  // In the plane of another one, at one of its sides.
  SpacePolygon continued(const SpacePolygon& other) {
    const auto k = static_cast<std::size_t>(below(static_cast<long>(other.size())));
    const SpacePoint &a = other[k], &b = other[(k + 1) % other.size()], &c = other[(k + 2) % other.size()];
    return {b, a, below(2) == 0 ? a + (b - c) : b + (b - c)};
  }

  // With a corner within another one, or half-way along one of its sides.
  SpacePolygon touching(const SpacePolygon& other) {
    const auto k = static_cast<std::size_t>(below(static_cast<long>(other.size())));
    const SpacePoint &a = other[k], &b = other[(k + 1) % other.size()], &c = other[(k + 2) % other.size()];
    const SpacePoint sum = below(2) == 0 ? a + b : a + c;
    return {{sum.x / 2, sum.y / 2, sum.z / 2}, point(0, 4), point(0, 4)};
  }

  // With a side on the line of a side of another one.
  SpacePolygon in_line_with(const SpacePolygon& other) {
    const auto k = static_cast<std::size_t>(below(static_cast<long>(other.size())));
    const SpacePoint &a = other[k], way = other[(k + 1) % other.size()] - a;
    const auto at = [&](const mpq_class& t) { return SpacePoint{a.x + t * way.x, a.y + t * way.y, a.z + t * way.z}; };
    const mpq_class t = mpq_class(between(-2, 3)) / 4;
    return {at(t), at(t + mpq_class(between(1, 4)) / 4), point(0, 4)};
  }

  SpacePolygon hexagon() {
    const SpacePoint a = point(1, 3), u = point(-2, 2), v = point(-2, 2);
    return {a + u, a + u + v, a + v, a - u, a - u - v, a - v};
  }

  SpacePolygon parallelogram() {
    const SpacePoint a = point(0, 4), u = point(-3, 3), v = point(-3, 3);
    return {a, a + u, a + u + v, a + v};
  }

  void add_boxes() {
    do {
      polygons_ = {first(), below(2) == 0 ? above(0, 0, 4) : wall(0, 0, 0, 0, 4)};
      const long count = between(1, 2);
      for (long k = 0; k < count; ++k) add_box(k == 0);
      drop_covered();
    } while (!is_valid_3(polygons_));
  }

  void add_box(bool stands) {
    const SpacePoint low{between(0, 3), between(0, 3), stands && below(3) > 0 ? 0 : between(0, 2)};
    const SpacePoint high = low + SpacePoint{between(1, 2), between(1, 2), between(1, 2)};
    for (SpacePolygon& face : oracle_box(low, high)) polygons_.push_back(std::move(face));
  }

  static std::vector<SpacePolygon> oracle_box(const SpacePoint& l, const SpacePoint& h) {
    return {{{l.x, l.y, l.z}, {l.x, h.y, l.z}, {h.x, h.y, l.z}, {h.x, l.y, l.z}},
            {{l.x, l.y, h.z}, {h.x, l.y, h.z}, {h.x, h.y, h.z}, {l.x, h.y, h.z}},
            {{l.x, l.y, l.z}, {h.x, l.y, l.z}, {h.x, l.y, h.z}, {l.x, l.y, h.z}},
            {{l.x, h.y, l.z}, {l.x, h.y, h.z}, {h.x, h.y, h.z}, {h.x, h.y, l.z}},
            {{l.x, l.y, l.z}, {l.x, l.y, h.z}, {l.x, h.y, h.z}, {l.x, h.y, l.z}},
            {{h.x, l.y, l.z}, {h.x, h.y, l.z}, {h.x, h.y, h.z}, {h.x, l.y, h.z}}};
  }

  // Leaves out faces that lie within another polygon.
  void drop_covered() {
    const auto engine = oracle::engine_polygons(polygons_);
    std::vector<char> is_dropped(polygons_.size(), 0);
    for (std::size_t k = 2; k < polygons_.size(); ++k)
      for (std::size_t other = 0; other < polygons_.size(); ++other)
        if (other != k && !is_dropped[other] && !is_dropped[k] &&
            std::all_of(engine[k].points.begin(), engine[k].points.end(),
                        [&](const Point3& p) { return contains(engine[other], p); }))
          is_dropped[k] = 1;
    Polygons3 left;
    for (std::size_t k = 0; k < polygons_.size(); ++k)
      if (!is_dropped[k]) left.push_back(polygons_[k]);
    polygons_ = std::move(left);
  }

  // Any two of all, with any sides.
  void choose_pair() {
    const auto move_to = [&](std::size_t place) {
      const auto k = place + static_cast<std::size_t>(below(static_cast<long>(polygons_.size() - place)));
      if (k >= 2 && below(2) == 0) std::reverse(polygons_[k].begin(), polygons_[k].end());
      std::swap(polygons_[place], polygons_[k]);
    };
    move_to(0);
    move_to(1);
  }

  std::mt19937_64 random_;
  Polygons3 polygons_;
};

// Makes a scene flat along one axis: narrow gaps, and walls that nearly lie in one plane.
void press(Polygons3& polygons, std::uint64_t chance) {
  const mpz_class by = mpz_class(1) << (1 + chance / 3 % 16);
  for (SpacePolygon& polygon : polygons)
    for (SpacePoint& p : polygon) (chance % 3 == 0 ? p.x : chance % 3 == 1 ? p.y : p.z) /= by;
}

}  // namespace

LatticeScene3 lattice_scene_3(std::uint64_t number) {
  LatticeScene3 scene{number, Scenes(number).draw()};
  if (number % 7 == 6) press(scene.polygons, number);
  if (number % 5 == 4) nudge_3(scene.polygons, number);
  return scene;
}

double nudge_3(Polygons3& polygons, std::uint64_t chance) {
  std::mt19937_64 random(chance);
  const mpq_class size = mpq_class(1) / (mpz_class(1) << (8 + random() % 60));
  const auto step = [&]() -> mpq_class { return size * (static_cast<long>(random() % 3) - 1); };
  Polygons3 nudged = polygons;
  for (std::size_t k = 2; k < nudged.size(); ++k)
    if (nudged[k].size() == 3 && random() % 3 > 0) {
      SpacePoint& p = nudged[k][random() % 3];
      p = {p.x + step(), p.y + step(), p.z + step()};
    }
  if (nudged == polygons || !is_valid_3(nudged)) return 0;
  polygons = std::move(nudged);
  return std::sqrt(3.0) * size.get_d();
}

bool stays_valid_3(const Polygons3& polygons, const SpacePolygon& added) {
  std::vector<Polygon3> of_its_plane = oracle::engine_polygons({added});
  if (!polygon_problem(of_its_plane[0]).text.empty()) return false;
  const PlaneFrame3 frame(of_its_plane[0].points);
  for (Polygon3& other : oracle::engine_polygons(polygons))
    if (const PlaneFrame3 its(other.points); !its.precedes(frame) && !frame.precedes(its))
      of_its_plane.push_back(std::move(other));
  return coplanar_clusters(of_its_plane).size() == of_its_plane.size();
}

bool is_valid_3(const Polygons3& polygons) {
  const std::vector<Polygon3> engine = oracle::engine_polygons(polygons);
  return std::all_of(engine.begin(), engine.end(), [](const Polygon3& p) { return polygon_problem(p).text.empty(); }) &&
         coplanar_clusters(engine).size() == engine.size();
}

}  // namespace hottel::storm
