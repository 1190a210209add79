#include "io/results/divided_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "geometry/name.h"
#include "io/results/csv_field.h"
#include "kernel/rational.h"
#include "kernel/version.h"
#include "solver/compare/division_orders.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

std::string short_number(const std::optional<double>& value) {
  return value && !std::isnan(*value) ? fmt::format("{:.2g}", *value) : "-";
}

constexpr const char* kExact = "exact";
constexpr std::size_t kMeansInText = 6, kNamesInText = 3;

std::string mean_name(const DividedMean& mean) {
  return mean.channel == "all" ? mean.face : mean.face + " (" + mean.channel + ")";
}

// A mean with what all its divisions tell.
struct ToldMean {
  const DividedMean* mean;
  DivisionOrders orders;

  double left() const { return orders.extrapolated ? std::abs(*orders.extrapolated - mean->means.back()) : 0; }
};

std::string mean_line(const ToldMean& told, std::size_t widest) {
  const auto& [mean, orders] = told;
  std::string text =
      fmt::format("  {:<{}} {:.8g} at {}", mean_name(*mean), widest, mean->means.back(), mean->divisions.back());
  if (orders.extrapolated) text += fmt::format(", extrapolated {:.8g}", *orders.extrapolated);
  std::string list;
  for (const std::optional<double>& order : orders.orders)
    if (order) list += fmt::format(" {:.2f}", *order);
  if (!list.empty()) text += ", orders" + list;
  const std::string convergence = convergence_text(orders);
  return text + (convergence.empty() ? "" : ": " + convergence) + "\n";
}

// The means of the faces by exact factors, those first that are furthest from what they are extrapolated to.
std::string means_text(std::span<const DividedMean> means) {
  std::vector<ToldMean> told;
  for (const DividedMean& mean : means)
    if (mean.method == kExact && mean.means.size() > 1)
      told.push_back({&mean, division_orders(mean.divisions, mean.means, mean.resolution)});
  if (told.empty()) return "";
  if (std::ranges::all_of(told, [](const ToldMean& t) { return t.mean->means.size() < 3; }))
    return "orders of convergence need three divisions\n";
  std::ranges::stable_sort(told, [](const ToldMean& a, const ToldMean& b) { return a.left() > b.left(); });
  const std::size_t shown = std::min(told.size(), kMeansInText);
  std::size_t widest = 0;
  for (std::size_t k = 0; k < shown; ++k) widest = std::max(widest, mean_name(*told[k].mean).size());
  std::string text = "mean radiosities of faces by exact factors:\n";
  for (std::size_t k = 0; k < shown; ++k) text += mean_line(told[k], widest);
  if (shown < told.size()) text += fmt::format("  and {} more in divide_faces.csv\n", told.size() - shown);
  std::vector<std::string> irregular;
  for (const ToldMean& each : told)
    if (is_irregular(each.orders.convergence)) irregular.push_back(mean_name(*each.mean));
  if (irregular.empty()) return text;
  text += fmt::format("orders are irregular for {} of {}:", irregular.size(), told.size());
  for (std::size_t k = 0; k < std::min(irregular.size(), kNamesInText); ++k)
    text += (k == 0 ? " " : ", ") + quoted_name(irregular[k]);
  if (irregular.size() > kNamesInText) text += fmt::format(" and {} more", irregular.size() - kNamesInText);
  return text + "; their extrapolated values are not to be relied on\n";
}

}  // namespace

std::string divide_csv(std::span<const DividedResult> results) {
  std::string text =
      "divide,elements,method,guarantee,seconds,max_error,rms_error,closure,max_radiosity_error,face_radiosity_error,"
      "face_radiosity_change,order\n";
  for (const auto& [divide, each, change, order] : results)
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", divide, each.elements, csv_field(each.info.name),
                    to_string(each.info.guarantee), csv_number(each.timing.median), csv_number(each.errors.max),
                    csv_number(each.errors.rms), csv_number(each.errors.closure), csv_number(each.max_radiosity_error),
                    csv_number(each.face_radiosity_error), csv_number(change), csv_number(order));
  return text;
}

std::string divide_faces_csv(std::span<const DividedMean> means) {
  std::string text = "method,face,channel,divide,mean,order,extrapolated,convergence\n";
  for (const DividedMean& mean : means)
    for (std::size_t k = 0; k < mean.means.size(); ++k) {
      const DivisionOrders told =
          division_orders(std::span(mean.divisions).first(k + 1), std::span(mean.means).first(k + 1), mean.resolution);
      text += fmt::format("{},{},{},{},{},{},{},{}\n", csv_field(mean.method), csv_field(mean.face), mean.channel,
                          mean.divisions[k], shortest(mean.means[k]), csv_number(told.orders[k]),
                          csv_number(told.extrapolated), convergence_text(told));
    }
  return text;
}

std::string divided_json(const std::string& scene, std::span<const DividedResult> results,
                         std::span<const DividedMean> means) {
  Json json;
  json["hottel"] = 1;
  json["version"] = kVersion;
  json["scene"] = scene;
  json["results"] = Json::array();
  const auto optional = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  for (const auto& [divide, each, change, order] : results)
    json["results"].push_back({{"divide", divide},
                               {"elements", each.elements},
                               {"method", each.info.name},
                               {"guarantee", to_string(each.info.guarantee)},
                               {"seconds", each.timing.median},
                               {"max_error", each.errors.max},
                               {"rms_error", each.errors.rms},
                               {"closure", each.errors.closure},
                               {"max_radiosity_error", optional(each.max_radiosity_error)},
                               {"face_radiosity_error", optional(each.face_radiosity_error)},
                               {"face_radiosity_change", optional(change)},
                               {"order", optional(order)},
                               {"notes", each.notes}});
  json["faces"] = Json::array();
  for (const DividedMean& mean : means) {
    const DivisionOrders told = division_orders(mean.divisions, mean.means, mean.resolution);
    Json orders = Json::array();
    for (const std::optional<double>& order : told.orders) orders.push_back(optional(order));
    const std::string convergence = convergence_text(told);
    json["faces"].push_back({{"method", mean.method},
                             {"face", mean.face},
                             {"channel", mean.channel},
                             {"divisions", mean.divisions},
                             {"means", mean.means},
                             {"orders", orders},
                             {"extrapolated", optional(told.extrapolated)},
                             {"convergence", convergence.empty() ? Json() : Json(convergence)}});
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string divided_text(std::span<const DividedResult> results, std::span<const DividedMean> means) {
  std::size_t widest = 6;
  for (const DividedResult& each : results) widest = std::max(widest, each.result.info.name.size());
  std::string text =
      fmt::format("{:>6} {:>9}  {:<{}} {:>10} {:>10} {:>10} {:>10} {:>10} {:>6}\n", "divide", "elements", "method",
                  widest, "seconds", "max error", "rms error", "radiosity", "of faces", "order");
  for (std::size_t k = 0; k < results.size(); ++k) {
    const auto& [divide, each, change, order] = results[k];
    text += fmt::format("{:>6} {:>9}  {:<{}} {:>10} {:>10} {:>10} {:>10} {:>10} {:>6}\n", divide, each.elements,
                        each.info.name, widest, short_number(each.timing.median), short_number(each.errors.max),
                        short_number(each.errors.rms), short_number(each.max_radiosity_error),
                        short_number(each.face_radiosity_error), order ? fmt::format("{:.1f}", *order) : "-");
  }
  return text + means_text(means);
}

}  // namespace hottel
