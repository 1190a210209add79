#include "io/results/finding_report.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/results/csv_field.h"
#include "kernel/rational.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

std::string count_text(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

void add_repair(const RepairReport& repair, Json& report) {
  report["repairs"] = Json::array();
  for (const RepairStep& step : *repair.steps)
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

std::string check_json(const std::vector<ReportedFinding>& findings, const RepairReport* repair) {
  auto list = Json::array();
  for (const ReportedFinding& finding : findings) {
    Json entry;
    entry["severity"] = to_string(finding.severity);
    entry["kind"] = finding.kind;
    entry["surfaces"] = Json::array();
    for (const std::string& name : finding.surfaces) entry["surfaces"].push_back(name);
    entry["at"] = nullptr;
    if (!finding.at.empty()) entry["at"] = finding.at;
    if (finding.is_in_mesh) entry["file"] = finding.where.file;
    entry["line"] = nullptr;
    if (finding.where.line > 0) entry["line"] = finding.where.line;
    entry["message"] = finding.message;
    entry["suggestion"] = finding.suggestion;
    list.push_back(std::move(entry));
  }
  Json report;
  report["findings"] = std::move(list);
  if (repair != nullptr) add_repair(*repair, report);
  return report.dump(2) + "\n";
}

std::string findings_text(const std::vector<ReportedFinding>& findings, std::size_t most) {
  std::string text;
  std::map<std::string, std::size_t> of_kind;
  for (const ReportedFinding& finding : findings) {
    if (++of_kind[finding.kind] > most) continue;
    text += fmt::format("{}: {}: {}{}: {}\n", finding.where.text(), to_string(finding.severity), finding.kind,
                        finding.at.empty() ? "" : " at " + finding.place, finding.message);
    if (!finding.suggestion.empty()) text += "  " + finding.suggestion + "\n";
  }
  for (const auto& [kind, number] : of_kind)
    if (number > most) text += fmt::format("and {} more of {} (--json has them all)\n", number - most, kind);
  return text;
}

std::string finding_note(Severity severity, const std::string& kind, const std::string& message,
                         const std::string& suggestion) {
  return fmt::format("{}: {}: {}{}", to_string(severity), kind, message,
                     suggestion.empty() ? "" : " (" + suggestion + ")");
}

std::string check_text(const std::vector<ReportedFinding>& findings, std::size_t most) {
  std::size_t count[3] = {0, 0, 0};
  for (const ReportedFinding& finding : findings) ++count[static_cast<int>(finding.severity)];
  return findings_text(findings, most) + fmt::format("{}, {}, {}\n", count_text(count[0], "error"),
                                                     count_text(count[1], "warning"), count_text(count[2], "note"));
}

std::string repair_text(const SceneTable& scene, const RepairReport& repair) {
  std::string text;
  for (const RepairStep& step : *repair.steps) {
    const auto surface = scene.find(step.surface);
    const FileLine where = surface ? place_of(scene, scene.surfaces[*surface]) : FileLine{scene.file};
    text += fmt::format("{}: {}: {}\n", where.text(), step.kind, step.message);
  }
  if (repair.steps->empty()) text += scene.file + ": nothing was repaired\n";
  const bool is_as_before = repair.changes == nullptr || (repair.changes->empty() && !is_anything_done(*repair.steps));
  if (is_as_before) return text;
  text += "from,to,before,after\n";
  const auto number = [](const std::optional<double>& value) { return value ? shortest(*value) : std::string(); };
  for (const FactorChange& change : *repair.changes)
    text += fmt::format("{},{},{},{}\n", csv_field(change.from), csv_field(change.to), number(change.before),
                        number(change.after));
  return text;
}

}  // namespace hottel
