#include "viewer/window/space/view_mode.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/scene_names.h"
#include "io/results/solve_report.h"
#include "kernel/support/failure.h"
#include "solver/space/compare/method_comparison.h"
#include "solver/space/methods/method_catalogue.h"
#include "viewer/edit/material_edits.h"
#include "viewer/picture/space/error_map.h"
#include "viewer/window/text_lines.h"

namespace hottel {
namespace {

// In the order of ViewMode3.
constexpr std::array<const char*, kViewModes3> kWords{"light",  "radiosity", "irradiance", "factors",
                                                      "errors", "plan",      "sweeps"};

constexpr double kDecades = 1e-4;  // least over largest factor of the scale

// All digits of a double.
std::string digits(double value) { return fmt::format("{:.17g}", value); }

const char* guarantee_word(Guarantee guarantee) {
  return guarantee == Guarantee::kExact ? "exact" : guarantee == Guarantee::kEnclosed ? "enclosed" : "estimated";
}

void add_quantity(Quantity quantity, ViewResult3& result) {
  const LiveVersion3& of = *result.version;
  result.shown = shown_values({.quantity = quantity}, of.scene(), of.factors()->matrix, *of.radiosities());
}

// By elements: what their whole polygons get.
ShownValues values_by_face(const ExchangeMatrix& elements, const ExchangeMatrix& faces, std::uint32_t from,
                           const std::string& name) {
  ShownValues shown;
  shown.name = "factor";
  shown.unit = "1";
  double largest = 0;
  std::vector<double> to_face(2 * std::size_t{faces.size()} + 2, 0);
  for (const FactorEntry& entry : faces.row(from)) {
    if (entry.to == faces.sky()) continue;
    const Element& element = faces.elements()[entry.to];
    to_face[Face{element.surface, element.is_back}.number()] = entry.factor.value;
    largest = std::max(largest, entry.factor.value);
  }
  shown.elements.resize(elements.size());
  for (std::uint32_t i = 0; i < elements.size(); ++i) {
    const Element& element = elements.elements()[i];
    if (elements.has_row(i)) shown.elements[i] = to_face[Face{element.surface, element.is_back}.number()];
  }
  shown.scale = largest > 0 ? ColourScale{kDecades * largest, largest, true} : ColourScale{0, 1, false};
  shown.title = fmt::format("view factor from {}: up to {:.3g}", name, largest);
  return shown;
}

void add_factors(const ViewRequest3& request, const StageProgress& progress, ViewResult3& result) {
  if (!request.face) {
    result.lines = {"click a polygon"};
    return;
  }
  const LiveVersion3& of = *result.version;
  const std::string name = face_name(of.scene(), *request.face);
  const std::shared_ptr<const ComputedFactors3> computed = of.of().whole().factors(progress);
  const ExchangeMatrix& matrix = computed->matrix;
  const auto from = matrix.find(name);
  result.lines = {"from " + name};
  if (!from || !matrix.has_row(*from)) {
    result.lines.push_back("it has no material, or nothing is left of it: no factors");
    return;
  }
  std::vector<std::size_t> order(matrix.row(*from).size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  const auto factor = [&](std::size_t k) { return matrix.row(*from)[k].factor.value; };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return factor(a) > factor(b); });
  for (const std::size_t k : order)
    result.lines.push_back(fmt::format("{}\t{}\t{}", digits(factor(k)), matrix.name(matrix.row(*from)[k].to),
                                       guarantee_word(matrix.guarantee(*from, k))));
  if (!order.empty()) result.number = shortest(factor(order[0]));
  result.shown = values_by_face(of.factors()->matrix, matrix, *from, name);
}

void add_errors(const ViewRequest3& request, const StageProgress& progress, ViewResult3& result) {
  const MethodComparison3 comparison(result.version->of().simulation(), progress);
  progress("comparison", 0.5);
  const MethodResult found = comparison.run(*methods_3().make(request.method), 1);
  result.shown = error_values_3(comparison, found);
  result.lines = error_lines(found);
  result.lines.push_back(fmt::format("{:.3g} ms", 1e3 * found.timing.median));
  result.number = shortest(found.errors.max);
}

// One solver after 0, 1, 2, ... sweeps: each a simulation of its own that shares the factors.
void add_sweeps(const ViewRequest3& request, const StageProgress& progress,
                const std::function<void(ViewResult3)>& tell, ViewResult3& result) {
  const Simulation3& simulation = result.version->of().simulation();
  for (int k = 0; k <= kMostSweeps; ++k) {
    SimulationRequest3 asked = simulation.request();
    asked.system = {.solver = request.solver, .iterations = k};
    result.radiosities = simulation.with_request(asked).radiosities(progress);
    SweepTexts texts = sweep_texts(request.solver, k, *result.radiosities);
    result.lines = std::move(texts.lines);
    result.number = std::move(texts.number);
    if (k == kMostSweeps || !tell) continue;
    tell(result);
    wait_between_sweeps();
  }
}

}  // namespace

const char* to_string(ViewMode3 mode) { return kWords[static_cast<std::size_t>(mode)]; }

std::optional<ViewMode3> view_mode_3(std::string_view word) { return mode_of<ViewMode3>(word, kWords); }

bool needs_work(const ViewRequest3& request) { return request.mode != ViewMode3::kLight; }

ViewResult3 compute_view_3(const LiveVersion3::Ptr& version, const ViewRequest3& request, const StageProgress& progress,
                           const std::function<void(ViewResult3)>& tell) {
  HOTTEL_REQUIRE(version && version->is_lit());
  ViewResult3 result{.version = version};
  try {
    switch (request.mode) {
      case ViewMode3::kLight:
        break;
      case ViewMode3::kRadiosity:
        add_quantity(Quantity::kRadiosity, result);
        break;
      case ViewMode3::kIrradiance:
        add_quantity(Quantity::kIrradiance, result);
        break;
      case ViewMode3::kFactors:
        add_factors(request, progress, result);
        break;
      case ViewMode3::kErrors:
        add_errors(request, progress, result);
        break;
      case ViewMode3::kPlan:
        for (const std::string& line : lines_of(plan_text(*version->of().simulation().plan(progress))))
          result.lines.push_back(with_tabs(line));
        break;
      case ViewMode3::kSweeps:
        add_sweeps(request, progress, tell, result);
        break;
    }
  } catch (const std::runtime_error& error) {  // what cannot be had; Interrupted is none
    result = {.version = version, .lines = {error.what()}};
  }
  return result;
}

ElementPaint3 ShownView3::light() const {
  HOTTEL_REQUIRE(version_ != nullptr);
  return result_ && result_->radiosities ? light_paint_3(version_->scene(), *result_->radiosities) : version_->light();
}

const RadiositySolution* ShownView3::radiosities() const {
  if (result_ && result_->radiosities) return result_->radiosities.get();
  return version_ && version_->is_lit() ? version_->radiosities().get() : nullptr;
}

std::string ShownView3::number(const std::optional<LiveElement3>& element) const {
  const std::optional<std::uint32_t> at = element && version_ ? element->number_in(version_->model()) : std::nullopt;
  if (at && values() != nullptr) {
    const std::optional<double>& value = values()->elements[*at];
    return value ? shortest(*value) : "";
  }
  if (!at || !version_->is_lit() || (result_ && result_->radiosities)) return result_ ? result_->number : "";
  std::string text;
  for (const ChannelSolution& channel : version_->radiosities()->channels)
    text += (text.empty() ? "" : " ") + shortest(channel.elements[*at].radiosity);
  return text;
}

const char* ShownView3::name_of_number() const {
  if (values() != nullptr) return values()->name.c_str();
  return result_ && result_->radiosities ? "residual" : "radiosity";
}

std::vector<std::string> face_lines_3(const LiveVersion3& version, const Face& face,
                                      const std::optional<LiveElement3>& element) {
  const Scene3& scene = version.scene();
  std::vector<std::string> lines{face_name(scene, face)};
  const auto material = scene.surfaces[face.surface].material_of(face.is_back);
  if (!material) {
    lines.push_back("opaque and black");
    return lines;
  }
  const Material& its = scene.materials[*material];
  lines.push_back("material\t" + its.name);
  lines.push_back("reflectivity\t" + spectrum_text(its.surface_reflectivity()));
  lines.push_back((its.has_given_flux() ? "net flux\t" : "emission\t") + spectrum_text(its.emission));
  const std::optional<std::uint32_t> number = element ? element->number_in(version.model()) : std::nullopt;
  if (!number) return lines;
  const Element& its_element = version.model().table().elements()[*number];
  if (its_element.parts > 1) lines.push_back(fmt::format("element\t{} of {}", its_element.part + 1, its_element.parts));
  lines.push_back("area\t" + digits(its_element.area.value));
  if (!version.is_lit()) return lines;
  for (std::size_t c = 0; c < version.radiosities()->channels.size(); ++c) {
    const ElementRadiosity& light = version.radiosities()->channels[c].elements[*number];
    const std::string& channel = version.radiosities()->channel_names[c];
    const std::string of = channel == "all" ? "" : " " + channel;
    lines.push_back("radiosity" + of + "\t" + digits(light.radiosity));
    lines.push_back("irradiance" + of + "\t" + digits(light.irradiance));
  }
  return lines;
}

}  // namespace hottel
