// A command that computes something of a scene and writes it to a file: run, timed, stopped.
#pragma once

#include <filesystem>
#include <string>

#include "io/files/held_folder.h"

namespace hottel {

// A folder for the output of one command, among the temporary files of the system.
class ScratchFolder : public OwnFolder {
 public:
  ScratchFolder();
};

// What a command left behind, and how long it took.
struct CommandRun {
  std::filesystem::path output;  // the file it wrote, in the scratch folder
  double seconds = 0;            // wall-clock time from the start of the shell to its end
};

// Runs a command by /bin/sh -c.
//
//   {scene}        in it is replaced by the path of the scene's file,
//   {out}          by the path of the file to write, which ends in .csv; {out.mtx}, {out.npy}, ... give another ending.
//                  A command without either writes its output to standard output.
//
// Paths with unusual characters are put between quotes. Other braces are left alone. Standard input is empty; standard
// error is passed through, and so is standard output when there is an {out}: to standard error.
//
// Throws RequestError, naming the command, when it fails (with its status or signal), cannot be started, or leaves no
// output; UsageError when it has an {out} of two different endings; Interrupted after Ctrl-C, when the command and all
// it started have been told to end, and killed where they do not within half a second.
CommandRun run_external_command(const std::string& command, const std::string& scene, const ScratchFolder& scratch);

// Kills the command that is running, if any, with all it started, and waits for its end. Async-signal-safe.
void kill_external_command() noexcept;

}  // namespace hottel
