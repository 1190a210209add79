// Frames put together as an animated PNG: what it says, and that the pixels are theirs.
#include "viewer/picture/animated_png.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>
#include <vector>

#include "kernel/support/failure.h"
#include "viewer/picture/png_file.h"
#include "viewer/picture/raster.h"

namespace hottel::animated_png_test {
namespace {

std::string frame(std::uint32_t width, std::uint32_t height, std::uint32_t colour) {
  return png_file(Raster(width, height, 0xFF000000u | colour));
}

struct Chunk {
  std::string type, bytes;
};

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = at; k < at + 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes.at(k));
  return value;
}

std::vector<Chunk> chunks_of(const std::string& file) {
  std::vector<Chunk> chunks;
  EXPECT_EQ(file.substr(0, 8), std::string("\x89PNG\r\n\x1a\n", 8));
  for (std::size_t at = 8; at < file.size();) {
    const std::uint32_t size = number_at(file, at);
    chunks.push_back({file.substr(at + 4, 4), file.substr(at + 8, size)});
    const std::string body = file.substr(at + 4, 4 + size);
    EXPECT_EQ(number_at(file, at + 8 + size),
              crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())));
    at += 12 + size;
  }
  return chunks;
}

TEST(AnimatedPng, SaysHowManyFramesThereAreHowLongAndWhere) {
  std::string file;
  AnimatedPng film(3, 40, 1000, [&file](std::string_view bytes) { file += bytes; });
  for (const std::uint32_t colour : {0xFFu, 0xFF00u, 0xFF0000u}) EXPECT_EQ(film.add(frame(5, 3, colour)), "");
  film.finish();
  const std::vector<Chunk> chunks = chunks_of(file);
  EXPECT_EQ(chunks.front().type, "IHDR");
  EXPECT_EQ(chunks[1].type, "acTL");
  EXPECT_EQ(number_at(chunks[1].bytes, 0), 3u);
  EXPECT_EQ(number_at(chunks[1].bytes, 4), 0u) << "over and over";
  EXPECT_EQ(chunks.back().type, "IEND");
  std::uint32_t sequence = 0, frames = 0;
  for (const Chunk& chunk : chunks) {
    if (chunk.type == "fcTL") {
      ++frames;
      EXPECT_EQ(chunk.bytes.size(), 26u);
      EXPECT_EQ(number_at(chunk.bytes, 4), 5u);
      EXPECT_EQ(number_at(chunk.bytes, 8), 3u);
      EXPECT_EQ(number_at(chunk.bytes, 20), 40u << 16 | 1000u);
    }
    if (chunk.type != "fcTL" && chunk.type != "fdAT") continue;
    EXPECT_EQ(number_at(chunk.bytes, 0), sequence++);
  }
  EXPECT_EQ(frames, 3u);
}

// (1)
TEST(AnimatedPng, PixelsAreThoseOfTheFrames) {
  const std::vector<std::string> frames{frame(64, 64, 0x123456), frame(64, 64, 0x654321)};
  std::string file;
  AnimatedPng film(2, 1, 25, [&file](std::string_view bytes) { file += bytes; });
  for (const std::string& one : frames) EXPECT_EQ(film.add(one), "");
  film.finish();
  std::vector<std::string> data(2);
  std::size_t at = 0;
  for (const Chunk& chunk : chunks_of(file)) {
    if (chunk.type == "fcTL") ++at;
    if (chunk.type == "IDAT") data[0] += chunk.bytes;
    if (chunk.type == "fdAT") data[at - 1] += chunk.bytes.substr(4);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    std::string own;
    for (const Chunk& chunk : chunks_of(frames[k]))
      if (chunk.type == "IDAT") own += chunk.bytes;
    EXPECT_EQ(data[k], own);
  }
}

TEST(AnimatedPng, RefusesWhatIsNoFrame) {
  AnimatedPng film(3, 1, 25, [](std::string_view) {});
  EXPECT_EQ(film.add(frame(4, 4, 0)), "");
  EXPECT_NE(film.add(frame(4, 5, 0)), "");
  EXPECT_NE(film.add("no picture"), "");
  std::string cut = frame(4, 4, 0);
  cut.resize(cut.size() - 5);
  EXPECT_NE(film.add(cut), "");
  std::string changed = frame(4, 4, 0);
  changed[40] = static_cast<char>(changed[40] ^ 1);
  EXPECT_NE(film.add(changed), "");
  EXPECT_THROW(film.finish(), ContractViolation);
}

}  // namespace
}  // namespace hottel::animated_png_test
