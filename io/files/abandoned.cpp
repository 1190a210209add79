#include "io/files/abandoned.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <fstream>
#include <mutex>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace hottel {
namespace {

constexpr std::string_view kPrefixes[] = {".hottel-", "hottel-run-", "hottel-sums-"};  // by Abandoned
constexpr std::string_view kFileEnding = ".tmp";
constexpr std::time_t kDay = 24 * 60 * 60;  // seconds

std::string_view prefix_of(Abandoned what) { return kPrefixes[static_cast<std::size_t>(what)]; }

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// What stands before the next "-", or all; it is taken from the text.
std::string_view take_part(std::string_view& text) {
  const std::size_t end = std::min(text.find('-'), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

// The kernel in the name of a temporary; empty in those of earlier versions, nothing for other names.
std::optional<std::string> kernel_of(std::string_view name, Abandoned what) {
  const bool is_file = what == Abandoned::kFiles;
  if (!name.starts_with(prefix_of(what))) return std::nullopt;
  name.remove_prefix(prefix_of(what).size());
  if (is_file) {
    if (!name.ends_with(kFileEnding)) return std::nullopt;
    name.remove_suffix(kFileEnding.size());
  }
  if (!is_number(take_part(name))) return std::nullopt;
  if (is_file && !is_number(take_part(name))) return std::nullopt;
  std::string kernel(take_part(name));
  return is_file == name.empty() ? std::optional(std::move(kernel)) : std::nullopt;
}

bool is_at(const struct stat& status, const std::string& path) {
  struct stat there {};
  return ::lstat(path.c_str(), &there) == 0 && there.st_dev == status.st_dev && there.st_ino == status.st_ino;
}

class Descriptor {
 public:
  Descriptor(const std::string& path, int flags) : number_(::open(path.c_str(), flags)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

void remove_if_abandoned(const std::string& path, bool is_of_this_kernel, Abandoned what) {
  const bool is_file = what == Abandoned::kFiles;
  const Descriptor descriptor(
      path, O_CLOEXEC | O_NOFOLLOW | (is_file ? O_RDWR | O_NONBLOCK | O_NOCTTY : O_RDONLY | O_DIRECTORY));
  struct stat status {};
  if (descriptor.number() < 0 || ::fstat(descriptor.number(), &status) != 0) return;
  if (status.st_uid != ::geteuid() || (is_file ? !S_ISREG(status.st_mode) : !S_ISDIR(status.st_mode))) return;
  if (!is_of_this_kernel && std::time(nullptr) - status.st_mtime < kDay) return;
  if (::flock(descriptor.number(), LOCK_EX | LOCK_NB) != 0 || !is_at(status, path)) return;
  // Nobody takes it from here on: who makes one of this name holds it before anything is written (hold_temporary).
  std::error_code ignored;
  if (is_file)
    ::unlink(path.c_str());
  else
    std::filesystem::remove_all(path, ignored);
}

// True for the first of all calls with these arguments.
bool is_first_look(const std::filesystem::path& folder, Abandoned what) {
  static std::mutex mutex;
  static std::set<std::pair<std::string, Abandoned>> seen;
  std::error_code missing;
  const std::filesystem::path path = std::filesystem::canonical(folder, missing);
  if (missing) return false;
  const std::lock_guard lock(mutex);
  return seen.emplace(path.string(), what).second;
}

}  // namespace

const std::string& running_kernel() {
  static const std::string kernel = [] {
    std::ifstream file("/proc/sys/kernel/random/boot_id");
    std::string text;
    std::getline(file, text);
    text = text.substr(0, 8);
    return text.size() == 8 && text.find_first_not_of("0123456789abcdef") == std::string::npos ? text : "0";
  }();
  return kernel;
}

std::string temporary_file_name(int k) {
  return std::string(prefix_of(Abandoned::kFiles)) + std::to_string(::getpid()) + "-" + std::to_string(k) + "-" +
         running_kernel() + std::string(kFileEnding);
}

std::string temporary_folder_pattern(Abandoned kind) {
  return std::string(prefix_of(kind)) + std::to_string(::getpid()) + "-" + running_kernel() + "-XXXXXX";
}

bool hold_temporary(int descriptor, const std::string& path) {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return errno != EWOULDBLOCK;
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && is_at(status, path);
}

void remove_abandoned(const std::filesystem::path& folder, Abandoned what) {
  if (!is_first_look(folder, what)) return;
  std::vector<std::pair<std::string, bool>> found;  // paths, and whether they are of this kernel
  std::error_code unreadable;
  for (std::filesystem::directory_iterator entry(folder, unreadable), end; !unreadable && entry != end;
       entry.increment(unreadable))
    if (const auto kernel = kernel_of(entry->path().filename().string(), what))
      found.emplace_back(entry->path().string(), *kernel == running_kernel() && *kernel != "0");
  for (const auto& [path, is_of_this_kernel] : found) remove_if_abandoned(path, is_of_this_kernel, what);
}

}  // namespace hottel
