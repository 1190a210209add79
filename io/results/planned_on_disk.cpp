#include "io/results/planned_on_disk.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "geometry/memory_text.h"

namespace hottel {

std::string on_disk_text(const PlannedOnDisk& planned) {
  const auto line = [](const char* name, const std::string& number, const std::string& what) {
    return fmt::format("  {:<24}{:<12}{}\n", name, number, what);
  };
  const std::string free =
      planned.free ? "; " + short_bytes(static_cast<double>(*planned.free)) + " are free there" : std::string();
  return fmt::format("solve {} {}\n", planned.option, planned.folder) +
         line("memory", short_bytes(planned.memory_bytes), "at the most, the program and the scene included") +
         line("disk", short_bytes(planned.disk_bytes), fmt::format("for {:.2g} visible pairs{}", planned.pairs, free)) +
         line("computed", fmt::format("{:.2g} s", planned.seconds), "all that is asked for") +
         (planned.fits() ? "" : "the disk has no room for it\n");
}

nlohmann::ordered_json on_disk_object(const PlannedOnDisk& planned) {
  nlohmann::ordered_json json = {
      {"folder", planned.folder},       {"pairs", planned.pairs},     {"seconds_estimate", planned.seconds},
      {"memory", planned.memory_bytes}, {"disk", planned.disk_bytes}, {"disk_free", nullptr}};
  if (planned.free) json["disk_free"] = *planned.free;
  json["fits"] = planned.fits();
  return json;
}

const char* on_disk_key(const PlannedOnDisk& planned) {
  return planned.option == "--checkpoint" ? "checkpoint" : "out_of_core";
}

}  // namespace hottel
