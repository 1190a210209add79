// `hottel view` as it runs on a screen, under hands.
#pragma once

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/program.h"
#include "tests/window/xvfb.h"

namespace hottel::testing_window {

inline constexpr double kPatience = 30;  // seconds, until what must come is taken to be missing

inline double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Asks again and again until the answer is yes. False where it has not come in so many seconds.
inline bool comes_true(const std::function<bool()>& question, double seconds = kPatience) {
  const auto start = std::chrono::steady_clock::now();
  while (!question()) {
    if (seconds_since(start) > seconds) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return true;
}

// One run of `hottel view WORDS`, its window in front and with the keyboard. Killed at the end, if it has not ended.
class ViewProgram {
 public:
  // Throws std::runtime_error where no window opens.
  ViewProgram(const XvfbSession& session, const std::filesystem::path& directory, const std::vector<std::string>& words)
      : session_(session), error_file_(directory / ".stderr") {
    start(directory, words);
    id_ = session.window("hottel$");
    session.xdotool("windowactivate --sync " + id_ + " windowfocus --sync " + id_);
  }
  ~ViewProgram() {
    if (code_) return;
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
  }
  ViewProgram(const ViewProgram&) = delete;
  ViewProgram& operator=(const ViewProgram&) = delete;

  const std::string& id() const { return id_; }
  std::string title() const { return session_.xdotool("getwindowname " + id_); }
  Raster frame() const { return session_.grab(id_); }

  // Waits until the window has shown the same for a while, and returns that.
  Raster frame_at_rest(double still = 0.4) const {
    Raster last = frame();
    auto since = std::chrono::steady_clock::now();
    const auto start = since;
    while (seconds_since(since) < still && seconds_since(start) < kPatience) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      Raster now = frame();
      if (now == last) continue;
      last = std::move(now);
      since = std::chrono::steady_clock::now();
    }
    return last;
  }
  // Waits until the window shows something else.
  bool changes_from(const Raster& before, double seconds = kPatience) const {
    return comes_true([&] { return !(frame() == before); }, seconds);
  }

  // A hand on the keyboard and the mouse, in pixels of the window.
  void keys(const std::string& names) const { session_.xdotool("key " + names); }
  void type(const std::string& text) const { session_.xdotool("type --delay 10 '" + text + "'"); }
  void move(int x, int y) const { session_.xdotool(to(x, y)); }
  void drag(int x, int y, int to_x, int to_y) const {
    constexpr int kSteps = 6;
    std::string words = to(x, y) + " mousedown 1";
    for (int k = 1; k <= kSteps; ++k)
      words += " " + to(x + (to_x - x) * k / kSteps, y + (to_y - y) * k / kSteps) + " sleep 0.02";
    session_.xdotool(words + " mouseup 1");
  }
  // As the button of the window's frame does.
  void close() const { session_.xdotool("key alt+F4"); }
  void send(int signal) const { ::kill(child_, signal); }

  // The exit code, once it ends: 128 more than a signal that ended it. Nothing while it has not, after so many seconds.
  std::optional<int> exit_code(double seconds = kPatience) {
    comes_true([this] { return has_ended(); }, seconds);
    return code_;
  }
  bool has_ended() {
    int status = 0;
    if (!code_ && ::waitpid(child_, &status, WNOHANG) == child_)
      code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return code_.has_value();
  }
  // What it has said on stderr.
  std::string said() const { return testing_cli::contents(error_file_); }

 private:
  void start(const std::filesystem::path& directory, const std::vector<std::string>& words) {
    std::vector<std::string> all{HOTTEL_PROGRAM, "view"};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char*> arguments;
    for (std::string& word : all) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    child_ = ::fork();
    if (child_ < 0) throw std::runtime_error("fork failed");
    if (child_ > 0) return;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int errors = ::open(error_file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(errors, 2);
    if (::chdir(directory.c_str()) == 0) ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  std::string to(int x, int y) const {
    return "mousemove --window " + id_ + " " + std::to_string(x) + " " + std::to_string(y);
  }

  const XvfbSession& session_;
  std::filesystem::path error_file_;
  pid_t child_ = -1;
  std::string id_;
  std::optional<int> code_;
};

}  // namespace hottel::testing_window
