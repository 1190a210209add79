// A run of the program that is killed after so much work.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace hottel::testing_cli {

// As many kills of each scene, and scenes so many times as large, as the environment says: tools/killed_runs asks for
// more.
inline int asked(const char* name, int usual) {
  const char* const text = std::getenv(name);
  return text == nullptr ? usual : std::atoi(text);
}

inline double seconds_of(const rusage& use) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(use.ru_utime) + seconds(use.ru_stime);
}

// Seconds that all threads of a process have worked.
inline double seconds_of(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text);
  std::istringstream words(text.substr(std::min(text.rfind(')') + 1, text.size())));
  std::string word;
  double ticks = 0;
  for (int k = 3; k <= 15 && words >> word; ++k)
    if (k >= 14) ticks += std::atof(word.c_str());
  return ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

struct KilledRun {
  bool succeeded = false, was_killed = false;
  double seconds = 0;  // of work, of all threads
};

// Kills it once its threads have worked for so many seconds. Looks at it all the while.
inline KilledRun run(
    const std::vector<std::string>& words, double seconds, const std::function<void(pid_t)>& look = [](pid_t) {}) {
  const pid_t child = ::fork();
  if (child == 0) {
    const int null = ::open("/dev/null", O_WRONLY);
    ::dup2(null, 1);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ::execv(HOTTEL_PROGRAM, arguments.data());
    ::_exit(126);
  }
  KilledRun result;
  int status = 0;
  rusage use{};
  while (::wait4(child, &status, WNOHANG, &use) == 0) {
    look(child);
    if (!result.was_killed && seconds_of(child) >= seconds) result.was_killed = ::kill(child, SIGKILL) == 0;
    ::usleep(2000);
  }
  result.succeeded = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  result.was_killed = WIFSIGNALED(status);
  result.seconds = seconds_of(use);
  return result;
}

}  // namespace hottel::testing_cli
