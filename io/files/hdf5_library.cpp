#include "io/files/hdf5_library.h"

#include <string>

#include "kernel/support/failure.h"
#include "kernel/support/loaded_library.h"

namespace hottel {
namespace {

Hdf5 load() try {
  const LoadedLibrary library(HOTTEL_HDF5_LIBRARY);
  Hdf5 result{};
#define HOTTEL_FIND(name) library.find("H5" #name, result.name);
  HOTTEL_EACH_OF_HDF5(HOTTEL_FIND)
#undef HOTTEL_FIND
  result.dont_atexit();  // what could not be written would be tried once more when the program ends
  result.open();
  return result;
} catch (const NotLoaded& reason) {
  throw RequestError(std::string("HDF5 could not be loaded (") + reason.what() +
                     "): files of view factors that end in .h5 need it; all other files need none");
}

}  // namespace

const Hdf5& hdf5() {
  static const Hdf5 loaded = load();
  return loaded;
}

}  // namespace hottel
