#include "io/scene/binary_scene.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/files/crc32.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::string_view kMagic = "\x93hottel scene\n";
constexpr std::uint32_t kLayout = 3;
// After the magic: the layout and the sum, four bytes each, the lower ones first; then the dimension and the scene.
constexpr std::size_t kHead = kMagic.size() + 2 * sizeof(std::uint32_t);

// What each part of a scene consists of: named once, for those who write and those who read. A change here is another
// layout.
template <class T, class... Parts>
concept Is = (std::same_as<std::remove_const_t<T>, Parts> || ...);

template <Is<Spectrum> T, class Visit>
void fields(T& s, Visit& visit) {
  visit(s.value, s.is_scalar);
}
template <Is<Material> T, class Visit>
void fields(T& m, Visit& visit) {
  visit(m.name, m.reflectivity, m.emission, m.called_insulated, m.emissivity, m.has_bands, m.says_solar,
        m.is_two_sided);
}
template <Is<MeshPlace> T, class Visit>
void fields(T& p, Visit& visit) {
  visit(p.file, p.line);
}
template <Is<Surface> T, class Visit>
void fields(T& s, Visit& visit) {
  visit(s.name, s.material, s.back, s.elements, s.group, s.line, s.is_obstruction, s.in_mesh, s.on);
}
template <Is<PatchBase> T, class Visit>
void fields(T& b, Visit& visit) {
  visit(b.name, b.is_back);
}
template <Is<Group> T, class Visit>
void fields(T& g, Visit& visit) {
  visit(g.name, g.behind, g.body);
}
template <Is<Light> T, class Visit>
void fields(T& l, Visit& visit) {
  visit(l.name, l.type, l.focus, l.falloff, l.power, l.is_thermal, l.line);
}
template <Is<Expectation> T, class Visit>
void fields(T& e, Visit& visit) {
  visit(e.name, e.kind, e.quantity, e.of, e.at, e.value, e.form, e.derivation, e.line);
}
template <Is<SceneTable> T, class Visit>
void fields(T& t, Visit& visit) {
  visit(t.file, t.sources, t.about, t.materials, t.surfaces, t.groups, t.bases, t.lights, t.sky_emission, t.closed,
        t.expect, t.unit, t.has_bands);
}
template <Is<Point2> T, class Visit>
void fields(T& p, Visit& visit) {
  visit(p.x, p.y);
}
template <Is<Edge2> T, class Visit>
void fields(T& e, Visit& visit) {
  visit(e.from, e.to);
}
template <Is<Grid2> T, class Visit>
void fields(T& g, Visit& visit) {
  visit(g.min, g.max, g.nx, g.ny, g.name);
}
template <Is<LightPath2, LightPath3> T, class Visit>
void fields(T& p, Visit& visit) {
  visit(p.points, p.seconds, p.closed);
}
template <Is<LightPlace2> T, class Visit>
void fields(T& p, Visit& visit) {
  visit(p.position, p.direction, p.turned, p.rotation, p.path);
}
template <Is<Point3, Vector3> T, class Visit>
void fields(T& p, Visit& visit) {
  visit(p.x, p.y, p.z);
}
template <Is<Polygon3> T, class Visit>
void fields(T& p, Visit& visit) {
  visit(p.points, p.holes, p.is_nearly_plane, p.facets);
}
template <Is<Mask3> T, class Visit>
void fields(T& m, Visit& visit) {
  visit(m.surface, m.base);
}
template <Is<LightPlace3> T, class Visit>
void fields(T& p, Visit& visit) {
  visit(p.position, p.direction, p.rotation, p.path);
}
template <Is<Camera3> T, class Visit>
void fields(T& c, Visit& visit) {
  visit(c.eye, c.target, c.up, c.field_of_view, c.width, c.height);
}
template <Is<Grid3> T, class Visit>
void fields(T& g, Visit& visit) {
  visit(g.origin, g.u, g.v, g.nu, g.nv, g.name, g.w, g.nw);
}
template <Is<Scene2> T, class Visit>
void fields(T& s, Visit& visit) {
  using Table = std::conditional_t<std::is_const_v<T>, const SceneTable, SceneTable>;
  visit(static_cast<Table&>(s), s.edges, s.light_places, s.grids);
}
template <Is<Scene3> T, class Visit>
void fields(T& s, Visit& visit) {
  using Table = std::conditional_t<std::is_const_v<T>, const SceneTable, SceneTable>;
  visit(static_cast<Table&>(s), s.polygons, s.masks, s.light_places, s.camera, s.grids);
}

// A rational is its numerator and denominator; where one of them has more than 62 bits it is this mark, and both as
// bytes.
enum class Size : unsigned char { kWhole, kShort, kLong };

bool is_short(const mpz_class& number) { return mpz_sizeinbase(number.get_mpz_t(), 2) <= 62; }

class SceneWriter {
 public:
  template <class... Parts>
  void operator()(const Parts&... parts) {
    (write(parts), ...);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void count(std::uint64_t number) {
    for (; number >= 0x80; number >>= 7) bytes_ += static_cast<char>(number | 0x80);
    bytes_ += static_cast<char>(number);
  }
  void whole(std::int64_t number) {  // small ones of either sign take few bytes
    count((static_cast<std::uint64_t>(number) << 1) ^ static_cast<std::uint64_t>(number >> 63));
  }
  template <std::integral T>
  void write(T number) {
    if constexpr (std::unsigned_integral<T>)
      count(number);
    else
      whole(number);
  }
  template <class T>
  requires std::is_enum_v<T>
  void write(T value) { bytes_ += static_cast<char>(value); }
  void write(const std::string& text) {
    count(text.size());
    bytes_ += text;
  }
  void write_long(const mpz_class& number) {
    std::vector<unsigned char> magnitude((mpz_sizeinbase(number.get_mpz_t(), 2) + 7) / 8);
    std::size_t size = 0;
    mpz_export(magnitude.data(), &size, -1, 1, 0, 0, number.get_mpz_t());
    count(2 * size + (sgn(number) < 0 ? 1 : 0));
    bytes_.append(reinterpret_cast<const char*>(magnitude.data()), size);
  }
  void write(const Rational& value) {
    if (!is_short(value.get_num()) || !is_short(value.get_den())) {
      write(Size::kLong);
      write_long(value.get_num());
      return write_long(value.get_den());
    }
    const bool is_whole = value.get_den() == 1;
    write(is_whole ? Size::kWhole : Size::kShort);
    whole(value.get_num().get_si());
    if (!is_whole) count(value.get_den().get_ui());
  }
  template <class T>
  void write(const std::vector<T>& list) {
    count(list.size());
    for (const T& each : list) write(each);
  }
  template <class T, std::size_t N>
  void write(const std::array<T, N>& list) {
    for (const T& each : list) write(each);
  }
  template <class T>
  void write(const std::optional<T>& value) {
    count(value ? 1 : 0);
    if (value) write(*value);
  }
  template <class T>
  requires std::is_class_v<T>
  void write(const T& part) { fields(part, *this); }

  std::string bytes_;
};

class SceneReader {
 public:
  SceneReader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}
  template <class... Parts>
  void operator()(Parts&... parts) {
    (read(parts), ...);
  }
  bool is_at_end() const { return rest_.empty(); }
  [[noreturn]] void refuse() const { throw InputError({name_, 0}, "is a binary scene that makes no sense"); }

 private:
  std::string_view take(std::uint64_t size) {
    if (size > rest_.size()) refuse();
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  unsigned char byte() { return static_cast<unsigned char>(take(1).front()); }
  std::uint64_t count() {
    std::uint64_t number = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      const unsigned char part = byte();
      number |= static_cast<std::uint64_t>(part & 0x7F) << shift;
      if (part < 0x80) return number;
    }
    refuse();
  }
  std::int64_t whole() {
    const std::uint64_t number = count();
    return static_cast<std::int64_t>(number >> 1) ^ -static_cast<std::int64_t>(number & 1);
  }
  template <std::integral T>
  void read(T& number) {
    const auto value = [this] {
      if constexpr (std::unsigned_integral<T>)
        return count();
      else
        return whole();
    }();
    if (!std::in_range<T>(value)) refuse();
    number = static_cast<T>(value);
  }
  void read(bool& value) {
    const unsigned char code = byte();
    if (code > 1) refuse();
    value = code == 1;
  }
  template <class T>
  requires std::is_enum_v<T>
  void read(T& value) {
    constexpr unsigned char kLast = 2;  // of each enumeration that a scene has
    const unsigned char code = byte();
    if (code > kLast) refuse();
    value = static_cast<T>(code);
  }
  void read(std::string& text) { text = take(count()); }
  mpz_class long_number() {
    const std::uint64_t size = count();
    const std::string_view magnitude = take(size / 2);
    mpz_class number;
    mpz_import(number.get_mpz_t(), magnitude.size(), -1, 1, 0, 0, magnitude.data());
    return size % 2 == 1 ? mpz_class(-number) : number;
  }
  void read(Rational& value) {
    Size size{};
    read(size);
    if (size == Size::kLong) {
      value.get_num() = long_number();
      value.get_den() = long_number();
    } else {
      value.get_num() = static_cast<long>(whole());
      if (size == Size::kShort) value.get_den() = static_cast<unsigned long>(count());
    }
    if (size != Size::kWhole && value.get_den() <= 0) refuse();
    if (size != Size::kWhole) value.canonicalize();
  }
  template <class T>
  void read(std::vector<T>& list) {
    const std::uint64_t size = count();
    if (size > rest_.size()) refuse();  // each has a byte at least
    list.assign(size, empty<T>());
    for (T& each : list) read(each);
  }
  template <class T>
  static T empty() {
    if constexpr (std::same_as<T, Group>)
      return Group("");
    else
      return {};
  }
  template <class T, std::size_t N>
  void read(std::array<T, N>& list) {
    for (T& each : list) read(each);
  }
  template <class T>
  void read(std::optional<T>& value) {
    bool is_there = false;
    read(is_there);
    value.reset();
    if (is_there) read(value.emplace());
  }
  template <class T>
  requires std::is_class_v<T>
  void read(T& part) { fields(part, *this); }

  std::string_view rest_;
  const std::string& name_;
};

void append(std::string& bytes, std::uint32_t number) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(number >> (8 * k));
}

std::uint32_t number_at(std::string_view bytes, std::size_t place) {
  std::uint32_t number = 0;
  for (unsigned k = 0; k < 4; ++k)
    number |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[place + k])) << (8 * k);
  return number;
}

template <class AnyScene>
std::string written(const AnyScene& scene, std::uint32_t dimension) {
  SceneWriter writer;
  writer(dimension, scene);
  std::string bytes(kMagic);
  append(bytes, kLayout);
  append(bytes, crc32_of(writer.bytes()));
  return bytes + writer.bytes();
}

template <class AnyScene>
AnyScene read_as(SceneReader& reader) {
  AnyScene scene;
  reader(scene);
  if (!reader.is_at_end() || scene.light_places.size() != scene.lights.size()) reader.refuse();
  return scene;
}

}  // namespace

std::string binary_scene(const Scene2& scene) { return written(scene, 2); }
std::string binary_scene(const Scene3& scene) { return written(scene, 3); }

ValidScene parse_binary_scene(std::string_view bytes, const std::string& name) {
  if (!is_binary_scene(bytes)) throw InputError({name, 0}, "is no binary scene");
  if (bytes.size() <= kHead) throw InputError({name, 0}, "is a binary scene that breaks off");
  const std::uint32_t layout = number_at(bytes, kMagic.size());
  if (layout != kLayout)
    throw InputError({name, 0},
                     "is a binary scene of the layout " + std::to_string(layout) + ", and this hottel reads " +
                         std::to_string(kLayout),
                     {"`hottel convert` makes it anew from the scene that it was made of"});
  const std::string_view body = bytes.substr(kHead);
  if (crc32_of(body) != number_at(bytes, kMagic.size() + sizeof(std::uint32_t)))
    throw InputError({name, 0}, "is a binary scene that breaks off or is damaged: its bytes have another sum");
  SceneReader reader(body, name);
  std::uint32_t dimension = 0;
  reader(dimension);
  if (dimension == 2) return ValidScene2(read_as<Scene2>(reader));
  if (dimension == 3) return ValidScene3(read_as<Scene3>(reader));
  reader.refuse();
}

}  // namespace hottel
