#include "kernel/support/folder_memory.h"

#include <fcntl.h>  // posix_fallocate
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "kernel/support/failure.h"
#include "kernel/support/nameless_file.h"

namespace hottel {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::string& what, int error) {
  throw RequestError(folder.string() + ": " + what + ": " + std::generic_category().message(error));
}

// A file that is gone when it is closed.
class NamelessFile {
 public:
  explicit NamelessFile(const std::filesystem::path& folder) : descriptor_(open_nameless(folder)) {
    if (descriptor_ < 0) refuse(folder, "no file can be made there", errno);
  }
  NamelessFile(const NamelessFile&) = delete;
  ~NamelessFile() { close(descriptor_); }

  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

}  // namespace

FolderMemory::FolderMemory(std::filesystem::path folder) : folder_(std::move(folder)) {
  const NamelessFile tried(folder_);
}

void* FolderMemory::take(std::size_t bytes) const {
  HOTTEL_REQUIRE(bytes > 0);
  const NamelessFile file(folder_);
  if (const int error = posix_fallocate(file.descriptor(), 0, static_cast<off_t>(bytes)); error != 0)
    refuse(folder_, "no room for " + std::to_string(bytes) + " bytes", error);
  void* begin = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file.descriptor(), 0);
  if (begin == MAP_FAILED) refuse(folder_, std::to_string(bytes) + " bytes cannot be mapped", errno);
  return begin;
}

void FolderMemory::give_back(void* begin, std::size_t bytes) noexcept { munmap(begin, bytes); }

}  // namespace hottel
