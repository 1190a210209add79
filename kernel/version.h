// The version of the library and of the program, MAJOR.MINOR.PATCH. It stands nowhere else: CMake reads it from here.
#pragma once

namespace hottel {

inline constexpr const char* kVersion = "0.2.0";

}  // namespace hottel
