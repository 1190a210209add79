// A file that appears whole or not at all, and a folder that is there only if something comes into it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/files/pending_removal.h"

namespace hottel {

// A file cannot be written. what() is "FILE: text", one line.                                       (exit code 3)
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::string& file, const std::string& text) : std::runtime_error(file + ": " + text), file_(file) {}
  const std::string& file() const { return file_; }

 private:
  std::string file_;
};

// Returns why no file can be made in a directory, by the number of the error: "cannot be written: there is no directory
// 'out'".
std::string unwritten_text(const std::filesystem::path& directory, int error);

// Nobody reads standard output any more: no reason for a message. The program ends without one, as if all were done.
class ReaderGone : public std::exception {
 public:
  const char* what() const noexcept override { return "the reader of standard output has gone"; }
};

// Writes a file under a temporary name in the same directory and renames it on commit().
//
//   (1) until commit() returns, a file that was there before is untouched
//   (2) without commit() the temporary file is removed by the destructor (or by remove_pending)
//   (3) every error of opening, writing, flushing to disk, closing and renaming throws OutputError
//   (4) an existing file keeps its permissions, a symbolic link stays one
//   (5) temporary files that killed runs left in the directory are removed (abandoned.h)
//
// "-" is standard output: there is no temporary, and bytes go out as the buffer fills. A path that exists and is no
// regular file (/dev/null, a pipe) is written to directly. A directory, or a file without write permission, is refused
// when it is to be opened.
class OutputFile {
 public:
  // Opens the file to write. Throws OutputError, for an empty name too.
  explicit OutputFile(const std::filesystem::path& file);
  OutputFile(OutputFile&&) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  // Appends bytes; they go out in pieces of some 64 KiB, or as they come where they are more. Throws OutputError,
  // ReaderGone when standard output is a pipe that nobody reads, Interrupted when a stop is asked for while a write
  // waits. REQUIRES that finish() or commit() has not been called.
  void write(std::string_view bytes);

  // Puts everything on disk and closes; nothing may be written afterwards. To replace several files together, finish()
  // all of them first, then commit() each: what can fail is over by then.
  void finish();

  // finish(), then the file takes its name. Throws Interrupted instead when a stop was requested.
  void commit();

  const std::string& name() const { return name_; }
  // Where the bytes are until commit(), for libraries that write a file by its path, instead of write(). Throws
  // OutputError for what is no regular file.
  const std::string& place() const;

 private:
  void open();
  void drain();
  void hand_on(std::string_view bytes);
  void begin_with_disk();
  [[noreturn]] void fail(int error);

  std::string name_;  // for messages
  std::filesystem::path target_;
  std::string temporary_;  // empty: written to directly
  PendingRemoval pending_;
  int descriptor_ = -1;
  int held_ = -1;         // a copy of it, from finish() on
  bool is_owned_ = true;  // the descriptor is ours to close
  std::string buffer_;
  std::uint64_t written_ = 0, begun_ = 0;  // bytes handed on, and those that the disk was told of
};

// Writes a whole file; see OutputFile. Until it returns a file that was there before is untouched.
void write_output_file(const std::filesystem::path& file, std::string_view bytes);

// Makes the folder where there is none, with those that it lies in.
//
//   (1) what it made and is empty at the end is removed again: by the destructor, or when a signal ends the program
//   (2) a folder that was there before stays
class OutputFolder {
 public:
  // Throws OutputError when it cannot be made, or is a file.
  explicit OutputFolder(const std::filesystem::path& folder);
  OutputFolder(OutputFolder&&) noexcept = default;
  OutputFolder& operator=(OutputFolder&&) = delete;
  ~OutputFolder();

 private:
  std::vector<std::pair<std::filesystem::path, PendingRemoval>> made_;  // each in the one before
};

}  // namespace hottel
