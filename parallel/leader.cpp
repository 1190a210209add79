#include "parallel/leader.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <utility>

#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "parallel/message.h"
#include "parallel/words.h"

namespace hottel {

Leader::Leader(Channel& channel) : channel_(channel), is_waiting_(static_cast<std::size_t>(channel.ranks()), 0) {}

void Leader::reply(int rank, Word word, const std::string& bytes) {
  is_waiting_[static_cast<std::size_t>(rank)] = 0;
  channel_.send(rank, word, bytes);
}

std::unique_ptr<LedWork> Leader::begin(const std::function<Job()>& make) {
  const std::lock_guard lock(together_);
  if (is_busy_ || channel_.ranks() == 1) return nullptr;
  auto work = std::make_unique<LedWork>(*this, make(), ++jobs_, threads_allowed());
  is_busy_ = true;
  return work;
}

std::vector<int> Leader::waiting_helpers() {
  // Whoever has done the last job asks at once; one that is still busy with it is not waited for.
  constexpr auto kPatience = std::chrono::milliseconds(100);
  const auto until = std::chrono::steady_clock::now() + kPatience;
  const auto is_missing = [](char is_waiting) { return is_waiting == 0; };
  for (Nap nap; std::any_of(is_waiting_.begin() + 1, is_waiting_.end(), is_missing);) {
    // What a helper found of a job that was given up is of no use.
    if (const auto message = channel_.receive())
      is_waiting_[static_cast<std::size_t>(message->rank)] = 1;
    else if (std::chrono::steady_clock::now() < until)
      nap.take();
    else
      break;
  }
  std::vector<int> helpers;
  for (std::size_t rank = 1; rank < is_waiting_.size(); ++rank)
    if (is_waiting_[rank] != 0) helpers.push_back(static_cast<int>(rank));
  return helpers;
}

std::unique_ptr<LedShares> Leader::begin_shares(const std::function<std::string(std::size_t, std::size_t)>& share) {
  const std::lock_guard lock(together_);
  if (is_busy_ || channel_.ranks() == 1) return nullptr;
  std::vector<int> helpers = waiting_helpers();
  if (helpers.empty()) return nullptr;
  const std::uint64_t id = ++jobs_;
  for (std::size_t k = 1; k <= helpers.size(); ++k)
    reply(helpers[k - 1], Word::kJob, job_message(id, threads_allowed(), share(k, helpers.size())));
  is_busy_ = true;
  return std::make_unique<LedShares>(*this, id, std::move(helpers));
}

void Leader::end(int code) {
  MessageWriter writer;
  writer.put(code);
  int left = channel_.ranks() - 1;
  const auto send_home = [&](int rank) {
    channel_.send(rank, Word::kEnd, writer.bytes());
    --left;
  };
  for (int rank = 1; rank < channel_.ranks(); ++rank)
    if (is_waiting_[static_cast<std::size_t>(rank)] != 0) send_home(rank);
  while (left > 0) send_home(channel_.wait().rank);
}

LedWork::LedWork(Leader& leader, Job job, std::uint64_t id, int threads)
    : leader_(leader),
      job_(std::move(job)),
      id_(id),
      threads_(threads),
      queue_(job_.tasks, static_cast<std::size_t>(leader.channel_.ranks() * threads)),
      speaker_([this] { speak(); }) {}

LedWork::~LedWork() {
  stop();
  speaker_.join();
  const std::lock_guard lock(leader_.together_);
  leader_.is_busy_ = false;
}

WorkTurn<FoundBytes> LedWork::next() {
  std::unique_lock lock(mutex_);
  while (!is_over_) {
    if (failure_) std::rethrow_exception(failure_);
    if (!found_.empty()) {
      WorkTurn<FoundBytes> turn{.there = std::move(found_.front())};
      found_.pop_front();
      return turn;
    }
    if (const WorkRange here = queue_.take(); !here.is_empty()) return {.here = here};
    if (out_.empty()) break;
    changed_.wait_for(lock, std::chrono::milliseconds(50));
    throw_if_interrupted();
  }
  is_over_ = true;
  changed_.notify_all();
  return {};
}

void LedWork::stop() {
  queue_.stop();
  const std::lock_guard lock(mutex_);
  is_over_ = true;
  changed_.notify_all();
}

void LedWork::speak() {
  try {
    for (std::size_t rank = 1; rank < leader_.is_waiting_.size(); ++rank)
      if (leader_.is_waiting_[rank] != 0)
        leader_.reply(static_cast<int>(rank), Word::kJob, job_message(id_, threads_, job_.bytes));
    const auto is_over = [this] {
      const std::lock_guard lock(mutex_);
      return is_over_;
    };
    for (Nap nap; !is_over();) {
      if (const auto message = leader_.channel_.receive()) {
        answer(*message);
        nap.forget();
      } else {
        nap.take();
      }
    }
  } catch (...) {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
    changed_.notify_all();
  }
}

void LedWork::answer(const Message& message) {
  const int rank = message.rank;
  leader_.is_waiting_[static_cast<std::size_t>(rank)] = 1;
  MessageReader reader(message.bytes);
  const WantHead head = read_want(reader);
  if (head.job != id_)  // what it found of a job that was given up is of no use
    return leader_.reply(rank, Word::kJob, job_message(id_, threads_, job_.bytes));
  if (head.want == Want::kCannot)
    throw RequestError("rank " + std::to_string(rank) + " cannot take part: " + std::string(reader.rest()));
  if (head.want != Want::kWork) take_in(rank, head, std::string(reader.rest()));
  give_more(rank);
}

void LedWork::take_in(int rank, const WantHead& head, std::string bytes) {
  const std::lock_guard lock(mutex_);
  const auto out = out_.find(rank);
  HOTTEL_REQUIRE(out != out_.end() && out->second == head.tasks);
  out_.erase(out);
  if (head.want == Want::kDone)
    found_.push_back({head.tasks, std::move(bytes)});
  else
    queue_.give_back(head.tasks);
  changed_.notify_all();
}

void LedWork::give_more(int rank) {
  WorkRange tasks;
  {
    const std::lock_guard lock(mutex_);
    tasks = queue_.take(static_cast<std::size_t>(threads_));
    if (tasks.is_empty()) return;
    out_.emplace(rank, tasks);
  }
  leader_.reply(rank, Word::kTasks, tasks_message(tasks, job_.telling ? job_.telling(tasks) : ""));
}

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
