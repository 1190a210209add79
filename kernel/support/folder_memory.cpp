#include "kernel/support/folder_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::string& what, int error) {
  throw RequestError(folder.string() + ": " + what + ": " + std::generic_category().message(error));
}

// A file that is gone when it is closed.
class NamelessFile {
 public:
  explicit NamelessFile(const std::filesystem::path& folder) : number_(open(folder.c_str(), O_TMPFILE | O_RDWR, 0600)) {
    if (number_ < 0) open_and_remove(folder);  // file systems that have none without a name
    if (number_ < 0) refuse(folder, "no file can be made there", errno);
  }
  NamelessFile(const NamelessFile&) = delete;
  ~NamelessFile() { close(number_); }

  int number() const { return number_; }

 private:
  void open_and_remove(const std::filesystem::path& folder) {
    std::string name = (folder / "hottel-XXXXXX").string();
    number_ = mkstemp(name.data());
    if (number_ >= 0) unlink(name.c_str());
  }

  int number_;
};

}  // namespace

FolderMemory::FolderMemory(std::filesystem::path folder) : folder_(std::move(folder)) {
  const NamelessFile tried(folder_);
}

void* FolderMemory::take(std::size_t bytes) const {
  HOTTEL_REQUIRE(bytes > 0);
  const NamelessFile file(folder_);
  if (const int error = posix_fallocate(file.number(), 0, static_cast<off_t>(bytes)); error != 0)
    refuse(folder_, "no room for " + std::to_string(bytes) + " bytes", error);
  void* begin = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file.number(), 0);
  if (begin == MAP_FAILED) refuse(folder_, std::to_string(bytes) + " bytes cannot be mapped", errno);
  return begin;
}

void FolderMemory::give_back(void* begin, std::size_t bytes) noexcept { munmap(begin, bytes); }

}  // namespace hottel
