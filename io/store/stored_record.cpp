#include "io/store/stored_record.h"

#include <openssl/evp.h>

#include <memory>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

void append_number(std::string& out, std::uint64_t value) {
  for (; value >= 128; value >>= 7) out += static_cast<char>(value % 128 + 128);
  out += static_cast<char>(value);
}

// Nothing where the text ends before the number, or the number is longer than 64 bits.
std::optional<std::uint64_t> take_number(std::string_view& text) {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 63; shift += 7) {
    if (text.empty()) return std::nullopt;
    const auto byte = static_cast<unsigned char>(text.front());
    text.remove_prefix(1);
    value |= std::uint64_t{byte % 128U} << shift;
    if (byte < 128) return value;
  }
  return std::nullopt;
}

}  // namespace

std::string record_of(const CachedRow& row) {
  std::string out;
  append_number(out, row.known.size());
  std::uint32_t last = 0;
  for (const ColumnRange& range : row.known) {
    append_number(out, range.begin - last);
    append_number(out, range.end - range.begin);
    last = range.end;
  }
  append_number(out, row.to.size());
  last = 0;
  for (const std::uint32_t to : row.to) {
    append_number(out, to - last);
    last = to;
  }
  return out + row.numbers;
}

std::optional<CachedRow> row_of(std::uint32_t row, std::string_view record, std::uint32_t elements) {
  CachedRow result{.row = row, .known = {}, .to = {}, .numbers = {}};
  const std::uint64_t most = std::uint64_t{elements} + 1;
  const auto ranges = take_number(record);
  if (!ranges || *ranges > most) return std::nullopt;
  std::uint64_t last = 0;
  for (std::uint64_t k = 0; k < *ranges; ++k) {
    const auto gap = take_number(record), size = take_number(record);
    if (!gap || !size || *gap > most || *size > most || last + *gap + *size > most || *size == 0) return std::nullopt;
    result.known.push_back({static_cast<std::uint32_t>(last + *gap), static_cast<std::uint32_t>(last + *gap + *size)});
    last += *gap + *size;
  }
  const auto count = take_number(record);
  if (!count || *count > most) return std::nullopt;
  last = 0;
  for (std::uint64_t k = 0; k < *count; ++k) {
    const auto gap = take_number(record);
    if (!gap || *gap > most || last + *gap >= most || (k > 0 && *gap == 0)) return std::nullopt;
    last += *gap;
    result.to.push_back(static_cast<std::uint32_t>(last));
  }
  result.numbers = record;
  return result;
}

std::string joined(std::span<const std::string> texts) {
  std::string out;
  for (const std::string& text : texts) {
    append_number(out, text.size());
    out += text;
  }
  return out;
}

std::optional<std::vector<std::string>> separated(std::string_view bytes) {
  std::vector<std::string> texts;
  while (!bytes.empty()) {
    const auto size = take_number(bytes);
    if (!size || *size > bytes.size()) return std::nullopt;
    texts.emplace_back(bytes.substr(0, *size));
    bytes.remove_prefix(*size);
  }
  return texts;
}

std::string digest_of(std::span<const std::string_view> parts) {
  const std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
  HOTTEL_REQUIRE(context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1);
  for (const std::string_view part : parts) {
    std::string size;
    append_number(size, part.size());
    EVP_DigestUpdate(context.get(), size.data(), size.size());
    EVP_DigestUpdate(context.get(), part.data(), part.size());
  }
  std::string digest(EVP_MAX_MD_SIZE, '\0');
  unsigned int length = 0;
  HOTTEL_REQUIRE(EVP_DigestFinal_ex(context.get(), reinterpret_cast<unsigned char*>(digest.data()), &length) == 1);
  digest.resize(length);
  return digest;
}

}  // namespace hottel
