// Radiosities and the report of a solution, as files.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "solver/plan.h"
#include "solver/radiosity/net_flux.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {

// `face,element,channel,area,emission,reflectivity,radiosity,lower,upper,irradiance,net`: one line for each element
// with a material and each channel. Shortest decimals that read back to the same double.
void write_radiosity_csv(const Scene2& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution,
                         const std::function<void(std::string_view)>& sink);

// `per,name,channel,area,net,lower,upper`: net flux in W (in the plane W per metre of depth) with proven bounds,
// positive where more leaves than arrives (net_flux.h). First a line for each face and channel, then for each group:
// polyline or edge of its own, fronts and backs by themselves. The sky is last in both; each half sums to 0.
struct NetFluxes {
  std::vector<NetFlux> faces, groups;

  NetFluxes(const Scene2& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution);
};
void write_flux_csv(const NetFluxes& fluxes, const std::vector<std::string>& channel_names,
                    const std::function<void(std::string_view)>& sink);

// Returns a plan as text for people, and as the head of a report.
std::string plan_text(const Plan& plan);
std::string plan_json(const std::string& scene, const Plan& plan);

// Everything that is said about one run of `solve`.
struct SolveReport {
  std::string scene;
  const Plan* plan = nullptr;
  const ExchangeReport* exchange = nullptr;
  const RadiositySolution* solution = nullptr;
  const NetFluxes* fluxes = nullptr;
  std::map<std::string, double> seconds{};         // of stages that ran, and of no others
  std::optional<double> picture_scale{};           // what a value was multiplied by before the tone curve
  std::optional<double> illumination_max_error{};  // of the averages over cells, where asked for
  std::vector<std::string> warnings{};             // first of the notes of the JSON object; not in the text
};

// Returns the report as one JSON object (the contract's report.json), and as text for people.
std::string report_json(const SolveReport& report);
std::string report_text(const SolveReport& report);

}  // namespace hottel
