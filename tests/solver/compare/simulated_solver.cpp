#include "tests/solver/compare/simulated_solver.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace hottel {
namespace {

Place operator+(const Place& a, const Place& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Place operator-(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Place operator*(double s, const Place& a) { return {s * a[0], s * a[1], s * a[2]}; }
double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Place cross(const Place& a, const Place& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double norm(const Place& a) { return std::sqrt(dot(a, a)); }

double rounded(double value) { return std::round(value * 1000) / 1000; }
Place rounded(const Place& p) { return {rounded(p[0]), rounded(p[1]), rounded(p[2])}; }

}  // namespace

void SimulatedScene::add(std::vector<Place> corners) {
  for (Place& corner : corners) corner = rounded(corner);
  SimulatedFace face{corners, {}, {}, 0};
  if (dimension_ == 2) {
    const Place along = corners[1] - corners[0];
    face.area = norm(along);
    face.normal = {along[1] / face.area, -along[0] / face.area, 0};
    face.centre = 0.5 * (corners[0] + corners[1]);
  } else {
    Place twice{};
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      const Place part = cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
      face.centre = face.centre + norm(part) / 3 * (corners[0] + corners[k] + corners[k + 1]);
      twice = twice + part;
    }
    const double length = norm(twice);
    face.centre = 1 / length * face.centre;
    face.normal = 1 / length * twice;
    face.area = length / 2;
  }
  faces_.push_back(std::move(face));
}

void SimulatedScene::add_wall(const Place& origin, const Place& u, const Place& v, int nu, int nv) {
  for (int i = 0; i < nu; ++i) {
    if (dimension_ == 2) {
      add({origin + (1.0 * i / nu) * u, origin + (1.0 * (i + 1) / nu) * u});
      continue;
    }
    for (int j = 0; j < nv; ++j) {
      const auto at = [&](int a, int b) { return rounded(origin + (1.0 * a / nu) * u + (1.0 * b / nv) * v); };
      add({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

// In the plane edges run counter-clockwise, so that their fronts, on the right, look outward.
void SimulatedScene::add_body(const std::vector<Place>& outline, double low, double high) {
  const auto at = [](const Place& p, double z) { return rounded(Place{p[0], p[1], z}); };
  std::vector<Place> top, bottom;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Place &a = outline[k], &b = outline[(k + 1) % outline.size()];
    if (dimension_ == 2) {
      add({at(a, 0), at(b, 0)});
      continue;
    }
    add({at(a, low), at(b, low), at(b, high), at(a, high)});
    top.push_back(at(a, high));
    bottom.insert(bottom.begin(), at(a, low));
  }
  if (dimension_ == 3) add(top);
  if (dimension_ == 3) add(bottom);
}

SimulatedScene::SimulatedScene(int dimension, std::uint64_t seed) : dimension_(dimension) {
  std::mt19937_64 random(seed * 7919 + static_cast<std::uint64_t>(dimension));
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  const double w = uniform(4, 7), d = uniform(3, 5), h = uniform(2, 3.5);
  const bool is_open = uniform(0, 1) < 0.3;
  if (dimension == 2) {
    // Clockwise: fronts look inward.
    const std::array<Place, 4> room{Place{0, 0, 0}, Place{0, d, 0}, Place{w, d, 0}, Place{w, 0, 0}};
    for (std::size_t k = is_open ? 3 : 0; k < 4; ++k)
      add_wall(room[k], room[(k + 1) % 4] - room[k], {}, static_cast<int>(uniform(3, 7)), 1);
  } else {
    const Place x{w, 0, 0}, y{0, d, 0}, z{0, 0, h};
    const int n = static_cast<int>(uniform(2, 4)), m = static_cast<int>(uniform(2, 4));
    add_wall({}, x, y, n, m);
    if (!is_open) {
      add_wall(z, y, x, m, n);
      add_wall({}, z, x, 1, n);
      add_wall(y, x, z, n, 1);
      add_wall({}, y, z, m, 1);
      add_wall(x, z, y, 1, m);
    }
  }
  // Bodies in cells of their own.
  const int bodies = dimension == 2 ? 4 : 3;
  for (int k = 0; k < bodies; ++k) {
    const double cell = w / bodies, cx = (k + 0.5) * cell, cy = d * uniform(0.35, 0.65);
    const double radius = std::min(cell, d) * uniform(0.25, 0.4), turn = uniform(0, 1.5);
    const int corners = dimension == 2 ? static_cast<int>(uniform(3, 6)) : 4;
    std::vector<Place> outline;
    for (int c = 0; c < corners; ++c) {
      const double angle = turn + 2 * std::numbers::pi * c / corners;
      outline.push_back(rounded(Place{cx + radius * std::cos(angle), cy + radius * std::sin(angle), 0}));
    }
    if (corners == 4) outline[3] = outline[0] + outline[2] - outline[1];  // a parallelogram
    const double low = rounded(h * uniform(0.1, 0.3));
    add_body(outline, low, rounded(h * uniform(0.45, 0.8)));
  }
}

std::string SimulatedScene::json() const {
  std::string text =
      fmt::format(R"({{"hottel": 1, "dimension": {}, "materials": {{"white": {{"reflectivity": 0.5}}}}, "{}": [)",
                  dimension_, dimension_ == 2 ? "edges" : "polygons");
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const auto corner = [&](std::size_t k) {
      const Place& p = faces_[i].corners[k];
      return dimension_ == 2 ? fmt::format("[{}, {}]", p[0], p[1]) : fmt::format("[{}, {}, {}]", p[0], p[1], p[2]);
    };
    std::string points;
    for (std::size_t k = 0; k < faces_[i].corners.size(); ++k) points += (k == 0 ? "" : ", ") + corner(k);
    text += (i == 0 ? "" : ", ") + fmt::format(R"({{"name": "f{}", "points": [{}], "material": "white"}})", i, points);
  }
  return text + "]}";
}

double SimulatedScene::kernel(const Place& x, const Place& x_normal, const Place& y, const Place& y_normal) const {
  const Place d = y - x;
  const double r = norm(d), from = dot(x_normal, d), to = -dot(y_normal, d);
  if (!(from > 1e-12 && to > 1e-12)) return 0;
  const double cosines = from / r * (to / r);
  return dimension_ == 2 ? cosines / (2 * r) : cosines / (std::numbers::pi * r * r);
}

// From x along `way`, as a multiple of it; infinity where the face is not met.
double SimulatedScene::distance_along(const Place& x, const Place& way, std::size_t face) const {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const SimulatedFace& f = faces_[face];
  const double slope = dot(f.normal, way);
  if (slope == 0) return kNever;
  const double t = dot(f.normal, f.corners[0] - x) / slope;
  if (!(t > 1e-9)) return kNever;
  const Place at = x + t * way;
  if (dimension_ == 2) {
    const Place along = f.corners[1] - f.corners[0];
    const double s = dot(at - f.corners[0], along) / dot(along, along);
    return s >= 0 && s <= 1 ? t : kNever;
  }
  for (std::size_t k = 0; k < f.corners.size(); ++k) {
    const Place& a = f.corners[k];
    if (dot(cross(f.corners[(k + 1) % f.corners.size()] - a, at - a), f.normal) < 0) return kNever;
  }
  return t;
}

bool SimulatedScene::see_each_other(const Place& x, const Place& y, std::size_t i, std::size_t j) const {
  for (std::size_t k = 0; k < faces_.size(); ++k)
    if (k != i && k != j && distance_along(x, y - x, k) < 1 - 1e-9) return false;
  return true;
}

std::size_t SimulatedScene::first_hit(const Place& x, const Place& way, std::size_t i) const {
  std::size_t met = size();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < faces_.size(); ++k) {
    const double t = k == i ? least : distance_along(x, way, k);
    if (t < least) {
      least = t;
      met = k;
    }
  }
  return met;
}

std::vector<WeightedPlace> points_of(const SimulatedScene& scene, std::size_t face, PointsOf kind) {
  const SimulatedFace& f = scene.face(face);
  if (kind == PointsOf::kCenter) return {{f.centre, 1}};
  std::vector<WeightedPlace> points;
  if (kind == PointsOf::kCorners) {
    for (const Place& corner : f.corners) points.push_back({corner, 1.0 / static_cast<double>(f.corners.size())});
    return points;
  }
  const std::vector<std::pair<double, double>> rule =
      kind == PointsOf::kGauss2
          ? std::vector<std::pair<double, double>>{{0.5 - 0.5 / std::sqrt(3), 0.5}, {0.5 + 0.5 / std::sqrt(3), 0.5}}
          : std::vector<std::pair<double, double>>{
                {0.5 - 0.5 * std::sqrt(0.6), 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + 0.5 * std::sqrt(0.6), 5.0 / 18}};
  if (scene.dimension() == 2) {
    for (const auto& [t, weight] : rule) points.push_back({f.corners[0] + t * (f.corners[1] - f.corners[0]), weight});
    return points;
  }
  // Parallelograms as they are, others by triangles at the first corner, with (s, t) -> s (1 - t) a + s t b.
  if (f.corners.size() == 4) {
    for (const auto& [s, v] : rule)
      for (const auto& [t, w] : rule)
        points.push_back({(1 - s) * (1 - t) * f.corners[0] + s * (1 - t) * f.corners[1] + s * t * f.corners[2] +
                              (1 - s) * t * f.corners[3],
                          v * w});
    return points;
  }
  for (std::size_t k = 1; k + 1 < f.corners.size(); ++k) {
    const Place a = f.corners[k] - f.corners[0], b = f.corners[k + 1] - f.corners[0];
    const double share = norm(cross(a, b)) / 2 / f.area;
    for (const auto& [s, v] : rule)
      for (const auto& [t, w] : rule)
        points.push_back({f.corners[0] + s * ((1 - t) * a + t * b), share * 2 * s * v * w});
  }
  return points;
}

double mean_factor(const SimulatedScene& scene, std::size_t i, std::size_t j, PointsOf kind) {
  double mean = 0;
  for (const WeightedPlace& x : points_of(scene, i, kind))
    for (const WeightedPlace& y : points_of(scene, j, kind))
      mean += x.weight * y.weight * scene.kernel(x.at, scene.face(i).normal, y.at, scene.face(j).normal);
  return scene.face(j).area * mean;
}

double disk_factor(const SimulatedScene& scene, std::size_t i, std::size_t j) {
  const SimulatedFace &a = scene.face(i), &b = scene.face(j);
  const double per_area = scene.kernel(a.centre, a.normal, b.centre, b.normal);
  const Place d = b.centre - a.centre;
  const double square = std::numbers::pi * dot(d, d);
  return b.area * per_area * square / (square + b.area);
}

Numbers counted(const SimulatedScene& scene, const CountedRays& rays) {
  const std::size_t n = scene.size();
  Numbers numbers(n, std::vector<double>(n + 1, 0));
  std::mt19937_64 random(rays.seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const int side = rays.is_stratified ? static_cast<int>(std::sqrt(rays.count)) : 1;
  const int count = rays.is_stratified ? side * side : rays.count;
  for (std::size_t i = 0; i < n; ++i) {
    const SimulatedFace& f = scene.face(i);
    const Place u = 1 / norm(f.corners[1] - f.corners[0]) * (f.corners[1] - f.corners[0]), v = cross(f.normal, u);
    for (int k = 0; k < count; ++k) {
      const auto stratum = [&](int which) {
        return rays.is_stratified ? (which + uniform(random)) / side : uniform(random);
      };
      const double a = stratum(k % side), b = stratum(k / side), c = uniform(random), e = uniform(random);
      Place from = f.corners[0], way;
      if (scene.dimension() == 2) {
        from = from + a * (f.corners[1] - f.corners[0]);
        const double sine = rays.is_uniform ? std::sin(std::numbers::pi * (b - 0.5)) : 2 * b - 1;
        way = sine * u + std::sqrt(1 - sine * sine) * f.normal;
      } else {
        // A triangle by area, then a place on it.
        double share = c;
        std::size_t t = 1;
        for (; t + 2 < f.corners.size(); ++t) {
          const double part = norm(cross(f.corners[t] - f.corners[0], f.corners[t + 1] - f.corners[0])) / 2 / f.area;
          if (share < part) break;
          share -= part;
        }
        const double root = std::sqrt(uniform(random));
        from = from + root * (1 - e) * (f.corners[t] - f.corners[0]) + root * e * (f.corners[t + 1] - f.corners[0]);
        const double cosine = rays.is_uniform ? 1 - a : std::sqrt(1 - a), sine = std::sqrt(1 - cosine * cosine);
        way = cosine * f.normal + sine * std::cos(2 * std::numbers::pi * b) * u +
              sine * std::sin(2 * std::numbers::pi * b) * v;
      }
      numbers[i][scene.first_hit(from, way, i)] += 1.0 / count;
    }
  }
  return numbers;
}

}  // namespace hottel
