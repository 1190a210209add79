// Scenes for the tests of exchange: short to write, and moved about.
#pragma once

#include <fmt/core.h>

#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "geometry/plane/exchange/closed_forms.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/generate/generators.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/scene/scene.h"

namespace hottel::testing_scenes {

inline constexpr int kBlack = -1;  // no material: a back that claims nothing

struct Line {
  std::string name;
  std::string x0, y0, x1, y1;  // as typed
  int material = 0;            // 0 to 3, all different
  int back = kBlack;
  std::uint32_t elements = 1;
};

inline Rational number(const std::string& text) { return parse_rational(text).value(); }

inline std::vector<Material> four_materials() {
  std::vector<Material> materials;
  for (int m = 0; m < 4; ++m) {
    Rational reflectivity(m, 4);
    reflectivity.canonicalize();
    materials.push_back({"material " + std::to_string(m), Spectrum::scalar(reflectivity), {}});
  }
  return materials;
}

inline void add(Scene2& scene, const Line& line, std::uint32_t group) {
  Surface surface;
  surface.name = line.name;
  surface.material = static_cast<std::uint32_t>(line.material);
  if (line.back != kBlack) surface.back = static_cast<std::uint32_t>(line.back);
  surface.elements = line.elements;
  surface.group = group;
  scene.add(surface, {{number(line.x0), number(line.y0)}, {number(line.x1), number(line.y1)}});
}

// Every line is a group of its own.
inline Scene2 scene_of(const std::vector<Line>& lines) {
  Scene2 scene;
  scene.file = "test.json";
  scene.materials = four_materials();
  for (const Line& line : lines) {
    scene.groups.push_back(line.name);
    add(scene, line, static_cast<std::uint32_t>(scene.groups.size() - 1));
  }
  validate(scene);
  return scene;
}

// A closed room [0, size]^2 with its fronts inside.
inline std::vector<Line> room(const std::string& size) {
  return {{"left", "0", "0", "0", size},
          {"top", "0", size, size, size},
          {"right", size, size, size, "0"},
          {"bottom", size, "0", "0", "0"}};
}

inline std::vector<Line> operator+(std::vector<Line> a, const std::vector<Line>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline Scene2 generated(const std::string& kind, std::uint64_t n, std::uint64_t seed) {
  GeneratorRequest2 request;
  request.kind = kind;
  request.n = n;
  request.seed = seed;
  return generate_2(request);
}

// The scene with a group for each five edges that follow each other.
inline Scene2 in_groups_of_five(Scene2 scene) {
  scene.groups.clear();
  for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
    if (k % 5 == 0) scene.groups.push_back("group " + std::to_string(k));
    scene.surfaces[k].group = static_cast<std::uint32_t>(scene.groups.size() - 1);
  }
  return scene;
}

// Some of each kind, small enough for exact sums of all pairs.
inline std::vector<Scene2> all_kinds(std::uint64_t n) {
  std::vector<Scene2> scenes;
  for (const GeneratorKind2& kind : generator_kinds_2())
    scenes.push_back(generated(kind.name, std::max(n, kind.min_edges), 5 + n));
  return scenes;
}

inline Scene2 moved(Scene2 scene, const std::function<Point2(const Point2&)>& motion) {
  for (Edge2& surface : scene.edges) {
    surface.from = motion(surface.from);
    surface.to = motion(surface.to);
  }
  return scene;
}

// One printed number, down to the last bit, under the names of its faces.
using Printed = std::map<std::pair<std::string, std::string>, std::tuple<double, int, double>>;

inline Printed printed(
    const ExchangeMatrix& matrix,
    const std::function<std::string(const std::string&)>& rename = [](const std::string& name) { return name; }) {
  Printed result;
  const auto name = [&](std::uint32_t i) { return i == matrix.sky() ? "sky" : rename(matrix.elements()[i].name); };
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    for (const FactorEntry& entry : matrix.row(i))
      result[{name(i), name(entry.to)}] = {entry.factor.value, entry.factor.side, entry.visibility};
  }
  return result;
}

inline Printed printed(const Scene2& scene) { return printed(exact_exchange(prepare(scene))); }

// The exact measures of one scene by name of element.
class Exact {
 public:
  explicit Exact(const Scene2& scene, Granularity granularity = Granularity::kFace)
      : prepared_(prepare(scene, granularity == Granularity::kElement ? Divided2::kYes : Divided2::kNo)),
        granularity_(granularity) {
    ExchangeRequest options;
    options.granularity = granularity;
    options.wants_measures = true;
    matrix_ = exact_exchange(prepared_, options, &report_);
  }

  const PreparedScene2& prepared() const { return prepared_; }
  const ExchangeMatrix& matrix() const { return matrix_; }
  const ExchangeReport& report() const { return report_; }

  // S(from, to)
  RootSum measure(const std::string& from, const std::string& to) const {
    const std::uint32_t i = matrix_.find(from).value(), j = matrix_.find(to).value();
    return exact_exchange_measures(prepared_, granularity_, {{std::min(i, j), std::max(i, j)}}).front();
  }
  std::string text(const std::string& from, const std::string& to) const { return measure(from, to).to_string(); }
  Rounded factor(const std::string& from, const std::string& to) const {
    return matrix_.factor(matrix_.find(from).value(), matrix_.find(to).value());
  }
  double value(const std::string& from, const std::string& to) const { return factor(from, to).value; }
  // Vis(from, to); -1 where there is no entry.
  double visibility(const std::string& from, const std::string& to) const {
    for (const FactorEntry& entry : matrix_.row(matrix_.find(from).value()))
      if (entry.to == matrix_.find(to).value()) return entry.visibility;
    return -1;
  }

 private:
  PreparedScene2 prepared_;
  Granularity granularity_;
  ExchangeReport report_;
  ExchangeMatrix matrix_;
};

}  // namespace hottel::testing_scenes
