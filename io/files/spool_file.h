// Bytes that are put aside on disk until all of them are known.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace hottel {

// A file without a name, which nothing is left of whatever ends the program.
//
//   (1) it holds 64 KiB of memory, however much is put aside
//   (2) every error of the disk throws OutputError, which names the folder
class SpoolFile {
 public:
  // folder: on the disk whose room is to be taken, as a rule that of the file which is made of it.
  explicit SpoolFile(std::filesystem::path folder);
  SpoolFile(const SpoolFile&) = delete;
  SpoolFile& operator=(const SpoolFile&) = delete;
  ~SpoolFile();

  void write(std::string_view bytes);
  // Appends a number as it lies in memory.
  template <class Number>
  void add(const Number& number) {
    char bytes[sizeof number];
    std::memcpy(bytes, &number, sizeof number);
    write({bytes, sizeof number});
  }

  std::uint64_t size() const { return size_; }
  // Hands all bytes to a sink, in pieces, from the first one; as often as one likes.
  void read(const std::function<void(std::string_view)>& sink);

 private:
  void flush();
  [[noreturn]] void fail(int error) const;

  std::filesystem::path folder_;
  int descriptor_ = -1;
  std::string buffer_;
  std::uint64_t size_ = 0;
};

}  // namespace hottel
