// Stages with the inputs that they were made for: after an edit only what depends on it is computed anew.
//
//   struct Version {
//     StageNode<int, double> root;
//     Version(int number, const Version* before)
//         : root(node_of("root", number, member_of(before, &Version::root),
//                        [](int input, const StageProgress&) { return std::sqrt(input); })) {}
//   };
#pragma once

#include <memory>
#include <utility>

#include "kernel/support/stage.h"

namespace hottel {

template <class T>
using StagePtr = std::shared_ptr<Stage<T>>;

// A stage, and the input that it was made for. An input is compared with that of another version: what it holds and
// does not compare must not change the value.
template <class Input, class T>
struct StageNode {
  Input input;
  StagePtr<T> stage;
};

// Returns the node of an input: that of the version before where its input is equal, else a new one, whose value
// make(input, progress) computes. before: null where there is none.
template <class Input, class Make>
auto node_of(const char* name, Input input, const auto* before, Make make) {
  using T = decltype(make(std::declval<const Input&>(), std::declval<const StageProgress&>()));
  if (before != nullptr && before->input == input) return *before;
  auto stage =
      std::make_shared<Stage<T>>(name, [input, make](const StageProgress& progress) { return make(input, progress); });
  return StageNode<Input, T>{std::move(input), std::move(stage)};
}

// A member of the version before, where there is one.
template <class Version, class Member>
const Member* member_of(const Version* before, Member Version::*member) {
  return before != nullptr ? &(before->*member) : nullptr;
}

}  // namespace hottel
