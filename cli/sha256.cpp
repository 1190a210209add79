#include "cli/sha256.h"

#include <openssl/evp.h>

#include <array>

#include "kernel/support/failure.h"

namespace hottel {

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
