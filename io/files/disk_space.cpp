#include "io/files/disk_space.h"

#include <fmt/format.h>

#include "kernel/support/failure.h"

namespace hottel {

std::optional<std::uint64_t> free_space(const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path place = file == "-" ? "/dev/stdout" : file;
  const bool exists = fs::exists(place, error);
  if (exists ? !fs::is_regular_file(place, error) : file == "-") return std::nullopt;
  if (exists) place = fs::canonical(place, error);
  // A folder that is not there yet will be in the first one above it that is.
  do place = fs::absolute(place, error).parent_path();
  while (!error && !fs::exists(place, error) && place.has_relative_path());
  const fs::space_info space = fs::space(place, error);
  if (error || space.capacity == 0) return std::nullopt;  // /proc and the like hold no files
  return space.available;
}

void require_space(const std::filesystem::path& file, std::uint64_t bytes, const std::string& what,
                   const std::string& advice) {
  const auto free = free_space(file);
  if (!free || bytes <= *free) return;
  throw RequestError(fmt::format("{} {} bytes; {} are free where '{}' is to be{}", what, bytes, *free,
                                 file == "-" ? "standard output" : file.string(), advice));
}

}  // namespace hottel
