// Failures that name the file they are about.
#pragma once

#include <string>

#include "kernel/support/failure.h"

namespace hottel {

// Returns what `work` returns. A RequestError of it, which knows no files, is told with the file before it; where the
// file has no name, as it was. Other exceptions pass as they are.
template <class Work>
auto with_file_context(const std::string& file, const Work& work) {
  try {
    return work();
  } catch (const RequestError& error) {
    throw RequestError(file.empty() ? error.what() : file + ": " + error.what());
  }
}

}  // namespace hottel
