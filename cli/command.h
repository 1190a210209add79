// How a command joins the program `hottel`.
//
// A command NAME is one file cli/NAME.cpp with one function, add_NAME, declared here and called in add_all_commands();
// nothing else in the program knows the command or its options:
//
//   struct ConvertOptions { std::string in, out; };
//
//   void add_convert(Commands& commands) {
//     const auto options = std::make_shared<ConvertOptions>();
//     CLI::App& command = commands.add("convert", "Rewrite a scene", {"hottel convert plan.svg plan.json"},
//                                      [options](Streams& streams) { return convert(*options, streams); });
//     command.add_option("IN", options->in, "...")->required();
//   }
//
// What run() throws becomes one line (and hints) on stderr and the exit code:
//   0    it returns ExitCode::kDone, or standard output was closed by its reader
//   1    RequestError, std::bad_alloc, anything unforeseen
//   2    UsageError (CLI11 throws its own for unknown commands and options, before run); an argument that is empty
//   3    InputError, OutputError, std::filesystem::filesystem_error
//   130  Interrupted by Ctrl-C; 128 + signal by another one. Work that polls kernel/support/interrupt.h stops by
//        itself; other work is ended after a second, or at the second signal, without a trace: temporary files of
//        OutputFile are removed in the signal handler.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/streams.h"

namespace hottel {

// What the program returns. kUnmet: the request cannot be met, or memory does not suffice; kUsage: an option or a
// name that makes no sense; kFile: a file cannot be read or written, or holds what it must not; kInterrupted: it
// was told to stop.
enum class ExitCode : int { kDone = 0, kUnmet = 1, kUsage = 2, kFile = 3, kInterrupted = 130 };

// Checks of an option's number, in words: CLI11's own let NaN pass and take -5 for a very large unsigned
// number. Finite numbers only.
CLI::Validator positive_number();
CLI::Validator number_not_below_zero();
CLI::Validator number_between(double least, double most);

// A whole number in this range, for CLI::Option::transform: leading zeros are dropped, which CLI11 takes for the mark
// of octal numbers.
CLI::Validator whole_number(std::uint64_t least = 0, std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

// Throws UsageError unless a scene is written to standard output ("" or "-") or to a file that ends in .json.
void require_scene_ending(const std::string& command, const std::string& file);

// The commands of the program. Each has --help, --quiet and --threads without doing anything for it.
class Commands {
 public:
  // The program's name and arguments, until run() is called.
  Commands();

  // Adds a command. `examples` are whole command lines that work when pasted in the root of the repository (a test
  // runs them); they end the command's --help.
  CLI::App& add(const std::string& name, const std::string& summary, const std::vector<std::string>& examples,
                std::function<ExitCode(Streams&)> run);

  // How many threads may work where --threads is not given. REQUIRES threads >= 1.
  void set_threads(int threads) { threads_ = threads; }

  // The first signal is not to ask for a stop, but to end the process (cli/signals.h).
  void end_at_first_signal() { ends_at_first_signal_ = true; }

  // Parses the command line, runs the command and returns the exit code of the program. Does not throw.
  int run(int argc, const char* const* argv) noexcept;

 private:
  ExitCode parse_and_run(int argc, const char* const* argv);
  void add_common_options(CLI::App& app);

  CLI::App program_;
  std::function<ExitCode(Streams&)> chosen_;
  bool is_quiet_ = false;
  int threads_ = 0;  // 0: as many as there are cores
  bool ends_at_first_signal_ = false;
};

// Each adds one command, with its options and examples (cli/NAME.cpp).
void add_solve(Commands& commands);
void add_plan(Commands& commands);
void add_factors(Commands& commands);
void add_visibility(Commands& commands);
void add_check(Commands& commands);
void add_compare(Commands& commands);
void add_reference(Commands& commands);
void add_generate(Commands& commands);
void add_convert(Commands& commands);
void add_view(Commands& commands);
void add_store(Commands& commands);
void add_animate(Commands& commands);
// Adds them all.
void add_all_commands(Commands& commands);

}  // namespace hottel
