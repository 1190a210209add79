// Radiosities and the report of a solution, as files.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/exchange/exchange_2.h"
#include "solver/plan.h"
#include "solver/system/radiosity.h"

namespace hottel {

// `face,element,channel,area,emission,reflectivity,radiosity,lower,upper,irradiance,net`: one line for each element
// with a material and each channel. Shortest decimals that read back to the same double.
void write_radiosity_csv(const Scene2& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution,
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
  std::map<std::string, double> seconds{};  // of stages that ran
  std::string solver{};
  double picture_scale = 1;                        // what a value was multiplied by before the tone curve
  std::optional<double> illumination_max_error{};  // of the averages over cells, where asked for
};

// Returns the report as one JSON object (the contract's report.json), and as text for people.
std::string report_json(const SolveReport& report);
std::string report_text(const SolveReport& report);

}  // namespace hottel
