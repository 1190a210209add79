#include "cli/command.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <new>
#include <optional>
#include <sstream>

#include "cli/signals.h"
#include "kernel/failure.h"
#include "kernel/interrupt.h"
#include "kernel/parallel.h"
#include "kernel/version.h"

namespace hottel {
namespace {

constexpr int kMostThreads = 4096;

// In the list of commands a command has one line: the first of its description.
class ProgramFormatter : public CLI::Formatter {
 public:
  std::string make_subcommand(const CLI::App* command) const override {
    const std::string description = command->get_description();
    std::ostringstream text;
    CLI::detail::format_help(text, command->get_name(), description.substr(0, description.find('\n')),
                             get_column_width());
    return text.str();
  }
};

CLI::Validator number_check(const std::string& wanted, bool (*is_wanted)(const std::string& text)) {
  return CLI::Validator(
      [=](std::string& text) { return is_wanted(text) ? "" : "expected " + wanted + ", not '" + text + "'"; }, "");
}

double number_or_nan(const std::string& text) {
  double number = 0;
  return CLI::detail::lexical_cast(text, number) && std::isfinite(number) ? number : std::nan("");
}

std::string after_colon(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return "hottel: " + text;
}

// The exit code and the message of the exception that is being handled.
ExitCode report_failure() noexcept {
  if (interrupted()) return ExitCode::kInterrupted;  // whatever the interruption made fail
  try {
    throw;
  } catch (const InputError& error) {
    print_error(error.what(), error.hints());
    return ExitCode::kFile;
  } catch (const OutputError& error) {
    print_error(error.what());
    return ExitCode::kFile;
  } catch (const std::filesystem::filesystem_error& error) {
    print_error(error.path1().string() + ": " + error.code().message());
    return ExitCode::kFile;
  } catch (const UsageError& error) {
    print_error(after_colon(error.what()));
    return ExitCode::kUsage;
  } catch (const RequestError& error) {
    print_error(error.what());
    return ExitCode::kUnmet;
  } catch (const ReaderGone&) {
    return ExitCode::kDone;
  } catch (const std::bad_alloc&) {
    print_error("hottel: out of memory");
    return ExitCode::kUnmet;
  } catch (const std::exception& error) {
    print_error(std::string("hottel: internal error: ") + error.what());
    return ExitCode::kUnmet;
  } catch (...) {
    print_error("hottel: internal error: unknown");
    return ExitCode::kUnmet;
  }
}

}  // namespace

CLI::Validator positive_number() {
  return number_check("a positive number", [](const std::string& text) { return number_or_nan(text) > 0; });
}

CLI::Validator number_not_below_zero() {
  return number_check("a number not below 0", [](const std::string& text) { return number_or_nan(text) >= 0; });
}

CLI::Validator whole_number() {
  return number_check("a whole number not below 0", [](const std::string& text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return '0' <= c && c <= '9'; });
  });
}

Commands::Commands() : program_("hottel: the exact reference for diffuse light", "hottel") {
  program_.require_subcommand(1);
  program_.set_version_flag("--version", std::string("hottel ") + kVersion, "Print the version and exit");
  program_.set_help_flag("-h,--help", "Print this text and exit");
  program_.footer("`hottel COMMAND --help` shows the options of a command, with examples.");
  const auto formatter = std::make_shared<ProgramFormatter>();
  formatter->column_width(34);
  program_.formatter(formatter);
  add_common_options(program_);
}

void Commands::add_common_options(CLI::App& app) {
  app.add_flag("--quiet", is_quiet_, "No remarks and no progress bar on stderr, only errors");
  app.add_option("--threads", threads_, "Number of threads; results do not depend on it")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
}

CLI::App& Commands::add(const std::string& name, const std::string& summary, const std::vector<std::string>& examples,
                        std::function<ExitCode(Streams&)> run) {
  CLI::App* command = program_.add_subcommand(name, summary);
  std::string footer = "Examples:";
  for (const std::string& example : examples) footer += "\n  " + example;
  command->footer(footer);
  command->callback([this, run = std::move(run)] { chosen_ = run; });
  add_common_options(*command);
  return *command;
}

ExitCode Commands::parse_and_run(int argc, const char* const* argv) {
  try {
    program_.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    std::ostringstream text, unused;
    program_.exit(success, text, unused);
    Streams(true).write("-", text.str());
    return ExitCode::kDone;
  } catch (const CLI::ParseError& error) {
    const auto chosen = program_.get_subcommands();
    if (const auto extras = program_.remaining(); chosen.empty() && !extras.empty()) {
      const std::string what = extras.front().starts_with("-") ? "option" : "command";
      print_error(after_colon("there is no " + what + " '" + one_line(extras.front()) + "'"),
                  {"`hottel --help` shows what there is"});
      return ExitCode::kUsage;
    }
    const std::string command = chosen.empty() ? "hottel" : "hottel " + chosen.front()->get_name();
    print_error(after_colon(error.what()), {"`" + command + " --help` shows what there is"});
    return ExitCode::kUsage;
  }
  std::optional<ThreadLimit> limit;
  if (threads_ > 0) limit.emplace(threads_);
  Streams streams(is_quiet_);
  return chosen_(streams);
}

int Commands::run(int argc, const char* const* argv) noexcept {
  try {
    install_signal_handlers();
    return static_cast<int>(parse_and_run(argc, argv));
  } catch (...) {
    return static_cast<int>(report_failure());
  }
}

}  // namespace hottel
