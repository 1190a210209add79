// How readers refuse what they are given.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "kernel/support/failure.h"

namespace hottel {

// Returns the message with which read() refuses its input, of one line and with three hints at most; empty where it
// does not refuse it as bad input.
template <class Read>
std::string refusal_by(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    EXPECT_LE(error.hints().size(), 3u);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  return "";
}

}  // namespace hottel
