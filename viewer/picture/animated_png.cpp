#include "viewer/picture/animated_png.h"

#include <zlib.h>

#include <utility>
#include <vector>

#include "kernel/support/failure.h"
#include "viewer/picture/big_endian.h"

namespace hottel {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);

std::string big_endian16(std::uint16_t value) { return big_endian(value).substr(2); }

std::uint32_t number_at(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[k]);
  return value;
}

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

struct Chunk {
  std::string_view type, bytes;
};

// The chunks of a PNG file, none where it is not whole.
std::vector<Chunk> chunks_of(std::string_view png) {
  if (!png.starts_with(kSignature)) return {};
  std::vector<Chunk> chunks;
  for (png.remove_prefix(kSignature.size()); !png.empty();) {
    if (png.size() < 12) return {};
    const std::size_t size = number_at(png);
    if (size > png.size() - 12 || number_at(png.substr(8 + size)) != checksum(png.substr(4, 4 + size))) return {};
    chunks.push_back({png.substr(4, 4), png.substr(8, size)});
    png.remove_prefix(12 + size);
  }
  const bool is_whole = chunks.size() > 2 && chunks.front().type == "IHDR" && chunks.front().bytes.size() == 13 &&
                        chunks.back().type == "IEND";
  return is_whole ? chunks : std::vector<Chunk>();
}

}  // namespace

AnimatedPng::AnimatedPng(std::uint32_t frames, std::uint16_t numerator, std::uint16_t denominator,
                         std::function<void(std::string_view)> sink)
    : frames_(frames), numerator_(numerator), denominator_(denominator), sink_(std::move(sink)) {
  HOTTEL_REQUIRE(frames > 0 && numerator > 0 && denominator > 0);
}

void AnimatedPng::chunk(std::string_view type, std::string_view bytes) {
  sink_(big_endian(static_cast<std::uint32_t>(bytes.size())));
  const std::string body = std::string(type) + std::string(bytes);
  sink_(body);
  sink_(big_endian(checksum(body)));
}

std::string AnimatedPng::add(std::string_view png) {
  HOTTEL_REQUIRE(added_ < frames_);
  const std::vector<Chunk> chunks = chunks_of(png);
  if (chunks.empty()) return "is no PNG file, or not a whole one";
  const std::string_view header = chunks.front().bytes;
  if (added_ == 0) {
    header_ = header;
    sink_(kSignature);
    chunk("IHDR", header);
    chunk("acTL", big_endian(frames_) + big_endian(0));
  } else if (header != header_) {
    return "has another size, or other pixels, than the first frame";
  }
  // The whole picture, for so long; nothing is left of the frame before.
  chunk("fcTL", big_endian(sequence_++) + header_.substr(0, 8) + big_endian(0) + big_endian(0) +
                    big_endian16(numerator_) + big_endian16(denominator_) + std::string(2, '\0'));
  for (const Chunk& part : chunks) {
    if (part.type != "IDAT") continue;
    if (added_ == 0)
      chunk("IDAT", part.bytes);
    else
      chunk("fdAT", big_endian(sequence_++) + std::string(part.bytes));
  }
  ++added_;
  return {};
}

void AnimatedPng::finish() {
  HOTTEL_REQUIRE(added_ == frames_);
  chunk("IEND", {});
}

}  // namespace hottel
