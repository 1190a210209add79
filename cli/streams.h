// Where a command writes: data, remarks, progress.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "cli/progress.h"
#include "io/files/output_file.h"
#include "kernel/support/stage.h"

namespace hottel {

// Data goes to the file of -o, or to standard output; everything else goes to stderr and is silent under --quiet.
class Streams {
 public:
  explicit Streams(bool is_quiet);

  bool is_quiet() const { return is_quiet_; }

  // Where data goes for the value of an option -o: standard output for "" and "-". Commit it when all is written.
  OutputFile output(const std::string& option) const { return OutputFile(option.empty() ? "-" : option); }

  // Writes a whole text there, and commits. That nobody reads standard output any more is no reason to stop.
  void write(const std::string& option, std::string_view text) const;
  // The same with what work writes. The file is opened before the work, which may be long.
  void write_with(const std::string& option, const std::function<void(OutputFile&)>& work) const;

  // A remark on stderr, unless --quiet. Lines; a final newline is added where there is none. An empty
  // text is no remark.
  void note(std::string_view text) const;

  // A callback for work that reports the fraction done, from any thread. It draws a bar with the time left (see
  // Progress) and throws Interrupted after Ctrl-C. The bar vanishes with the last copy of the callback.
  std::function<void(double)> progress(const std::string& what) const;
  // The same for stages (kernel/support/stage.h), one bar after the other.
  StageProgress stages() const;

 private:
  bool is_quiet_;
};

// One line without control characters or ill-formed UTF-8: what a message may contain of a file name or argument. Each
// byte of these is written as \xNN; all else is kept.
std::string one_line(std::string_view text);

// An error message on stderr: the line, then at most three hints, indented. Printed under --quiet too.
void print_error(const std::string& line, const std::vector<std::string>& hints = {}) noexcept;

}  // namespace hottel
