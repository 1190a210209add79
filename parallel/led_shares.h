// A job of which each helper keeps a share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "parallel/channel.h"
#include "parallel/leader.h"

namespace hottel {

// What rank 0 asks the helpers of again and again, all at once, each about its own share; it waits for all answers.
//
//   (1) an answer is of the last question; a helper that could not make anything of its share is not asked again
//   (2) after an exception within ask() nobody is asked any more
// One thread at a time.
class LedShares {
 public:
  // helpers: those that were given shares.
  LedShares(Leader& leader, std::uint64_t id, std::vector<int> helpers);
  ~LedShares();
  LedShares(const LedShares&) = delete;
  LedShares& operator=(const LedShares&) = delete;

  std::size_t helpers() const { return helpers_.size(); }
  // Calls meanwhile(), and take(k, answer) for each helper that answers, from 1 on. Throws what these throw, and
  // Interrupted.
  void ask(const std::string& question, const std::function<void()>& meanwhile,
           const std::function<void(std::size_t, std::string_view)>& take);

 private:
  enum class State : char { kPreparing, kReady, kAsked, kLost };

  void listen_while(State state, const std::function<void(std::size_t, std::string_view)>& take);

  Leader& leader_;
  const std::uint64_t id_;
  const std::vector<int> helpers_;
  std::vector<State> state_;
  bool is_given_up_ = false;
};

}  // namespace hottel
