// Every option of every command: where it has an effect, and where it is refused because it would have none.
//
// The lines are those of a shell in an empty directory. What they print on standard output is compared, so a line shows
// what matters of its files. Every command has --help, --quiet and --threads besides; they are tested for all alike.
#pragma once

#include <ostream>
#include <utility>
#include <vector>

namespace hottel {

struct OptionCommand {
  const char* name;
  const char* line;  // where it works
};

struct OptionRefusal {
  const char* line;
  const char* message;  // what the message holds; the exit code is 2
};

struct OptionEntry {
  const char *command, *option;
  const char *with, *without;  // print something else each; nullptr for what is always refused
  std::vector<OptionRefusal> refused = {};
};

inline void PrintTo(const OptionCommand& command, std::ostream* out) { *out << command.name; }
inline void PrintTo(const OptionEntry& entry, std::ostream* out) { *out << entry.command << " " << entry.option; }

// Files of the table by name, and the shell variables that name scenes of the repository.
const std::vector<std::pair<const char*, const char*>>& option_scenes();
inline constexpr const char* kOptionVariables =
    "S=scenes/analytic/strip_obstructed.json; Q=scenes/analytic/square_radiosity.json; C=scenes/space/cube.json";

const std::vector<OptionCommand>& option_commands();
const std::vector<OptionEntry>& option_entries();

}  // namespace hottel
