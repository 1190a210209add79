#include "io/files/zip_file.h"

#include "io/files/crc32.h"

namespace hottel {
namespace {

constexpr std::uint32_t kLocalEntry = 0x04034b50, kCentralEntry = 0x02014b50, kEnd = 0x06054b50, kLargeEnd = 0x06064b50,
                        kLargeEndPlace = 0x07064b50;
constexpr unsigned kVersion = 20, kLargeVersion = 45;  // of the format that is needed to read it
constexpr unsigned kDate = (1u << 5) | 1u;             // 1980-01-01
constexpr unsigned kLargeField = 1;                    // the extra field of zip64
constexpr std::uint32_t kElsewhere = 0xffffffff;       // a number that is in that field, or in the larger record

// A record of little-endian numbers.
class Record {
 public:
  Record& two(unsigned value) { return number(value, 2); }
  Record& four(std::uint32_t value) { return number(value, 4); }
  Record& eight(std::uint64_t value) { return number(value, 8); }
  Record& text(std::string_view value) {
    bytes_ += value;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  Record& number(std::uint64_t value, int size) {
    for (int k = 0; k < size; ++k) bytes_ += static_cast<char>(value >> (8 * k) & 0xff);
    return *this;
  }
  std::string bytes_;
};

bool is_large(std::uint64_t value) { return value >= kElsewhere; }

std::uint32_t short_of(std::uint64_t value) { return is_large(value) ? kElsewhere : static_cast<std::uint32_t>(value); }

}  // namespace

void ZipWriter::write(std::string_view bytes) {
  written_ += bytes.size();
  sink_(bytes);
}

void ZipWriter::begin(const std::string& name, std::uint32_t checksum, std::uint64_t size) {
  entries_.push_back({name, checksum, size, written_});
  const bool large = is_large(size);
  Record head;
  head.four(kLocalEntry).two(large ? kLargeVersion : kVersion).two(0).two(0).two(0).two(kDate);
  head.four(checksum).four(short_of(size)).four(short_of(size));
  head.two(static_cast<unsigned>(name.size())).two(large ? 20 : 0).text(name);
  if (large) head.two(kLargeField).two(16).eight(size).eight(size);
  write(head.bytes());
}

void ZipWriter::add(const std::string& name, std::string_view bytes) {
  begin(name, crc32_of(bytes), bytes.size());
  write(bytes);
}

void ZipWriter::add(const std::string& name, const std::function<void(const Sink&)>& write_bytes) {
  std::uint32_t checksum = 0;
  std::uint64_t size = 0;
  write_bytes([&](std::string_view bytes) {
    checksum = crc32_of(bytes, checksum);
    size += bytes.size();
  });
  begin(name, checksum, size);
  write_bytes([this](std::string_view bytes) { write(bytes); });
}

void ZipWriter::finish() {
  const std::uint64_t begin = written_;
  for (const Entry& entry : entries_) {
    Record large;
    if (is_large(entry.size)) large.eight(entry.size).eight(entry.size);
    if (is_large(entry.offset)) large.eight(entry.offset);
    const auto more = static_cast<unsigned>(large.bytes().size());
    const unsigned version = more > 0 ? kLargeVersion : kVersion;
    Record record;
    record.four(kCentralEntry).two(version).two(version).two(0).two(0).two(0).two(kDate);
    record.four(entry.checksum).four(short_of(entry.size)).four(short_of(entry.size));
    record.two(static_cast<unsigned>(entry.name.size())).two(more > 0 ? more + 4 : 0).two(0).two(0).two(0).four(0);
    record.four(short_of(entry.offset)).text(entry.name);
    if (more > 0) record.two(kLargeField).two(more).text(large.bytes());
    write(record.bytes());
  }
  write_end(begin);
}

void ZipWriter::write_end(std::uint64_t begin) {
  const auto count = static_cast<unsigned>(entries_.size());
  const std::uint64_t size = written_ - begin, end_at = written_;
  Record end;
  if (is_large(begin)) {
    end.four(kLargeEnd).eight(44).two(kLargeVersion).two(kLargeVersion).four(0).four(0);
    end.eight(count).eight(count).eight(size).eight(begin);
    end.four(kLargeEndPlace).four(0).eight(end_at).four(1);
  }
  end.four(kEnd).two(0).two(0).two(count).two(count).four(short_of(size)).four(short_of(begin)).two(0);
  write(end.bytes());
}

}  // namespace hottel
