// A shared library that no program is linked with: it is loaded when something asks for it.
#pragma once

#include <stdexcept>
#include <string>
#include <type_traits>

namespace hottel {

// The library is not on this machine, or is not the one that is meant. what() is why, without a sentence around it.
class NotLoaded : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class LoadedLibrary {
 public:
  // Loads a library by the name that it has for programs linked with it: "libSDL2-2.0.so.0". It stays loaded, and its
  // names are not seen by others. Throws NotLoaded.
  explicit LoadedLibrary(std::string name);

  // Sets a pointer to the function or variable of that name. REQUIRES that it is of the type that the pointer tells.
  // Throws NotLoaded where there is none.
  template <class Pointer>
  void find(const char* symbol, Pointer& pointer) const {
    pointer = reinterpret_cast<std::remove_reference_t<Pointer>>(address(symbol));
  }

 private:
  void* address(const char* symbol) const;

  std::string name_;
  void* handle_;
};

}  // namespace hottel
