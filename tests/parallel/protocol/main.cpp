// Leader and helpers on several ranks, with jobs that are made up: squares of whole numbers, and rows of systems that
// are too small to be shared otherwise. Exit code 0 where all is as it should be.
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "kernel/support/failure.h"
#include "parallel/channel.h"
#include "parallel/helper.h"
#include "parallel/leader.h"
#include "parallel/message.h"
#include "parallel/row_crew.h"
#include "solver/radiosity/radiosity.h"

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

// "k" and its number: what it keeps. It answers with both numbers, and fails where it is asked for 7; the third of
// several cannot take part.
class KeptJob : public HelperJob {
 public:
  explicit KeptJob(std::string_view number) : number_(number) {
    if (number_ == "3") throw std::runtime_error("it does not want to");
  }
  std::string work(const WorkRange&, std::string_view told) override {
    if (told == "7") throw std::runtime_error("it fails");
    return number_ + " " + std::string(told);
  }

 private:
  std::string number_;
};

// Rows, of which every third question is too much.
class TiredRows : public HelperJob {
 public:
  explicit TiredRows(std::unique_ptr<HelperJob> rows) : rows_(std::move(rows)) {}
  std::string work(const WorkRange& tasks, std::string_view told) override {
    if (++asked_ % 3 == 0) throw std::runtime_error("it fails");
    return rows_->work(tasks, told);
  }

 private:
  const std::unique_ptr<HelperJob> rows_;
  int asked_ = 0;
};

// Rank 2 is tired, and rank 3 holds no rows.
class AllJobs : public HelperJobs {
 public:
  explicit AllJobs(int rank) : rank_(rank) {}
  std::unique_ptr<HelperJob> make(std::string_view bytes) override {
    if (bytes.front() == 'k') return std::make_unique<KeptJob>(bytes.substr(1));
    if (bytes.front() != 'r') return std::make_unique<SquareJob>(bytes);
    if (rank_ == 3) throw std::runtime_error("it does not want to");
    auto rows = rows_.make(bytes.substr(1));
    if (rank_ == 2) return std::make_unique<TiredRows>(std::move(rows));
    return rows;
  }

 private:
  const int rank_;
  RowJobs rows_;
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

// Returns what begin() begins, once helpers wait: on a machine that is busy they are late.
template <class Begin>
auto begun(const Begin& begin) {
  auto there = begin();
  for (int k = 0; k < 600 && there == nullptr; ++k) there = begin();
  return there;
}

// Returns how many answered a question.
std::size_t answers(LedShares& shares, const std::string& question) {
  std::size_t count = 0;
  bool was_here = false;
  shares.ask(
      question, [&] { was_here = true; },
      [&](std::size_t k, std::string_view answer) {
        expect(answer == std::to_string(k) + " " + question, "the answer is of the last question, and of its share");
        ++count;
      });
  expect(was_here, "work is done meanwhile");
  return count;
}

void ask_all(Leader& leader) {
  const auto shares =
      begun([&] { return leader.begin_shares([](std::size_t k, std::size_t) { return "k" + std::to_string(k); }); });
  if (shares == nullptr) return expect(false, "helpers that wait take part");
  const std::size_t able = shares->helpers() - (shares->helpers() >= 3 ? 1 : 0);
  expect(shares->helpers() > 0, "there are helpers");
  expect(leader.begin([] { return job_of("s"); }) == nullptr, "there is no other job meanwhile");
  for (int k = 1; k < 20; ++k)
    expect(answers(*shares, std::to_string(k)) == (k == 7 ? 0 : able), "those answer who can");
  try {
    shares->ask(
        "20", [] { throw std::runtime_error("here"); }, [](std::size_t, std::string_view) {});
    expect(false, "what is thrown meanwhile is thrown on");
  } catch (const std::runtime_error&) {
  }
  expect(answers(*shares, "21") == 0, "nobody is asked after an exception");
}

// A room of boards that see each other, by factors that are made up: nearly all of the light goes to the next ones.
ExchangeMatrix made_up_room(std::uint32_t size) {
  std::vector<Element> elements(size);
  for (std::uint32_t i = 0; i < size; ++i) elements[i] = {.name = std::to_string(i), .material = i % 2, .area = {1, 0}};
  std::vector<std::size_t> begin{0};
  FactorEntries entries;
  for (std::uint32_t i = 0; i < size; ++i) {
    double sum = 0;
    const auto factor = [&](std::uint32_t j) {
      const double distance = i < j ? j - i : i - j;
      return 1 / (distance * distance * distance * (1 + 0.1 * static_cast<double>((i + j) % 7)));
    };
    for (std::uint32_t j = 0; j < size; ++j) sum += i == j ? 0 : factor(j);
    for (std::uint32_t j = 0; j < size; ++j)
      if (i != j) entries.push_back({j, {factor(j) / sum, 0}, 1});
    begin.push_back(entries.size());
  }
  ExchangeMatrix matrix(std::move(elements), Guarantee::kEstimated);
  matrix.assign(std::move(begin), std::move(entries));
  return matrix;
}

// Helpers fail at some of it, and nobody sees that.
void solve_together(Leader& leader) {
  const ExchangeMatrix matrix = made_up_room(700);
  std::vector<Material> materials(2);
  materials[0].reflectivity = Spectrum::scalar(Rational(9, 10));
  materials[1].reflectivity = Spectrum::scalar(Rational(1, 2));
  materials[1].emission = Spectrum::scalar(1);
  const RadiosityOptions options{.solver = Solver::kBicgstab};
  const RadiositySolution alone = solve_radiosity(matrix, materials, Spectrum(), options);
  LedRowCrew crew(leader, 'r', 0);
  {
    const RadiositySystem system(matrix, materials, 0);
    const std::vector<char> is_wanted(system.components().size(), 1);
    const auto rows = begun([&] { return crew.begin(system, is_wanted); });
    if (rows == nullptr) return expect(false, "rows are shared");
    std::vector<double> x(system.size(), 1), result(system.size());
    std::size_t here = 0;
    rows->multiply(
        RowProduct::kPlain, x, [&](const WorkRange& range) { here += range.size(); }, result);
    expect(0 < here && here < system.size(), "some rows are formed here, some elsewhere");
  }
  const CrewScope<RowCrew> scope(crew);
  const RadiositySolution together = solve_radiosity(matrix, materials, Spectrum(), options);
  expect(alone.channels.size() == together.channels.size(), "as many channels");
  for (std::size_t c = 0; c < alone.channels.size(); ++c) {
    expect(alone.channels[c].residual_history == together.channels[c].residual_history, "the same iterations");
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      const ElementRadiosity &a = alone.channels[c].elements[i], &b = together.channels[c].elements[i];
      expect(a.radiosity == b.radiosity && a.lower == b.lower && a.upper == b.upper && a.irradiance == b.irradiance,
             "the same radiosities");
    }
  }
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
  for (int k = 0; k < 3; ++k) {
    ask_all(leader);
    square_all(leader, "f");
    give_up(leader);
  }
  solve_together(leader);
  expect(square_all(leader, "l") > 0, "others take part after all");
  const int code = failures == 0 ? 0 : 1;
  leader.end(code);
  return code;
}

}  // namespace
}  // namespace hottel

int main(int argc, char** argv) {
  hottel::Channel channel(argc, argv);
  if (channel.rank() == 0) return hottel::lead(channel);
  hottel::AllJobs jobs(channel.rank());
  return hottel::help(channel, jobs);
}
