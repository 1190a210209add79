#include "io/results/store_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "kernel/support/counted.h"

namespace hottel {
namespace {

std::string some(std::uint64_t count) { return count == 0 ? "none" : std::to_string(count); }

constexpr auto kReplaced = nlohmann::ordered_json::error_handler_t::replace;

}  // namespace

std::string store_text(const StoreReport& report) {
  const auto& [computed, read, damaged] = report.use;
  std::string text = fmt::format("store {}: {} read, {} computed", report.file,
                                 read == 0 ? "no pair" : counted(read, "pair"), some(computed));
  if (damaged > 0)
    text += fmt::format("; {} damaged, and as good as not there",
                        damaged == 1 ? "a record was" : counted(damaged, "record") + " were");
  return text;
}

std::string store_json(const StoreReport& report) {
  const nlohmann::ordered_json json = {{"file", report.file},
                                       {"read", report.use.read},
                                       {"computed", report.use.computed},
                                       {"damaged", report.use.damaged}};
  return json.dump(-1, ' ', false, kReplaced);
}

std::string contents_text(const std::string& file, const StoreContents& contents, bool checked) {
  std::string text;
  for (const StoredList& list : contents.lists)
    text += fmt::format("{}: {}, {}, {} bytes\n", list.about, counted(list.elements, "element"),
                        counted(list.records, "row"), list.bytes);
  text += fmt::format("{}: {}, {} bytes of {}", file, counted(contents.records, "row"), contents.bytes, contents.limit);
  if (checked && contents.damage.empty()) text += ", each as it was written";
  text += "\n";
  for (const std::string& damage : contents.damage) text += damage + "\n";
  return text;
}

std::string contents_json(const std::string& file, const StoreContents& contents, bool checked) {
  nlohmann::ordered_json json;
  json["hottel"] = 1;
  json["store"] = file;
  json["bytes"] = contents.bytes;
  json["limit"] = contents.limit;
  json["rows"] = contents.records;
  json["lists"] = nlohmann::ordered_json::array();
  for (const StoredList& list : contents.lists)
    json["lists"].push_back(
        {{"about", list.about}, {"elements", list.elements}, {"rows", list.records}, {"bytes", list.bytes}});
  json["checked"] = checked;
  json["damage"] = contents.damage;
  return json.dump(2, ' ', false, kReplaced) + "\n";
}

}  // namespace hottel
