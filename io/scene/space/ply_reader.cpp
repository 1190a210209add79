#include "io/scene/space/ply_reader.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/name.h"
#include "geometry/planarity.h"
#include "geometry/space/scene/near_plane.h"
#include "io/scene/binary_values.h"
#include "io/scene/ply_header.h"
#include "io/scene/text_words.h"
#include "kernel/exact_double.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// Where an element is read: "vertex 3 of 8", for messages.
struct Item {
  const PlyElement* element = nullptr;
  std::uint64_t index = 0;

  std::string text() const {
    return element->name + " " + std::to_string(index) + " of " + std::to_string(element->count);
  }
};

// The rest of a text file.
class TextBody {
 public:
  TextBody(std::string_view bytes, const std::string& file, const PlyHeader& header)
      : words_(bytes.substr(header.body), file, false, header.body_line), file_(file) {}

  // Each value is a character, and a blank.
  void require_room(const PlyElement& element) const {
    const std::size_t values = (words_.bytes_left() + 1) / 2;
    if (element.count > values / element.properties.size())
      throw InputError({file_, element.line}, "the header says " + std::to_string(element.count) + " of element " +
                                                  quoted_name(element.name) + ", and the file ends before that");
  }
  void begin(const Item& item) { item_ = item; }

  Rational coordinate(const PlyProperty& property) {
    const std::string_view text = word();
    Rational value = words_.number(text, property.name);
    finest_.take(text);
    return value;
  }
  // What was told of the digits of coordinates.
  void tell_digits(Mesh3& mesh) const { mesh.unit = finest_.unit(); }
  std::int64_t integer(PlyType, const PlyProperty& property) { return words_.integer(word(), property.name); }
  void pass_over(PlyType, std::uint64_t count) {
    for (; count > 0; --count) word();
  }

  void require_end() {
    if (const auto word = words_.next()) refuse("after the last element there is " + quoted_name(*word));
  }

  // The place of the last value.
  int line() const { return words_.line(); }
  std::optional<std::size_t> byte() const { return std::nullopt; }
  [[noreturn]] void refuse(const std::string& text) const { words_.refuse(text); }

 private:
  std::string_view word() {
    if (const auto word = words_.next()) return *word;
    refuse("the file ends within " + item_.text());
  }

  TextWords words_;
  const std::string& file_;
  Item item_;
  FinestDigit finest_;
};

// The rest of a binary file.
class BinaryBody {
 public:
  BinaryBody(std::string_view bytes, const std::string& file, const PlyHeader& header)
      : values_(bytes, header.format == PlyFormat::kBigEndian ? std::endian::big : std::endian::little, header.body),
        file_(file),
        at_(header.body) {}

  void require_room(const PlyElement& element) {
    at_ = values_.at();
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties) least += ply_size(property.count.value_or(property.type));
    if (element.count > values_.bytes_left() / least)
      refuse("the header says " + std::to_string(element.count) + " of element " + quoted_name(element.name) +
             " and the file has " + std::to_string(values_.bytes_left()) + " bytes more");
  }
  void begin(const Item& item) {
    item_ = item;
    begin_ = values_.at();
  }

  Rational coordinate(const PlyProperty& property) {
    if (is_integer(property.type)) return Rational(static_cast<long>(integer(property.type, property)));
    require(property.type, 1);
    const int digits =
        property.type == PlyType::kFloat32 ? std::numeric_limits<float>::digits : std::numeric_limits<double>::digits;
    float_digits_ = float_digits_ == 0 ? digits : std::min(float_digits_, digits);
    const double value = property.type == PlyType::kFloat32 ? values_.take<float>() : values_.take<double>();
    if (!std::isfinite(value)) refuse(property.name + " of " + item_.text() + " is not finite");
    return exact_value(value);
  }
  // Integers have the unit 1.
  void tell_digits(Mesh3& mesh) const {
    mesh.unit = 1;
    mesh.float_digits = float_digits_;
  }
  std::int64_t integer(PlyType type, const PlyProperty&) {
    require(type, 1);
    switch (type) {
      case PlyType::kInt8:
        return values_.take<std::int8_t>();
      case PlyType::kUint8:
        return values_.take<std::uint8_t>();
      case PlyType::kInt16:
        return values_.take<std::int16_t>();
      case PlyType::kUint16:
        return values_.take<std::uint16_t>();
      case PlyType::kInt32:
        return values_.take<std::int32_t>();
      default:
        return values_.take<std::uint32_t>();
    }
  }
  void pass_over(PlyType type, std::uint64_t count) {
    require(type, count);
    values_.pass_over(count * ply_size(type));
  }

  void require_end() {
    at_ = values_.at();
    if (values_.bytes_left() > 0)
      refuse("after the last element there are " + std::to_string(values_.bytes_left()) + " bytes more");
  }

  int line() const { return 0; }
  // Where the item begins.
  std::optional<std::size_t> byte() const { return begin_; }
  [[noreturn]] void refuse(const std::string& text) const {
    throw InputError({file_, 0}, text + " (byte " + std::to_string(at_) + ")");
  }

 private:
  void require(PlyType type, std::uint64_t count) {
    at_ = values_.at();
    if (count > values_.bytes_left() / ply_size(type)) refuse("the file ends within " + item_.text());
  }

  BinaryValues values_;
  const std::string& file_;
  std::size_t at_, begin_ = 0;  // of the last value, of the item
  Item item_;
  int float_digits_ = 0;
};

// A face as it is listed: its vertices may stand after it.
struct ListedFace {
  std::vector<std::uint32_t> vertices;
  int line = 0;
  std::optional<std::size_t> byte;
};

template <class Body>
class BodyReader {
 public:
  BodyReader(const PlyHeader& header, Body body, const std::string& file) : header_(header), body_(std::move(body)) {
    mesh_.file = file;
  }

  Mesh3 read() {
    for (const PlyElement& element : header_.elements)
      if (element.name == "vertex") vertices_ = element.count;
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;  // nothing is written of it
      if (element.count > 0) body_.require_room(element);
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else
        pass_over(element);
    }
    body_.require_end();
    if (faces_.empty()) throw InputError({mesh_.file, 0}, "has no faces");
    mesh_.faces.reserve(faces_.size());
    for (ListedFace& listed : faces_) add(listed);
    body_.tell_digits(mesh_);
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void refuse(const PlyElement& element, const std::string& text) const {
    throw InputError({mesh_.file, element.line}, text);
  }

  void pass_over(const PlyProperty& property) {
    if (!property.count) return body_.pass_over(property.type, 1);
    body_.pass_over(property.type, length(property));
  }

  std::uint64_t length(const PlyProperty& list) {
    const std::int64_t length = body_.integer(*list.count, list);
    if (length < 0) body_.refuse("the list " + quoted_name(list.name) + " has the length " + std::to_string(length));
    return static_cast<std::uint64_t>(length);
  }

  void read_vertices(const PlyElement& element) {
    std::array<std::size_t, 3> place{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string name(1, "xyz"[axis]);
      const auto found = element.find(name);
      if (!found || element.properties[*found].count) refuse(element, "element 'vertex' has no number " + name);
      place[axis] = *found;
    }
    for (std::uint64_t k = 0; k < element.count; ++k) {
      body_.begin({&element, k});
      Point3 point;
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        if (p == place[0])
          point.x = body_.coordinate(property);
        else if (p == place[1])
          point.y = body_.coordinate(property);
        else if (p == place[2])
          point.z = body_.coordinate(property);
        else
          pass_over(property);
      }
      points_.push_back(std::move(point));
    }
  }

  void read_faces(const PlyElement& element) {
    const auto indices = element.find("vertex_indices"), index = element.find("vertex_index");
    if (indices && index) refuse(element, "element 'face' has two lists: vertex_indices and vertex_index");
    if (!indices && !index) refuse(element, "element 'face' has no list vertex_indices");
    const std::size_t place = indices ? *indices : *index;
    const PlyProperty& list = element.properties[place];
    if (!list.count || !is_integer(list.type))
      refuse(element, quoted_name(list.name) + " of element 'face' is no list of integers");
    for (std::uint64_t k = 0; k < element.count; ++k) {
      body_.begin({&element, k});
      for (std::size_t p = 0; p < element.properties.size(); ++p)
        if (p == place)
          read_face(list, k);
        else
          pass_over(element.properties[p]);
    }
  }

  void read_face(const PlyProperty& list, std::uint64_t k) {
    ListedFace face;
    const std::uint64_t length = this->length(list);
    face.line = body_.line();
    face.byte = body_.byte();
    if (length < 3)
      body_.refuse("face " + std::to_string(k) + " has fewer than three vertices: " + std::to_string(length));
    for (std::uint64_t c = 0; c < length; ++c) {  // each is read before there is room for the next
      const std::int64_t vertex = body_.integer(list.type, list);
      if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= vertices_)
        body_.refuse("the vertex " + std::to_string(vertex) + " of face " + std::to_string(k) + " is none of the " +
                     std::to_string(vertices_) + ", counted from 0");
      face.vertices.push_back(static_cast<std::uint32_t>(vertex));
    }
    faces_.push_back(std::move(face));
  }

  void pass_over(const PlyElement& element) {
    if (element.name == "tristrips" && element.count > 0)
      refuse(element, "element 'tristrips' is not read: write faces instead of strips of triangles");
    for (std::uint64_t k = 0; k < element.count; ++k) {
      body_.begin({&element, k});
      for (const PlyProperty& property : element.properties) pass_over(property);
    }
  }

  void add(ListedFace& listed) {
    MeshFace3 face;
    face.polygon.points.reserve(listed.vertices.size());
    for (const std::uint32_t vertex : std::exchange(listed.vertices, {}))
      face.polygon.points.push_back(points_[vertex]);
    face.line = listed.line;
    face.byte = listed.byte;
    mesh_.faces.push_back(std::move(face));
  }

  const PlyHeader& header_;
  Body body_;
  Mesh3 mesh_;
  std::uint64_t vertices_ = 0;
  std::vector<Point3> points_;
  std::vector<ListedFace> faces_;
};

}  // namespace

Mesh3 parse_ply_3(std::string_view bytes, const std::string& file) {
  const PlyHeader header = parse_ply_header(bytes, file);
  if (header.format == PlyFormat::kText) return BodyReader(header, TextBody(bytes, file, header), file).read();
  return BodyReader(header, BinaryBody(bytes, file, header), file).read();
}

}  // namespace hottel
