#include "io/results/plane/check_report.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "geometry/plane/check/wording.h"
#include "io/results/factor_files.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

int line_of(const Scene2& scene, const Finding2& finding) {
  return finding.surfaces.empty() ? 0 : scene.surfaces[finding.surfaces.front()].line;
}

std::string count_text(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

void add_repair(const RepairReport& repair, Json& report) {
  report["repairs"] = Json::array();
  for (const RepairStep2& step : *repair.steps)
    report["repairs"].push_back({{"kind", step.kind}, {"surface", step.surface}, {"message", step.message}});
  report["changes"] = nullptr;
  if (repair.changes == nullptr) return;
  report["changes"] = Json::array();
  const auto number = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
  for (const FactorChange& change : *repair.changes)
    report["changes"].push_back(
        {{"from", change.from}, {"to", change.to}, {"before", number(change.before)}, {"after", number(change.after)}});
}

}  // namespace

std::string check_json(const Scene2& scene, const Findings2& findings, const RepairReport* repair) {
  auto list = Json::array();
  for (const Finding2& finding : findings) {
    Json entry;
    entry["severity"] = to_string(finding.severity);
    entry["kind"] = finding.kind;
    entry["surfaces"] = Json::array();
    for (const std::uint32_t s : finding.surfaces) entry["surfaces"].push_back(scene.surfaces[s].name);
    entry["at"] = nullptr;
    if (finding.at) entry["at"] = {to_double(finding.at->x), to_double(finding.at->y)};
    entry["line"] = nullptr;
    if (const int line = line_of(scene, finding); line > 0) entry["line"] = line;
    entry["message"] = finding.message;
    entry["suggestion"] = finding.suggestion;
    list.push_back(std::move(entry));
  }
  Json report;
  report["findings"] = std::move(list);
  if (repair != nullptr) add_repair(*repair, report);
  return report.dump(2) + "\n";
}

std::string findings_text(const Scene2& scene, const Findings2& findings, std::size_t most) {
  std::string text;
  std::map<std::string, std::size_t> of_kind;
  for (const Finding2& finding : findings) {
    if (++of_kind[finding.kind] > most) continue;
    const int line = line_of(scene, finding);
    text += fmt::format("{}{}: {}: {}{}: {}\n", scene.file, line > 0 ? fmt::format(":{}", line) : "",
                        to_string(finding.severity), finding.kind, finding.at ? " at " + place_text(*finding.at) : "",
                        finding.message);
    if (!finding.suggestion.empty()) text += "  " + finding.suggestion + "\n";
  }
  for (const auto& [kind, number] : of_kind)
    if (number > most) text += fmt::format("and {} more of {} (--json has them all)\n", number - most, kind);
  return text;
}

std::string check_text(const Scene2& scene, const Findings2& findings, std::size_t most) {
  std::size_t count[3] = {0, 0, 0};
  for (const Finding2& finding : findings) ++count[static_cast<int>(finding.severity)];
  return findings_text(scene, findings, most) + fmt::format("{}, {}, {}\n", count_text(count[0], "error"),
                                                            count_text(count[1], "warning"),
                                                            count_text(count[2], "note"));
}

std::vector<std::string> finding_notes(const Findings2& findings) {
  std::vector<std::string> notes;
  for (const Finding2& finding : findings)
    notes.push_back(fmt::format("{}: {}: {}{}", to_string(finding.severity), finding.kind, finding.message,
                                finding.suggestion.empty() ? "" : " (" + finding.suggestion + ")"));
  return notes;
}

std::string repair_text(const Scene2& scene, const RepairReport& repair) {
  std::string text;
  for (const RepairStep2& step : *repair.steps) {
    const auto surface = scene.find(step.surface);
    const int line = surface ? scene.surfaces[*surface].line : 0;
    text +=
        fmt::format("{}{}: {}: {}\n", scene.file, line > 0 ? fmt::format(":{}", line) : "", step.kind, step.message);
  }
  if (repair.steps->empty()) text += scene.file + ": there was nothing to repair\n";
  if (repair.changes == nullptr) return text;
  text += "from,to,before,after\n";
  const auto number = [](const std::optional<double>& value) { return value ? shortest(*value) : std::string(); };
  for (const FactorChange& change : *repair.changes)
    text += fmt::format("{},{},{},{}\n", csv_field(change.from), csv_field(change.to), number(change.before),
                        number(change.after));
  return text;
}

}  // namespace hottel
