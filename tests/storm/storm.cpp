#include "tests/storm/storm.h"

#include <fmt/core.h>
#include <time.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <numeric>
#include <thread>

#include "io/scene/scene_json.h"
#include "kernel/support/parallel.h"
#include "tests/comparison/plane/engine_comparison.h"
#include "tests/storm/crash_notice.h"
#include "tests/storm/plane/shrink.h"

namespace hottel::storm {

namespace {

// What is wrong with a scene by one law; an exception is wrong too.
std::string verdict(const Law& law, const Edges& edges, std::uint64_t chance) {
  try {
    return law.broken(Subject(edges, chance));
  } catch (const std::exception& error) {
    return std::string("throws: ") + error.what() + "\n";
  }
}

double processor_seconds() {  // of this thread
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

class Storm {
 public:
  Storm(const StormOptions& options, const std::vector<Law>& laws) : options_(options), laws_(laws) {
    result_.checks.resize(laws.size());
    result_.failures.resize(laws.size());
    result_.seconds.resize(laws.size());
  }

  void run(std::uint64_t number) {
    const double start = processor_seconds();
    const int k = options_.k > 0 ? options_.k : 2 + static_cast<int>(number % 5);
    const LatticeScene scene = lattice_scene(number, k);
    CrashNotice::is_at(number, k, "any");
    try {
      const Subject subject(scene.edges, number);
      for (std::size_t l = 0; l < laws_.size(); ++l)
        if (options_.all_laws || (number + l) % laws_[l].every == 0)
          if (!check(l, subject, k)) break;  // what follows rests on it
    } catch (const std::exception&) {        // there are no factors to hold against any law
      ++result_.checks[0];
      add_failure(0, scene.edges, number);
    }
    ++result_.scenes;
    result_.edges += scene.edges.size();
    count_contacts(scene.lattice, result_.contacts);
    count_solids(scene, result_.contacts);
    const double taken = processor_seconds() - start;
    result_.slowest = std::max(result_.slowest, taken);
    result_.total += taken;
  }

  const StormResult& result() const { return result_; }

 private:
  bool check(std::size_t l, const Subject& subject, int k) {
    CrashNotice::is_at(subject.chance(), k, laws_[l].name);
    ++result_.checks[l];
    std::string what;
    const double start = processor_seconds();
    try {
      what = laws_[l].broken(subject);
    } catch (const std::exception& error) {
      what = error.what();
    }
    result_.seconds[l] += processor_seconds() - start;
    if (!what.empty()) add_failure(l, subject.edges(), subject.chance());
    return what.empty();
  }

  void add_failure(std::size_t l, const Edges& edges, std::uint64_t number) {
    if (++result_.failures[l] > 1) return;
    const auto fails = [&](const Edges& some) { return !verdict(laws_[l], some, number).empty(); };
    if (!fails(edges)) return;
    Edges least = shrunk(edges, fails);
    std::string what = verdict(laws_[l], least, number);
    result_.examples.push_back({number, laws_[l].name, std::move(what), std::move(least)});
  }

  const StormOptions& options_;
  const std::vector<Law>& laws_;
  StormResult result_;
};

}  // namespace

std::uint64_t StormResult::all_checks() const {
  return std::accumulate(checks.begin(), checks.end(), std::uint64_t{0});
}

std::uint64_t StormResult::all_failures() const {
  return std::accumulate(failures.begin(), failures.end(), std::uint64_t{0});
}

void StormResult::add(const StormResult& other) {
  scenes += other.scenes;
  edges += other.edges;
  checks.resize(other.checks.size());
  failures.resize(other.failures.size());
  seconds.resize(other.seconds.size());
  for (std::size_t l = 0; l < checks.size(); ++l) {
    checks[l] += other.checks[l];
    failures[l] += other.failures[l];
    seconds[l] += other.seconds[l];
  }
  for (std::size_t c = 0; c < kContactKinds; ++c) contacts[c] += other.contacts[c];
  examples.insert(examples.end(), other.examples.begin(), other.examples.end());
  std::sort(examples.begin(), examples.end(), [](const Failure& a, const Failure& b) { return a.number < b.number; });
  slowest = std::max(slowest, other.slowest);
  total += other.total;
}

StormResult run_storm(const StormOptions& options, const std::vector<Law>& which) {
  const unsigned count = std::max(1U, options.threads);
  const std::uint64_t at_once = std::clamp<std::uint64_t>(options.scenes / (8 * count), 1, 64);
  const CrashNotice notice;
  const ThreadLimit limit(1);  // a scene stays on its thread, which knows its number should it die
  std::atomic<std::uint64_t> next{0}, done{0};
  std::vector<Storm> storms(count, Storm(options, which));
  const auto work = [&](unsigned thread) {
    const SignalStack stack;
    for (std::uint64_t from; (from = next.fetch_add(at_once)) < options.scenes;) {
      const std::uint64_t to = std::min(from + at_once, options.scenes);
      for (std::uint64_t k = from; k < to; ++k) {
        storms[thread].run(options.first + k);
        ++done;
        if (thread == 0 && options.progress) options.progress(done.load());
      }
    }
  };
  std::vector<std::thread> threads;
  for (unsigned thread = 1; thread < count; ++thread) threads.emplace_back(work, thread);
  work(0);
  for (std::thread& thread : threads) thread.join();
  StormResult result;
  for (const Storm& storm : storms) result.add(storm.result());
  return result;
}

std::string report(const StormResult& result, const std::vector<Law>& which) {
  std::string text = fmt::format(
      "{} scenes of {:.1f} edges, {} checks, {} failures; {:.2f} ms a scene, at most {:.0f} ms\n\n", result.scenes,
      static_cast<double>(result.edges) / static_cast<double>(result.scenes), result.all_checks(),
      result.all_failures(), 1e3 * result.total / static_cast<double>(result.scenes), 1e3 * result.slowest);
  for (std::size_t l = 0; l < which.size(); ++l)
    text += fmt::format("{:24} {:>12} checks {:>6} failures {:>10.1f} s\n", which[l].name, result.checks[l],
                        result.failures[l], result.seconds[l]);
  text += "\n";
  for (std::size_t c = 0; c < kContactKinds; ++c)
    text += fmt::format("{:24} {:>12}\n", to_string(static_cast<Contact>(c)), result.contacts[c]);
  for (const Failure& failure : result.examples) {
    Scene2 scene = oracle::to_scene(failure.edges);
    scene.about = fmt::format("Scene {} of the storm, shrunk: {}.", failure.number, failure.law);
    text += fmt::format("\nscene {} breaks {}:\n{}{}", failure.number, failure.law, failure.what, write_scene_2(scene));
  }
  return text;
}

}  // namespace hottel::storm
