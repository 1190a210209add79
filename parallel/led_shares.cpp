#include "parallel/led_shares.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "parallel/message.h"
#include "parallel/words.h"

namespace hottel {

LedShares::LedShares(Leader& leader, std::uint64_t id, std::vector<int> helpers)
    : leader_(leader), id_(id), helpers_(std::move(helpers)), state_(helpers_.size(), State::kPreparing) {}

LedShares::~LedShares() {
  const std::lock_guard lock(leader_.together_);
  leader_.is_busy_ = false;
}

void LedShares::ask(const std::string& question, const std::function<void()>& meanwhile,
                    const std::function<void(std::size_t, std::string_view)>& take) {
  // Given up until all is heard: what is thrown on the way leaves answers behind that nobody waits for.
  if (std::exchange(is_given_up_, true)) return meanwhile();
  listen_while(State::kPreparing, take);
  for (std::size_t k = 0; k < helpers_.size(); ++k) {
    if (state_[k] != State::kReady) continue;
    state_[k] = State::kAsked;
    leader_.reply(helpers_[k], Word::kTasks, tasks_message({k, k + 1}, question));
  }
  meanwhile();
  listen_while(State::kAsked, take);
  is_given_up_ = false;
}

void LedShares::listen_while(State state, const std::function<void(std::size_t, std::string_view)>& take) {
  for (Nap nap; std::ranges::find(state_, state) != state_.end();) {
    const auto message = leader_.channel_.receive();
    if (!message) {
      throw_if_interrupted();
      nap.take();
      continue;
    }
    nap.forget();
    leader_.is_waiting_[static_cast<std::size_t>(message->rank)] = 1;
    const auto place = std::ranges::find(helpers_, message->rank);
    if (place == helpers_.end()) continue;  // it has done what it had in hand of another job
    MessageReader reader(message->bytes);
    const WantHead head = read_want(reader);
    HOTTEL_REQUIRE(head.job == id_);
    const auto k = static_cast<std::size_t>(place - helpers_.begin());
    HOTTEL_REQUIRE(state_[k] == State::kPreparing || state_[k] == State::kAsked);
    state_[k] = head.want == Want::kCannot ? State::kLost : State::kReady;
    if (head.want != Want::kDone) continue;
    HOTTEL_REQUIRE((head.tasks == WorkRange{k, k + 1}));
    take(k + 1, reader.rest());
  }
}

}  // namespace hottel
