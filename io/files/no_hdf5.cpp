// In place of hdf5.cpp where hottel is built without HDF5.
#include "io/files/hdf5.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr const char* kWithout = " needs HDF5, which this hottel was built without (-DHOTTEL_HDF5=OFF)";

}  // namespace

struct Hdf5Writer::File {};
struct Hdf5Reader::File {};

void require_hdf5(std::string_view what) { throw UsageError(std::string(what) + kWithout); }

Hdf5Writer::Hdf5Writer(const std::string&, std::string name) { require_hdf5(name); }
Hdf5Writer::~Hdf5Writer() = default;
void Hdf5Writer::say(const std::string&, const std::string&) {}
void Hdf5Writer::say(const std::string&, std::uint32_t) {}
void Hdf5Writer::say_of(const std::string&, const std::string&, const std::string&) {}
void Hdf5Writer::begin(const std::string&, Hdf5Number, std::uint64_t) {}
void Hdf5Writer::append_bytes(const std::string&, std::string_view) {}
void Hdf5Writer::write_texts(const std::string&, const std::vector<std::string>&) {}
void Hdf5Writer::write_text(const std::string&, const std::string&) {}
void Hdf5Writer::finish() {}

Hdf5Reader::Hdf5Reader(std::string name, std::string_view) {
  throw InputError({std::move(name), 0}, "is a file of HDF5, and this hottel was built without (-DHOTTEL_HDF5=OFF)");
}
Hdf5Reader::~Hdf5Reader() = default;
bool Hdf5Reader::has(const std::string&) const { return false; }
std::vector<std::uint64_t> Hdf5Reader::whole_numbers(const std::string&) const { return {}; }
std::vector<double> Hdf5Reader::numbers(const std::string&) const { return {}; }
std::vector<std::string> Hdf5Reader::texts(const std::string&) const { return {}; }
std::optional<std::string> Hdf5Reader::said_text(const std::string&) const { return std::nullopt; }
std::optional<std::uint64_t> Hdf5Reader::said_number(const std::string&) const { return std::nullopt; }

}  // namespace hottel
