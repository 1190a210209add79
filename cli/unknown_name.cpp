#include "cli/unknown_name.h"

#include "geometry/near_names.h"

namespace hottel {

UnknownName::UnknownName(const std::string& text, std::string_view name, std::span<const std::string> known)
    : UsageError(text), hints_(near_name_hints(name, known)) {}

}  // namespace hottel
