// A progress bar with the time left, on stderr.
#pragma once

#include <atomic>
#include <chrono>
#include <string>

namespace hottel {

// Shows how far work has come, for people at a terminal.
//
//   (1) update and advance may be called from any thread, as often as one likes   COST: a clock and two atomics
//   (2) nothing is drawn in the first second, nor more often than ten times a second, nor unless `is_shown`
//   (3) the fraction never goes back; the line is wiped by the destructor
//   (4) a line that cannot be written is no reason to stop
class Progress {
 public:
  // `total` is what advance() counts up to.
  Progress(std::string what, bool is_shown, double total = 1);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(double fraction);     // fraction done, 0 to 1
  void advance(double amount = 1);  // so much more of the total is done

  // Wipes the line of a bar, so that a remark has it. The bar comes again with its next tenth of a second.
  static void make_room();

  // Returns true when stderr is a terminal.
  static bool is_terminal();

 private:
  using Clock = std::chrono::steady_clock;
  void draw_when_due(double fraction);

  const std::string what_;
  const bool is_shown_;
  const double total_;
  const Clock::time_point start_ = Clock::now();
  std::atomic<double> done_{0};
  std::atomic<long> next_draw_ms_{1000};
  std::atomic<bool> is_drawn_{false};
};

// The line as it is drawn: "view factors  [#####.....]  50 %  12 s left". A fraction beyond 0 or 1 is taken for these;
// at 0 no time is told, and never more than 100 hours. The time left is what the rest takes at the pace so far.
std::string progress_line(const std::string& what, double fraction, double seconds_so_far);

}  // namespace hottel
