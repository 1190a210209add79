#include "io/sums/plane/sum_chunk.h"

#include <bit>
#include <cstring>
#include <fstream>
#include <string_view>
#include <utility>

#include "io/files/crc32.h"
#include "io/files/output_file.h"
#include "kernel/int128.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

static_assert(std::endian::native == std::endian::little, "chunks are written as the machine holds them");

constexpr std::string_view kMagic{"hottel sums 1\n\0\0", 16};
constexpr std::size_t kMostHead = std::size_t{1} << 20;

// A sum as it stands in a file.
struct WrittenSum {
  std::uint64_t key, lengths, low, high;
};
static_assert(sizeof(WrittenSum) == 32);

WrittenSum written(const PairSum2& sum) {
  const auto value = static_cast<UInt128>(sum.value);
  return {sum.key, std::uint64_t{sum.inexact} << 1 | sum.is_obstructed, static_cast<std::uint64_t>(value),
          static_cast<std::uint64_t>(value >> 64)};
}

PairSum2 read(const WrittenSum& sum) {
  PairSum2 result;
  result.key = sum.key;
  const std::uint64_t inexact = sum.lengths >> 1;
  result.inexact = inexact & (~std::uint64_t{0} >> 1);
  result.is_obstructed = static_cast<unsigned>(sum.lengths & 1);
  result.value = static_cast<Int128>(UInt128{sum.high} << 64 | sum.low);
  return result;
}

template <class Number>
std::string_view bytes_of(const Number& number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

std::string head_bytes(const SumChunkHead2& head) {
  std::string bytes;
  const auto put = [&bytes](std::uint64_t number) { bytes += bytes_of(number); };
  for (const std::string& text : {head.key, head.about}) {
    put(text.size());
    bytes += text;
  }
  for (const std::uint64_t number : {head.begin, head.end, head.counts.gaps, head.counts.updates}) put(number);
  put(head.segments.size());
  for (const SumChunkHead2::Segment& segment : head.segments) {
    put(segment.count);
    put(segment.sum);
  }
  return bytes;
}

// The numbers and texts of a head, one after another.
class Head {
 public:
  Head(std::string_view bytes, const std::filesystem::path& file) : bytes_(bytes), file_(file) {}

  std::uint64_t number() {
    std::uint64_t number = 0;
    std::memcpy(&number, take(sizeof number).data(), sizeof number);
    return number;
  }
  std::string text() { return std::string(take(number())); }

 private:
  std::string_view take(std::uint64_t size) {
    if (size > bytes_.size()) throw InputError({file_.string(), 0}, "is a damaged chunk of sums");
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }

  std::string_view bytes_;
  std::filesystem::path file_;
};

SumChunkHead2 parsed(std::string_view bytes, const std::filesystem::path& file) {
  Head in(bytes, file);
  SumChunkHead2 head;
  head.key = in.text();
  head.about = in.text();
  head.begin = in.number();
  head.end = in.number();
  head.counts.gaps = in.number();
  head.counts.updates = in.number();
  const std::uint64_t count = in.number();
  for (std::uint64_t k = 0; k < count; ++k) {
    const std::uint64_t size = in.number();
    head.segments.push_back({size, static_cast<std::uint32_t>(in.number())});
  }
  return head;
}

// The sums of each range of rows.
std::vector<std::vector<WrittenSum>> by_range(const PairSums2& sums, const ElementTable2& table, const RowCuts& cuts) {
  std::vector<std::vector<WrittenSum>> ranges(cuts.count());
  const auto none = ranges.size();
  sums.for_each([&](const PairSum2& sum) {
    const std::size_t of_i = table.has_row(sum.i()) ? cuts.of(sum.i()) : none;
    const std::size_t of_j = table.has_row(sum.j()) ? cuts.of(sum.j()) : none;
    if (of_i != none) ranges[of_i].push_back(written(sum));
    if (of_j != none && of_j != of_i) ranges[of_j].push_back(written(sum));
  });
  return ranges;
}

std::string_view bytes_of(const std::vector<WrittenSum>& sums) {
  return {reinterpret_cast<const char*>(sums.data()), sums.size() * sizeof(WrittenSum)};
}

std::uint64_t size_of_head(const SumChunkHead2& head) { return kMagic.size() + 4 + head_bytes(head).size() + 4; }

}  // namespace

SumChunkHead2 write_sum_chunk(const std::filesystem::path& file, SumChunkHead2 head, const PairSums2& sums,
                              const ElementTable2& table, const RowCuts& cuts) {
  const std::vector<std::vector<WrittenSum>> ranges = by_range(sums, table, cuts);
  for (const auto& range : ranges) head.segments.push_back({range.size(), crc32_of(bytes_of(range))});
  const std::string bytes = head_bytes(head);
  OutputFile out(file);
  out.write(kMagic);
  out.write(bytes_of(static_cast<std::uint32_t>(bytes.size())));
  out.write(bytes);
  out.write(bytes_of(crc32_of(bytes)));
  for (const auto& range : ranges) out.write(bytes_of(range));
  out.commit();
  return head;
}

SumChunkHead2 read_sum_chunk_head_2(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string magic(kMagic.size(), '\0');
  std::uint32_t size = 0, sum = 0;
  in.read(magic.data(), static_cast<std::streamsize>(magic.size()));
  in.read(reinterpret_cast<char*>(&size), sizeof size);
  if (!in || magic != kMagic || size > kMostHead)
    throw InputError({file.string(), 0}, "is no chunk of sums, or one of another version of hottel");
  std::string bytes(size, '\0');
  in.read(bytes.data(), size);
  in.read(reinterpret_cast<char*>(&sum), sizeof sum);
  if (!in || sum != crc32_of(bytes)) throw InputError({file.string(), 0}, "is a damaged chunk of sums");
  SumChunkHead2 head = parsed(bytes, file);
  std::uint64_t expected = size_of_head(head);
  for (const SumChunkHead2::Segment& segment : head.segments) expected += segment.count * sizeof(WrittenSum);
  std::error_code error;
  if (std::filesystem::file_size(file, error) != expected)
    throw InputError({file.string(), 0}, "is a chunk of sums that breaks off");
  return head;
}

std::vector<PairSum2> read_sum_segment(const std::filesystem::path& file, const SumChunkHead2& head, std::size_t k) {
  std::uint64_t place = size_of_head(head);
  for (std::size_t before = 0; before < k; ++before) place += head.segments[before].count * sizeof(WrittenSum);
  std::vector<WrittenSum> sums(head.segments[k].count);
  std::ifstream in(file, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(place));
  in.read(reinterpret_cast<char*>(sums.data()), static_cast<std::streamsize>(sums.size() * sizeof(WrittenSum)));
  if (!in || crc32_of(bytes_of(sums)) != head.segments[k].sum)
    throw InputError({file.string(), 0}, "is a damaged chunk of sums; without it they are found again");
  std::vector<PairSum2> result;
  result.reserve(sums.size());
  for (const WrittenSum& sum : sums) result.push_back(read(sum));
  return result;
}

}  // namespace hottel
