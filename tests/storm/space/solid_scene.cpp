#include "tests/storm/space/solid_scene.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <utility>

#include "kernel/support/failure.h"

namespace hottel::storm {

namespace {

using Kind = SolidBody3::Kind;
using Outline = std::vector<std::array<long, 2>>;

constexpr std::array<Rational Point3::*, 3> kAxes{&Point3::x, &Point3::y, &Point3::z};

class Bodies {
 public:
  explicit Bodies(std::uint64_t number) : random_(number * 7919 + 5), has_two_materials_(number % 8 == 3) {}

  SolidBodies3 draw() {
    const long around = below(8);
    const bool is_first = below(2) == 0;
    if (is_first) add_around(around);
    const long count = between(1, around < 2 ? 4 : 3);
    for (long k = 0; k < count; ++k) add_any();
    if (!is_first) add_around(around);
    return std::move(bodies_);
  }

 private:
  long below(long count) { return static_cast<long>(random_() % static_cast<std::uint64_t>(count)); }
  long between(long low, long high) { return low + below(high - low + 1); }
  std::uint32_t material() { return has_two_materials_ ? static_cast<std::uint32_t>(below(kSolidMaterials)) : 0; }

  void add_around(long around) {
    switch (around) {
      case 0:
      case 1:
        return;  // open to the sky
      case 2:
        add_box({0, 0, 0}, {2, 4, 4}, true);
        add_box({2, 0, 0}, {4, 4, 4}, true);
        return;
      case 3: {  // a room in a building, or two
        add_box({-1, -1, -1}, {5, 5, below(2) == 0 ? 4 : 5}, false);
        const long wall = between(0, 3);
        add_box({0, 0, 0}, {wall == 0 ? 4 : wall, 4, 4}, true);
        if (wall > 0 && wall < 3) add_box({wall + below(2), 0, 0}, {4, 4, 4}, true);
        return;
      }
      default:
        add_box({0, 0, 0}, {4, 4, 4}, true);
    }
  }

  void add_any() {
    switch (below(14)) {
      case 0:
        return add_tetrahedron();
      case 1:
        return add_prism({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, {}, 3);
      case 2:
        return add_prism({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, {}, 3);
      case 3:
        return add_prism({{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}, 3);
      case 4:
        return add_random_box(0, 4, true);
      case 5:
        return add_random_box(-1, 5, false);
      case 6:
      case 7:
      case 8:
      case 9:
        return add_random_box(0, 4, false);
      default:
        return add_sheet();
    }
  }

  SolidBody3& begin(Kind kind) {
    bodies_.push_back({kind, kind == Kind::kSolid && below(16) == 0, {}});
    return bodies_.back();
  }

  void add_face(SolidBody3& body, std::vector<Point3> points, std::vector<Point3> hole, bool is_turned,
                std::uint32_t m) {
    if (is_turned) std::reverse(points.begin(), points.end());
    std::rotate(points.begin(), points.begin() + below(static_cast<long>(points.size())), points.end());
    Polygon3 polygon{std::move(points), {}};
    if (!hole.empty()) polygon.holes.push_back(std::move(hole));
    body.faces.push_back({std::move(polygon), m, {}});
  }

  void add_box(const std::array<long, 3>& low, const std::array<long, 3>& high, bool is_room) {
    extrude({{low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}}, {}, 2, low[2], high[2],
            is_room);
  }

  void add_random_box(long from, long to, bool is_room) {
    std::array<long, 3> low{}, high{};
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = between(from, to - 1);
      high[a] = between(low[a] + 1, to);
    }
    add_box(low, high, is_room);
  }

  void add_prism(Outline outline, Outline hole, long size) {
    const long x = between(-1, 5 - size), y = between(-1, 5 - size), low = below(4), axis = below(3);
    for (Outline* loop : {&outline, &hole})
      for (auto& [u, v] : *loop) {
        u += x;
        v += y;
      }
    const long high = between(low + 1, 4);
    extrude(outline, hole, static_cast<std::size_t>(axis), low, high, below(12) == 0);
  }

  // The prism over an outline, counter-clockwise, with a shaft, along an axis.
  void extrude(const Outline& outline, const Outline& hole, std::size_t axis, long low, long high, bool is_room) {
    const auto at = [axis](const std::array<long, 2>& p, long height) {
      Point3 point;
      point.*kAxes[axis] = height;
      point.*kAxes[(axis + 1) % 3] = p[0];
      point.*kAxes[(axis + 2) % 3] = p[1];
      return point;
    };
    const auto level = [&](const Outline& loop, long height) {
      std::vector<Point3> points;
      for (const auto& p : loop) points.push_back(at(p, height));
      return points;
    };
    const std::uint32_t m = material();
    SolidBody3& body = begin(is_room ? Kind::kRoom : Kind::kSolid);
    add_face(body, level(outline, high), level(hole, high), is_room, m);
    add_face(body, level(outline, low), level(hole, low), !is_room, m);
    for (const Outline* loop : {&outline, &hole})
      for (std::size_t k = 0; k < loop->size(); ++k) {
        const auto &p = (*loop)[k], &q = (*loop)[(k + 1) % loop->size()];
        add_face(body, {at(p, low), at(q, low), at(q, high), at(p, high)}, {}, is_room != (loop == &hole), m);
      }
    std::rotate(body.faces.begin(), body.faces.begin() + below(static_cast<long>(body.faces.size())), body.faces.end());
  }

  void add_tetrahedron() {
    std::array<Point3, 4> p;
    Rational volume;
    do {
      for (Point3& point : p) {
        const long x = between(0, 4), y = between(0, 4), z = between(0, 4);
        point = {x, y, z};
      }
      volume = dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
    } while (volume == 0);
    if (volume < 0) std::swap(p[2], p[3]);
    const std::uint32_t m = material();
    SolidBody3& body = begin(Kind::kSolid);
    for (const auto& [a, b, c] : std::vector<std::array<std::size_t, 3>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
      add_face(body, {p[a], p[b], p[c]}, {}, false, m);
  }

  void add_sheet() {
    const auto axis = static_cast<std::size_t>(below(3));
    const long height = between(-1, 5), u = between(-1, 3), v = between(-1, 3);
    const auto at = [&](long du, long dv) {
      Point3 point;
      point.*kAxes[axis] = height;
      point.*kAxes[(axis + 1) % 3] = u + du;
      point.*kAxes[(axis + 2) % 3] = v + dv;
      return point;
    };
    std::vector<Point3> points, hole;
    switch (below(5)) {
      case 0:
        points = {at(0, 0), at(3, 0), at(3, 1), at(1, 1), at(1, 3), at(0, 3)};
        break;
      case 1:
        points = {at(0, 0), at(4, 0), at(4, 3), at(0, 3)};
        hole = {at(1, 1), at(between(2, 3), 1), at(2, 2), at(1, 2)};
        if (!(hole[1] == at(2, 1))) hole[2] = at(3, 2);
        break;
      case 2: {
        const long w = between(1, 4), h = between(1, 4);
        points = {at(0, 0), at(w, 0), at(below(2) * w, h)};
        break;
      }
      default: {
        const long w = between(1, 4), h = between(1, 4);
        points = {at(0, 0), at(w, 0), at(w, h), at(0, h)};
      }
    }
    const std::uint32_t m = material();
    const bool is_turned = below(2) == 0, has_back = below(3) == 0;
    SolidBody3& body = begin(Kind::kSheets);
    add_face(body, points, hole, is_turned, m);
    if (has_back) body.faces.back().back = material();
  }

  std::mt19937_64 random_;
  bool has_two_materials_;
  SolidBodies3 bodies_;
};

template <class Visit>
void for_each_point(SolidBodies3& bodies, const Visit& visit) {
  for (SolidBody3& body : bodies)
    for (SolidBody3::Face& face : body.faces) {
      for (Point3& p : face.polygon.points) visit(p);
      for (auto& hole : face.polygon.holes)
        for (Point3& p : hole) visit(p);
    }
}

// Six times the volume that the fronts of a closed mesh look out of.
Rational volume_of(const SolidBody3& body) {
  Rational sum;
  for (const SolidBody3::Face& face : body.faces)
    sum += dot(doubled_area(face.polygon), face.polygon.points[0] - Point3{0, 0, 0});
  return sum;
}

// Points that stand between their neighbours, or on them, left out.
void tidy(std::vector<Point3>& points) {
  for (bool is_done = false; !is_done;) {
    is_done = true;
    for (std::size_t k = 0; k < points.size() && points.size() > 3; ++k) {
      const std::size_t n = points.size();
      const Point3 &a = points[(k + n - 1) % n], &b = points[k], &c = points[(k + 1) % n];
      if (!cross(b - a, c - b).is_zero()) continue;
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(k));
      is_done = false;
      break;
    }
  }
}

std::vector<SolidBodies3> with_fewer(const SolidBodies3& bodies) {
  std::vector<SolidBodies3> result;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    result.push_back(bodies);
    result.back().erase(result.back().begin() + static_cast<std::ptrdiff_t>(b));
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto change = [&](const auto& how) {
      result.push_back(bodies);
      how(result.back()[b]);
      if (result.back() == bodies) result.pop_back();
    };
    change([](SolidBody3& body) { body.is_open = false; });
    change([](SolidBody3& body) {
      if (body.kind == Kind::kSheets) body.faces[0].polygon.holes.clear();
    });
    change([](SolidBody3& body) {
      for (SolidBody3::Face& face : body.faces) face.back.reset();
    });
    change([](SolidBody3& body) {
      for (SolidBody3::Face& face : body.faces) face.material = 0;
    });
  }
  return result;
}

std::vector<SolidBodies3> with_fewer_places(const SolidBodies3& bodies) {
  std::vector<SolidBodies3> result;
  for (const auto axis : kAxes) {
    std::set<Rational> values;
    SolidBodies3 all = bodies;
    for_each_point(all, [&](Point3& p) { values.insert(p.*axis); });
    for (auto value = values.begin(); value != values.end() && std::next(value) != values.end(); ++value)
      for (const bool is_up : {false, true}) {
        SolidBodies3 some = bodies;
        const Rational &from = is_up ? *value : *std::next(value), &to = is_up ? *std::next(value) : *value;
        for_each_point(some, [&](Point3& p) {
          if (p.*axis == from) p.*axis = to;
        });
        for (SolidBody3& body : some) {
          for (SolidBody3::Face& face : body.faces) {
            tidy(face.polygon.points);
            for (auto& hole : face.polygon.holes) tidy(hole);
          }
          std::erase_if(body.faces, [](const SolidBody3::Face& face) { return doubled_area(face.polygon).is_zero(); });
        }
        std::erase_if(some, [](const SolidBody3& body) { return body.faces.empty(); });
        result.push_back(std::move(some));
      }
  }
  return result;
}

}  // namespace

SolidBodies3 solid_bodies_3(std::uint64_t number) { return Bodies(number).draw(); }

Scene3 to_scene_3(const SolidBodies3& bodies) {
  Scene3 scene;
  scene.file = "storm";
  for (std::uint32_t m = 0; m < kSolidMaterials; ++m)
    scene.materials.push_back({fmt::format("m{}", m), Spectrum::scalar(Rational(1, 2 + m)), {}});
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    scene.groups.emplace_back(fmt::format("body {}", b), bodies[b].is_open ? Behind::kOpen : Behind::kByOutline);
    for (std::size_t f = 0; f < bodies[b].faces.size(); ++f) {
      const SolidBody3::Face& face = bodies[b].faces[f];
      Surface surface;
      surface.name = fmt::format("{}.{}", b, f);
      surface.material = face.material;
      surface.back = face.back;
      surface.group = static_cast<std::uint32_t>(b);
      scene.add(std::move(surface), face.polygon);
    }
  }
  return scene;
}

oracle::Places to_places(const SolidBodies3& bodies) {
  std::vector<oracle::PlaceFace> faces;
  std::vector<oracle::PlaceBody> kinds;
  const auto loop = [](const std::vector<Point3>& points) {
    oracle::SpacePolygon result;
    for (const Point3& p : points) result.push_back({p.x, p.y, p.z});
    return result;
  };
  for (const SolidBody3& body : bodies) {
    for (const SolidBody3::Face& face : body.faces) {
      oracle::PlaceFace& place = faces.emplace_back();
      place.loops.push_back(loop(face.polygon.points));
      for (const auto& hole : face.polygon.holes) place.loops.push_back(loop(hole));
      place.front = static_cast<int>(face.material);
      if (face.back) place.back = static_cast<int>(*face.back);
      place.body = kinds.size();
    }
    kinds.push_back(body.is_open || body.kind == Kind::kSheets ? oracle::PlaceBody::kNothing
                    : body.kind == Kind::kSolid                ? oracle::PlaceBody::kSolid
                                                               : oracle::PlaceBody::kRoom);
  }
  return {std::move(faces), std::move(kinds)};
}

bool is_valid_3(const SolidBodies3& bodies) {
  if (bodies.empty()) return false;
  for (const SolidBody3& body : bodies) {
    for (const SolidBody3::Face& face : body.faces)
      if (!polygon_problem(face.polygon).text.empty()) return false;
    if (body.kind == Kind::kSheets) continue;
    if (body.faces.size() < 4 || sgn(volume_of(body)) != (body.kind == Kind::kSolid ? 1 : -1)) return false;
  }
  return true;
}

bool is_boxy_3(const SolidBodies3& bodies) {
  SolidBodies3 all = bodies;
  bool is_whole = true;
  for_each_point(all, [&](Point3& p) {
    for (const auto axis : kAxes) is_whole = is_whole && (p.*axis).get_den() == 1;
  });
  const auto is_level = [](const std::vector<Point3>& points) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Vector3 way = points[(k + 1) % points.size()] - points[k];
      if ((way.x != 0) + (way.y != 0) + (way.z != 0) != 1) return false;
    }
    return true;
  };
  return is_whole && std::all_of(all.begin(), all.end(), [&](const SolidBody3& body) {
           return std::all_of(body.faces.begin(), body.faces.end(), [&](const SolidBody3::Face& face) {
             return is_level(face.polygon.points) &&
                    std::all_of(face.polygon.holes.begin(), face.polygon.holes.end(), is_level);
           });
         });
}

SolidBodies3 shrunk_3(SolidBodies3 bodies, const std::function<bool(const SolidBodies3&)>& fails) {
  const auto shrink_by = [&](const std::vector<SolidBodies3>& candidates) {
    for (const SolidBodies3& some : candidates)
      if (is_valid_3(some) && fails(some)) {
        bodies = some;
        return true;
      }
    return false;
  };
  while (shrink_by(with_fewer(bodies)) || shrink_by(with_fewer_places(bodies))) {
  }
  return bodies;
}

}  // namespace hottel::storm
