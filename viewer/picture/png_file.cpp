#include "viewer/picture/png_file.h"

#include <zlib.h>

#include <algorithm>
#include <new>
#include <string_view>
#include <vector>

#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "viewer/picture/big_endian.h"
#include "viewer/picture/raster.h"

namespace hottel {
namespace {

constexpr int kLevel = 4;
constexpr std::size_t kStripBytes = std::size_t{1} << 19;  // of pixels, about
constexpr unsigned char kUp = 2;                           // each byte less the one above it

const Bytef* bytes_of(std::string_view text) { return reinterpret_cast<const Bytef*>(text.data()); }

void add_chunk(std::string& file, std::string_view kind, std::string_view data) {
  uLong sum = crc32(0, bytes_of(kind), static_cast<uInt>(kind.size()));
  sum = crc32_z(sum, bytes_of(data), data.size());
  file += big_endian(static_cast<std::uint32_t>(data.size()));
  file.append(kind).append(data);
  file += big_endian(static_cast<std::uint32_t>(sum));
}

// Rows of a picture, packed.
struct Strip {
  std::string packed;
  uLong sum = 0;  // Adler's, of what was packed
  std::size_t size = 0;
};

Strip pack(const std::string& rows, bool is_last) {
  z_stream stream{};
  if (deflateInit2(&stream, kLevel, Z_DEFLATED, -MAX_WBITS, 8, Z_FILTERED) != Z_OK) throw std::bad_alloc();
  Strip strip{std::string(deflateBound(&stream, rows.size()) + 16, '\0'),
              adler32_z(adler32(0, nullptr, 0), bytes_of(rows), rows.size()), rows.size()};
  stream.next_in = const_cast<Bytef*>(bytes_of(rows));
  stream.avail_in = static_cast<uInt>(rows.size());
  stream.next_out = reinterpret_cast<Bytef*>(strip.packed.data());
  stream.avail_out = static_cast<uInt>(strip.packed.size());
  deflate(&stream, is_last ? Z_FINISH : Z_FULL_FLUSH);  // which ends on a whole byte
  const bool is_whole = stream.avail_in == 0 && stream.avail_out > 0;
  strip.packed.resize(stream.total_out);
  deflateEnd(&stream);
  HOTTEL_REQUIRE(is_whole);
  return strip;
}

}  // namespace

std::string png_file(const std::uint32_t* pixels, std::uint32_t width, std::uint32_t height, std::size_t stride) {
  HOTTEL_REQUIRE(width > 0 && height > 0);
  const std::size_t row_bytes = 3 * std::size_t{width};
  const std::size_t rows_each = std::max<std::size_t>(1, kStripBytes / row_bytes);
  std::vector<Strip> strips((height + rows_each - 1) / rows_each);
  parallel_for(strips.size(), [&](std::size_t k) {
    const std::size_t first = k * rows_each, last = std::min<std::size_t>(height, first + rows_each);
    std::string rows;
    rows.reserve((last - first) * (1 + row_bytes));
    for (std::size_t y = first; y < last; ++y) {
      rows += static_cast<char>(kUp);
      const std::uint32_t* row = pixels + y * stride;
      const std::uint32_t* above = y == 0 ? nullptr : row - stride;
      for (std::uint32_t x = 0; x < width; ++x)
        for (const int shift : {16, 8, 0})
          rows += static_cast<char>((row[x] >> shift) - (above == nullptr ? 0 : above[x] >> shift));
    }
    strips[k] = pack(rows, k + 1 == strips.size());
  });

  std::string data{'\x78', '\x5e'};  // zlib's head: a window of 32 K, fast
  uLong sum = adler32(0, nullptr, 0);
  for (const Strip& strip : strips) {
    data += strip.packed;
    sum = adler32_combine(sum, strip.sum, static_cast<z_off_t>(strip.size));
  }
  data += big_endian(static_cast<std::uint32_t>(sum));

  std::string file("\x89PNG\r\n\x1a\n", 8);
  add_chunk(file, "IHDR", big_endian(width) + big_endian(height) + std::string("\x08\x02\x00\x00\x00", 5));
  // A chunk holds less than 2^31 bytes.
  constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;
  for (std::size_t done = 0; done < data.size(); done += kMostAtOnce)
    add_chunk(file, "IDAT", std::string_view(data).substr(done, kMostAtOnce));
  add_chunk(file, "IEND", "");
  return file;
}

std::string png_file(const Raster& raster) {
  HOTTEL_REQUIRE(raster.pixels.size() == std::size_t{raster.width} * raster.height);
  return png_file(raster.pixels.data(), raster.width, raster.height, raster.width);
}

}  // namespace hottel
