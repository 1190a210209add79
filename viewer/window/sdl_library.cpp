#include "viewer/window/sdl_library.h"

#include <dlfcn.h>

#include <string>
#include <type_traits>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr const char* kLibrary = "libSDL2-2.0.so.0";

[[noreturn]] void refuse(const std::string& reason) {
  throw RequestError("no window could be opened (" + reason + "): a window needs SDL 2.0.18 or later (Debian: " +
                     "libsdl2-2.0-0); --screenshot, --script and --record need none");
}

Sdl load() {
  void* const library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) refuse(dlerror());
  Sdl result{};
  const auto find = [&](const char* name, auto& function) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
    if (function == nullptr) refuse(std::string(kLibrary) + " has no " + name);
  };
#define HOTTEL_FIND(name) find("SDL_" #name, result.name);
  HOTTEL_EACH_OF_SDL(HOTTEL_FIND)
#undef HOTTEL_FIND
  SDL_version version{};
  result.GetVersion(&version);
  if (version.major == 2 && version.minor == 0 && version.patch < 18)
    refuse(std::string(kLibrary) + " is 2.0." + std::to_string(version.patch));
  return result;
}

}  // namespace

const Sdl& sdl() {
  static const Sdl loaded = load();
  return loaded;
}

}  // namespace hottel
