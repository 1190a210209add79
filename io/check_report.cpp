#include "io/check_report.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "geometry/check/wording.h"

namespace hottel {
namespace {

int line_of(const Scene2& scene, const Finding& finding) {
  return finding.surfaces.empty() ? 0 : scene.surfaces[finding.surfaces.front()].line;
}

std::string count_text(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace

std::string check_json(const Scene2& scene, const Findings& findings) {
  auto list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings) {
    nlohmann::ordered_json entry;
    entry["severity"] = to_string(finding.severity);
    entry["kind"] = finding.kind;
    entry["surfaces"] = nlohmann::ordered_json::array();
    for (const std::uint32_t s : finding.surfaces) entry["surfaces"].push_back(scene.surfaces[s].name);
    entry["at"] = nullptr;
    if (finding.at) entry["at"] = {to_double(finding.at->x), to_double(finding.at->y)};
    entry["line"] = nullptr;
    if (const int line = line_of(scene, finding); line > 0) entry["line"] = line;
    entry["message"] = finding.message;
    entry["suggestion"] = finding.suggestion;
    list.push_back(std::move(entry));
  }
  nlohmann::ordered_json report;
  report["findings"] = std::move(list);
  return report.dump(2) + "\n";
}

std::string check_text(const Scene2& scene, const Findings& findings, std::size_t most) {
  std::string text;
  std::map<std::string, std::size_t> of_kind;
  std::size_t count[3] = {0, 0, 0};
  for (const Finding& finding : findings) {
    ++count[static_cast<int>(finding.severity)];
    if (++of_kind[finding.kind] > most) continue;
    const int line = line_of(scene, finding);
    text += fmt::format("{}{}: {}: {}{}: {}\n", scene.file, line > 0 ? fmt::format(":{}", line) : "",
                        to_string(finding.severity), finding.kind, finding.at ? " at " + place_text(*finding.at) : "",
                        finding.message);
    if (!finding.suggestion.empty()) text += "  " + finding.suggestion + "\n";
  }
  for (const auto& [kind, number] : of_kind)
    if (number > most) text += fmt::format("and {} more of {} (--json has them all)\n", number - most, kind);
  return text + fmt::format("{}, {}, {}\n", count_text(count[0], "error"), count_text(count[1], "warning"),
                            count_text(count[2], "note"));
}

}  // namespace hottel
