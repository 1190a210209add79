#include "io/files/hdf5.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <map>
#include <mutex>
#include <utility>

#include "io/files/crc32.h"
#include "io/files/hdf5_library.h"
#include "io/files/output_file.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"

namespace hottel {

namespace hdf5_library {

// Something that the library has open: closed by the function that fits.
class Handle {
 public:
  Handle() = default;
  Handle(hid_t id, herr_t (*closing)(hid_t)) : id_(id), close_(closing) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  hid_t operator*() const { return id_; }
  bool is_open() const { return id_ >= 0; }
  bool close() { return close_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_ = -1;
  herr_t (*close_)(hid_t) = nullptr;
};

// An array that is being written: what came of it and is no whole chunk yet.
struct OpenArray {
  Handle array;
  hid_t type = -1;
  std::size_t width = 0;
  hsize_t size = 0, chunk = 0, written = 0;
  std::string pending{};
  std::uint32_t sum = 0;
};

}  // namespace hdf5_library

namespace {

using hdf5_library::Handle;
using hdf5_library::OpenArray;

constexpr hsize_t kChunk = hsize_t{1} << 17;              // numbers
constexpr std::size_t kTextChunk = std::size_t{1} << 20;  // bytes of texts
constexpr const char* kSum = "crc32";
constexpr unsigned kReadOnly = 0, kTruncate = 2;  // H5F_ACC_RDONLY and H5F_ACC_TRUNC, which call the library

// Keeps the library for one thread, and what it prints of its errors to itself, for as long as it lives.
class Quiet {
 public:
  Quiet() : lock_(mutex()) {
    hdf5().Eget_auto2(H5E_DEFAULT, &print_, &data_);
    hdf5().Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Quiet() { hdf5().Eset_auto2(H5E_DEFAULT, print_, data_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }
  std::scoped_lock<std::mutex> lock_;
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

hid_t type_of(Hdf5Number number) {
  switch (number) {
    case Hdf5Number::kInt8:
      return *hdf5().T_STD_I8LE_g;
    case Hdf5Number::kUint32:
      return *hdf5().T_STD_U32LE_g;
    case Hdf5Number::kUint64:
      return *hdf5().T_STD_U64LE_g;
    case Hdf5Number::kFloat64:
      return *hdf5().T_IEEE_F64LE_g;
  }
  return -1;
}

// A type of texts of so many bytes of UTF-8.
Handle text_type(std::size_t bytes) {
  Handle type(hdf5().Tcopy(*hdf5().T_C_S1_g), hdf5().Tclose);
  hdf5().Tset_size(*type, std::max<std::size_t>(bytes, 1));
  hdf5().Tset_strpad(*type, H5T_STR_NULLPAD);
  hdf5().Tset_cset(*type, H5T_CSET_UTF8);
  return type;
}

// No dates, and chunks where there is something: their places follow from their numbers.
Handle array_properties(hsize_t size, hsize_t most = kChunk) {
  Handle properties(hdf5().Pcreate(*hdf5().P_CLS_DATASET_CREATE_ID_g), hdf5().Pclose);
  hdf5().Pset_obj_track_times(*properties, false);
  hdf5().Pset_alloc_time(*properties, H5D_ALLOC_TIME_EARLY);
  hdf5().Pset_fill_time(*properties, H5D_FILL_TIME_NEVER);
  const hsize_t chunk = std::min(size, most);
  if (size > 0) hdf5().Pset_chunk(*properties, 1, &chunk);
  return properties;
}

Handle file_properties() {
  Handle properties(hdf5().Pcreate(*hdf5().P_CLS_FILE_CREATE_ID_g), hdf5().Pclose);
  hdf5().Pset_obj_track_times(*properties, false);
  hdf5().Pset_link_creation_order(*properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  hdf5().Pset_link_phase_change(*properties, 64, 32);  // in the head of the file, which has a sum
  hdf5().Pset_attr_phase_change(*properties, 64, 32);
  return properties;
}

}  // namespace

void require_hdf5(std::string_view) { hdf5(); }

struct Hdf5Writer::File {
  std::string name;
  Handle file;
  std::map<std::string, OpenArray> arrays{};

  // Throws OutputError unless what the library returned is no failure.
  template <class Returned>
  Returned require(Returned returned) const {
    if (returned < 0)
      throw OutputError(name, errno != 0 ? "cannot be written: " + std::string(std::strerror(errno))
                                         : std::string("cannot be written: HDF5 fails"));
    return returned;
  }
  Handle scalar() const { return {require(hdf5().Screate(H5S_SCALAR)), hdf5().Sclose}; }
  void say(hid_t object, const std::string& key, hid_t type, const void* value) const {
    const Handle space = scalar();
    const Handle attribute(require(hdf5().Acreate2(object, key.c_str(), type, *space, H5P_DEFAULT, H5P_DEFAULT)),
                           hdf5().Aclose);
    require(hdf5().Awrite(*attribute, type, value));
  }
  void say_text(hid_t object, const std::string& key, const std::string& text) const {
    say(object, key, *text_type(text.size()), text.empty() ? "\0" : text.data());
  }
  Handle create(const std::string& name_of_it, hid_t type, hid_t space, hid_t properties) const {
    return {require(hdf5().Dcreate2(*file, name_of_it.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT)),
            hdf5().Dclose};
  }
  void write_out(OpenArray& array) const;
  void end(OpenArray& array) const;
};

// Puts what is pending behind what was written.
void Hdf5Writer::File::write_out(OpenArray& array) const {
  throw_if_interrupted();
  const hsize_t count = array.pending.size() / array.width;
  if (count == 0) return;
  const Handle memory(require(hdf5().Screate_simple(1, &count, nullptr)), hdf5().Sclose);
  const Handle space(require(hdf5().Dget_space(*array.array)), hdf5().Sclose);
  require(hdf5().Sselect_hyperslab(*space, H5S_SELECT_SET, &array.written, nullptr, &count, nullptr));
  errno = 0;
  require(hdf5().Dwrite(*array.array, array.type, *memory, *space, H5P_DEFAULT, array.pending.data()));
  array.sum = crc32_of(array.pending, array.sum);
  array.written += count;
  array.pending.clear();
}

void Hdf5Writer::File::end(OpenArray& array) const {
  write_out(array);
  HOTTEL_REQUIRE(array.written == array.size);
  say(*array.array, kSum, *hdf5().T_STD_U32LE_g, &array.sum);
  require(array.array.close() ? 0 : -1);
}

Hdf5Writer::Hdf5Writer(const std::string& path, std::string name) : file_(new File{std::move(name), {}}) {
  const Quiet quiet;
  const Handle access(hdf5().Pcreate(*hdf5().P_CLS_FILE_ACCESS_ID_g), hdf5().Pclose);
  hdf5().Pset_libver_bounds(*access, H5F_LIBVER_V110, H5F_LIBVER_V110);
  hdf5().Pset_file_locking(*access, false, true);  // temporary files have a lock of ours
  errno = 0;
  file_->file =
      Handle(file_->require(hdf5().Fcreate(path.c_str(), kTruncate, *file_properties(), *access)), hdf5().Fclose);
}

// To close a file that is not complete would write to it once more, and the library does not survive a full disk then.
Hdf5Writer::~Hdf5Writer() {
  static auto* const unfinished = new std::vector<std::unique_ptr<File>>;
  const Quiet quiet;
  if (file_->file.is_open()) unfinished->push_back(std::move(file_));
}

void Hdf5Writer::say(const std::string& key, const std::string& text) {
  const Quiet quiet;
  file_->say_text(*file_->file, key, text);
}

void Hdf5Writer::say(const std::string& key, std::uint32_t number) {
  const Quiet quiet;
  file_->say(*file_->file, key, *hdf5().T_STD_U32LE_g, &number);
}

void Hdf5Writer::say_of(const std::string& array, const std::string& key, const std::string& text) {
  const Quiet quiet;
  file_->say_text(*file_->arrays.at(array).array, key, text);
}

void Hdf5Writer::begin(const std::string& name, Hdf5Number number, std::uint64_t size) {
  const Quiet quiet;
  const hsize_t count = size;
  const Handle space(file_->require(hdf5().Screate_simple(1, &count, nullptr)), hdf5().Sclose);
  const hid_t type = type_of(number);
  file_->arrays[name] = OpenArray{file_->create(name, type, *space, *array_properties(size)), type,
                                  hdf5().Tget_size(type), count, kChunk};
}

void Hdf5Writer::append_bytes(const std::string& name, std::string_view bytes) {
  OpenArray& array = file_->arrays.at(name);
  const std::size_t most = array.chunk * array.width;
  while (!bytes.empty()) {
    const std::size_t taken = std::min(bytes.size(), most - array.pending.size());
    array.pending += bytes.substr(0, taken);
    bytes.remove_prefix(taken);
    if (array.pending.size() < most) continue;
    const Quiet quiet;
    file_->write_out(array);
  }
}

void Hdf5Writer::write_texts(const std::string& name, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  const Quiet quiet;
  const hsize_t count = texts.size();
  const Handle space(file_->require(hdf5().Screate_simple(1, &count, nullptr)), hdf5().Sclose);
  const Handle type = text_type(longest);
  const hsize_t chunk = std::max<std::size_t>(kTextChunk / longest, 1);
  OpenArray array{file_->create(name, *type, *space, *array_properties(count, chunk)), *type, longest, count, chunk};
  for (const std::string& text : texts) {
    array.pending += text;
    array.pending.append(longest - text.size(), '\0');
    if (array.pending.size() == chunk * longest) file_->write_out(array);
  }
  file_->end(array);
}

void Hdf5Writer::write_text(const std::string& name, const std::string& text) {
  const Quiet quiet;
  const Handle type = text_type(text.size()), space = file_->scalar();
  Handle array = file_->create(name, *type, *space, *array_properties(0));
  errno = 0;
  file_->require(hdf5().Dwrite(*array, *type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.empty() ? "\0" : text.data()));
  const std::uint32_t sum = crc32_of(text);
  file_->say(*array, kSum, *hdf5().T_STD_U32LE_g, &sum);
  file_->require(array.close() ? 0 : -1);
}

void Hdf5Writer::finish() {
  const Quiet quiet;
  for (auto& [name, array] : file_->arrays) file_->end(array);
  file_->arrays.clear();
  errno = 0;
  file_->require(hdf5().Fflush(*file_->file, H5F_SCOPE_GLOBAL));
  file_->require(file_->file.close() ? 0 : -1);
}

struct Hdf5Reader::File {
  std::string name;
  std::size_t bytes = 0;
  Handle file{};

  [[noreturn]] void refuse(const std::string& text) const { throw InputError({name, 0}, text); }
  [[noreturn]] void refuse_damaged() const { refuse("is a file of HDF5 that breaks off or is damaged"); }

  // An array of one dimension, or a single value, and how many members it has.
  struct Array {
    Handle array, type;
    std::uint64_t size = 0;
  };
  Array open(const std::string& array) const;
  // Throws unless the bytes that were read have the sum that is said of them.
  void require_sum(const Array& array, const std::string& array_name, std::string_view read) const;
  template <class T>
  std::vector<T> values(const std::string& array, hid_t type, H5T_class_t kind) const;
};

Hdf5Reader::File::Array Hdf5Reader::File::open(const std::string& array_name) const {
  if (hdf5().Lexists(*file, array_name.c_str(), H5P_DEFAULT) <= 0) refuse("has no array `" + array_name + "`");
  Array result{{hdf5().Dopen2(*file, array_name.c_str(), H5P_DEFAULT), hdf5().Dclose}, {}, 0};
  if (!result.array.is_open()) refuse_damaged();
  result.type = Handle(hdf5().Dget_type(*result.array), hdf5().Tclose);
  const Handle space(hdf5().Dget_space(*result.array), hdf5().Sclose);
  if (!result.type.is_open() || !space.is_open()) refuse_damaged();
  if (hdf5().Sget_simple_extent_ndims(*space) > 1) refuse("`" + array_name + "` has more than one dimension");
  result.size = static_cast<std::uint64_t>(std::max<hssize_t>(hdf5().Sget_simple_extent_npoints(*space), 0));
  // No compression makes more than a thousandth of zeros.
  if (result.size > bytes * 1100 / std::max<std::size_t>(hdf5().Tget_size(*result.type), 1)) refuse_damaged();
  return result;
}

void Hdf5Reader::File::require_sum(const Array& array, const std::string& array_name, std::string_view read) const {
  if (hdf5().Aexists(*array.array, kSum) <= 0) return;
  const Handle attribute(hdf5().Aopen(*array.array, kSum, H5P_DEFAULT), hdf5().Aclose);
  std::uint32_t sum = 0;
  if (hdf5().Aread(*attribute, *hdf5().T_NATIVE_UINT32_g, &sum) < 0) refuse_damaged();
  if (sum != crc32_of(read)) refuse("is damaged: `" + array_name + "` has not the sum that the file tells");
}

template <class T>
std::vector<T> Hdf5Reader::File::values(const std::string& array_name, hid_t type, H5T_class_t kind) const {
  const Array array = open(array_name);
  const H5T_class_t found = hdf5().Tget_class(*array.type);
  if (found != H5T_INTEGER && found != kind)
    refuse("`" + array_name + "` holds no " + (kind == H5T_INTEGER ? "whole " : "") + "numbers");
  // In the type of the file first, whose bytes have the sum.
  std::string raw(array.size * hdf5().Tget_size(*array.type), '\0');
  if (hdf5().Dread(*array.array, *array.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, raw.data()) < 0) refuse_damaged();
  require_sum(array, array_name, raw);
  raw.resize(std::max(raw.size(), array.size * sizeof(T)));
  if (hdf5().Tconvert(*array.type, type, array.size, raw.data(), nullptr, H5P_DEFAULT) < 0)
    refuse("`" + array_name + "` holds other numbers than are read");
  std::vector<T> result(array.size);
  if (!result.empty()) std::memcpy(result.data(), raw.data(), result.size() * sizeof(T));
  return result;
}

Hdf5Reader::Hdf5Reader(std::string name, std::string_view bytes) : file_(new File{std::move(name), bytes.size()}) {
  const Quiet quiet;
  const Handle access(hdf5().Pcreate(*hdf5().P_CLS_FILE_ACCESS_ID_g), hdf5().Pclose);
  constexpr std::size_t kIncrement = 1 << 16;
  hdf5().Pset_fapl_core(*access, kIncrement, false);
  // The library copies the bytes and does not change them; it only asks for them as if it might.
  hdf5().Pset_file_image(*access, const_cast<char*>(bytes.data()), bytes.size());
  constexpr const char* kNowhere =
      "/dev/null/image";  // a name that no file has: the library refuses those that one has
  file_->file = Handle(hdf5().Fopen(kNowhere, kReadOnly, *access), hdf5().Fclose);
  if (!file_->file.is_open()) file_->refuse_damaged();
}

Hdf5Reader::~Hdf5Reader() {
  const Quiet quiet;
  file_.reset();
}

bool Hdf5Reader::has(const std::string& array) const {
  const Quiet quiet;
  return hdf5().Lexists(*file_->file, array.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::uint64_t> Hdf5Reader::whole_numbers(const std::string& array) const {
  const Quiet quiet;
  return file_->values<std::uint64_t>(array, *hdf5().T_NATIVE_UINT64_g, H5T_INTEGER);
}

std::vector<double> Hdf5Reader::numbers(const std::string& array) const {
  const Quiet quiet;
  return file_->values<double>(array, *hdf5().T_NATIVE_DOUBLE_g, H5T_FLOAT);
}

std::vector<std::string> Hdf5Reader::texts(const std::string& name) const {
  const Quiet quiet;
  const File::Array array = file_->open(name);
  if (hdf5().Tget_class(*array.type) != H5T_STRING) file_->refuse("`" + name + "` holds no texts");
  std::vector<std::string> result;
  if (hdf5().Tis_variable_str(*array.type) > 0) {
    std::vector<char*> read(array.size, nullptr);
    const Handle space(hdf5().Dget_space(*array.array), hdf5().Sclose);
    if (hdf5().Dread(*array.array, *array.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, read.data()) < 0)
      file_->refuse_damaged();
    for (const char* text : read) result.emplace_back(text == nullptr ? "" : text);
    hdf5().Dvlen_reclaim(*array.type, *space, H5P_DEFAULT, read.data());
    return result;
  }
  const std::size_t width = hdf5().Tget_size(*array.type);
  std::string read(array.size * width, '\0');
  if (hdf5().Dread(*array.array, *array.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, read.data()) < 0) file_->refuse_damaged();
  file_->require_sum(array, name, read);
  const char pad = hdf5().Tget_strpad(*array.type) == H5T_STR_SPACEPAD ? ' ' : '\0';
  for (std::uint64_t k = 0; k < array.size; ++k) {
    std::string text = read.substr(k * width, width);
    if (pad == '\0') text.resize(std::min(text.size(), text.find('\0')));
    while (!text.empty() && text.back() == pad) text.pop_back();
    result.push_back(std::move(text));
  }
  return result;
}

std::optional<std::string> Hdf5Reader::said_text(const std::string& key) const {
  const Quiet quiet;
  if (hdf5().Aexists(*file_->file, key.c_str()) <= 0) return std::nullopt;
  const Handle attribute(hdf5().Aopen(*file_->file, key.c_str(), H5P_DEFAULT), hdf5().Aclose);
  const Handle type(hdf5().Aget_type(*attribute), hdf5().Tclose);
  if (hdf5().Tget_class(*type) != H5T_STRING || hdf5().Tis_variable_str(*type) > 0) return std::nullopt;
  std::string text(hdf5().Aget_storage_size(*attribute), '\0');
  if (text.size() != hdf5().Tget_size(*type) || hdf5().Aread(*attribute, *type, text.data()) < 0) return std::nullopt;
  text.resize(std::min(text.size(), text.find('\0')));
  return text;
}

std::optional<std::uint64_t> Hdf5Reader::said_number(const std::string& key) const {
  const Quiet quiet;
  if (hdf5().Aexists(*file_->file, key.c_str()) <= 0) return std::nullopt;
  const Handle attribute(hdf5().Aopen(*file_->file, key.c_str(), H5P_DEFAULT), hdf5().Aclose);
  const Handle type(hdf5().Aget_type(*attribute), hdf5().Tclose);
  std::uint64_t number = 0;
  if (hdf5().Tget_class(*type) != H5T_INTEGER || hdf5().Aget_storage_size(*attribute) > sizeof number ||
      hdf5().Aread(*attribute, *hdf5().T_NATIVE_UINT64_g, &number) < 0)
    return std::nullopt;
  return number;
}

}  // namespace hottel
