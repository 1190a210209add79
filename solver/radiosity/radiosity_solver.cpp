#include "solver/radiosity/radiosity_solver.h"

#include <string>
#include <utility>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"
#include "solver/radiosity/band_gains.h"
#include "solver/radiosity/enclosed_radiosity.h"
#include "solver/radiosity/loose_bounds.h"
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
