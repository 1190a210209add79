#include "geometry/space/pieces/arc_end.h"

#include <bit>
#include <cstddef>

namespace hottel {
namespace {

// Seven bits a byte, the lowest first; the last one has no eighth.
void add(std::uint32_t number, std::vector<unsigned char>& bytes) {
  for (; number >= 0x80; number >>= 7) bytes.push_back(static_cast<unsigned char>(number | 0x80));
  bytes.push_back(static_cast<unsigned char>(number));
}

std::uint32_t next(std::span<const unsigned char> bytes, std::size_t& place) {
  std::uint32_t number = 0;
  for (int shift = 0;; shift += 7) {
    const std::uint32_t byte = bytes[place++];
    number |= (byte & 0x7f) << shift;
    if (byte < 0x80) return number;
  }
}

}  // namespace

// Planes as what they are more than the one before. Labels as two numbers: the highest bit, which says of what kind
// they are, becomes the lowest one. Counts with their sign in the lowest bit.
std::vector<unsigned char> packed_ends_3(std::span<const ArcEnd3> ends) {
  std::vector<unsigned char> bytes;
  bytes.reserve(6 * ends.size());
  std::uint32_t before = 0;
  for (const ArcEnd3& end : ends) {
    const auto plane = static_cast<std::uint32_t>(end.plane.number());
    add(plane - before, bytes);
    before = plane;
    add(static_cast<std::uint32_t>(end.label), bytes);
    add(std::rotl(static_cast<std::uint32_t>(end.label >> 32), 1), bytes);
    add((static_cast<std::uint32_t>(end.count) << 1) ^ static_cast<std::uint32_t>(end.count >> 31), bytes);
  }
  bytes.shrink_to_fit();
  return bytes;
}

std::vector<ArcEnd3> unpacked_ends_3(std::span<const unsigned char> bytes) {
  std::vector<ArcEnd3> ends;
  std::uint32_t plane = 0;
  for (std::size_t place = 0; place < bytes.size();) {
    plane += next(bytes, place);
    const std::uint64_t low = next(bytes, place), high = std::rotr(next(bytes, place), 1);
    const std::uint32_t count = next(bytes, place);
    ends.push_back({PlaneId3(plane), high << 32 | low, static_cast<int>((count >> 1) ^ (0 - (count & 1)))});
  }
  return ends;
}

}  // namespace hottel
