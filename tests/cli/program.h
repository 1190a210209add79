// The program as a stranger runs it: in a directory of its own, by shell lines.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "tests/temporary_folder.h"

namespace hottel::testing_cli {

namespace fs = std::filesystem;

struct Outcome {
  int code = -1;  // -1: ended by a signal
  std::string out, err;
};

inline std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// A directory that is removed at the end. `hottel` in a shell line is the program that was built.
class Workplace {
 public:
  Workplace() { fs::create_directory(directory_ / "work"); }

  fs::path path(const std::string& name) const { return directory_ / "work" / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  std::string read(const std::string& name) const { return contents(path(name)); }

  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(directory_ / "work"))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  Outcome run(const std::string& line) const {
    const std::string whole = "export HOTTEL_SPEED=1; cd '" + (directory_ / "work").string() + "' && PATH='" +
                              fs::path(HOTTEL_PROGRAM).parent_path().string() + "':\"$PATH\" && { " + line + "\n} >'" +
                              (directory_ / "out").string() + "' 2>'" + (directory_ / "err").string() + "'";
    const pid_t child = ::fork();
    if (child == 0) {
      ::execl("/bin/bash", "bash", "-c", whole.c_str(), nullptr);
      ::_exit(126);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(directory_ / "out"), contents(directory_ / "err")};
  }

 private:
  TemporaryFolder directory_;
};

}  // namespace hottel::testing_cli
