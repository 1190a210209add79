#include "tests/storm/space/matrix_law.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/division.h"
#include "geometry/space/scene/validation.h"
#include "geometry/unmeasured_pairs.h"
#include "tests/comparison/space/map_comparison.h"

namespace hottel::storm {
namespace {

constexpr double kTolerance = 1e-12, kDigits = 1e-14;  // of the smaller area; of the square of the largest distance
constexpr double kRounding = 0x1p-50;                  // of an area and a sum
constexpr std::size_t kFewPolygons = 8, kMostPolygons = 40, kRowsOfTown = 12;

// What the pairs of an element come to, over its area.
struct Row {
  long double sum = 0, error = 0, lower = 0, upper = 0, sky = 0;
  bool sees_sky = false;
};

std::vector<Row> rows_of(const ElementTable3& table, std::span<const PairSum3> pairs) {
  std::vector<Row> rows(table.count());
  const auto add = [&](std::uint32_t label, const PairSum3& pair) {
    const long double area = table.extent(label).value;
    Row& row = rows[label];
    row.sum += pair.measure / area;
    row.error += pair.error / area;
    row.lower += pair.bounds.lower / area;
    row.upper += pair.bounds.upper / area;
    if (pair.j != table.sky()) return;
    row.sky = pair.measure / area;
    row.sees_sky = true;
  };
  for (const PairSum3& pair : pairs) {
    if (pair.is_zero()) continue;
    add(pair.i, pair);
    if (pair.j != pair.i && pair.j != table.sky()) add(pair.j, pair);
  }
  return rows;
}

std::vector<std::uint32_t> some_rows(const ElementTable3& table, std::uint64_t chance) {
  std::mt19937_64 random(chance * 31 + 17);
  std::vector<std::uint32_t> labels;
  for (std::size_t k = 0; k < kRowsOfTown; ++k) {
    const auto label = static_cast<std::uint32_t>(random() % table.count());
    if (table.has_row(label)) labels.push_back(label);
  }
  return labels;
}

// The largest square of a distance over the smallest area.
double square_over_area(const Polygons3& polygons) {
  double square = 0, area = 0;
  for (const oracle::SpacePolygon& polygon : polygons) {
    const oracle::SpacePoint normal = oracle::normal_of(polygon);
    const double twice = std::sqrt(oracle::dot(normal, normal).get_d());
    if (twice > 0 && (area == 0 || twice / 2 < area)) area = twice / 2;
    for (const oracle::SpacePoint& p : polygon)
      for (const oracle::SpacePoint& q : polygons[0]) square = std::max(square, 4 * oracle::dot(q - p, q - p).get_d());
  }
  return square / area;
}

std::string by_closure_is_wrong(const PreparedScene3& prepared, ExchangeRequest request, const ExchangeRows3& integrals,
                                const std::vector<Row>& rows) {
  const ElementTable3& table = integrals.table();
  PairRanges all(table.count());
  for (std::uint32_t i = 0; i < table.count(); ++i) all.add(i, {i, table.count() + 1});
  request.sky = SkyBy::kClosure;
  ExchangeRows3 by_closure(prepared, request);
  by_closure.take({integrals.pairs().begin(), integrals.pairs().end()}, std::move(all));
  ExchangeReport3 report;
  const ExchangeMatrix matrix = by_closure.matrix(&report);
  std::string wrong;
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (!table.has_row(i)) continue;
    const double sky = matrix.factor(i, table.sky()).value;
    const auto off = static_cast<double>(std::fabs(sky - rows[i].sky));
    if ((sky > 0) != rows[i].sees_sky || !(off <= static_cast<double>(rows[i].error) + kRounding))
      wrong += fmt::format("{} sees {:.17g} of the sky, by closure {:.17g}\n", table.elements()[i].name,
                           static_cast<double>(rows[i].sky), sky);
  }
  if (report.sky->beyond > 0)
    wrong += fmt::format("{} differs from its rest by {:.3g}\n", report.sky->farthest, report.sky->max_difference);
  return wrong;
}

}  // namespace

Scene3 scene_of_polygons_3(const Polygons3& polygons) {
  Scene3 scene;
  scene.materials.emplace_back();
  scene.materials.back().name = "black";
  const std::vector<Polygon3> shapes = oracle::engine_polygons(polygons);
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    Surface surface;
    surface.name = fmt::format("{}", k);
    surface.group = static_cast<std::uint32_t>(k);
    surface.back = 0;
    scene.groups.emplace_back(surface.name);
    scene.add(std::move(surface), shapes[k]);
  }
  return scene;
}

MatrixAnswer3 matrix_answer_3(const Polygons3& polygons, std::uint64_t chance) {
  Scene3 scene = scene_of_polygons_3(polygons);
  const bool is_divided = polygons.size() <= kFewPolygons && chance % 4 == 0;
  if (is_divided) divide_into(scene, 2);
  validate(scene);
  const PreparedScene3 prepared = prepare(scene);
  const double tolerance = std::max(kTolerance, kDigits * (is_divided ? 4 : 1) * square_over_area(polygons));
  const ExchangeRequest request{
      .granularity = Granularity::kElement, .wants_visibility = false, .tolerance = tolerance};
  ExchangeRows3 integrals(prepared, request);
  const ElementTable3& table = integrals.table();
  const bool is_town = polygons.size() > kMostPolygons;
  try {
    if (is_town)
      integrals.add(some_rows(table, chance));
    else
      integrals.add_all();
  } catch (const UnmeasuredPairs& problem) {
    return {.wrong = "", .refusal = problem.what()};
  }
  const std::vector<Row> rows = rows_of(table, integrals.pairs());
  std::string wrong;
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (!table.has_row(i) || integrals.is_missing(i)) continue;
    const Row& row = rows[i];
    const auto off = static_cast<double>(row.sum - 1), stated = static_cast<double>(row.error) + kRounding;
    if (!(std::fabs(off) <= stated))
      wrong += fmt::format("the row of {} sums to 1 {:+.3g}, its entries state {:.3g}, asked for was {:.3g}\n",
                           table.elements()[i].name, off, stated, tolerance);
    if (!(row.lower <= 1 + kRounding && row.upper >= 1 - kRounding))
      wrong += fmt::format("the bounds of the row of {} sum to [{:.17g}, {:.17g}]\n", table.elements()[i].name,
                           static_cast<double>(row.lower), static_cast<double>(row.upper));
  }
  if (!is_town) wrong += by_closure_is_wrong(prepared, request, integrals, rows);
  return {.wrong = std::move(wrong), .refusal = ""};
}

}  // namespace hottel::storm
