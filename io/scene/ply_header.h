// What the header of a PLY file says of the rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hottel {

enum class PlyFormat : unsigned char { kText, kLittleEndian, kBigEndian };

enum class PlyType : unsigned char { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

// The bytes of a value in a binary file.
std::size_t ply_size(PlyType type);
bool is_integer(PlyType type);

// A number, or a list of them.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat32;
  std::optional<PlyType> count;  // of a list: the type of its length, an integer
};

// As many items with these properties.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  int line = 0;

  // The property of that name, by its index.
  std::optional<std::size_t> find(std::string_view property) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::kText;
  std::vector<PlyElement> elements;
  std::size_t body = 0;  // where the rest begins
  int body_line = 0;     // and in which line
};

// Returns the header of a PLY file of version 1.0.
//
//   (1) lines end as the first one does: in LF, CR LF or CR
//   (2) types have their old names (char, uchar, ..., double) or their new ones (int8, ..., float64)
//   (3) `comment` and `obj_info` are passed over
//
// Throws InputError with file and line for anything else, and for a name given twice.
PlyHeader parse_ply_header(std::string_view bytes, const std::string& file);

}  // namespace hottel
