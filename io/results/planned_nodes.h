// What several nodes of a cluster would take, as text and JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "solver/plan_nodes.h"

namespace hottel {

// A line each, under a heading that calls it a model.
std::string nodes_text(const PlannedNodes& planned);
nlohmann::ordered_json nodes_object(const PlannedNodes& planned);
// The object of plan_json() with the nodes at its end.
std::string with_nodes(const std::string& plan_json, const PlannedNodes& planned);

}  // namespace hottel
