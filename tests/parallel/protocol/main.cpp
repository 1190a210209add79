// Leader and helpers on several ranks, with jobs that are made up: squares of whole numbers. Exit code 0 where all is
// as it should be.
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "kernel/support/failure.h"
#include "parallel/channel.h"
#include "parallel/helper.h"
#include "parallel/leader.h"
#include "parallel/message.h"

namespace hottel {
namespace {

int failures = 0;

void expect(bool is_so, const char* what) {
  if (is_so) return;
  std::printf("not so: %s\n", what);
  ++failures;
}

// "f": tasks whose number ends in 7 fail. "l": long answers. "c": it cannot take part.
class SquareJob : public HelperJob {
 public:
  explicit SquareJob(std::string_view kind) : kind_(kind) {
    if (kind_ == "c") throw std::runtime_error("it does not want to");
  }
  std::string work(const WorkRange& tasks, std::string_view told) override {
    if (told != std::to_string(tasks.begin)) throw std::runtime_error("other words");
    MessageWriter writer;
    for (std::size_t k = tasks.begin; k < tasks.end; ++k) {
      if (kind_ == "f" && k % 10 == 7) throw std::runtime_error("it fails");
      writer.put(std::uint64_t{k * k});
    }
    return writer.bytes() + std::string(kind_ == "l" ? 3'000'000 : 0, 'x');
  }

 private:
  std::string kind_;
};

class SquareJobs : public HelperJobs {
 public:
  std::unique_ptr<HelperJob> make(std::string_view bytes) override { return std::make_unique<SquareJob>(bytes); }
};

constexpr std::size_t kCount = 2000;

Job job_of(const std::string& kind) {
  return {.bytes = kind, .tasks = {.count = kCount, .dear = 20, .most = 50}, .telling = [](const WorkRange& tasks) {
            return std::to_string(tasks.begin);
          }};
}

// Whoever squares them: each number once. Returns how many others squared.
std::size_t square_all(Leader& leader, const std::string& kind) {
  const auto work = leader.begin([&] { return job_of(kind); });
  expect(work != nullptr, "work is shared");
  expect(leader.begin([&] { return job_of(kind); }) == nullptr, "there is one job at a time");
  WorkCount count;
  std::size_t elsewhere = 0;
  for (auto turn = work->next(); !turn.is_over(); turn = work->next()) {
    if (turn.there) {
      MessageReader reader(turn.there->bytes);
      for (std::size_t k = turn.there->tasks.begin; k < turn.there->tasks.end; ++k)
        expect(reader.take<std::uint64_t>() == k * k, "squares come with their numbers");
      elsewhere += turn.there->tasks.size();
      count.add(turn.there->tasks);
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      count.add(turn.here);
    }
  }
  expect(count.has_each_once(kCount), "each task is done once");
  return elsewhere;
}

// Helpers that are still busy with what was given up must not disturb.
void give_up(Leader& leader) {
  const auto work = leader.begin([] { return job_of("l"); });
  work->next();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  work->stop();
  expect(work->next().is_over(), "nothing comes after a stop");
}

bool is_refused(Leader& leader) {
  const auto work = leader.begin([] { return job_of("c"); });
  try {
    for (auto turn = work->next(); !turn.is_over(); turn = work->next())
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
  } catch (const RequestError& error) {
    return std::string(error.what()).find("it does not want to") != std::string::npos;
  }
  return false;
}

int lead(Channel& channel) {
  Leader leader(channel);
  expect(channel.ranks() > 1, "there are helpers");
  for (int k = 0; k < 3; ++k) expect(square_all(leader, "s") > 0, "others take part");
  for (int k = 0; k < 3; ++k) {
    give_up(leader);
    square_all(leader, "f");
  }
  expect(square_all(leader, "l") > 0, "others take part with long answers");
  expect(is_refused(leader), "who cannot take part is told of");
  expect(square_all(leader, "s") > 0, "others take part again");
  const int code = failures == 0 ? 0 : 1;
  leader.end(code);
  return code;
}

}  // namespace
}  // namespace hottel

int main(int argc, char** argv) {
  hottel::Channel channel(argc, argv);
  if (channel.rank() == 0) return hottel::lead(channel);
  hottel::SquareJobs jobs;
  return hottel::help(channel, jobs);
}
