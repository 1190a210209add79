#include "io/external/external_command.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string_view>
#include <system_error>

#include "geometry/name.h"
#include "io/files/output_file.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/stopwatch.h"

extern char** environ;

namespace hottel {
namespace {

std::atomic<pid_t> running_group{0};
static_assert(std::atomic<pid_t>::is_always_lock_free, "a signal handler reads this");

// A path as one word of the shell.
std::string shell_word(const std::string& path) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+,:@%";
  if (!path.empty() && path.find_first_not_of(kPlain) == std::string::npos) return path;
  std::string word = "'";
  for (const char c : path) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

// What stands between "{out" and "}" at a place of the command: "", ".mtx"; nothing when this is not such a word.
bool output_ending(std::string_view rest, std::string& ending, std::size_t& length) {
  constexpr std::string_view kOut = "{out";
  if (!rest.starts_with(kOut)) return false;
  std::size_t at = kOut.size();
  if (at < rest.size() && rest[at] == '.')
    while (++at < rest.size() && std::isalnum(static_cast<unsigned char>(rest[at]))) continue;
  if (at == rest.size() || rest[at] != '}' || rest[at - 1] == '.') return false;
  ending = at == kOut.size() ? ".csv" : std::string(rest.substr(kOut.size(), at - kOut.size()));
  length = at + 1;
  return true;
}

struct ShellLine {
  std::string text;
  std::filesystem::path output;
  bool has_output = false;
};

ShellLine filled_in(const std::string& command, const std::string& scene, const std::filesystem::path& folder) {
  constexpr std::string_view kScene = "{scene}";
  ShellLine line;
  line.output = folder / "out.csv";
  for (std::size_t at = 0; at < command.size();) {
    const std::string_view rest = std::string_view(command).substr(at);
    std::string ending;
    std::size_t length = 0;
    if (rest.starts_with(kScene)) {
      line.text += shell_word(scene);
      at += kScene.size();
    } else if (output_ending(rest, ending, length)) {
      const std::filesystem::path output = folder / ("out" + ending);
      if (line.has_output && line.output != output) throw UsageError("run: takes one {out}, or several of one ending");
      line.output = output;
      line.has_output = true;
      line.text += shell_word(output.string());
      at += length;
    } else {
      line.text += command[at++];
    }
  }
  return line;
}

// The attributes and redirections of a command; freed at the end.
class SpawnPlan {
 public:
  explicit SpawnPlan(const ShellLine& line) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (line.has_output)
      posix_spawn_file_actions_adddup2(&actions_, STDERR_FILENO, STDOUT_FILENO);
    else
      posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, line.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                       S_IRUSR | S_IWUSR);
    posix_spawnattr_init(&attributes_);
    sigset_t ours;
    sigemptyset(&ours);
    for (const int signal : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM}) sigaddset(&ours, signal);
    posix_spawnattr_setsigdefault(&attributes_, &ours);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;
  ~SpawnPlan() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  // Returns 0, or what went wrong.
  int start(const std::string& text, pid_t& child) const {
    char shell[] = "sh", option[] = "-c";
    std::string copy = text;
    char* const arguments[] = {shell, option, copy.data(), nullptr};
    return posix_spawn(&child, "/bin/sh", &actions_, &attributes_, arguments, environ);
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

void sleep_for(double seconds) {
  timespec time{0, static_cast<long>(seconds * 1e9)};
  ::nanosleep(&time, nullptr);  // a signal may cut it short
}

// Waits until the child ends or `is_over` says so, looking more and more rarely; true when it has ended.
template <class IsOver>
bool wait_for(pid_t child, int& status, const IsOver& is_over) {
  constexpr double kShortest = 2e-4, kLongest = 2e-2;
  for (double pause = kShortest;; pause = std::min(kLongest, pause * 1.05)) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child || (ended < 0 && errno != EINTR)) return true;
    if (is_over()) return false;
    sleep_for(pause);
  }
}

void stop(pid_t child) {
  int status = 0;
  ::kill(-child, SIGTERM);
  Stopwatch watch;
  double waited = 0;
  if (wait_for(child, status, [&] { return (waited += watch.lap()) > 0.5; })) return;
  ::kill(-child, SIGKILL);
  ::waitpid(child, &status, 0);
}

std::string outcome_text(int status) {
  if (WIFSIGNALED(status))
    return "was ended by signal " + std::to_string(WTERMSIG(status)) + " (" + ::strsignal(WTERMSIG(status)) + ")";
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

std::filesystem::path place_of_scratch() {
  std::error_code missing;
  const std::filesystem::path place = std::filesystem::temp_directory_path(missing);
  if (missing) throw OutputError("TMPDIR", "names no folder for temporary files: " + missing.message());
  return place;
}

}  // namespace

ScratchFolder::ScratchFolder() : OwnFolder(place_of_scratch(), Abandoned::kRunFolders) {}

CommandRun run_external_command(const std::string& command, const std::string& scene, const ScratchFolder& scratch) {
  const std::string named = "the command " + quoted_name(command);
  const ShellLine line = filled_in(command, scene, scratch.path());
  std::filesystem::remove(line.output);  // of an earlier run
  const SpawnPlan plan(line);
  Stopwatch watch;
  pid_t child = 0;
  if (const int error = plan.start(line.text, child); error != 0)
    throw RequestError(named + " cannot be started: " + std::strerror(error));
  running_group = child;
  int status = 0;
  const bool has_ended = wait_for(child, status, interrupted);
  const double seconds = watch.lap();
  if (!has_ended) stop(child);
  running_group = 0;
  throw_if_interrupted();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw RequestError(named + " " + outcome_text(status));
  if (!std::filesystem::exists(line.output)) throw RequestError(named + " ended well but wrote nothing to {out}");
  return {line.output, seconds};
}

void kill_external_command() noexcept {
  const pid_t group = running_group;
  if (group <= 0) return;
  ::kill(-group, SIGKILL);
  while (::waitpid(group, nullptr, 0) < 0 && errno == EINTR) continue;
}

}  // namespace hottel
