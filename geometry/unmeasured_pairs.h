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

}  // namespace hottel
