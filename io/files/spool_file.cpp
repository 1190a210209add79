#include "io/files/spool_file.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>
#include <vector>

#include "io/files/output_file.h"
#include "kernel/support/nameless_file.h"

namespace hottel {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 16;

}  // namespace

SpoolFile::SpoolFile(std::filesystem::path folder)
    : folder_(folder.empty() ? std::filesystem::path(".") : std::move(folder)), descriptor_(open_nameless(folder_)) {
  if (descriptor_ < 0) fail(errno);
  buffer_.reserve(kPiece);
}

SpoolFile::~SpoolFile() { ::close(descriptor_); }

void SpoolFile::write(std::string_view bytes) {
  size_ += bytes.size();
  if (buffer_.size() + bytes.size() > kPiece) flush();
  buffer_.append(bytes);
}

void SpoolFile::flush() {
  for (std::size_t done = 0; done < buffer_.size();) {
    const ::ssize_t count = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
    if (count < 0 && errno != EINTR) fail(errno);
    done += static_cast<std::size_t>(std::max<::ssize_t>(count, 0));
  }
  buffer_.clear();
}

void SpoolFile::read(const std::function<void(std::string_view)>& sink) {
  flush();
  std::vector<char> piece(kPiece);
  for (std::uint64_t at = 0; at < size_;) {
    const ::ssize_t count = ::pread(descriptor_, piece.data(), piece.size(), static_cast<::off_t>(at));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail(count < 0 ? errno : EIO);
    sink({piece.data(), static_cast<std::size_t>(count)});
    at += static_cast<std::uint64_t>(count);
  }
}

void SpoolFile::fail(int error) const {
  throw OutputError(folder_.string(), std::string("what is put aside there: ") + std::strerror(error));
}

}  // namespace hottel
