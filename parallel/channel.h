// Messages between the processes of one MPI job. The one place that knows MPI.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace hottel {

// What a message is.
enum class Word : int {
  kWant = 1,   // to rank 0: what was done, and that more is wanted
  kJob = 2,    // from rank 0: what to prepare
  kTasks = 3,  // from rank 0: what to do of it
  kEnd = 4,    // from rank 0: nothing more, with the exit code
};

struct Message {
  int rank = 0;  // who sent it
  Word word = Word::kWant;
  std::string bytes;
};

// This process among all.
//
//   (1) messages of one rank to another arrive whole, once and in their order, of any size
//   (2) nobody who waits here takes a core meanwhile: it looks every millisecond, sooner where messages just came
// Calls of several threads must not overlap; they may come from any thread. One object a process, made first and
// destroyed last.
class Channel {
 public:
  // Joins the job that mpirun started, or is one process alone. MPI takes its own options out of the arguments.
  Channel(int& argc, char**& argv);
  ~Channel();
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  int rank() const { return rank_; }
  int ranks() const { return ranks_; }
  // How many of them, this one included, may run on the same cores of this machine.
  int ranks_on_these_cores() const { return ranks_on_these_cores_; }

  // May wait until the other one receives, where a message is long.
  void send(int rank, Word word, const std::string& bytes);
  // A message that is there, or nothing.
  std::optional<Message> receive();
  // Waits for one.
  Message wait();

 private:
  int rank_ = 0, ranks_ = 1, ranks_on_these_cores_ = 1;
};

// Waits a moment, longer each time.
class Nap {
 public:
  void take();
  void forget() { microseconds_ = kLeast; }

 private:
  static constexpr int kLeast = 20, kMost = 1000;
  int microseconds_ = kLeast;
};

}  // namespace hottel
