// Pairs whose view factors could not be measured.
#pragma once

#include <cstddef>
#include <string>

#include "kernel/support/failure.h"

namespace hottel {

// Some pairs could not be measured within the tolerance that was asked for; how many.
class UnmeasuredPairs : public RequestError {
 public:
  UnmeasuredPairs(const std::string& text, std::size_t count) : RequestError(text), count_(count) {}
  std::size_t count() const { return count_; }

 private:
  std::size_t count_;
};

// As with_file_context does, and these stay what they are.
template <class Work>
auto with_file_context_of_pairs(const std::string& file, const Work& work) {
  const auto named = [&](const char* text) { return file.empty() ? std::string(text) : file + ": " + text; };
  try {
    return work();
  } catch (const UnmeasuredPairs& error) {
    throw UnmeasuredPairs(named(error.what()), error.count());
  } catch (const RequestError& error) {
    throw RequestError(named(error.what()));
  }
}

}  // namespace hottel
