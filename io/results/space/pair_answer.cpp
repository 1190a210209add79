#include "io/results/space/pair_answer.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "geometry/scene_names.h"
#include "geometry/space/scene/scene.h"
#include "io/results/space/exact_point.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

const char* to_string(PairVisibility3 sight) {
  switch (sight) {
    case PairVisibility3::kHidden:
      return "hidden";
    case PairVisibility3::kClear:
      return "clear";
    case PairVisibility3::kMixed:
      return "mixed";
  }
  return "";
}

const char* to_string(StretchRole3 role) {
  switch (role) {
    case StretchRole3::kSource:
      return "source";
    case StretchRole3::kFoot:
      return "foot";
    case StretchRole3::kOutline:
      return "outline";
  }
  return "";
}

// "one polygon", "17 polygons".
std::string polygons(std::size_t count) { return count == 1 ? "one polygon" : fmt::format("{} polygons", count); }

// Why a pair was settled as it was, in words for people.
std::string reason(const Scene3& scene, const PairReport3& report) {
  if (!report.hiders.empty()) {
    const std::string name = "'" + scene.surfaces[report.hiders.front()].name + "'";
    const std::size_t more = report.hiders.size() - 1;
    if (more == 0) return name + " hides all of each from the other";
    return fmt::format("{} and {} more in its plane hide all of each from the other", name, more);
  }
  if (!report.is_facing()) return "no part of one is in front of the other";
  switch (report.sight) {
    case PairVisibility3::kHidden:
      return "nothing of the sky is seen";
    case PairVisibility3::kClear:
      return "nothing can stand between them";
    case PairVisibility3::kMixed:
      break;
  }
  const std::string between = polygons(report.between.size()) + " may stand between";
  if (report.exchange.bounds.upper == 0) return between + ", and hide everything";
  return between + (report.is_whole ? ", and hide nothing" : "");
}

Json json_of(const Estimate3& number) {
  return {{"value", number.value}, {"lower", number.bounds.lower}, {"upper", number.bounds.upper}};
}

Json names_of(const Scene3& scene, const std::vector<std::uint32_t>& surfaces) {
  Json names = Json::array();
  for (const std::uint32_t s : surfaces) names.push_back(scene.surfaces[s].name);
  return names;
}

Json json_of(const Scene3& scene, const PairReport3::Stretch& stretch) {
  Json pieces = Json::array();
  for (const PairDetails3::Piece& piece : stretch.pieces)
    pieces.push_back({{"t", {piece.low, piece.high}}, {"arcs", piece.arcs}, {"exchange", piece.measure}});
  Json json{{"role", to_string(stretch.role)}, {"of", nullptr}};
  if (stretch.is_on_from) json["of"] = "from";
  if (stretch.is_on_to) json["of"] = "to";
  json["ends"] = {exact_point(stretch.from), exact_point(stretch.to)};
  json["at"] = names_of(scene, stretch.surfaces);
  json["relied"] = stretch.relied;
  json["exchange"] = stretch.measure;
  json["pieces"] = std::move(pieces);
  return json;
}

// An answer while it is made.
struct Draft {
  Json json;
  std::string text;

  void add(const char* key, const std::string& label, const Estimate3& number) {
    json[key] = json_of(number);
    text += fmt::format("  {:<28} {:<24} within {} .. {}\n", label, shortest(number.value),
                        shortest(number.bounds.lower), shortest(number.bounds.upper));
  }
  void add_sizes(const std::string& from, const std::string& to, const PairReport3& report) {
    const auto of_face = [this](const char* key, const std::string& label, const std::optional<Estimate3>& number) {
      json[key] = nullptr;
      if (number) add(key, label, *number);
    };
    const auto area = [](const std::optional<Rounded>& rounded) {
      return rounded ? std::optional(Estimate3{rounded->value, 0, rounded->enclosure()}) : std::nullopt;
    };
    of_face("area_from", "A of '" + from + "'", area(report.area_from));
    of_face("area_to", "A of '" + to + "'", area(report.area_to));
    of_face("factor", "F from '" + from + "'", report.factor_from);
    of_face("factor_back", "F from '" + to + "'", report.factor_to);
  }
};

std::string counts_text(const PairReport3& report) {
  if (report.stretches.empty())
    return report.looked_at == 0
               ? ""
               : fmt::format("along none of {} stretches of edges is anything seen ({} points looked around from)\n",
                             report.looked_at, report.maps);
  return fmt::format(
      "S as a sum of integrals along edges: {}, with an estimated error of {}; another sum, 0 in theory, is {}, where "
      "up to "
      "{} passes{}\n"
      "{} stretches of edges, something seen along {} of them, in {} pieces; {} points looked around from, {} summed\n",
      shortest(report.along_edges.value), shortest(report.along_edges.error), shortest(report.residual),
      shortest(report.residual_bound), report.problem.empty() ? "" : ": " + report.problem, report.looked_at,
      report.stretches.size(), report.pieces, report.maps, report.nodes);
}

void add_stretches(const Scene3& scene, const PairReport3& report, Json& json) {
  json["counts"] = {{"stretches", report.looked_at},
                    {"seen", report.stretches.size()},
                    {"pieces", report.pieces},
                    {"maps", report.maps},
                    {"nodes", report.nodes}};
  json["tiers"] = {{"filter", report.signs.by_tier[0]},
                   {"combinatorial", report.signs.by_tier[1]},
                   {"exact", report.signs.by_tier[2]}};
  json["along_edges"] = nullptr;
  json["residual"] = nullptr;
  if (!report.stretches.empty()) {
    json["along_edges"] = {{"value", report.along_edges.value}, {"error", report.along_edges.error}};
    if (!report.problem.empty()) json["along_edges"]["problem"] = report.problem;
    json["residual"] = {{"value", report.residual}, {"bound", report.residual_bound}};
  }
  json["stretches"] = Json::array();
  for (const PairReport3::Stretch& stretch : report.stretches) json["stretches"].push_back(json_of(scene, stretch));
}

}  // namespace

VisibilityAnswer pair_answer(const Scene3& scene, const std::string& from, const std::string& to,
                             const PairReport3& report, const std::string& form) {
  const char* const guarantee = hottel::to_string(report.is_enclosed() ? Guarantee::kEnclosed : Guarantee::kEstimated);
  const std::string why = reason(scene, report);
  Draft answer;
  answer.json["from"] = from;
  answer.json["to"] = to;
  answer.text = fmt::format("'{}' and '{}'\n", from, to);
  answer.add("exchange", "S, direct exchange area", report.exchange);
  answer.json["exchange"]["error"] = report.exchange.error;
  answer.json["exchange"]["guarantee"] = guarantee;
  answer.json["exchange"]["exact"] = form.empty() ? Json() : Json(form);
  if (!form.empty()) answer.text += fmt::format("  S = {}\n", form);
  answer.add("unobstructed", "S0, everything else removed", report.unobstructed);
  answer.json["visibility"] = nullptr;
  if (report.visibility) answer.add("visibility", "Vis = S / S0", *report.visibility);
  answer.add_sizes(from, to, report);
  answer.json["tolerance"] = report.tolerance;
  answer.json["settled"] = to_string(report.sight);
  answer.json["reason"] = why;
  answer.json["between"] = names_of(scene, report.between);
  answer.text += fmt::format("S is {} within {} of the smaller area; its estimated error is {}\n", guarantee,
                             shortest(report.tolerance), shortest(report.exchange.error));
  answer.text += fmt::format("settled as {}: {}\n", to_string(report.sight), why) + counts_text(report);
  add_stretches(scene, report, answer.json);
  return {answer.json.dump(2) + "\n", answer.text};
}

}  // namespace hottel
