#include "cli/command.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <new>
#include <optional>
#include <sstream>

#include "cli/signals.h"
#include "geometry/near_names.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/out_of_memory.h"
#include "kernel/support/parallel.h"
#include "kernel/version.h"

namespace hottel {
namespace {

constexpr std::uint64_t kMostThreads = 4096;

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

CLI::Validator number_check(const std::string& wanted, std::function<bool(std::string& text)> is_wanted) {
  return CLI::Validator(
      [=](std::string& text) { return is_wanted(text) ? "" : "expected " + wanted + ", not '" + text + "'"; }, "");
}

double number_or_nan(const std::string& text) {
  double number = 0;
  return CLI::detail::lexical_cast(text, number) && std::isfinite(number) ? number : std::nan("");
}

// Nothing is meant by an empty name, path or number: it comes of a variable that is not set.
void refuse_empty_arguments(int argc, const char* const* argv) {
  for (int k = 1; k < argc; ++k) {
    const std::string_view argument = argv[k], before = argv[k - 1];
    const bool is_empty_value = argument.starts_with("--") && argument.find('=') == argument.size() - 1;
    if (!argument.empty() && !is_empty_value) continue;
    const std::string_view option = is_empty_value                     ? argument.substr(0, argument.size() - 1)
                                    : k > 1 && before.starts_with('-') ? before
                                                                       : "";
    throw UsageError((option.empty() ? "an argument" : one_line(option)) + std::string(" is empty"));
  }
}

// An option that was left without its value takes the option that follows for it.
void refuse_options_as_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    for (const std::string& value : option->results())
      if (value.starts_with("--") && command.get_option_no_throw(value) != nullptr)
        throw UsageError(option->get_name() + " wants a value, and " + value + " is an option");
}

// The names of all commands, or of the options of one.
std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}
std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// What may have been meant by an option that a command has not: one of a name near it, or the place of the output.
std::vector<std::string> option_hints(const std::string& option, const CLI::App& command) {
  if (option != "-o" && option != "--out" && option != "--output")
    return near_name_hints(option, option_names(command));
  if (command.get_option_no_throw("-o") != nullptr) return {"-o says where to write"};
  if (command.get_option_no_throw("OUT") != nullptr)
    return {"where to write is an argument: hottel " + command.get_name() + " IN OUT"};
  return {};
}

// "--fix: 1 required OUT missing" and "--elements: At Most 1 required but received 2" in plain words.
std::string told(const CLI::ArgumentMismatch& mismatch) {
  const std::string text = mismatch.what(), option = text.substr(0, text.find(':'));
  if (text.ends_with(" missing")) {
    const std::size_t begin = text.find(" required ") + 10, end = text.size() - 8;
    return option + " wants a value: " + option + " " + text.substr(begin, end - begin);
  }
  return text.find("At Most 1") != std::string::npos ? option + " is given more than once" : text;
}

std::string after_colon(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return "hottel: " + text;
}

// The scene of the command that was chosen; empty where it has none.
std::string scene_file(const CLI::App& program) noexcept {
  try {
    for (const CLI::App* command : program.get_subcommands())
      if (const CLI::Option* scene = command->get_option_no_throw("SCENE"); scene != nullptr && scene->count() > 0)
        return scene->results().front();
  } catch (...) {  // there is no memory for it
  }
  return "";
}

// Says what could not be held, of which scene, and what helps; the least of it where that takes more memory than there
// is.
void report_no_memory(const std::string& scene, const char* work) noexcept {
  try {
    const std::string of = *work != 0 ? std::string(" for the stage '") + work + "'" : "";
    print_error(
        (scene.empty() ? "hottel" : scene) + ": memory ran out" + of,
        {"fewer elements (--elements, --element-size), or fewer cells (--grid) where light is asked for, take less",
         "`hottel plan SCENE --memory BYTES` tells what each stage takes"});
  } catch (...) {
    print_error("hottel: memory ran out");
  }
}

// The exit code and the message of the exception that is being handled. scene: the file that the command is about,
// where there is one.
ExitCode report_failure(const std::string& scene) noexcept {
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
  } catch (const UnknownName& error) {
    print_error(after_colon(error.what()), error.hints());
    return ExitCode::kUsage;
  } catch (const UsageError& error) {
    print_error(after_colon(error.what()));
    return ExitCode::kUsage;
  } catch (const RequestError& error) {
    print_error(error.what());
    return ExitCode::kUnmet;
  } catch (const ReaderGone&) {
    return ExitCode::kDone;
  } catch (const OutOfMemory& error) {
    report_no_memory(scene, error.what());
    return ExitCode::kUnmet;
  } catch (const std::bad_alloc&) {
    report_no_memory(scene, "");
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

CLI::Validator number_between(double least, double most) {
  return number_check(fmt::format("a number from {} to {}", least, most), [least, most](const std::string& text) {
    const double number = number_or_nan(text);
    return least <= number && number <= most;
  });
}

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) {
  const bool has_most = most < std::numeric_limits<std::uint64_t>::max();
  const std::string wanted = has_most ? "a whole number from " + std::to_string(least) + " to " + std::to_string(most)
                                      : "a whole number from " + std::to_string(least) + " to 2^64 - 1";
  return number_check(wanted, [least, most](std::string& text) {
    if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos) return false;
    text.erase(0, std::min(text.find_first_not_of('0'), text.size() - 1));
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && least <= number && number <= most;
  });
}

void require_scene_ending(const std::string& command, const std::string& file) {
  if (!file.empty() && file != "-" && std::filesystem::path(file).extension() != ".json")
    throw UsageError(command + " writes a scene (.json, or - for standard output), not '" + file + "'");
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
      ->transform(whole_number(1, kMostThreads));
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
  refuse_empty_arguments(argc, argv);
  try {
    program_.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    std::ostringstream text, unused;
    program_.exit(success, text, unused);
    Streams(true).write("-", text.str());
    return ExitCode::kDone;
  } catch (const CLI::ParseError& error) {
    const auto chosen = program_.get_subcommands();
    const CLI::App& command = chosen.empty() ? program_ : *chosen.front();
    refuse_options_as_values(command);
    const std::string name = chosen.empty() ? "hottel" : "hottel " + command.get_name();
    std::string message = error.what();
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && chosen.empty()) message = "no command is given";
    if (const auto* const mismatch = dynamic_cast<const CLI::ArgumentMismatch*>(&error)) message = told(*mismatch);
    std::vector<std::string> hints;
    if (auto extras = program_.remaining(true);
        !extras.empty() && (chosen.empty() || dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)) {
      // The first option is what is wrong, the rest perhaps its values; CLI11 lists them in another order.
      const auto is_option = [](const std::string& text) { return text.starts_with("-"); };
      const auto option = std::find_if(extras.begin(), extras.end(), is_option);
      const std::string& extra = chosen.empty() || option == extras.end() ? extras.front() : *option;
      const char* what = is_option(extra) ? "option" : chosen.empty() ? "command" : "argument";
      message = (chosen.empty() ? "there is no " : command.get_name() + " has no ") + std::string(what) + " '" +
                one_line(extra) + "'";
      if (is_option(extra))
        hints = option_hints(extra, command);
      else if (chosen.empty())
        hints = near_name_hints(extra, command_names(program_));
    }
    hints.push_back("`" + name + " --help` shows what there is");
    print_error(after_colon(message), hints);
    return ExitCode::kUsage;
  }
  const CLI::App* const chosen = program_.get_subcommands().front();
  refuse_options_as_values(*chosen);
  if (program_.count("--threads") > 0 && chosen->count("--threads") > 0)
    throw UsageError("--threads is given twice, before and after the command");
  std::optional<ThreadLimit> limit;
  if (threads_ > 0) limit.emplace(threads_);
  Streams streams(is_quiet_);
  return chosen_(streams);
}

void add_all_commands(Commands& commands) {
  add_solve(commands);
  add_plan(commands);
  add_factors(commands);
  add_visibility(commands);
  add_check(commands);
  add_compare(commands);
  add_reference(commands);
  add_generate(commands);
  add_convert(commands);
  add_view(commands);
  add_animate(commands);
  add_store(commands);
}

int Commands::run(int argc, const char* const* argv) noexcept {
  try {
    install_signal_handlers(ends_at_first_signal_);
    return static_cast<int>(parse_and_run(argc, argv));
  } catch (...) {
    const ExitCode code = report_failure(scene_file(program_));
    return code == ExitCode::kInterrupted ? code_of_interruption() : static_cast<int>(code);
  }
}

}  // namespace hottel
