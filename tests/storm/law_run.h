// Holds numbered scenes of any kind against laws.
#pragma once

#include <algorithm>
#include <cstdint>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "tests/storm/crash_notice.h"
#include "tests/storm/loop.h"

namespace hottel::storm {

// What came of a storm, by law.
struct LawCounts {
  std::uint64_t scenes = 0, parts = 0;          // parts of scenes: edges, or polygons
  std::vector<std::uint64_t> checks, failures;  // by law
  std::vector<double> seconds;                  // of processor time, by law
  double slowest = 0, total = 0;                // seconds of processor time of a scene; of all, summed over the threads
  std::uint64_t slowest_number = 0;             // of that scene

  std::uint64_t all_checks() const;
  std::uint64_t all_failures() const;
  void add(const LawCounts& other);
  // The counts as lines; `part` is what a part is called ("edges").
  std::string text(const std::vector<const char*>& laws, const char* part) const;
};

// A scene that breaks a law, with nothing in it that could be left out or moved nearer to the origin.
template <class Scene>
struct Failed {
  std::uint64_t number = 0;
  std::string law, what;
  Scene scene;
};

template <class Scene>
struct LawResult : LawCounts {
  std::vector<Failed<Scene>> examples;  // the first of each law, by number

  void add(const LawResult& other) {
    LawCounts::add(other);
    examples.insert(examples.end(), other.examples.begin(), other.examples.end());
    std::sort(examples.begin(), examples.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  }
};

// What the storms differ in. A Kind has the types
//   Law       name, broken(subject), every
//   Subject   what laws are held against: made of a Scene and a number
//   Scene     what is shrunk and shown
//   Made      a Scene as `scene`, and what else is known of it
//   Result    a LawResult<Scene> with counts of its own, and add()
// and the functions
//   make(number, options)      the Made of a number
//   lattice(number, options)   the k that CrashNotice is told
//   is_asked(law, subject)     whether the law says anything of it
//   note(subject, result), count(made, result)   its own counts; the latter adds to Result::parts
//   shrunk(scene, fails)
template <class Kind>
class LawRun {
 public:
  using Law = typename Kind::Law;
  using Subject = typename Kind::Subject;
  using Scene = typename Kind::Scene;
  using Result = typename Kind::Result;

  // REQUIRES that both outlive this.
  LawRun(const StormOptions& options, const std::vector<Law>& laws) : options_(options), laws_(laws) {
    result_.checks.resize(laws.size());
    result_.failures.resize(laws.size());
    result_.seconds.resize(laws.size());
  }

  void run(std::uint64_t number) {
    const double start = processor_seconds();
    const typename Kind::Made made = Kind::make(number, options_);
    is_at(number, "any");
    try {
      const Subject subject(made.scene, number);
      Kind::note(subject, result_);
      for (std::size_t l = 0; l < laws_.size(); ++l)
        if (options_.all_laws || (number + l) % laws_[l].every == 0)
          if (Kind::is_asked(laws_[l], subject) && !check(l, subject, made.scene)) break;  // what follows rests on it
    } catch (const std::exception&) {  // there is nothing to hold against any law
      ++result_.checks[0];
      add_failure(0, made.scene, number);
    }
    ++result_.scenes;
    Kind::count(made, result_);
    const double taken = processor_seconds() - start;
    if (taken > result_.slowest) {
      result_.slowest = taken;
      result_.slowest_number = number;
    }
    result_.total += taken;
  }

  const Result& result() const { return result_; }

 private:
  void is_at(std::uint64_t number, const char* law) const {
    CrashNotice::is_at(number, Kind::lattice(number, options_), law);
  }

  // What is wrong by one law; an exception is wrong too.
  template <class Ask>
  static std::string verdict(const Ask& ask) {
    try {
      return ask();
    } catch (const std::exception& error) {
      return std::string("throws: ") + error.what() + "\n";
    }
  }
  static std::string verdict(const Law& law, const Scene& scene, std::uint64_t number) {
    return verdict([&]() -> std::string {
      const Subject subject(scene, number);
      return Kind::is_asked(law, subject) ? law.broken(subject) : "";
    });
  }

  bool check(std::size_t l, const Subject& subject, const Scene& scene) {
    is_at(subject.chance(), laws_[l].name);
    ++result_.checks[l];
    const double start = processor_seconds();
    const std::string what = verdict([&] { return laws_[l].broken(subject); });
    result_.seconds[l] += processor_seconds() - start;
    if (!what.empty()) add_failure(l, scene, subject.chance());
    return what.empty();
  }

  void add_failure(std::size_t l, const Scene& scene, std::uint64_t number) {
    if (++result_.failures[l] > 1) return;
    const auto fails = [&](const Scene& some) { return !verdict(laws_[l], some, number).empty(); };
    if (!fails(scene)) return;
    Scene least = options_.shrinks ? Kind::shrunk(scene, fails) : scene;
    std::string what = verdict(laws_[l], least, number);
    result_.examples.push_back({number, laws_[l].name, std::move(what), std::move(least)});
  }

  const StormOptions& options_;
  const std::vector<Law>& laws_;
  Result result_;
};

// Holds scenes first, first + 1, ... against the laws, each up to the first that it breaks. The result does not depend
// on the number of threads, but for its times.
template <class Kind>
typename Kind::Result run_laws(const StormOptions& options, const std::vector<typename Kind::Law>& laws) {
  std::vector<LawRun<Kind>> runs(std::max(1U, options.threads), LawRun<Kind>(options, laws));
  for_each_scene(options, [&](unsigned thread, std::uint64_t number) { runs[thread].run(number); });
  typename Kind::Result result;
  for (const LawRun<Kind>& run : runs) result.add(run.result());
  return result;
}

template <class Law>
std::vector<const char*> names_of(const std::vector<Law>& laws) {
  std::vector<const char*> names;
  for (const Law& law : laws) names.push_back(law.name);
  return names;
}

}  // namespace hottel::storm
