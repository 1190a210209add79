// A screen in memory with a window manager, a hand on its mouse and keyboard, and an eye on what it shows.
#pragma once

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "viewer/picture/raster.h"

namespace hottel::testing_window {

// The value of a variable of the environment while it lives; nothing: not set.
class ScopedVariable {
 public:
  ScopedVariable(std::string name, const std::optional<std::string>& value) : name_(std::move(name)) {
    if (const char* before = std::getenv(name_.c_str())) before_ = before;
    set(value);
  }
  ~ScopedVariable() { set(before_); }
  ScopedVariable(const ScopedVariable&) = delete;
  ScopedVariable& operator=(const ScopedVariable&) = delete;

 private:
  void set(const std::optional<std::string>& value) const {
    if (value) {
      ::setenv(name_.c_str(), value->c_str(), 1);
    } else {
      ::unsetenv(name_.c_str());
    }
  }

  std::string name_;
  std::optional<std::string> before_;
};

// A program that runs beside the test, silent, and ends with it.
class Companion {
 public:
  // The program inherits the file descriptor, if one is given (not -1).
  explicit Companion(const std::vector<std::string>& words, int inherited = -1) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    child_ = ::fork();
    if (child_ < 0) throw std::runtime_error("fork failed");
    if (child_ > 0) return;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int null = ::open("/dev/null", O_RDWR);
    for (const int stream : {0, 1, 2}) ::dup2(null, stream);
    if (inherited != -1) ::fcntl(inherited, F_SETFD, 0);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
  ~Companion() {
    ::kill(child_, SIGTERM);
    ::waitpid(child_, nullptr, 0);
  }
  Companion(const Companion&) = delete;
  Companion& operator=(const Companion&) = delete;

 private:
  pid_t child_;
};

// Starts Xvfb and openbox and makes their display that of this process and those it starts, until it is destroyed.
// Functions throw std::runtime_error where a program is missing, with the Debian package that has it, or fails.
class XvfbSession {
 public:
  explicit XvfbSession(std::uint32_t width = 1400, std::uint32_t height = 1000) {
    need("Xvfb", "xvfb");
    need("openbox", "openbox");
    need("xdotool", "xdotool");
    need("xwd", "x11-apps");
    need("xprop", "x11-utils");
    need("setxkbmap", "x11-xkb-utils");
    start_screen(width, height);
    start_window_manager();
  }
  ~XvfbSession() {
    manager_.reset();
    screen_.reset();
    std::error_code ignored;
    std::filesystem::remove(configuration_, ignored);
  }
  XvfbSession(const XvfbSession&) = delete;
  XvfbSession& operator=(const XvfbSession&) = delete;

  // ":99".
  const std::string& display() const { return display_; }

  // Runs xdotool with the words of a shell line, and returns what it prints, without the last line end.
  std::string xdotool(const std::string& words) const {
    std::string text = output("xdotool " + words);
    if (text.ends_with('\n')) text.pop_back();
    return text;
  }

  // Gives the keyboard a layout: "us", "fr".
  void set_keyboard(const std::string& layout) const { output("setxkbmap " + layout); }

  // The id of the visible window whose title matches a pattern, once there is one, for xdotool.
  std::string window(const std::string& pattern) const {
    std::string id;
    for (int tries = 0; tries < 200; ++tries) {
      std::istringstream ids(output("xdotool search --onlyvisible --name '" + pattern + "' || true"));
      if (ids >> id) return id;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    throw std::runtime_error("no window is called " + pattern);
  }

  // What the whole screen shows, or the inside of a window; opaque.
  Raster screen() const { return parsed(output("xwd -silent -root")); }
  Raster grab(const std::string& window) const { return parsed(output("xwd -silent -id " + window)); }

 private:
  static void need(const std::string& program, const std::string& package) {
    if (std::system(("command -v " + program + " >/dev/null").c_str()) != 0)
      throw std::runtime_error(program + " is missing: install the package " + package + " (tools/setup does)");
  }

  // What a program prints that ends within twenty seconds: one that waits for a screen that never answers would take
  // the test with it, and leave nothing to read.
  static std::string output(const std::string& command) {
    const std::string line = "LC_ALL=C.UTF-8 timeout 20 " + command;
    const auto close = [](FILE* pipe) { return ::pclose(pipe); };
    std::unique_ptr<FILE, decltype(close)> pipe(::popen(line.c_str(), "r"), close);
    std::string text;
    std::array<char, 1 << 16> part;
    while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe.get())) text.append(part.data(), size);
    const int status = ::pclose(pipe.release());
    if (status != 0) throw std::runtime_error(line + " ended with status " + std::to_string(status) + ": " + text);
    return text;
  }

  void start_screen(std::uint32_t width, std::uint32_t height) {
    std::array<int, 2> ends;
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    const std::string size = std::to_string(width) + "x" + std::to_string(height) + "x24";
    screen_.emplace(std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", size,
                                             "-nolisten", "tcp", "-noreset"},
                    ends[1]);
    ::close(ends[1]);
    std::string number;  // and a line end, once the screen is there
    for (char c = 0; c != '\n';) {
      const ssize_t got = ::read(ends[0], &c, 1);
      if (got < 0 && errno == EINTR) continue;
      if (got != 1) throw std::runtime_error("Xvfb has not started");
      if (c != '\n') number += c;
    }
    ::close(ends[0]);
    display_ = ":" + number;
    variables_.emplace_back(std::make_unique<ScopedVariable>("DISPLAY", display_));
    for (const char* name : {"WAYLAND_DISPLAY", "SDL_VIDEODRIVER", "XMODIFIERS"})
      variables_.emplace_back(std::make_unique<ScopedVariable>(name, std::nullopt));
  }

  // No key or button means anything to the window manager, but for Alt and F4, which closes a window.
  void start_window_manager() {
    configuration_ = std::filesystem::temp_directory_path() / ("hottel-openbox-" + std::to_string(::getpid()) + ".xml");
    std::ofstream(configuration_) << "<openbox_config xmlns='http://openbox.org/3.4/rc'><keyboard>"
                                     "<keybind key='A-F4'><action name='Close'/></keybind></keyboard><mouse/>"
                                     "</openbox_config>\n";
    manager_.emplace(std::vector<std::string>{"openbox", "--sm-disable", "--config-file", configuration_});
    // A window that is opened between its first word and its first answer may never be shown, and waits for ever.
    for (int tries = 0; tries < 200; ++tries) {
      output("xdotool set_num_desktops 1 2>/dev/null || true");
      if (output("xprop -root _NET_NUMBER_OF_DESKTOPS").ends_with("= 1\n")) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    throw std::runtime_error("openbox has not started");
  }

  // The format of xwd: 25 big-endian numbers, a name, colours of 12 bytes each, rows. Of a screen with windows of
  // several visuals it says that pixels have 24 bits, and writes 32.
  static Raster parsed(const std::string& dump) {
    const auto number = [&](std::size_t k) {
      std::uint32_t value = 0;
      for (std::size_t b = 0; b < 4; ++b) value = value << 8 | static_cast<unsigned char>(dump.at(4 * k + b));
      return value;
    };
    constexpr std::uint32_t kVersion = 7, kLowByteFirst = 0;
    if (number(1) != kVersion || number(7) != kLowByteFirst || (number(11) != 24 && number(11) != 32))
      throw std::runtime_error("xwd: not what this test reads");
    Raster raster(number(4), number(5));
    const std::size_t begin = number(0) + 12 * std::size_t{number(19)}, row = number(12), pixel = number(11) / 8;
    for (std::uint32_t y = 0; y < raster.height; ++y)
      for (std::uint32_t x = 0; x < raster.width; ++x)
        for (std::size_t b = 0; b < 3; ++b)
          raster.pixels[std::size_t{y} * raster.width + x] |=
              std::uint32_t{static_cast<unsigned char>(dump.at(begin + y * row + pixel * x + b))} << (8 * b);
    return raster;
  }

  std::vector<std::unique_ptr<ScopedVariable>> variables_;
  std::string display_;
  std::filesystem::path configuration_;
  std::optional<Companion> screen_, manager_;
};

}  // namespace hottel::testing_window
