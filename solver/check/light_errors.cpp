#include "solver/check/light_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/scene_names.h"
#include "geometry/unit_of_length.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/element_temperatures.h"
#include "solver/radiosity/matrix_checks.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {
namespace {

constexpr double kModerate = 1e60;
constexpr const char* kOtherLight = "choose another unit of light";

using Faces = std::vector<std::uint32_t>;  // elements of the matrix, ascending

bool is_a_size(double area) { return area > 0 && std::isfinite(area); }
double largest(const Spectrum& spectrum) {
  return to_double(*std::max_element(spectrum.value.begin(), spectrum.value.end()));
}
bool is_finite(const RadiositySolution& solution, std::uint32_t i) {
  return std::all_of(solution.channels.begin(), solution.channels.end(), [i](const ChannelSolution& channel) {
    return std::isfinite(channel.elements[i].radiosity) && std::isfinite(channel.elements[i].irradiance);
  });
}

class ErrorTeller {
 public:
  ErrorTeller(const SceneTable& scene, const ExchangeMatrix& matrix) : scene_(scene), matrix_(matrix) {}

  // What is given.
  void tell_sizes(const char* size) {
    tell_beyond(rows_where([this](std::uint32_t i) { return !is_a_size(matrix_.elements()[i].area.value); }),
                fmt::format("the {} of", size), "choose another unit of length");
    tell_beyond(rows_where([this](std::uint32_t i) { return !std::isfinite(largest(material_of(i).emission)); }),
                "the emission of", kOtherLight);
    if (!std::isfinite(largest(scene_.sky_emission)))
      errors_.push_back({"beyond-doubles", {}, "the emission of the sky is beyond the range of doubles", kOtherLight});
    if (errors_.empty()) tell(below_doubles(matrix_, scene_.materials));
  }

  void tell_mirrors(const LightFates& fates, bool has_given_fluxes) {
    for (const auto& [faces, fate] : fates.of)
      if (fate.has_no_solution && has_given_fluxes)
        add("no-solution", faces,
            fmt::format(
                "all light that meets {} is reflected, or sent back by a given net flux, and none gets out, yet "
                "heat is supplied or taken there: there are no temperatures for it",
                names_text(scene_, surfaces_of_elements(matrix_, faces))),
            "give one of them a temperature, or open a way to the sky");
      else if (fate.has_no_solution)
        add("no-solution", faces,
            fmt::format("all light that meets {} is reflected and none gets out, yet some is emitted there: it would "
                        "grow without end",
                        names_text(scene_, surfaces_of_elements(matrix_, faces))),
            "give one of them a reflectivity below 1, or open a way to the sky");
  }

  // What is computed. Where numbers are so moderate that doubles can tell it, nothing is solved for it.
  void tell_light(const LightFates& fates, const RadiositySources& sources,
                  const std::function<void(double)>& progress) {
    if (fates.rows_are_closed && is_moderate(sources) && sources.withdrawn.empty() && !sources.has_bands) return;
    try {
      const RadiositySolution solution = solve_sources(matrix_, scene_.materials, sources, {.progress = progress});
      tell_beyond(rows_where([&](std::uint32_t i) { return !is_finite(solution, i); }), "the light of",
                  "choose another unit of light, or let more of it be absorbed");
      if (errors_.empty()) tell_power(solution);
      if (errors_.empty()) tell(temperature_beyond_doubles(matrix_, scene_.materials, solution));
      if (errors_.empty()) tell_cold(solution);
    } catch (const RequestError& error) {
      const auto least = std::min_element(fates.of.begin(), fates.of.end(),
                                          [](auto& a, auto& b) { return a.second.loss < b.second.loss; });
      add(fates.rows_are_closed ? "beyond-doubles" : "no-solution", least == fates.of.end() ? Faces{} : least->first,
          error.what(), "give one of them a smaller reflectivity, or open a wider way out");
    }
  }

  bool has_errors() const { return !errors_.empty(); }
  std::vector<LightError> take() { return std::move(errors_); }

 private:
  void tell_power(const RadiositySolution& solution) {
    try {
      require_doubles(matrix_, scene_.sky_emission, solution);
    } catch (const RequestError& error) {
      add("beyond-doubles", rows(), error.what(), "choose another unit of length or of light");
    }
  }

  void tell(const std::optional<BeyondDoubles>& beyond) {
    if (beyond) add("beyond-doubles", {*beyond->element}, beyond->text, "choose another unit of light");
  }

  void tell_cold(const RadiositySolution& solution) {
    if (const auto i = first_without_emissivity(matrix_, scene_.materials, solution))
      add("no-temperature", {*i}, text_without_emissivity(matrix_.elements()[*i], scene_.materials),
          "give its material an emissivity");
    if (const auto cold = coldest_below_zero(matrix_, scene_.materials, solution))
      add("no-temperature", {cold->element}, text_of(*cold, matrix_, scene_.materials),
          "take less heat from it, or let more of its surroundings be warm");
  }

  void tell_beyond(const Faces& faces, const std::string& what, const char* suggestion) {
    if (faces.empty()) return;
    add("beyond-doubles", faces,
        fmt::format("{} {} is beyond the range of doubles", what,
                    names_text(scene_, surfaces_of_elements(matrix_, faces))),
        suggestion);
  }

  void add(const char* kind, const Faces& faces, std::string message, const char* suggestion) {
    errors_.push_back({kind, surfaces_of_elements(matrix_, faces), std::move(message), suggestion});
  }

  const Material& material_of(std::uint32_t face) const { return scene_.materials[*matrix_.elements()[face].material]; }

  template <class Is>
  Faces rows_where(const Is& is) const {
    Faces faces;
    for (std::uint32_t i = 0; i < matrix_.size(); ++i)
      if (matrix_.has_row(i) && is(i)) faces.push_back(i);
    return faces;
  }
  Faces rows() const {
    return rows_where([](std::uint32_t) { return true; });
  }

  // Light that is sent out arrives where it is absorbed by way of exchange areas and absorbing areas, each of which
  // adds to radiosity the power over its area: far from the ends of the range all of it can be told.
  bool is_moderate(const RadiositySources& sources) const {
    double least = std::numeric_limits<double>::infinity(), most = largest(scene_.sky_emission);
    const auto meet = [&](double value) {
      least = std::min(least, value);
      most = std::max(most, value);
    };
    for (const std::uint32_t i : rows()) {
      const Material& material = material_of(i);
      const double area = matrix_.elements()[i].area.value;
      most = std::max(most, std::abs(largest(material.emission)));
      most = std::max(most, std::abs(to_double(material.power_above_radiosity())));
      if (!sources.direct_irradiance.empty())
        for (int c = 0; c < 3; ++c) most = std::max(most, to_double(sources.direct_irradiance[i][c].upper));
      for (const Rational& rho : material.reflectivity.value)
        if (rho != 1) meet(area * to_double(1 - rho));
      for (const FactorEntry& entry : matrix_.row(i)) meet(area * entry.factor.value);
    }
    return least > 1 / kModerate && most < kModerate;
  }

  const SceneTable& scene_;
  const ExchangeMatrix& matrix_;
  std::vector<LightError> errors_;
};

}  // namespace

std::vector<std::uint32_t> surfaces_of_elements(const ExchangeMatrix& matrix, std::span<const std::uint32_t> elements) {
  std::vector<std::uint32_t> surfaces;
  for (const std::uint32_t element : elements)
    if (surfaces.empty() || surfaces.back() != matrix.elements()[element].surface)
      surfaces.push_back(matrix.elements()[element].surface);
  return surfaces;
}

LightError refused_light(const SceneTable& scene, std::string message) {
  if (untold_lamp(scene).empty()) return {"beyond-doubles", {}, std::move(message), kOtherLight};
  return {"unknown-unit", {}, std::move(message), fmt::format("give lengths in {}", kKnownUnits)};
}

std::vector<LightError> size_errors(const SceneTable& scene, const ExchangeMatrix& matrix, const char* size) {
  ErrorTeller teller(scene, matrix);
  teller.tell_sizes(size);
  return teller.take();
}

std::vector<LightError> light_errors(const SceneTable& scene, const ExchangeMatrix& matrix,
                                     const RadiositySources& sources, const LightFates& fates, const char* size,
                                     const std::function<void(double)>& progress) {
  ErrorTeller teller(scene, matrix);
  if (fates.are_real_rows_closed) teller.tell_mirrors(fates, sources.has_given_fluxes);
  if (!teller.has_errors()) teller.tell_sizes(size);
  if (!teller.has_errors()) teller.tell_light(fates, sources, progress);
  return teller.take();
}

}  // namespace hottel
