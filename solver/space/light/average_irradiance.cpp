#include "solver/space/light/average_irradiance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "solver/radiosity/direct_light.h"
#include "solver/space/light/scene_light_shares.h"

namespace hottel {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// The cell as a polygon that looks along u x v.
Polygon3 cell_polygon(const Grid3& grid, std::size_t cell) {
  const Rational i(static_cast<unsigned long>(cell % grid.nu)), j(static_cast<unsigned long>(cell / grid.nu));
  const Rational nu(grid.nu), nv(grid.nv);
  const Rational s = i / nu, t = j / nv, s_end = (i + 1) / nu, t_end = (j + 1) / nv;
  Polygon3 polygon;
  polygon.points = {place_in(grid, s, t), place_in(grid, s_end, t), place_in(grid, s_end, t_end),
                    place_in(grid, s, t_end)};
  return polygon;
}

// A name that no surface or group begins with.
std::string free_prefix(const Scene3& scene) {
  std::string prefix = "cell_";
  const auto is_taken = [&](const auto& named) { return named.name.starts_with(prefix); };
  while (std::ranges::any_of(scene.surfaces, is_taken) || std::ranges::any_of(scene.groups, is_taken)) prefix += "_";
  return prefix;
}

// A scene with the cells of a grid before its surfaces. All materials are one that is black: where a cell lies on a
// face the first of both has the place, and no claim differs from another.
struct SceneOfCells3 {
  Scene3 scene;
  std::string prefix;
  std::size_t cells;

  SceneOfCells3(const Scene3& original, const Grid3& grid)
      : scene(original), prefix(free_prefix(original)), cells(grid.cells()) {
    scene.closed = false;
    scene.materials = {Material{.name = "black", .reflectivity = {}, .emission = {}}};
    for (Surface& surface : scene.surfaces) {
      surface.material = 0;
      if (surface.back) surface.back = 0;
    }
    for (Mask3& mask : scene.masks) {
      mask.surface += static_cast<std::uint32_t>(cells);
      mask.base += static_cast<std::uint32_t>(cells);
    }
    add_cells(grid);
  }

 private:
  void add_cells(const Grid3& grid) {
    std::vector<Surface> surfaces;
    std::vector<Polygon3> polygons;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      Surface surface;
      surface.name = prefix + std::to_string(cell);
      surface.group = static_cast<std::uint32_t>(scene.groups.size());
      scene.groups.emplace_back(surface.name);
      surfaces.push_back(std::move(surface));
      polygons.push_back(cell_polygon(grid, cell));
    }
    scene.surfaces.insert(scene.surfaces.begin(), surfaces.begin(), surfaces.end());
    scene.polygons.insert(scene.polygons.begin(), polygons.begin(), polygons.end());
  }
};

// What a column of the matrix of cells sends out: an element of the scene by its number there, or nothing of others.
std::vector<std::optional<std::uint32_t>> senders(const ExchangeMatrix& matrix, const std::vector<Element>& elements) {
  std::unordered_map<std::string, std::uint32_t> by_name;
  for (std::uint32_t i = 0; i < elements.size(); ++i)
    if (elements[i].material) by_name.emplace(elements[i].name, i);
  std::vector<std::optional<std::uint32_t>> result;
  for (const Element& element : matrix.elements()) {
    const auto found = by_name.find(element.name);
    result.push_back(found == by_name.end() ? std::nullopt : std::optional(found->second));
  }
  return result;
}

// A sum of terms that are not negative, and bounds of it.
struct BoundedSum {
  double value = 0, lower = 0, upper = 0;
  int terms = 0;

  void add(double factor, const Enclosure& within, double of) {
    value += factor * of;
    lower += within.lower * of;
    upper += within.upper * of;
    ++terms;
  }
  void add(const RationalEnclosure& number) {
    const double low = to_double(number.lower), high = to_double(number.upper);
    value += low + (high - low) / 2;
    lower += low;
    upper += high;
    ++terms;
  }
  // What the value may be off: each product and sum is rounded once.
  double error() const {
    const double rounding = (terms + 2) * std::numeric_limits<double>::epsilon();
    return std::max({upper * (1 + rounding) - value, value - lower * (1 - rounding), 0.0});
  }
};

// The rows of cells, and what is sent to them.
class GatheringCells3 {
 public:
  GatheringCells3(const PreparedScene3& original, const std::shared_ptr<const PreparedScene3>& prepared,
                  const RadiositySolution& solution, const ExchangeRequest& asked)
      : original_(original),
        solution_(solution),
        matrix_(exact_exchange(*prepared, asked)),
        senders_(senders(matrix_, original.elements(asked.granularity)->elements())) {
    const Scene3& scene = prepared->scene;
    if (scene.lights.empty()) return;
    add_lights(matrix_, scene.lights, LitElements3(prepared, asked.granularity).shares(scene), sources_);
  }

  const ExchangeMatrix& matrix() const { return matrix_; }

  // Writes what an element gathers, and returns what it may be off; nothing where there is nothing to be seen.
  std::optional<double> gather(std::uint32_t label, std::span<double> light) const {
    if (!matrix_.has_row(label)) return std::nullopt;
    if (original_.scene.closed && !sees_a_face(label)) return std::nullopt;
    double error = 0;
    for (std::size_t c = 0; c < light.size(); ++c) {
      const BoundedSum sum = sum_of(label, c);
      light[c] = sum.value;
      error = std::max(error, sum.error());
    }
    return error;
  }

 private:
  bool sees_a_face(std::uint32_t label) const {
    return std::ranges::any_of(matrix_.row(label).columns(),
                               [&](std::uint32_t to) { return to != matrix_.sky() && senders_[to]; });
  }

  BoundedSum sum_of(std::uint32_t label, std::size_t channel) const {
    BoundedSum sum;
    const FactorRow row = matrix_.row(label);
    for (std::size_t k = 0; k < row.size(); ++k)
      sum.add(row[k].factor.value, matrix_.bounds(label, k), sent_out(row[k].to, channel));
    if (!sources_.direct_irradiance.empty()) sum.add(sources_.direct_irradiance[label][static_cast<int>(channel)]);
    return sum;
  }

  double sent_out(std::uint32_t to, std::size_t channel) const {
    if (to == matrix_.sky()) return to_double(original_.scene.sky_emission.value[channel]);
    return senders_[to] ? solution_.channels[channel].elements[*senders_[to]].radiosity : 0;
  }

  const PreparedScene3& original_;
  const RadiositySolution& solution_;
  ExchangeMatrix matrix_;
  std::vector<std::optional<std::uint32_t>> senders_;
  RadiositySources sources_;
};

}  // namespace

IlluminationGrid3 average_irradiance(const PreparedScene3& prepared, const RadiositySolution& solution,
                                     const Grid3& grid, ExchangeRequest asked) {
  HOTTEL_REQUIRE(grid_problem(grid).empty());
  Stopwatch watch;
  const SceneOfCells3 with_cells(prepared.scene, grid);
  asked.wants_visibility = asked.wants_measures = false;
  asked.rows = RowChoice::of(with_cells.scene, with_cells.prefix + "*", asked.granularity);
  const auto ready = std::make_shared<const PreparedScene3>(prepare(with_cells.scene));
  const GatheringCells3 gathering(prepared, ready, solution, asked);

  IlluminationGrid3 result{grid, static_cast<std::uint32_t>(solution.channels.size()), {}};
  result.values.assign(with_cells.cells * result.channels, kNaN);
  result.errors.assign(with_cells.cells, 0);
  const std::vector<Element>& elements = gathering.matrix().elements();
  for (std::uint32_t label = 0; label < elements.size(); ++label) {
    const std::size_t cell = elements[label].surface;
    if (cell >= with_cells.cells || elements[label].is_back) continue;
    const std::span<double> light = std::span(result.values).subspan(cell * result.channels, result.channels);
    if (const auto error = gathering.gather(label, light)) result.errors[cell] = *error;
  }
  result.seconds = watch.lap();
  return result;
}

}  // namespace hottel
