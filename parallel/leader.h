// Rank 0, which runs the command, deals out tasks of work to all others and gets what they found.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "geometry/shared_work.h"
#include "parallel/channel.h"
#include "parallel/words.h"

namespace hottel {

// What a helper found, in its own words.
struct FoundBytes {
  WorkRange tasks;
  std::string bytes;
};

// A job in bytes: what a helper prepares; its tasks; what it is told of each range, null where that is
// nothing.
struct Job {
  std::string bytes;
  WorkSizes tasks;
  std::function<std::string(const WorkRange&)> telling = {};
};

class LedShares;
class LedWork;

// Who leads. Helpers ask for work, so none is waited for but one that has tasks in hand.
class Leader {
 public:
  // REQUIRES that the channel outlives it.
  explicit Leader(Channel& channel);

  // Begins to share the job that is made, with as many threads of each helper as may work here; null where there are no
  // helpers, or they have another job. From any thread.
  std::unique_ptr<LedWork> begin(const std::function<Job()>& make);
  // Begins a job of which each helper keeps a share: share(k, helpers) are the bytes of the k-th of them, from 1 on.
  // Takes part who waits for work, or does so soon; null where nobody does, or helpers have another job. From any
  // thread.
  std::unique_ptr<LedShares> begin_shares(const std::function<std::string(std::size_t, std::size_t)>& share);
  // Sends the helpers home with an exit code, each after what it does now. REQUIRES that no work is there; once.
  void end(int code);

 private:
  friend class LedShares;
  friend class LedWork;
  std::vector<int> waiting_helpers();                         // REQUIRES the lock
  void reply(int rank, Word word, const std::string& bytes);  // to one that waits

  Channel& channel_;
  std::mutex together_;
  bool is_busy_ = false;
  std::uint64_t jobs_ = 0;
  std::vector<char> is_waiting_;  // by rank: has asked for work and has no answer
};

// Tasks of one job. A thread of its own speaks with the helpers while it lives.
//
//   (1) next() and stop() as of SharedWork: each task is in one turn, whatever helpers do. What a helper could not do
//       is done here
//   (2) throws RequestError where a helper cannot take part, or has prepared something else; ContractViolation where it
//       sends what it was not asked for
class LedWork : public SharedWork<FoundBytes> {
 public:
  LedWork(Leader& leader, Job job, std::uint64_t id, int threads);
  ~LedWork() override;

  WorkTurn<FoundBytes> next() override;
  void stop() override;

 private:
  void speak();
  void answer(const Message& message);
  void take_in(int rank, const WantHead& head, std::string bytes);
  void give_more(int rank);

  Leader& leader_;
  const Job job_;
  const std::uint64_t id_;
  const int threads_;
  WorkQueue queue_;
  std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  std::map<int, WorkRange> out_;  // by rank: what it has in hand
  std::deque<FoundBytes> found_;
  std::exception_ptr failure_;
  bool is_over_ = false;
  std::thread speaker_;  // last: it uses the others
};

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
