// Zip archives, as NumPy's .npz files are: entries are stored as they are.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace hottel {

// Writes an archive through a sink, entry by entry; whatever the sink throws stops the writing.
//
//   (1) the same entries give the same bytes: all are dated 1980-01-01
//   (2) entries are found in the archive in the order in which they were added
//   (3) an entry that begins or ends beyond 4 GiB is told by the extension for large files (zip64), others without it
//
// SEE: PKWARE, APPNOTE.TXT, 4.3 to 4.5.
class ZipWriter {
 public:
  using Sink = std::function<void(std::string_view)>;
  explicit ZipWriter(Sink sink) : sink_(std::move(sink)) {}

  // REQUIRES: names differ, at most 65535 of them, ASCII.
  void add(const std::string& name, std::string_view bytes);
  // The same of bytes that do not lie in memory. write_bytes hands all of them to a sink, and is called twice.
  void add(const std::string& name, const std::function<void(const Sink&)>& write_bytes);
  // Writes the table of entries. REQUIRES: called once, after all entries.
  void finish();

 private:
  struct Entry {
    std::string name;
    std::uint32_t checksum;
    std::uint64_t size, offset;
  };
  void begin(const std::string& name, std::uint32_t checksum, std::uint64_t size);
  void write_end(std::uint64_t begin);
  void write(std::string_view bytes);

  Sink sink_;
  std::vector<Entry> entries_;
  std::uint64_t written_ = 0;
};

}  // namespace hottel
