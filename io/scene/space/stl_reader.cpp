#include "io/scene/space/stl_reader.h"

#include <bit>
#include <cmath>

#include "geometry/name.h"
#include "io/scene/binary_values.h"
#include "io/scene/space/mesh_names.h"
#include "io/scene/text_words.h"
#include "kernel/exact_double.h"
#include "kernel/support/counted.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::size_t kHeaderBytes = 80, kNormalBytes = 12, kTriangleBytes = 50;
constexpr std::size_t kFirstTriangle = kHeaderBytes + 4;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_keyword(std::string_view word, std::string_view keyword) {
  if (word.size() != keyword.size()) return false;
  for (std::size_t k = 0; k < word.size(); ++k)
    if (lower(word[k]) != keyword[k]) return false;
  return true;
}

// What a group may be called (name_problem) after a solid: other characters are '_'.
std::string group_name(std::string_view typed) {
  const bool is_text = is_utf8(typed);
  std::string name;
  for (const char c : typed) {
    const auto byte = static_cast<unsigned char>(c);
    name += c == '#' || byte < 0x20 || byte == 0x7F || (!is_text && byte >= 0x80) ? '_' : c;
  }
  return name.empty() || name_problem(name).empty() ? name : name + "_";
}

class TextStl3 {
 public:
  TextStl3(std::string_view text, const std::string& file) : words_(text, file, false) { mesh_.file = file; }

  Mesh3 read() {
    std::size_t solids = 0;
    for (; const auto word = words_.next(); ++solids) {
      require(*word, "solid");
      begin_solid(words_.rest_of_line());
      while (!read_end_or_facet()) {
      }
    }
    mesh_.is_one_body = solids > 1;
    if (!mesh_.is_one_body) forget_groups();
    return std::move(mesh_);
  }

 private:
  void begin_solid(std::string_view typed) {
    name_ = {group_name(typed), words_.line()};
    typed_ = typed;
    group_.reset();
  }

  // The group of the solid, once it has a triangle; none if it has no name.
  std::optional<std::uint32_t> group() {
    if (!group_ && !typed_.empty()) group_ = names_.index_of(typed_, name_, mesh_.groups);
    return group_;
  }

  void forget_groups() {
    mesh_.groups.clear();
    for (MeshFace3& face : mesh_.faces) face.group.reset();
  }

  std::string_view word() {
    if (const auto word = words_.next()) return *word;
    words_.refuse("the file ends before endsolid, after " + std::to_string(mesh_.faces.size()) + " whole triangles");
  }

  void require(std::string_view word, std::string_view keyword) const {
    if (!is_keyword(word, keyword))
      words_.refuse("there is " + quoted_name(word) + " where " + std::string(keyword) + " has to be");
  }
  void read(std::string_view keyword) { require(word(), keyword); }

  // True at the end of the solid.
  bool read_end_or_facet() {
    const std::string_view first = word();
    if (is_keyword(first, "endsolid")) {
      words_.rest_of_line();
      return true;
    }
    if (!is_keyword(first, "facet"))
      words_.refuse("there is " + quoted_name(first) + " where facet or endsolid has to be");
    MeshFace3 face;
    face.line = words_.line();
    read("normal");
    for (int axis = 0; axis < 3; ++axis) word();
    read("outer");
    read("loop");
    for (int corner = 0; corner < 3; ++corner) {
      read("vertex");
      Point3 point;
      for (Rational* coordinate : {&point.x, &point.y, &point.z}) *coordinate = words_.number(word(), "coordinate");
      face.polygon.points.push_back(std::move(point));
    }
    read("endloop");
    read("endfacet");
    face.group = group();
    mesh_.faces.push_back(std::move(face));
    return false;
  }

  TextWords words_;
  Mesh3 mesh_;
  MeshName3 name_;  // of the solid, as a group may be called
  std::string typed_;
  std::optional<std::uint32_t> group_;
  MeshNames3 names_;
};

std::uint32_t triangles_of(std::string_view bytes) {
  return BinaryValues(bytes, std::endian::little, kHeaderBytes).take<std::uint32_t>();
}

bool is_text(std::string_view bytes) {
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n\v\f");
  return begin != std::string_view::npos && is_keyword(bytes.substr(begin, 5), "solid") &&
         bytes.substr(0, kFirstTriangle).find('\0') == std::string_view::npos;
}

// Why bytes are neither.
[[noreturn]] void refuse(std::string_view bytes, const std::string& file) {
  std::string why = "is no STL file: it does not begin with solid, and ";
  if (bytes.size() < kFirstTriangle) {
    why += "it has " + std::to_string(bytes.size()) + " bytes where a binary one has 84 or more";
  } else {
    const std::size_t count = triangles_of(bytes);
    why = "is no STL file, or no whole one: a binary one of " + counted(count, "triangle") + " (bytes 80 to 83) has " +
          std::to_string(kFirstTriangle + kTriangleBytes * count) + " bytes, not " + std::to_string(bytes.size()) +
          "; one of text begins with solid";
  }
  throw InputError({file, 0}, why);
}

Mesh3 parse_binary(std::string_view bytes, const std::string& file) {
  Mesh3 mesh;
  mesh.file = file;
  BinaryValues values(bytes, std::endian::little, kFirstTriangle);
  mesh.faces.reserve(triangles_of(bytes));  // they are there
  while (values.bytes_left() > 0) {
    MeshFace3 face;
    face.byte = values.at();
    values.pass_over(kNormalBytes);
    for (int corner = 0; corner < 3; ++corner) {
      Point3 point;
      for (Rational* coordinate : {&point.x, &point.y, &point.z}) {
        const std::size_t at = values.at();
        const float value = values.take<float>();
        if (!std::isfinite(value))
          throw InputError({file, 0}, "a coordinate of triangle " + std::to_string(mesh.faces.size()) +
                                          " is not finite (byte " + std::to_string(at) + ")");
        *coordinate = exact_value(value);
      }
      face.polygon.points.push_back(std::move(point));
    }
    values.pass_over(2);
    mesh.faces.push_back(std::move(face));
  }
  return mesh;
}

}  // namespace

bool is_binary_stl_3(std::string_view bytes) {
  return bytes.size() >= kFirstTriangle && bytes.size() == kFirstTriangle + kTriangleBytes * triangles_of(bytes);
}

Mesh3 parse_stl_3(std::string_view bytes, const std::string& file) {
  if (!is_binary_stl_3(bytes) && !is_text(bytes)) refuse(bytes, file);
  Mesh3 mesh = is_binary_stl_3(bytes) ? parse_binary(bytes, file) : TextStl3(bytes, file).read();
  if (mesh.faces.empty()) throw InputError({file, 0}, "has no triangles");
  return mesh;
}

}  // namespace hottel
