#include "io/files/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "io/files/abandoned.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"

namespace hottel {
namespace {

constexpr std::size_t kBufferBytes = 1 << 16;
constexpr std::uint64_t kBytesOnTheWay = 1 << 23;  // written before the disk is told to begin with them
constexpr int kMostNames = 1000;                   // tried before giving up

std::string text_of(int error) { return "cannot be written: " + std::string(std::strerror(error)); }

// The folder that lacks, and the error with which it was not made.
[[noreturn]] void refuse_folder(const std::filesystem::path& folder, const std::error_code& error) {
  const std::filesystem::path parent = folder.has_parent_path() ? folder.parent_path() : ".";
  const std::string why = error == std::errc::no_such_file_or_directory
                              ? "'" + parent.string() + "' takes no new folders"
                          : error == std::errc::not_a_directory ? "'" + parent.string() + "' is a file, not a folder"
                                                                : error.message();
  throw OutputError(folder.string(), "this folder cannot be made: " + why);
}

}  // namespace

std::string unwritten_text(const std::filesystem::path& directory, int error) {
  std::error_code unknown;
  if (error != ENOENT) return text_of(error);
  return "cannot be written: " + (std::filesystem::exists(directory, unknown)
                                      ? "'" + directory.string() + "' takes no new files"
                                      : "there is no directory '" + directory.string() + "'");
}

OutputFile::OutputFile(const std::filesystem::path& file)
    : name_(file == "-" ? "standard output" : file.string()), target_(file) {
  if (file == "-") {
    descriptor_ = STDOUT_FILENO;
    is_owned_ = false;
  } else {
    open();
  }
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : name_(std::move(other.name_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      pending_(std::move(other.pending_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      held_(std::exchange(other.held_, -1)),
      is_owned_(other.is_owned_),
      buffer_(std::move(other.buffer_)),
      written_(other.written_),
      begun_(other.begun_) {}

OutputFile::~OutputFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  if (descriptor_ >= 0 && is_owned_) ::close(descriptor_);
  if (held_ >= 0) ::close(held_);
}

void OutputFile::fail(int error) { throw OutputError(name_, text_of(error)); }

void OutputFile::open() {
  if (target_.empty()) throw OutputError("''", "is no name of a file");
  std::error_code unresolved;
  if (auto resolved = std::filesystem::canonical(target_, unresolved); !unresolved) target_ = std::move(resolved);

  struct stat status {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail(errno);
  if (exists && S_ISDIR(status.st_mode)) throw OutputError(name_, "is a directory, not a file");
  if (exists && ::access(target_.c_str(), W_OK) != 0) fail(errno);
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail(errno);
    return;
  }
  const std::filesystem::path directory = target_.has_parent_path() ? target_.parent_path() : ".";
  if (!target_.has_filename()) throw OutputError(name_, "is a directory, not a file");
  remove_abandoned(directory, Abandoned::kFiles);
  for (int k = 0; descriptor_ < 0; ++k) {
    temporary_ = (directory / temporary_file_name(k)).string();
    pending_ = PendingRemoval(temporary_, Removal::kFile);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0 && hold_temporary(descriptor_, temporary_)) break;
    const int error = descriptor_ >= 0 ? EEXIST : errno;  // somebody took it for one that was left behind
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
    pending_ = {};
    temporary_.clear();
    if (error == ENOENT) throw OutputError(name_, unwritten_text(directory, error));
    if (error != EEXIST || k == kMostNames) fail(error);
  }
  if (exists) ::fchmod(descriptor_, status.st_mode & 07777);
}

void OutputFile::drain() {
  hand_on(buffer_);
  buffer_.clear();
}

void OutputFile::hand_on(std::string_view bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) {
      throw_if_interrupted();
      continue;
    }
    if (count < 0 && errno == EPIPE && descriptor_ == STDOUT_FILENO) throw ReaderGone();
    if (count < 0) fail(errno);
    done += static_cast<std::size_t>(count);
  }
  written_ += bytes.size();
  begin_with_disk();
}

// Lets the disk work while the rest is still being made, so that finish() waits for little.
void OutputFile::begin_with_disk() {
#ifdef SYNC_FILE_RANGE_WRITE
  if (temporary_.empty() || written_ - begun_ < kBytesOnTheWay) return;
  // Only advice: what the disk cannot do, finish() finds out.
  (void)::sync_file_range(descriptor_, static_cast<off64_t>(begun_), static_cast<off64_t>(written_ - begun_),
                          SYNC_FILE_RANGE_WRITE);
  begun_ = written_;
#endif
}

void OutputFile::write(std::string_view bytes) {
  HOTTEL_REQUIRE(descriptor_ >= 0);
  if (buffer_.size() + bytes.size() < kBufferBytes) {
    buffer_ += bytes;
    return;
  }
  drain();
  hand_on(bytes);
}

const std::string& OutputFile::place() const {
  if (temporary_.empty()) throw OutputError(name_, "is no regular file, and this format needs one");
  return temporary_;
}

void OutputFile::finish() {
  if (descriptor_ < 0) return;
  drain();
  // A device or pipe has nothing to flush to disk.
  if (!temporary_.empty() && ::fsync(descriptor_) != 0) fail(errno);
  const int descriptor = std::exchange(descriptor_, -1);
  if (!temporary_.empty()) held_ = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);  // until the file has its name
  if (is_owned_ && ::close(descriptor) != 0) fail(errno);
}

void OutputFile::commit() {
  finish();
  if (temporary_.empty()) return;
  throw_if_interrupted();
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
  pending_ = {};
  if (held_ >= 0) ::close(std::exchange(held_, -1));
}

void write_output_file(const std::filesystem::path& file, std::string_view bytes) {
  OutputFile output(file);
  output.write(bytes);
  output.commit();
}

OutputFolder::OutputFolder(const std::filesystem::path& folder) {
  if (folder.empty()) throw OutputError("''", "is no name of a folder");
  std::vector<std::filesystem::path> missing;
  std::error_code error;
  for (auto path = folder; !path.empty() && !std::filesystem::exists(path, error); path = path.parent_path())
    missing.push_back(path);
  for (auto path = missing.rbegin(); path != missing.rend(); ++path) {
    if (std::filesystem::create_directory(*path, error))
      made_.emplace_back(*path, PendingRemoval(path->string(), Removal::kEmptyFolder));
    if (error) refuse_folder(*path, error);
  }
  if (!std::filesystem::is_directory(folder, error)) throw OutputError(folder.string(), "is a file, not a folder");
}

OutputFolder::~OutputFolder() {
  while (!made_.empty()) {
    ::rmdir(made_.back().first.c_str());  // fails where something is in it, as it should
    made_.pop_back();
  }
}

}  // namespace hottel
