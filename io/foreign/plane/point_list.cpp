#include "io/foreign/plane/point_list.h"

#include <algorithm>
#include <cctype>

#include "geometry/name.h"
#include "io/foreign/csv_reader.h"
#include "io/scene/json_fields.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBlanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

std::string upper_case(std::string_view word) {
  std::string result(word);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

Rational number_of(std::string_view text, const FileLine& where) {
  if (const auto value = parse_rational(text)) return *value;
  throw InputError(where, "a coordinate is not a number: " + quoted_name(text),
                   {"numbers are written like 12, -0.1, 2.5e-3 or 4/3, with an exponent of at most " +
                    std::to_string(kMaxNumberExponent)});
}

// ---- csv

std::vector<Point2> points_of_csv(std::string_view text, const std::string& name) {
  std::vector<Point2> points;
  CsvReader reader(name, text);
  for (bool is_first = true; reader.next(); is_first = false) {
    const auto& fields = reader.fields();
    if (fields.size() == 1 && trimmed(fields[0]).empty()) continue;
    if (fields.size() != 2)
      throw InputError(reader.where(), "a point has two coordinates x,y, not " + std::to_string(fields.size()));
    const std::string_view x = trimmed(fields[0]), y = trimmed(fields[1]);
    if (is_first && upper_case(x) == "X" && upper_case(y) == "Y") continue;
    points.push_back({number_of(x, reader.where()), number_of(y, reader.where())});
  }
  return points;
}

// ---- GeoJSON

class GeoJsonPoints {
 public:
  explicit GeoJsonPoints(std::vector<Point2>& points) : points_(points) {}

  // Nothing is nested deeper than kMaxJsonDepth.
  void read(const JsonValue& object) {
    require_kind(object, JsonKind::kObject, {"a GeoJSON object"});
    const JsonValue type_value = member(object, "type");
    const std::string type = read_string(type_value, {"\"type\""});
    if (type == "Point") {
      add(member(object, "coordinates"));
    } else if (type == "MultiPoint") {
      for_each(member(object, "coordinates"), "\"coordinates\"", [this](const JsonValue& item) { add(item); });
    } else if (type == "GeometryCollection") {
      for_each(member(object, "geometries"), "\"geometries\"", [this](const JsonValue& item) { read(item); });
    } else if (type == "Feature") {
      const JsonValue geometry = member(object, "geometry");
      if (geometry.kind() == JsonKind::kNull) refuse(geometry, "a feature has no place: its geometry is null");
      read(geometry);
    } else if (type == "FeatureCollection") {
      for_each(member(object, "features"), "\"features\"", [this](const JsonValue& item) { read(item); });
    } else {
      refuse(type_value, quoted_name(type) + " is no list of points",
             {"understood: Point, MultiPoint, GeometryCollection, Feature, FeatureCollection"});
    }
  }

 private:
  static JsonValue member(const JsonValue& object, std::string_view key) {
    for (const auto& [name, value] : object.members())
      if (name.text() == key) return value;
    refuse(object, "a GeoJSON object has no \"" + std::string(key) + "\"");
  }
  template <class Read>
  static void for_each(const JsonValue& list, std::string_view what, const Read& read_item) {
    require_kind(list, JsonKind::kArray, {what});
    for (const JsonValue item : list.items()) read_item(item);
  }
  void add(const JsonValue& position) {
    require_kind(position, JsonKind::kArray, {"a position"});
    if (position.size() != 2)
      refuse(position, "a position in the plane has two coordinates, not " + std::to_string(position.size()));
    const auto items = position.items();
    auto item = items.begin();
    Point2 point;
    point.x = read_number(*item, {"a coordinate"});
    ++item;
    point.y = read_number(*item, {"a coordinate"});
    points_.push_back(std::move(point));
  }

  std::vector<Point2>& points_;
};

// ---- well-known text

class WellKnownText {
 public:
  WellKnownText(std::string_view text, const std::string& name, std::vector<Point2>& points)
      : text_(text), name_(name), points_(points) {}

  void read_all() {
    while (skip_blanks()) read_geometry(0);
  }

 private:
  bool skip_blanks() {
    for (; at_ < text_.size() && kBlanks.find(text_[at_]) != std::string_view::npos; ++at_)
      if (text_[at_] == '\n') ++line_;
    return at_ < text_.size();
  }
  FileLine here() const { return {name_, line_}; }
  [[noreturn]] void refuse_here(const std::string& expected) const {
    const std::string found =
        at_ < text_.size() ? quoted_name(text_.substr(at_, text_.find_first_of(" \t\r\n", at_ + 1) - at_)) : "the end";
    throw InputError(here(), expected + " is expected, not " + found);
  }
  // The word that stands here, in capitals; empty where there is none.
  std::string word() {
    skip_blanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    return upper_case(text_.substr(begin, at_ - begin));
  }
  bool takes(char c) {
    if (!skip_blanks() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!takes(c)) refuse_here(std::string("'") + c + "'");
  }
  Rational number() {
    if (!skip_blanks()) refuse_here("a coordinate");
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n,()", at_), text_.size());
    if (end == at_) refuse_here("a coordinate");
    const std::string_view token = text_.substr(at_, end - at_);
    at_ = end;
    return number_of(token, here());
  }
  void read_position() {
    Point2 point;
    point.x = number();
    point.y = number();
    if (skip_blanks() && text_[at_] != ')' && text_[at_] != ',')
      throw InputError(here(), "a position in the plane has two coordinates");
    points_.push_back(std::move(point));
  }
  template <class Read>
  void read_list(const Read& read_item) {
    do read_item();
    while (takes(','));
    expect(')');
  }
  // True where a list begins, false for EMPTY.
  bool begins() {
    skip_blanks();
    if (at_ < text_.size() && is_letter(text_[at_])) {
      const FileLine where = here();
      const std::string found = word();
      if (found == "EMPTY") return false;
      if (found == "Z" || found == "M" || found == "ZM")
        throw InputError(where, "a position in the plane has two coordinates: " + found + " is not understood");
      throw InputError(where, "'(' or EMPTY is expected, not " + quoted_name(found));
    }
    expect('(');
    return true;
  }
  void read_geometry(int depth) {
    skip_blanks();
    const FileLine where = here();
    const std::string type = word();
    if (type.empty()) refuse_here("POINT, MULTIPOINT or GEOMETRYCOLLECTION");
    if (type != "POINT" && type != "MULTIPOINT" && type != "GEOMETRYCOLLECTION")
      throw InputError(where, quoted_name(type) + " is no list of points",
                       {"understood: POINT, MULTIPOINT, GEOMETRYCOLLECTION; or a csv of lines x,y"});
    if (depth == kMaxJsonDepth) throw InputError(where, "collections are nested too deep");
    if (!begins()) return;
    if (type == "POINT") {
      read_position();
      expect(')');
    } else if (type == "MULTIPOINT") {
      read_list([this] {
        const bool is_wrapped = takes('(');
        read_position();
        if (is_wrapped) expect(')');
      });
    } else {
      read_list([this, depth] { read_geometry(depth + 1); });
    }
  }

  std::string_view text_;
  const std::string& name_;
  std::vector<Point2>& points_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace

std::vector<Point2> read_points_2(std::string_view text, const std::string& name) {
  std::string_view content = text;
  if (content.starts_with(kByteOrderMark)) content.remove_prefix(kByteOrderMark.size());
  const std::string_view start = trimmed(content);
  const bool is_word = !start.empty() && is_letter(start.front());
  const bool is_header = is_word && (start.front() == 'x' || start.front() == 'X');
  std::vector<Point2> points;
  if (start.starts_with('{')) {
    const JsonDocument document(content, name);
    GeoJsonPoints(points).read(document.root());
  } else if (is_word && !is_header) {
    WellKnownText(content, name, points).read_all();
  } else {
    points = points_of_csv(content, name);
  }
  if (points.empty()) throw InputError({name, 0}, "there is no point in it");
  return points;
}

}  // namespace hottel
