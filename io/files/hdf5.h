// HDF5: named arrays of numbers and texts in one file. hdf5.cpp alone knows the library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hottel {

// Throws UsageError where hottel was built without HDF5, RequestError where its library is not on this machine. what:
// the file or option that asks for it.
void require_hdf5(std::string_view what);

// Whether bytes begin as a file of HDF5 does.
inline bool is_hdf5(std::string_view bytes) { return bytes.starts_with("\x89HDF\r\n\x1a\n"); }

// What the numbers of an array are, little-endian.
enum class Hdf5Number : unsigned char { kInt8, kUint32, kUint64, kFloat64 };

// Writes a file of HDF5 1.10, array by array.
//
//   (1) the same calls give the same bytes: nothing is dated, and arrays lie in the file in the order in which they
//       were begun
//   (2) an array is laid out in chunks of 2^17 numbers (of a mebibyte of texts), one behind the other, whoever writes
//   which of them (3) each array has the attribute `crc32` of its bytes
//
// Throws OutputError where the disk is full or fails, RequestError where the library is not on this machine. That is
// used by one thread at a time.
class Hdf5Writer {
 public:
  // path: of a file that is there already and is overwritten; name: what messages call it.
  Hdf5Writer(const std::string& path, std::string name);
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  // What is said of the file. Texts are UTF-8, without zeros.
  void say(const std::string& key, const std::string& text);
  void say(const std::string& key, std::uint32_t number);
  // The same of an array. REQUIRES that it was begun.
  void say_of(const std::string& array, const std::string& key, const std::string& text);

  // Begins an array of so many numbers, which append() then gives, in order. Several may be open at once.
  void begin(const std::string& name, Hdf5Number number, std::uint64_t size);
  // REQUIRES a number of the type that the array was begun with, and no more of them than it has.
  template <class T>
  void append(const std::string& name, const T* values, std::size_t count) {
    append_bytes(name, {reinterpret_cast<const char*>(values), count * sizeof(T)});
  }
  // An array of texts of UTF-8, as long as the longest, zeros behind the shorter ones.
  void write_texts(const std::string& name, const std::vector<std::string>& texts);
  // One text of any length.
  void write_text(const std::string& name, const std::string& text);

  // Closes the file. REQUIRES that all arrays are complete; nothing may follow.
  void finish();

 private:
  void append_bytes(const std::string& name, std::string_view bytes);
  struct File;
  std::unique_ptr<File> file_;
};

// Reads a file of HDF5 that is held in memory. Throws InputError, naming the file, for what breaks off, is damaged as
// its sums tell, or holds other things than were asked for, and for arrays that claim to be larger than the file can
// hold.
class Hdf5Reader {
 public:
  Hdf5Reader(std::string name, std::string_view bytes);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  bool has(const std::string& array) const;
  // Arrays of one dimension. Numbers of other types are converted; where that cannot be, they are refused.
  std::vector<std::uint64_t> whole_numbers(const std::string& array) const;
  std::vector<double> numbers(const std::string& array) const;
  std::vector<std::string> texts(const std::string& array) const;
  // What is said of the file; nothing where nothing is.
  std::optional<std::string> said_text(const std::string& key) const;
  std::optional<std::uint64_t> said_number(const std::string& key) const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace hottel
