// Names of faces in the sidecar that hottel writes beside a NumPy array.
#pragma once

#include <string>
#include <vector>

namespace hottel {

// Returns the member `names` of FILE.json. Empty where there is no such file, or it is no object with
// an array of texts of that name: it may be about something else. COST: reads the file.
std::vector<std::string> sidecar_names(const std::string& sidecar);

}  // namespace hottel
