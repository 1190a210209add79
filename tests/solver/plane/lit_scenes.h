// Scenes with a radiosity for each element, ready to be lit.
#pragma once

#include <gtest/gtest.h>

#include <random>

#include "geometry/plane/visibility/visibility_polygon.h"
#include "solver/plane/light/face_radiosity.h"
#include "solver/plane/light/illumination_grid.h"

namespace hottel {

inline void add_edge(Scene2& scene, Point2 from, Point2 to, bool has_back = false) {
  if (scene.materials.empty()) scene.materials.push_back({"white", {}, {}});
  Surface surface;
  surface.name = "edge" + std::to_string(scene.surfaces.size());
  if (has_back) surface.back = 0;
  surface.group = static_cast<std::uint32_t>(scene.groups.size());
  scene.groups.push_back(surface.name);
  scene.add(std::move(surface), {std::move(from), std::move(to)});
}

inline void add_polygon(Scene2& scene, const std::vector<Point2>& corners) {
  for (std::size_t k = 0; k < corners.size(); ++k) add_edge(scene, corners[k], corners[(k + 1) % corners.size()]);
}

// Clockwise: fronts inside.
inline Scene2 square_room() {
  Scene2 scene;
  add_polygon(scene, {{0, 0}, {0, 1}, {1, 1}, {1, 0}});
  return scene;
}

// The square room with a square pillar in its middle.
inline Scene2 pillar_room() {
  Scene2 scene = square_room();
  add_polygon(scene, {{Rational(2, 5), Rational(2, 5)},
                      {Rational(3, 5), Rational(2, 5)},
                      {Rational(3, 5), Rational(3, 5)},
                      {Rational(2, 5), Rational(3, 5)}});
  return scene;
}

inline Scene2 random_lattice_scene(unsigned seed, int edges) {
  std::mt19937 random(seed);
  Scene2 scene;
  for (int k = 0; k < edges; ++k) {
    const auto draw = [&] { return Rational(static_cast<int>(random() % 9)); };
    Point2 a{draw(), draw()}, b{draw(), draw()};
    if (!(a == b)) add_edge(scene, a, b, random() % 2 == 0);
  }
  return scene;
}

// A scene, ready, with a radiosity for each element and the sky.
struct Lit {
  explicit Lit(Scene2 scene, std::uint32_t channel_count = 1, double fixed = -1)
      : prepared(prepare(std::move(scene), Divided2::kYes)),
        table(prepared.scene, prepared.arrangement, prepared.division, Granularity::kElement),
        location(prepared.arrangement.vertices(), prepared.arrangement.triangulation()) {
    std::mt19937 random(1);
    const auto draw = [&] { return fixed >= 0 ? fixed : static_cast<double>(random() % 1000) / 100; };
    for (std::size_t k = 0; k < std::size_t{table.count()} * channel_count; ++k) by_element.push_back(draw());
    for (std::uint32_t c = 0; c < channel_count; ++c) sky.push_back(draw());
  }

  FaceRadiosity2 faces() const { return {prepared.arrangement, table, by_element, sky}; }
  SentOut2 sent_out() const { return {table, by_element, sky}; }
  IlluminationGrid2 grid(const Grid2& cells) const { return illuminate_points(prepared, cells, table, sent_out()); }
  double radiosity(PieceSideId side, std::uint32_t channel = 0) const { return faces().of(side)[channel]; }
  double at(const Rational& x, const Rational& y) const {
    return grid({{x - 1, y - 1}, {x + 1, y + 1}, 1, 1}).values[0];
  }
  // The slow way: the exact visibility polygon, its angles as balls.
  double reference(const Point2& eye, std::uint32_t channel = 0) const {
    const FaceRadiosity2 radiosities = faces();
    const VisibilityPolygon2 polygon = visibility_polygon(prepared.arrangement, location, eye);
    double sum = 0;
    for (std::size_t part = 0; part < polygon.parts.size(); ++part) {
      const Enclosure fraction = angle_fraction(polygon, part, 128).nearest_of_ends();
      EXPECT_EQ(fraction.lower, fraction.upper);
      sum += fraction.lower * radiosities.of(polygon.parts[part].side)[channel];
    }
    return sum;
  }

  PreparedScene2 prepared;
  ElementTable2 table;
  PointLocation2 location;
  std::vector<double> by_element, sky;
};

}  // namespace hottel
