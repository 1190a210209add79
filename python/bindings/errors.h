// Failures of the library as exceptions of Python.
#pragma once

#include <string>
#include <string_view>

namespace hottel::python {

// What scenes are called in messages that come from no file. InputErrors name no file then.
inline constexpr std::string_view kNoFile = "Scene";

// Returns the surface that a sentence is about, "edge 'wall' has length zero"; empty where it begins with none.
std::string surface_in(std::string_view reason);

}  // namespace hottel::python
