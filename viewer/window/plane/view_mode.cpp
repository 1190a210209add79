#include "viewer/window/plane/view_mode.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/plane/exchange/closed_forms.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/critical_points.h"
#include "geometry/plane/visibility/point_view.h"
#include "geometry/scene_names.h"
#include "io/results/plane/check_report.h"
#include "io/results/plane/visibility_report.h"
#include "io/results/solve_report.h"
#include "kernel/decimal.h"
#include "kernel/rounding.h"
#include "kernel/support/failure.h"
#include "solver/plane/check/scene_check.h"
#include "solver/plane/compare/method_comparison.h"
#include "solver/plane/methods/computed_factors.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/plane/simulation/queries.h"
#include "viewer/picture/plane/error_map.h"
#include "viewer/window/text_lines.h"

namespace hottel {
namespace {

constexpr std::array<const char*, kViewModes2> kWords{"light", "floor",  "bands", "visibility", "factors",
                                                      "pair",  "errors", "check", "plan",       "sweeps"};

std::string text_of(const Point2& p) { return fmt::format("({}, {})", decimal_text(p.x), decimal_text(p.y)); }

// Nothing inside solids and on edges.
std::string text_of(const PointLight2& light) {
  std::string text;
  if (std::ranges::any_of(light.mean_irradiance, [](double value) { return std::isnan(value); })) return text;
  for (const double value : light.mean_irradiance) text += (text.empty() ? "" : " ") + shortest(value);
  return text;
}

// The light at the mouse, and where the drawing is wanted what the mouse sees.
void add_sight(const LiveState2& state, ViewResult2& result, const StageProgress& progress) {
  if (!result.request.mouse || !state.prepared) return;
  const Point2& eye = *result.request.mouse;
  const PointView2 sight = point_view(*state.prepared, eye);
  if (result.request.mode == ViewMode2::kVisibility) {
    result.sight = drawing_of(sight.polygon);
    result.lines = {"from " + text_of(eye)};
    if (sight.polygon.area)
      result.lines.push_back("area " + decimal_text(*sight.polygon.area) +
                             (result.request.wants_closed_form ? " = " + to_string(*sight.polygon.area) : ""));
    for (const SeenFrom2& seen : sight.faces)
      result.lines.push_back(fmt::format("{}  {}", shortest(seen.fraction.value), seen.name));
    for (const SeenFrom2& solid : sight.solids)
      result.lines.push_back(fmt::format("{}  in the solid {}", shortest(solid.fraction.value), solid.name));
  }
  if (!state.radiosities) return;
  const PointLight2 light = light_at(*state.simulation, sight.polygon, progress);
  result.number = text_of(light);
  if (!result.number.empty()) result.at_mouse = light.mean_irradiance;
  if (result.request.mode == ViewMode2::kVisibility && !result.number.empty())
    result.lines.insert(result.lines.begin() + 1, "mean irradiance " + result.number);
}

// A line of a pair's answer without its closed form.
std::string without_form(const std::string& line) {
  const auto form = line.find(" = ");
  return line.starts_with("  ") && form != std::string::npos && line.find("S / S0") == std::string::npos
             ? line.substr(0, line.find_last_not_of(' ', form) + 1)
             : line;
}

void add_pair(const LiveState2& state, ViewResult2& result) {
  const ViewRequest2& request = result.request;
  if (!request.face) {
    result.lines = {request.mode == ViewMode2::kPair ? "click a face, then another" : "click a face"};
    return;
  }
  if (!state.prepared) return;
  const Scene2& scene = state.prepared->scene;
  const std::optional<Face> face = face_called(scene, request.face), other = face_called(scene, request.other);
  if (!face) return;
  if (!other) {
    result.lines = {"from " + *request.face,
                    request.mode == ViewMode2::kPair ? "click another face" : "the factor to the face under the mouse"};
    return;
  }
  PairSight2 sight{.from = *request.face,
                   .to = *request.other,
                   .face_from = face,
                   .face_to = other,
                   .pair = exact_pair(*state.prepared, face, other),
                   .critical = {},
                   .unit = scene.unit};
  if (request.mode == ViewMode2::kPair) {
    sight.critical = critical_points(*state.prepared, *face, other);
    result.pair = drawing_of(sight);
  }
  for (const std::string& line : lines_of(pair_answer(sight).text)) {
    if (request.mode != ViewMode2::kPair && line.starts_with("critical")) break;
    result.lines.push_back(with_tabs(request.wants_closed_form ? line : without_form(line)));
  }
  if (const RootSum& area = sight.pair.area_from; !area.is_zero())
    result.number = shortest(round_quotient(sight.pair.exchange, area).number.value);
}

double seconds_of(const ComputedFactors2& factors) {
  double sum = 0;
  for (const auto& [stage, seconds] : factors.report.counts.seconds)
    if (stage != "prepare") sum += seconds;
  return sum;
}

void add_errors(const LiveState2& state, ViewResult2& result, const StageProgress& progress) {
  if (!state.simulation || !state.factors) return;
  const MethodComparison2 comparison(*state.simulation, progress);
  progress("comparison", 0.5);
  const MethodResult found = comparison.run(*methods_2().make(result.request.method), 1);
  result.plan = error_map_picture_2(comparison, found);
  if (!result.plan->colouring) result.plan.reset();
  result.times = fmt::format("exact {:.3g} ms   {} {:.3g} ms", 1e3 * seconds_of(*state.factors), found.info.name,
                             1e3 * found.timing.median);
  result.lines = error_lines(found);
  result.lines.push_back(result.times);
  result.number = shortest(found.errors.max);
}

void add_check(const LiveState2& state, ViewResult2& result, const StageProgress& progress) {
  if (!state.simulation) return;
  const auto check = state.simulation->check(progress);
  for (std::size_t k = 0; k < check->findings.size(); ++k) {
    const Finding2& finding = check->findings[k];
    if (finding.at) result.findings.push_back({*finding.at, finding.severity, k + 1});
    result.lines.push_back(
        fmt::format("{}  {}: {}: {}", k + 1, to_string(finding.severity), finding.kind, finding.message));
    if (!finding.suggestion.empty()) result.lines.push_back("    " + finding.suggestion);
  }
  if (result.lines.empty()) result.lines = {"nothing to tell"};
}

// One solver after 0, 1, 2, ... sweeps: each a simulation of its own that shares the factors, and what the cells see.
void add_sweeps(const LiveState2& state, ViewResult2& result, const StageProgress& progress,
                const std::function<void(ViewResult2)>& tell) {
  if (!state.simulation || !state.factors) return;
  SimulationRequest2 request = state.simulation->request();
  request.system.solver = result.request.solver;
  request.grid = coarse_grid_2(state.simulation->grid(), kCoarseCells);
  request.keeps_rows = true;
  Simulation2 simulation = *state.simulation;
  for (int k = 0; k <= kMostSweeps; ++k) {
    request.system.iterations = k;
    simulation = simulation.with_request(request);
    const auto radiosities = simulation.radiosities(progress);
    result.light = simulation.light(progress);
    SweepTexts texts = sweep_texts(request.system.solver, k, *radiosities);
    result.lines = std::move(texts.lines);
    result.lines.push_back(
        fmt::format("bounds of the radiosities {:.3g} wide, relative", radiosities->max_relative_width));
    result.number = std::move(texts.number);
    result.is_done = k == kMostSweeps;
    if (result.is_done || !tell) continue;
    tell(result);
    wait_between_sweeps();
  }
}

}  // namespace

const char* to_string(ViewMode2 mode) { return kWords[static_cast<std::size_t>(mode)]; }

std::optional<ViewMode2> view_mode_2(std::string_view word) { return mode_of<ViewMode2>(word, kWords); }

bool shows_light_at_mouse(ViewMode2 mode) {
  return mode == ViewMode2::kLight || mode == ViewMode2::kFloor || mode == ViewMode2::kBands ||
         mode == ViewMode2::kVisibility;
}

std::optional<Face> face_called(const Scene2& scene, const std::optional<std::string>& name) {
  if (!name) return std::nullopt;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    for (const Face face : {Face{s, false}, Face{s, true}})
      if (name->starts_with(scene.surfaces[s].name) && face_name(scene, face) == *name) return face;
  return std::nullopt;
}

bool needs_work(const ViewRequest2& request) { return !shows_light_at_mouse(request.mode) || request.mouse; }

ViewResult2 compute_view(const LiveState2& state, const ViewRequest2& request, const StageProgress& progress,
                         const std::function<void(ViewResult2)>& tell) {
  ViewResult2 result{.version = state.version, .request = request};
  try {
    switch (request.mode) {
      case ViewMode2::kLight:
      case ViewMode2::kFloor:
      case ViewMode2::kBands:
      case ViewMode2::kVisibility:
        add_sight(state, result, progress);
        break;
      case ViewMode2::kFactors:
      case ViewMode2::kPair:
        add_pair(state, result);
        break;
      case ViewMode2::kErrors:
        add_errors(state, result, progress);
        break;
      case ViewMode2::kCheck:
        add_check(state, result, progress);
        break;
      case ViewMode2::kPlan:
        if (!state.simulation) break;
        for (const std::string& line : lines_of(plan_text(*state.simulation->plan(progress))))
          result.lines.push_back(with_tabs(line));
        break;
      case ViewMode2::kSweeps:
        add_sweeps(state, result, progress, tell);
        break;
    }
  } catch (const std::runtime_error& error) {  // what cannot be had; Interrupted is none
    result.lines = {error.what()};
  }
  return result;
}

}  // namespace hottel
