#include "parallel/helper.h"

#include <cstdint>
#include <exception>
#include <optional>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "parallel/message.h"
#include "parallel/words.h"

namespace hottel {
namespace {

// The job that a helper has, and what it answers.
class JobAtHand {
 public:
  explicit JobAtHand(HelperJobs& jobs) : jobs_(jobs) {}

  // Each returns what is sent to rank 0.
  std::string take(MessageReader reader) {
    job_.reset();
    int threads = 1;
    reader.take_into(id_, threads);
    limit_.reset();
    limit_.emplace(threads);
    try {
      job_ = jobs_.make(reader.rest());
      return want_message({id_, Want::kWork});
    } catch (const std::exception& error) {
      return want_message({id_, Want::kCannot}, error.what());
    }
  }
  std::string work(MessageReader reader) {
    HOTTEL_REQUIRE(job_ != nullptr);
    const WorkRange tasks = read_tasks(reader);
    try {
      return want_message({id_, Want::kDone, tasks}, job_->work(tasks, reader.rest()));
    } catch (const std::exception&) {
      return want_message({id_, Want::kUndone, tasks});
    }
  }

 private:
  HelperJobs& jobs_;
  std::uint64_t id_ = 0;
  std::unique_ptr<HelperJob> job_;
  std::optional<ThreadLimit> limit_;
};

}  // namespace

int help(Channel& channel, HelperJobs& jobs) {
  JobAtHand job(jobs);
  channel.send(0, Word::kWant, want_message({}));
  for (;;) {
    const Message message = channel.wait();
    MessageReader reader(message.bytes);
    if (message.word == Word::kEnd) return reader.take<int>();
    channel.send(0, Word::kWant, message.word == Word::kJob ? job.take(reader) : job.work(reader));
  }
}

}  // namespace hottel
