// What helpers and their leader say to each other.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/shared_work.h"
#include "parallel/message.h"

namespace hottel {

// How a helper asks for more.
enum class Want : unsigned char {
  kWork,    // it has nothing in hand
  kDone,    // the tasks are done: what was found follows
  kUndone,  // the tasks could not be done
  kCannot,  // it cannot take part in the job: why follows
};

struct WantHead {
  std::uint64_t job = 0;  // the number of the one that it has, 0 where it has none
  Want want = Want::kWork;
  WorkRange tasks{};
};

// Of Word::kWant.
inline std::string want_message(const WantHead& head, std::string_view rest = {}) {
  MessageWriter writer;
  writer.put(head.job, head.want, std::uint64_t{head.tasks.begin}, std::uint64_t{head.tasks.end});
  return writer.bytes() + std::string(rest);
}
inline WantHead read_want(MessageReader& reader) {
  WantHead head;
  reader.take_into(head.job, head.want, head.tasks.begin, head.tasks.end);
  return head;
}

// Of Word::kJob: its number, how many threads work on it, and what it is.
inline std::string job_message(std::uint64_t id, int threads, std::string_view job) {
  MessageWriter writer;
  writer.put(id, threads);
  return writer.bytes() + std::string(job);
}

// Of Word::kTasks: what is told of them follows.
inline std::string tasks_message(const WorkRange& tasks, std::string_view told) {
  MessageWriter writer;
  writer.put(std::uint64_t{tasks.begin}, std::uint64_t{tasks.end});
  return writer.bytes() + std::string(told);
}
inline WorkRange read_tasks(MessageReader& reader) {
  WorkRange tasks;
  reader.take_into(tasks.begin, tasks.end);
  return tasks;
}

}  // namespace hottel
