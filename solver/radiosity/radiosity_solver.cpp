#include "solver/radiosity/radiosity_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "kernel/exact_double.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"
#include "solver/radiosity/enclosed_radiosity.h"
#include "solver/radiosity/matrix_checks.h"
#include "solver/radiosity/signed_radiosity.h"
#include "solver/radiosity/unbounded_rows.h"

namespace hottel {
namespace {

// What a solve reports of its progress, as one of two that follow each other.
std::function<void(double)> first_half_of(const std::function<void(double)>& progress) {
  if (!progress) return {};
  return [progress](double fraction) { progress(fraction / 2); };
}
std::function<void(double)> second_half_of(const std::function<void(double)>& progress) {
  if (!progress) return {};
  return [progress](double fraction) { progress((1 + fraction) / 2); };
}

SourceSpectrum with_thermal(const SourceSpectrum& spectrum, const RationalEnclosure& thermal) {
  return SourceSpectrum::of(std::array{spectrum[kSolarBand], thermal, thermal});
}

Rational not_below_zero(const Rational& value) { return value > 0 ? value : Rational(0); }

// Two bands: what faces gain in the solar band is heat that they give away in the thermal one. Returns the sources of
// the thermal band, once the solar one is solved: an element that keeps its gains sends out a = (1 - rho_s) H_s - E_s
// beside what it emits, or, where that is below 0, has it withdrawn.
//
//   (1) a is enclosed by the bounds of the solar net flux, of which it is the opposite: exact where that is, as where
//   no
//       light is absorbed; where a may be of either sign something may be sent out and something withdrawn
// Throws RequestError, naming an element, where its solar net flux has no bounds. REQUIRES sources with bands, `solar`
// the solution of their channel 0.
RadiositySources with_gains(const ExchangeMatrix& matrix, RadiositySources sources, const ChannelSolution& solar) {
  HOTTEL_REQUIRE(sources.has_bands && sources.keeps_gains.size() == matrix.size());
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!sources.keeps_gains[i]) continue;
    const ElementRadiosity& element = solar.elements[i];
    if (element.net_lower == 0 && element.net_upper == 0) continue;
    if (!std::isfinite(element.net_lower) || !std::isfinite(element.net_upper))
      throw RequestError("what '" + matrix.elements()[i].name +
                         "' gains in the solar band has no proven bounds, so there are none of its temperature");
    RationalEnclosure flux = sources.emission[i][kThermalBand];
    if (!sources.withdrawn.empty()) {
      const RationalEnclosure& taken = sources.withdrawn[i][kThermalBand];
      flux = {flux.lower - taken.upper, flux.upper - taken.lower};
    }
    const Rational lower = flux.lower - exact_value(element.net_upper);
    const Rational upper = flux.upper - exact_value(element.net_lower);
    sources.emission[i] = with_thermal(sources.emission[i], {not_below_zero(lower), not_below_zero(upper)});
    if (lower < 0) sources.withdrawn.resize(matrix.size());
    if (!sources.withdrawn.empty())
      sources.withdrawn[i] = with_thermal({}, {not_below_zero(-upper), not_below_zero(-lower)});
  }
  return sources;
}

// The solution whose channel 0 is that of `solar` and whose channel 1 is that of `thermal`. REQUIRES two solutions of
// the same system in two channels.
RadiositySolution in_one(RadiositySolution solar, RadiositySolution thermal) {
  HOTTEL_REQUIRE(solar.channels.size() == 2 && thermal.channels.size() == 2);
  solar.channels[kThermalBand] = std::move(thermal.channels[kThermalBand]);
  sum_up_channels(solar);
  if (solar.factorizations == 0 || thermal.factorizations > 0) solar.used = thermal.used;
  solar.factorizations += thermal.factorizations;
  solar.unknowns = std::max(solar.unknowns, thermal.unknowns);
  solar.components = std::max(solar.components, thermal.components);
  for (const auto& [stage, seconds] : thermal.seconds) solar.seconds[stage] += seconds;
  for (std::string& note : thermal.notes)
    if (std::find(solar.notes.begin(), solar.notes.end(), note) == solar.notes.end())
      solar.notes.push_back(std::move(note));
  return solar;
}

constexpr std::size_t kMostNamed = 3;
constexpr double kNarrow = 1e-9;            // relative
constexpr double kTimesTheBrightest = 1e3;  // so much wider, relatively, than beside the brightest is wide

struct Faint {
  double width = 0;  // relative
  std::uint32_t element = 0;
};

// The widest first.
std::vector<Faint> faint_of(const ChannelSolution& channel) {
  double brightest = 0, widest = 0;
  const auto is_bounded = [](const ElementRadiosity& e) { return e.radiosity > 0 && std::isfinite(e.upper); };
  for (const ElementRadiosity& e : channel.elements) {
    if (!is_bounded(e)) continue;
    brightest = std::max(brightest, e.radiosity);
    widest = std::max(widest, e.upper - e.lower);
  }
  const double ordinary = std::max(kNarrow, kTimesTheBrightest * (brightest > 0 ? widest / brightest : 0));
  std::vector<Faint> result;
  for (std::uint32_t i = 0; i < channel.elements.size(); ++i) {
    const ElementRadiosity& e = channel.elements[i];
    const double width = is_bounded(e) ? (e.upper - e.lower) / e.radiosity : 0;
    if (width > ordinary) result.push_back({width, i});
  }
  std::stable_sort(result.begin(), result.end(), [](const Faint& a, const Faint& b) { return a.width > b.width; });
  return result;
}

// A note for each channel in which bounds of faint radiosities are wide: a thousand times as wide, relatively, as those
// of all are beside the brightest, and wider than 1e-9. It says of how many, names the widest three and says how wide
// they are. Bounds that are open have a note of their own.
//
//   (1) none where elimination could be had: up to kMostEliminatedUnknowns unknowns in a component, solver auto,
//       cholesky or cg without limits, factors that are normal doubles, radiosities too
std::vector<std::string> notes_of_loose_bounds(const ExchangeMatrix& matrix, const RadiositySolution& solution) {
  std::vector<std::string> notes;
  for (std::size_t c = 0; c < solution.channels.size(); ++c) {
    const std::vector<Faint> faint = faint_of(solution.channels[c]);
    if (faint.empty()) continue;
    std::string note = fmt::format("relative accuracy is lost in {} radiosit{} far below the brightest", faint.size(),
                                   faint.size() == 1 ? "y" : "ies");
    if (solution.channels.size() > 1) note += fmt::format(" ({})", solution.channel_names[c]);
    const std::size_t named = std::min(faint.size(), kMostNamed);
    for (std::size_t k = 0; k < named; ++k)
      note += fmt::format("{} the bounds of '{}' are {:.2g} times its value apart", k == 0 ? ":" : ",",
                          matrix.elements()[faint[k].element].name, faint[k].width);
    if (named < faint.size()) note += fmt::format(" and {} more", faint.size() - named);
    notes.push_back(note);
  }
  return notes;
}

}  // namespace

struct RadiositySolver::Parts {
  std::shared_ptr<const ExchangeMatrix> matrix;
  RadiosityOptions options;
  EnclosedRadiosity radiosity;
  double seconds;  // for the systems
  double closure_defect, reciprocity_defect;

  Parts(std::shared_ptr<const ExchangeMatrix> of, const std::vector<Spectrum>& reflectivity, RadiosityOptions with,
        Stopwatch watch = {})
      : matrix(std::move(of)),
        options(std::move(with)),
        radiosity(*matrix, reflectivity),
        seconds(watch.lap()),
        closure_defect(hottel::closure_defect(*matrix)),
        reciprocity_defect(hottel::reciprocity_defect(*matrix)) {}

  RadiositySolution solve(const RadiositySources& sources, RadiosityOptions asked) const {
    if (!sources.has_bands) return solve_signed(sources, asked);
    const std::function<void(double)> told = asked.progress;
    asked.progress = first_half_of(told);
    RadiositySources of_band = sources;
    of_band.only_channel = kSolarBand;
    of_band.withdrawn.clear();
    RadiositySolution solar = solve_signed(of_band, asked);
    asked.progress = second_half_of(told);
    of_band = with_gains(*matrix, sources, solar.channels[kSolarBand]);
    of_band.only_channel = kThermalBand;
    return in_one(std::move(solar), solve_signed(of_band, asked));
  }

  RadiositySolution solve_signed(const RadiositySources& sources, RadiosityOptions asked) const {
    if (sources.withdrawn.empty()) return radiosity.solve(sources, asked);
    const std::function<void(double)> told = asked.progress;
    asked.progress = first_half_of(told);
    RadiositySolution supplied = radiosity.solve(sources, asked);
    asked.progress = second_half_of(told);
    const bool in_channels = supplied.channels.size() > 1;
    return difference_of(*matrix, std::move(supplied), radiosity.solve(sources.withdrawn_alone(in_channels), asked));
  }
};

RadiositySolver::RadiositySolver(std::shared_ptr<const ExchangeMatrix> matrix,
                                 const std::vector<Spectrum>& reflectivity, RadiosityOptions options) {
  HOTTEL_REQUIRE(matrix != nullptr);
  HOTTEL_REQUIRE(options.iterations.value_or(0) >= 0 && options.until.value_or(0) >= 0);
  const DefaultFloatingPoint arithmetic;
  parts_ = std::make_unique<const Parts>(std::move(matrix), reflectivity, std::move(options));
}

RadiositySolver::~RadiositySolver() = default;
RadiositySolver::RadiositySolver(RadiositySolver&&) noexcept = default;
RadiositySolver& RadiositySolver::operator=(RadiositySolver&&) noexcept = default;

const ExchangeMatrix& RadiositySolver::matrix() const { return *parts_->matrix; }
double RadiositySolver::seconds() const { return parts_->seconds; }

RadiositySolution RadiositySolver::solve(const RadiositySources& sources,
                                         const std::function<void(double)>& progress) const {
  const DefaultFloatingPoint arithmetic;
  const ExchangeMatrix& matrix = *parts_->matrix;
  HOTTEL_REQUIRE(sources.emission.size() == matrix.size());
  HOTTEL_REQUIRE(sources.direct_irradiance.empty() || sources.direct_irradiance.size() == matrix.size());
  HOTTEL_REQUIRE(sources.withdrawn.empty() || sources.withdrawn.size() == matrix.size());
  RadiosityOptions options = parts_->options;
  options.progress = progress;
  RadiositySolution solution = parts_->solve(sources, options);
  solution.closure_defect = parts_->closure_defect;
  solution.reciprocity_defect = parts_->reciprocity_defect;
  for (std::string& note : notes_of_unbounded_rows(matrix, solution)) solution.notes.push_back(std::move(note));
  if (matrix.guarantee() == Guarantee::kEstimated)
    solution.guarantee = Guarantee::kEstimated;
  else  // the faint radiosities of estimates are what they are: estimates
    for (std::string& note : notes_of_loose_bounds(matrix, solution)) solution.notes.push_back(std::move(note));
  return solution;
}

}  // namespace hottel
