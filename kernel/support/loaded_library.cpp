#include "kernel/support/loaded_library.h"

#include <dlfcn.h>

#include <utility>

namespace hottel {

LoadedLibrary::LoadedLibrary(std::string name)
    : name_(std::move(name)), handle_(dlopen(name_.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (handle_ == nullptr) throw NotLoaded(dlerror());
}

void* LoadedLibrary::address(const char* symbol) const {
  void* const found = dlsym(handle_, symbol);
  if (found == nullptr) throw NotLoaded(name_ + " has no " + symbol);
  return found;
}

}  // namespace hottel
