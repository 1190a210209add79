#include "viewer/window/sdl_library.h"

#include <string>

#include "kernel/support/failure.h"
#include "kernel/support/loaded_library.h"

namespace hottel {
namespace {

constexpr const char* kLibrary = "libSDL2-2.0.so.0";

Sdl load() try {
  const LoadedLibrary library(kLibrary);
  Sdl result{};
#define HOTTEL_FIND(name) library.find("SDL_" #name, result.name);
  HOTTEL_EACH_OF_SDL(HOTTEL_FIND)
#undef HOTTEL_FIND
  SDL_version version{};
  result.GetVersion(&version);
  if (version.major == 2 && version.minor == 0 && version.patch < 18)
    throw NotLoaded(std::string(kLibrary) + " is 2.0." + std::to_string(version.patch));
  return result;
} catch (const NotLoaded& reason) {
  throw RequestError(std::string("no window could be opened (") + reason.what() +
                     "): a window needs SDL 2.0.18 or later (Debian: libsdl2-2.0-0); --screenshot, --script and " +
                     "--record need none");
}

}  // namespace

const Sdl& sdl() {
  static const Sdl loaded = load();
  return loaded;
}

}  // namespace hottel
