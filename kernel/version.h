// The version of the library and of the program: the only place where it stands (CMake reads it from here).
#pragma once

namespace hottel {

inline constexpr const char* kVersion = "0.1.0";

}  // namespace hottel
