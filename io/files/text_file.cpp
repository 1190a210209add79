#include "io/files/text_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "kernel/support/failure.h"

namespace hottel {

std::string read_text_file(const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& text) { throw InputError({file.string(), 0}, text); };
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) refuse("there is no such file");
  if (status.type() == std::filesystem::file_type::directory) refuse("is a directory, not a file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), &std::fclose);
  if (!stream) refuse(std::string("cannot be opened: ") + std::strerror(errno));

  std::string text;
  if (const auto size = std::filesystem::file_size(file, error); !error && size <= kMaxTextFileBytes)
    text.reserve(size);
  char buffer[1 << 16];
  while (const std::size_t got = std::fread(buffer, 1, sizeof buffer, stream.get())) {
    text.append(buffer, got);
    if (text.size() > kMaxTextFileBytes) refuse("is larger than " + std::to_string(kMaxTextFileBytes) + " bytes");
  }
  if (std::ferror(stream.get())) refuse(std::string("cannot be read: ") + std::strerror(errno));
  return text;
}

}  // namespace hottel
