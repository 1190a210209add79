#include "io/results/planned_nodes.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "geometry/memory_text.h"
#include "kernel/support/counted.h"

namespace hottel {

std::string nodes_text(const PlannedNodes& planned) {
  const Nodes& nodes = planned.nodes;
  std::string text = "nodes, by a model: no more than one machine was ever measured\n";
  const auto add = [&text](const std::string& name, const std::string& value, const std::string& what) {
    text += fmt::format("  {:<24}{:<12}{}\n", name, value, what);
  };
  const auto about = [](double seconds) { return fmt::format("{:.2g} s", seconds); };
  const std::string cores = counted(static_cast<std::size_t>(nodes.cores), "core");
  if (planned.seconds) {
    add("one core", about(*planned.seconds_of_one_core), "alone");
    add("one node", about(*planned.seconds_of_one_node), "of " + cores);
    if (nodes.count > 1)
      add(counted(static_cast<std::size_t>(nodes.count), "node"), about(*planned.seconds),
          "of " + cores + " each, without the time on the network");
  }
  add("first node", short_bytes(planned.first_bytes), "of memory: pairs, matrix and radiosities are its alone");
  if (nodes.count > 1)
    add(nodes.count > 2 ? "each other node" : "the other node", short_bytes(planned.other_bytes),
        "of memory: elements, and rows while radiosities are solved for");
  add("allowed", short_bytes(nodes.memory), "of memory, of each node");
  add("least number of nodes", planned.fits() ? "1" : "none",
      planned.fits() ? "the memory of one suffices" : "the first needs more memory, however many others there are");
  return text;
}

nlohmann::ordered_json nodes_object(const PlannedNodes& planned) {
  nlohmann::ordered_json json{{"is_model", true},
                              {"nodes", planned.nodes.count},
                              {"cores", planned.nodes.cores},
                              {"seconds_estimate", nullptr}};
  if (planned.seconds)
    json["seconds_estimate"] = {{"one_core", *planned.seconds_of_one_core},
                                {"one_node", *planned.seconds_of_one_node},
                                {"all_nodes", *planned.seconds}};
  json["bytes"] = {{"first", planned.first_bytes}, {"other", planned.other_bytes}, {"allowed", planned.nodes.memory}};
  json["least_nodes"] = nullptr;
  if (planned.fits()) json["least_nodes"] = 1;
  return json;
}

std::string with_nodes(const std::string& plan_json, const PlannedNodes& planned) {
  auto json = nlohmann::ordered_json::parse(plan_json);
  json["nodes"] = nodes_object(planned);
  return json.dump(2) + "\n";
}

}  // namespace hottel
