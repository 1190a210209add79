// Where a repaired scene goes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "cli/streams.h"
#include "io/files/output_file.h"

namespace hottel {

// The file of a repaired scene: where it is that of the scene itself, written only if something was repaired, and told.
class RepairedFile {
 public:
  // Opens it. Throws OutputError.
  RepairedFile(const std::string& file, const std::filesystem::path& scene) : file_(file), out_(file) {
    std::error_code missing;
    is_input_ = std::filesystem::equivalent(file, scene, missing) && !missing;
  }

  // Holds the text until commit().
  void write(std::string_view text, bool is_repaired) {
    is_written_ = !is_input_ || is_repaired;
    if (!is_written_) return;
    out_.write(text);
    out_.finish();
  }

  // Whether the scene stays as it is, where it would be overwritten by one that is not repaired.
  bool is_left() const { return is_input_ && !is_written_; }

  void commit(const Streams& streams) {
    if (is_written_) out_.commit();
    if (is_input_)
      streams.note(file_ +
                   (is_written_ ? " is overwritten by the repaired scene" : " is left as it is: nothing is repaired"));
  }

 private:
  std::string file_;
  OutputFile out_;
  bool is_input_ = false, is_written_ = false;
};

}  // namespace hottel
