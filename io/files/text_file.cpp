#include "io/files/text_file.h"

#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

// Appends what is left of a stream. Refuse throws, with a text.
template <class Refuse>
void append_rest(std::FILE* stream, std::string& text, const Refuse& refuse) {
  char buffer[1 << 16];
  while (const std::size_t got = std::fread(buffer, 1, sizeof buffer, stream)) {
    text.append(buffer, got);
    if (text.size() > kMaxTextFileBytes) refuse("is larger than " + std::to_string(kMaxTextFileBytes) + " bytes");
  }
  if (std::ferror(stream)) refuse(std::string("cannot be read: ") + std::strerror(errno));
}

}  // namespace

std::string read_standard_input() {
  std::string text;
  append_rest(stdin, text, [](const std::string& why) { throw InputError({"standard input", 0}, why); });
  return text;
}

std::string read_text_file(const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& text) { throw InputError({file.string(), 0}, text); };
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw MissingFile({file.string(), 0}, "there is no such file");
  if (status.type() == std::filesystem::file_type::directory) refuse("is a directory, not a file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), &std::fclose);
  if (!stream) refuse(std::string("cannot be opened: ") + std::strerror(errno));

  std::string text;
  if (const auto size = std::filesystem::file_size(file, error); !error && size <= kMaxTextFileBytes)
    text.reserve(size);
  append_rest(stream.get(), text, refuse);
  return text;
}

std::string read_named_file(const TextSource& files, const std::filesystem::path& file, const FileLine& where,
                            const std::string& what) {
  try {
    return files(file);
  } catch (const MissingFile& error) {
    throw MissingFile(where, what + " " + error.what(), error.hints());
  } catch (const InputError& error) {
    throw InputError(where, what + " " + error.what(), error.hints());
  }
}

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned int length = 0;
  const int done = EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr);
  HOTTEL_REQUIRE(done == 1 && length == 32);
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (unsigned int k = 0; k < length; ++k) text += {kDigits[digest[k] >> 4], kDigits[digest[k] & 15]};
  return text;
}

}  // namespace hottel
