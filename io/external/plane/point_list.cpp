#include "io/external/plane/point_list.h"

#include <algorithm>
#include <cctype>

#include "geometry/name.h"
#include "io/external/csv_reader.h"
#include "io/scene/json_fields.h"
#include "io/scene/plane/map_position.h"
#include "io/scene/plane/well_known_text.h"
#include "kernel/support/failure.h"
#include "kernel/support/lower_case.h"
#include "kernel/support/trimmed.h"

namespace hottel {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBlanks = " \t\r\n";

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

// ---- csv

bool is_head(const std::vector<std::string_view>& fields) {
  const std::string_view first = trimmed(fields[0], kBlanks);
  return !first.empty() && is_letter(first.front());
}

// Of a head that names other columns than x,y.
[[noreturn]] void refuse_head(const CsvReader& reader) {
  std::string line;
  for (const std::string_view field : reader.fields()) line += (line.empty() ? "" : ",") + std::string(field);
  throw InputError(reader.where(), quoted_name(line) + " is no first line that is known",
                   {"a csv of points has lines x,y, in space x,y,z, with or without these words as the first line",
                    "points with normals have the first line x,y,nx,ny, in space x,y,z,nx,ny,nz; there are no other "
                    "columns"});
}

[[noreturn]] void refuse_count(const CsvReader& reader, bool is_first) {
  const auto& fields = reader.fields();
  const std::string_view only = trimmed(fields[0], kBlanks);
  if (fields.size() == 1 && only.find_first_of(" \t;") != std::string_view::npos)
    throw InputError(reader.where(), quoted_name(only) + " is no point: commas stand between its numbers");
  const std::string in_space = is_first ? ", in space three x,y,z" : "";
  throw InputError(reader.where(),
                   "a point has two coordinates x,y" + in_space + ", not " + std::to_string(fields.size()),
                   {"points with normals, which may be in space, have the first line x,y,nx,ny or x,y,z,nx,ny,nz"});
}

std::vector<Point2> points_of_csv(std::string_view text, const std::string& name) {
  std::vector<Point2> points;
  CsvReader reader(name, text);
  for (bool is_first = true; reader.next(); is_first = false) {
    const auto& fields = reader.fields();
    if (fields.size() == 1 && trimmed(fields[0], kBlanks).empty()) continue;
    const bool is_pair = fields.size() == 2;
    const std::string_view x = trimmed(fields[0], kBlanks), y = is_pair ? trimmed(fields[1], kBlanks) : "";
    if (is_first && lower_case(x) == "x" && lower_case(y) == "y") continue;
    if (is_first && is_head(fields)) refuse_head(reader);
    if (!is_pair) refuse_count(reader, is_first);
    points.push_back({coordinate_of_2(x, reader.where()), coordinate_of_2(y, reader.where())});
  }
  return points;
}

// ---- GeoJSON

class GeoJsonPoints {
 public:
  GeoJsonPoints(std::vector<Point2>& points, PassedOver& passed_over) : points_(points), passed_over_(passed_over) {}

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
  void add(const JsonValue& position) { points_.push_back(read_position_2(position, passed_over_)); }

  std::vector<Point2>& points_;
  PassedOver& passed_over_;
};

// ---- well-known text

class WellKnownPoints {
 public:
  WellKnownPoints(WellKnownText2& text, std::vector<Point2>& points) : text_(text), points_(points) {}

  void read_all() {
    while (text_.skip_blanks()) read_geometry(0);
  }

 private:
  void read_geometry(int depth) {
    text_.skip_blanks();
    const FileLine where = text_.here();
    const std::string type = text_.geometry();
    if (type.empty()) text_.refuse_here("POINT, MULTIPOINT or GEOMETRYCOLLECTION");
    if (type != "POINT" && type != "MULTIPOINT" && type != "GEOMETRYCOLLECTION")
      throw InputError(where, quoted_name(type) + " is no list of points",
                       {"understood: POINT, MULTIPOINT, GEOMETRYCOLLECTION; or a csv of lines x,y"});
    if (depth == kMaxJsonDepth) throw InputError(where, "collections are nested too deep");
    if (!text_.begins()) return;
    if (type == "POINT") {
      points_.push_back(text_.position());
      text_.expect(')');
    } else if (type == "MULTIPOINT") {
      text_.read_list([this] { points_.push_back(text_.wrapped_position()); });
    } else {
      text_.read_list([this, depth] { read_geometry(depth + 1); });
    }
  }

  WellKnownText2& text_;
  std::vector<Point2>& points_;
};

}  // namespace

std::vector<Point2> read_points_2(std::string_view text, const std::string& name, PassedOver* passed_over) {
  PassedOver untold;
  PassedOver& told = passed_over != nullptr ? *passed_over : untold;
  std::string_view content = text;
  if (content.starts_with(kByteOrderMark)) content.remove_prefix(kByteOrderMark.size());
  const std::string_view start = trimmed(content, kBlanks);
  const std::string_view line = start.substr(0, start.find_first_of("\r\n"));
  const bool is_word = !start.empty() && is_letter(start.front());
  const bool is_header = line.find(',') < line.find('(');
  std::vector<Point2> points;
  if (start.starts_with('{')) {
    const JsonDocument document(content, name);
    GeoJsonPoints(points, told).read(document.root());
  } else if (is_word && !is_header) {
    WellKnownText2 well_known(content, name, told);
    WellKnownPoints(well_known, points).read_all();
  } else {
    points = points_of_csv(content, name);
  }
  if (points.empty()) throw InputError({name, 0}, "there is no point in it");
  return points;
}

}  // namespace hottel
