#include "tests/storm/space/hiding_scene.h"

#include <algorithm>
#include <array>
#include <random>
#include <utility>

namespace hottel::storm {

using oracle::SpacePoint;
using oracle::SpacePolygon;

namespace {

constexpr std::size_t kMostPolygons = 40, kMostOfTown = 110;

SpacePoint operator+(const SpacePoint& a, const SpacePoint& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
SpacePoint times(const mpq_class& s, const SpacePoint& a) { return {s * a.x, s * a.y, s * a.z}; }
SpacePoint between(const SpacePoint& a, const SpacePoint& b, const mpq_class& t) { return a + times(t, b - a); }

SpacePoint middle_of(const std::vector<SpacePoint>& points) {
  SpacePoint sum;
  for (const SpacePoint& p : points) sum = sum + p;
  return times(mpq_class(1, static_cast<unsigned long>(points.size())), sum);
}

// A convex body: faces, counter-clockwise seen from outside.
struct Body {
  std::vector<SpacePolygon> faces;
  std::array<long, 3> low{}, high{};  // of the box that it was put in

  std::vector<SpacePoint> corners() const {
    std::vector<SpacePoint> all;
    for (const SpacePolygon& face : faces) all.insert(all.end(), face.begin(), face.end());
    return all;
  }
};

template <class Move>
void move_all(std::vector<SpacePolygon>& polygons, const Move& move) {
  for (SpacePolygon& polygon : polygons)
    for (SpacePoint& p : polygon) p = move(p);
}

class Scenes {
 public:
  explicit Scenes(std::uint64_t number) : random_(number * 2003 + 5), is_town_(number % 16 == 15) {}

  Polygons3 draw() {
    do {
      polygons_.clear();
      bodies_.clear();
      const bool has_ground = below(3) > 0;
      if (has_ground) add(rectangle(2, 0, {-1, -1}, {is_town_ ? 9 : 5, is_town_ ? 9 : 5}));
      if (below(8) == 0) add(rectangle(static_cast<std::size_t>(below(2)), -1, {-1, 0}, {5, 5}));
      const long count = is_town_ ? from_to(12, 25) : below(4) == 0 ? from_to(4, 7) : from_to(2, 3);
      for (long k = 0; k < count; ++k) add_body(has_ground);
      const long sheets = below(3);
      for (long k = 0; k < sheets; ++k)
        for (int tries = 0; tries < 10 && !add(sheet()); ++tries) {
        }
    } while (polygons_.size() < 3);
    if (below(6) == 0) turn_all();
    std::swap(polygons_[0], polygons_[static_cast<std::size_t>(below(static_cast<long>(polygons_.size())))]);
    std::swap(polygons_[1], polygons_[1 + static_cast<std::size_t>(below(static_cast<long>(polygons_.size()) - 1))]);
    return std::move(polygons_);
  }

 private:
  long below(long count) { return static_cast<long>(random_() % static_cast<std::uint64_t>(count)); }
  long from_to(long low, long high) { return low + below(high - low + 1); }
  template <class List>
  auto& any(List& list) {
    return list[static_cast<std::size_t>(below(static_cast<long>(list.size())))];
  }

  bool add(SpacePolygon polygon) {
    if (polygons_.size() >= (is_town_ ? kMostOfTown : kMostPolygons)) return false;
    if (below(3) == 0) std::reverse(polygon.begin(), polygon.end());
    if (!stays_valid_3(polygons_, polygon)) return false;
    polygons_.push_back(std::move(polygon));
    return true;
  }

  static SpacePoint at(std::size_t axis, const mpq_class& height, const mpq_class& u, const mpq_class& v) {
    return axis == 0 ? SpacePoint{height, u, v} : axis == 1 ? SpacePoint{v, height, u} : SpacePoint{u, v, height};
  }
  static SpacePolygon rectangle(std::size_t axis, long height, const std::array<long, 2>& low,
                                const std::array<long, 2>& high) {
    return {at(axis, height, low[0], low[1]), at(axis, height, high[0], low[1]), at(axis, height, high[0], high[1]),
            at(axis, height, low[0], high[1])};
  }

  // Where a body is put: anywhere, at one that is there, on it, or in it.
  void place(bool has_ground, Body& body) {
    const bool stands = has_ground && below(4) > 0;
    for (std::size_t a = 0; a < 3; ++a) {
      body.low[a] = from_to(0, is_town_ ? 7 : 3);
      body.high[a] = body.low[a] + from_to(1, 2);
    }
    if (is_town_) body.low[2] = 0;
    if (!bodies_.empty() && below(2) == 0) {
      const Body& other = any(bodies_);
      const auto axis = static_cast<std::size_t>(below(3));
      switch (below(6)) {
        case 0:
        case 1:  // beside it, or on it
          for (std::size_t a = 0; a < 3; ++a) {
            const long size = below(2) == 0 ? other.high[a] - other.low[a] : from_to(1, 2);
            body.low[a] = a == axis ? other.high[a] : other.low[a] + below(2) * below(2);
            body.high[a] = body.low[a] + size;
          }
          break;
        case 2:  // at an edge
          for (std::size_t a = 0; a < 3; ++a) {
            body.low[a] = a == axis ? other.low[a] : other.high[a];
            body.high[a] = a == axis ? other.high[a] : body.low[a] + from_to(1, 2);
          }
          break;
        case 3:  // at a corner
          for (std::size_t a = 0; a < 3; ++a) {
            body.low[a] = other.high[a];
            body.high[a] = body.low[a] + from_to(1, 2);
          }
          break;
        default:
          body.low[2] = other.high[2];
          body.high[2] = body.low[2] + from_to(1, 2);
      }
      if (stands && body.low[2] != other.high[2]) body.low[2] = 0;
    } else if (stands) {
      body.low[2] = 0;
    }
  }

  // Over or below an outline in the plane of two axes.
  static Body prism(const SpacePolygon& bottom, const SpacePoint& way) {
    Body body;
    SpacePolygon top;
    for (const SpacePoint& p : bottom) top.push_back(p + way);
    for (std::size_t k = 0; k < bottom.size(); ++k) {
      const std::size_t next = (k + 1) % bottom.size();
      body.faces.push_back({bottom[k], bottom[next], top[next], top[k]});
    }
    body.faces.push_back({bottom.rbegin(), bottom.rend()});
    body.faces.push_back(std::move(top));
    return body;
  }
  static Body pyramid(const SpacePolygon& bottom, const SpacePoint& apex) {
    Body body;
    for (std::size_t k = 0; k < bottom.size(); ++k)
      body.faces.push_back({bottom[k], bottom[(k + 1) % bottom.size()], apex});
    body.faces.push_back({bottom.rbegin(), bottom.rend()});
    return body;
  }

  // Some of twelve points of a circle.
  SpacePolygon round() {
    const std::array<std::array<long, 2>, 12> all{
        {{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-4, 3}, {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}}};
    SpacePolygon outline;
    const long most = from_to(5, 8);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const long left = static_cast<long>(all.size() - k), wanted = most - static_cast<long>(outline.size());
      if (below(left) < wanted) outline.push_back({mpq_class(all[k][0]) / 5, mpq_class(all[k][1]) / 5, 0});
    }
    return outline;
  }

  Body shape(const Body& box) {
    const auto axis = static_cast<std::size_t>(below(5) < 3 ? 2 : below(2));
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const std::array<long, 3>&l = box.low, &h = box.high;
    const SpacePolygon bottom = rectangle(axis, l[axis], {l[u], l[v]}, {h[u], h[v]});
    const SpacePoint way = at(axis, h[axis] - l[axis], 0, 0);
    switch (below(10)) {
      case 0: {
        SpacePolygon triangle = bottom;
        triangle.erase(triangle.begin() + below(4));
        return prism(triangle, way);
      }
      case 1:
        return pyramid(bottom, below(2) == 0 ? middle_of(bottom) + way : any(bottom) + way);
      case 2: {
        SpacePolygon triangle = bottom;
        triangle.erase(triangle.begin() + below(4));
        return pyramid(triangle, any(bottom) + way);
      }
      case 3: {
        SpacePolygon outline = round();
        const SpacePoint middle = middle_of(bottom);
        for (SpacePoint& p : outline)
          p = middle + at(axis, 0, p.x * mpq_class(h[u] - l[u]) / 2, p.y * mpq_class(h[v] - l[v]) / 2);
        return below(3) > 0 ? prism(outline, way) : pyramid(outline, middle + way);
      }
      case 4:  // leaning
        return prism(bottom, way + at(axis, 0, from_to(-1, 1), from_to(-1, 1)));
      default:
        return prism(bottom, way);
    }
  }

  void turn(Body& body) {
    static const std::array<std::array<long, 3>, 3> kTurns{{{3, 4, 5}, {5, 12, 13}, {8, 15, 17}}};
    const auto& [a, b, c] = any(kTurns);
    const mpq_class cosine = mpq_class(a) / c, sine = mpq_class(b) / c;
    const SpacePoint middle = middle_of(body.corners());
    const auto axis = static_cast<std::size_t>(below(3) > 0 ? 2 : below(2));
    move_all(body.faces, [&](const SpacePoint& p) {
      const SpacePoint d = p - middle;
      const mpq_class u = axis == 0 ? d.y : axis == 1 ? d.z : d.x, v = axis == 0 ? d.z : axis == 1 ? d.x : d.y;
      const mpq_class h = axis == 0 ? d.x : axis == 1 ? d.y : d.z;
      return middle + at(axis, h, cosine * u - sine * v, sine * u + cosine * v);
    });
  }

  void turn_all() {
    static const std::array<std::array<long, 2>, 3> kTangents{{{1, 2}, {2, 3}, {1, 7}}};
    const auto [p, q] = any(kTangents);
    const auto [r, s] = any(kTangents);
    const mpq_class t = mpq_class(p) / q, w = mpq_class(r) / s;
    const mpq_class a = (1 - t * t) / (1 + t * t), b = 2 * t / (1 + t * t);
    const mpq_class c = (1 - w * w) / (1 + w * w), d = 2 * w / (1 + w * w);
    move_all(polygons_, [&](const SpacePoint& from) {
      const SpacePoint to{a * from.x - b * from.y, b * from.x + a * from.y, from.z};
      return SpacePoint{to.x, c * to.y - d * to.z, d * to.y + c * to.z};
    });
  }

  void nudge(Body& body) {
    const mpq_class size = mpq_class(1) / (mpz_class(1) << (8 + random_() % 53));
    const SpacePoint step = times(size, {from_to(-1, 1), from_to(-1, 1), from_to(-1, 1)});
    move_all(body.faces, [&](const SpacePoint& p) { return p + step; });
  }

  // Cut in two, through corners or middles of sides; one of both may be turned over.
  void split(std::vector<SpacePolygon>& faces, std::size_t k) {
    const SpacePolygon face = faces[k];
    const std::size_t n = face.size();
    if (n < 4) return;
    if (n == 4 && below(2) == 0) {
      const SpacePoint a = between(face[0], face[1], mpq_class(1) / 2), b = between(face[3], face[2], mpq_class(1) / 2);
      faces[k] = {face[0], a, b, face[3]};
      faces.push_back({a, face[1], face[2], b});
    } else {
      faces[k] = {face[0], face[1], face[2]};
      faces.emplace_back(face.begin() + 2, face.end());
      faces.back().push_back(face[0]);
    }
    if (below(2) == 0) std::reverse(faces[k].begin(), faces[k].end());
  }

  void make_hole(std::vector<SpacePolygon>& faces, std::size_t k) {
    const SpacePolygon face = faces[k];
    const SpacePoint middle = middle_of(face);
    const mpq_class t = mpq_class(from_to(1, 3)) / 4;
    faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(k));
    for (std::size_t c = 0; c < face.size(); ++c) {
      const SpacePoint &a = face[c], &b = face[(c + 1) % face.size()];
      faces.push_back({a, b, between(b, middle, t), between(a, middle, t)});
    }
  }

  // A corner of a body is moved a little, or by a tenth, inward or outward: what is no longer plane is a triangle there
  // and the rest, or triangles.
  void dent(std::vector<SpacePolygon>& faces) {
    const SpacePoint corner = any(any(faces));
    const mpq_class size = below(3) == 0 ? mpq_class(1, 10) : mpq_class(1, 1'000'000);
    const SpacePoint moved = corner + times(size, {from_to(-1, 1), from_to(-1, 1), from_to(-1, 1)});
    std::vector<SpacePolygon> result;
    for (const SpacePolygon& face : faces) {
      const auto place = std::find(face.begin(), face.end(), corner);
      if (place == face.end()) {
        result.push_back(face);
        continue;
      }
      SpacePolygon turned(place, face.end());
      turned.insert(turned.end(), face.begin(), place);
      const std::size_t n = turned.size();
      turned[0] = moved;
      if (n == 3) {
        result.push_back(std::move(turned));
      } else if (below(2) == 0) {
        result.push_back({turned[n - 1], moved, turned[1]});
        result.emplace_back(turned.begin() + 1, turned.end());
      } else {
        for (std::size_t k = 1; k + 1 < n; ++k) result.push_back({moved, turned[k], turned[k + 1]});
      }
    }
    faces = std::move(result);
  }

  void add_body(bool has_ground) {
    Body box;
    place(has_ground, box);
    Body body = shape(box);
    body.low = box.low;
    body.high = box.high;
    if (below(5) == 0) turn(body);
    if (below(8) == 0) nudge(body);
    bodies_.push_back(body);
    std::vector<SpacePolygon> faces = body.faces;
    const auto drop = [&] { faces.erase(faces.begin() + below(static_cast<long>(faces.size()))); };
    const auto last_is_dropped = [&] { faces.erase(faces.end() - 1 - below(2)); };
    switch (below(12)) {
      case 0:
      case 1:
        last_is_dropped();
        break;
      case 2:
      case 3:
        drop();
        break;
      case 4:
        drop();
        drop();
        break;
      case 5:
        split(faces, static_cast<std::size_t>(below(static_cast<long>(faces.size()))));
        break;
      case 6:
        make_hole(faces, static_cast<std::size_t>(below(static_cast<long>(faces.size()))));
        break;
      case 7:
        drop();
        split(faces, static_cast<std::size_t>(below(static_cast<long>(faces.size()))));
        break;
      case 8:
      case 9:
        for (long dents = from_to(1, 3); dents > 0; --dents) dent(faces);
        if (below(4) == 0) drop();
        break;
      default:
        break;
    }
    for (SpacePolygon& face : faces) add(std::move(face));
  }

  SpacePolygon sheet() {
    const Body& body = any(bodies_);
    const std::vector<SpacePoint> corners = body.corners();
    const SpacePoint middle = middle_of(corners);
    const SpacePolygon& face = any(body.faces);
    const SpacePoint &a = face[0], &b = face[1], &c = face[2];
    const SpacePoint of_face = middle_of(face);
    switch (below(9)) {
      case 0:  // on a face, within it
        return {between(of_face, a, mpq_class(1) / 2), between(of_face, b, mpq_class(1) / 2),
                between(of_face, c, mpq_class(1) / 2)};
      case 1:  // in its plane, beside it
        return {a, b, b + (b - c)};
      case 2:  // stands on it
        return {between(of_face, a, mpq_class(1) / 2), between(of_face, b, mpq_class(1) / 2),
                of_face + (of_face - middle)};
      case 3:  // pierces it
        return {between(middle, of_face, mpq_class(1) / 2), a + (a - middle), b + (b - middle)};
      case 4:  // in the body
        return {between(middle, any(corners), mpq_class(1) / 2), between(middle, any(corners), mpq_class(1) / 2),
                between(middle, any(corners), mpq_class(1) / 3)};
      case 5:  // through it, from corner to corner
        return {any(corners), any(corners), any(corners)};
      case 6:  // before it, parallel
        return {between(a, middle, -1), between(b, middle, -1), between(c, middle, -1)};
      default: {
        const auto axis = static_cast<std::size_t>(below(3));
        const long u = from_to(-1, 3), v = from_to(-1, 3);
        SpacePolygon polygon = rectangle(axis, from_to(-1, 4), {u, v}, {u + from_to(1, 3), v + from_to(1, 3)});
        if (below(3) == 0) polygon.erase(polygon.begin() + below(4));
        return polygon;
      }
    }
  }

  std::mt19937_64 random_;
  bool is_town_;
  Polygons3 polygons_;
  std::vector<Body> bodies_;
};

}  // namespace

Polygons3 hiding_scene_3(std::uint64_t number) {
  Polygons3 polygons = Scenes(number).draw();
  if (number % 7 != 6) return polygons;
  const mpz_class by = mpz_class(1) << (1 + number / 21 % 16);
  for (SpacePolygon& polygon : polygons)
    for (SpacePoint& p : polygon) (number / 7 % 3 == 0 ? p.x : number / 7 % 3 == 1 ? p.y : p.z) /= by;
  return polygons;
}

}  // namespace hottel::storm
