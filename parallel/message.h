// Values one after another in a message between processes of one program.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "io/scene/binary_values.h"
#include "kernel/support/failure.h"

namespace hottel {

// Writes what MessageReader reads. All processes must be of one kind of machine: bytes are as they lie in memory.
class MessageWriter {
 public:
  template <class T>
  void put(T value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T, class... More>
  void put(T value, More... more) {
    put(value);
    (put(more), ...);
  }
  void put_text(std::string_view text) {
    put(std::uint64_t{text.size()});
    bytes_ += text;
  }
  // How many there are, and each as it lies in memory.
  template <class T>
  void put_all(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    put(std::uint64_t{values.size()});
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }
  template <class T>
  void put_all(const std::vector<T>& values) {
    put_all(std::span<const T>(values));
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

// Throws ContractViolation where the bytes end too early. REQUIRES that they outlive it.
class MessageReader {
 public:
  explicit MessageReader(std::string_view bytes) : bytes_(bytes), values_(bytes, std::endian::native) {}

  template <class T>
  T take() {
    return values_.take<T>();
  }
  template <class T, class... More>
  void take_into(T& value, More&... more) {
    value = take<T>();
    (..., (more = take<More>()));
  }
  std::string_view take_text() {
    const auto size = take<std::uint64_t>();
    const std::string_view text = bytes_.substr(values_.at(), size);
    values_.pass_over(size);
    return text;
  }
  // What put_all() wrote.
  template <class T>
  std::vector<T> take_all() {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto size = take<std::uint64_t>();
    HOTTEL_REQUIRE(size <= values_.bytes_left() / sizeof(T));
    std::vector<T> values(size);
    if (size > 0) std::memcpy(static_cast<void*>(values.data()), bytes_.data() + values_.at(), size * sizeof(T));
    values_.pass_over(size * sizeof(T));
    return values;
  }
  // All that is left.
  std::string_view rest() const { return bytes_.substr(values_.at()); }
  bool is_at_end() const { return values_.bytes_left() == 0; }

 private:
  std::string_view bytes_;
  BinaryValues values_;
};

}  // namespace hottel
