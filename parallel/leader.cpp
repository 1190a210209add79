#include "parallel/leader.h"

#include <chrono>
#include <optional>
#include <utility>

#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "parallel/message.h"
#include "parallel/words.h"

namespace hottel {

Leader::Leader(Channel& channel) : channel_(channel), is_waiting_(static_cast<std::size_t>(channel.ranks()), 0) {}

std::unique_ptr<LedWork> Leader::begin(const std::function<Job()>& make) {
  const std::lock_guard lock(together_);
  if (is_busy_ || channel_.ranks() == 1) return nullptr;
  auto work = std::make_unique<LedWork>(*this, make(), ++jobs_, threads_allowed());
  is_busy_ = true;
  return work;
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
      if (leader_.is_waiting_[rank] != 0) reply(static_cast<int>(rank), Word::kJob, job_message());
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

void LedWork::reply(int rank, Word word, const std::string& bytes) {
  leader_.is_waiting_[static_cast<std::size_t>(rank)] = 0;
  leader_.channel_.send(rank, word, bytes);
}

std::string LedWork::job_message() const {
  MessageWriter writer;
  writer.put(id_, threads_);
  return writer.bytes() + job_.bytes;
}

void LedWork::answer(const Message& message) {
  const int rank = message.rank;
  leader_.is_waiting_[static_cast<std::size_t>(rank)] = 1;
  MessageReader reader(message.bytes);
  const WantHead head = read_want(reader);
  if (head.job != id_)  // what it found of a job that was given up is of no use
    return reply(rank, Word::kJob, job_message());
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
  reply(rank, Word::kTasks, tasks_message(tasks, job_.telling ? job_.telling(tasks) : ""));
}

}  // namespace hottel
