#include "io/files/zip_file.h"

#include <algorithm>

#include "io/files/crc32.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::uint32_t kLocalEntry = 0x04034b50, kCentralEntry = 0x02014b50, kEnd = 0x06054b50;
constexpr unsigned kVersion = 20;           // of the format that is needed to read it
constexpr unsigned kDate = (1u << 5) | 1u;  // 1980-01-01
constexpr std::uint64_t kLimit = 0xffffffff;

// A record of little-endian numbers.
class Record {
 public:
  Record& two(unsigned value) { return number(value, 2); }
  Record& four(std::uint32_t value) { return number(value, 4); }
  Record& text(std::string_view value) {
    bytes_ += value;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  Record& number(std::uint32_t value, int size) {
    for (int k = 0; k < size; ++k) bytes_ += static_cast<char>(value >> (8 * k) & 0xff);
    return *this;
  }
  std::string bytes_;
};

}  // namespace

void ZipWriter::write(std::string_view bytes) {
  written_ += bytes.size();
  if (written_ > kLimit) throw RequestError("an archive of more than 4 GiB is not written");
  sink_(bytes);
}

void ZipWriter::add(const std::string& name, std::string_view bytes) {
  if (bytes.size() > kLimit) throw RequestError("an archive of more than 4 GiB is not written");
  const Entry entry{name, crc32_of(bytes), static_cast<std::uint32_t>(bytes.size()),
                    static_cast<std::uint32_t>(written_)};
  Record head;
  head.four(kLocalEntry).two(kVersion).two(0).two(0).two(0).two(kDate);
  head.four(entry.checksum).four(entry.size).four(entry.size);
  head.two(static_cast<unsigned>(name.size())).two(0).text(name);
  write(head.bytes());
  write(bytes);
  entries_.push_back(entry);
}

void ZipWriter::finish() {
  const auto begin = static_cast<std::uint32_t>(written_);
  for (const Entry& entry : entries_) {
    Record record;
    record.four(kCentralEntry).two(kVersion).two(kVersion).two(0).two(0).two(0).two(kDate);
    record.four(entry.checksum).four(entry.size).four(entry.size);
    record.two(static_cast<unsigned>(entry.name.size())).two(0).two(0).two(0).two(0).four(0);
    record.four(entry.offset).text(entry.name);
    write(record.bytes());
  }
  const auto count = static_cast<unsigned>(entries_.size());
  const auto size = static_cast<std::uint32_t>(written_) - begin;
  Record end;
  end.four(kEnd).two(0).two(0).two(count).two(count).four(size).four(begin).two(0);
  write(end.bytes());
}

}  // namespace hottel
