#include "io/scene/plane/map_reader.h"

#include <optional>
#include <utility>
#include <vector>

#include "geometry/name.h"
#include "io/files/text_file.h"
#include "io/scene/json_fields.h"
#include "io/scene/plane/map_polylines.h"
#include "io/scene/plane/map_position.h"
#include "io/scene/plane/well_known_text.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr const char* kNoOutline = "a polygon has a hole, and its outline is empty";

using Feature = MapFeature2;
using Map = MapPolylines2;
using Ring = std::vector<PolylinePoint2>;

// ---- GeoJSON

class GeoJsonMap {
 public:
  explicit GeoJsonMap(Map& map) : map_(map) {}

  // Nothing is nested deeper than kMaxJsonDepth.
  void read(const JsonValue& object, const Feature& feature) {
    require_kind(object, JsonKind::kObject, {"a GeoJSON object"});
    const JsonValue type_value = required(object, "type");
    const std::string type = read_string(type_value, {"\"type\""});
    if (type == "Polygon") {
      read_polygon(required(object, "coordinates"), feature);
    } else if (type == "MultiPolygon") {
      for_each(required(object, "coordinates"), [&](const JsonValue& item) { read_polygon(item, feature); });
    } else if (type == "LineString") {
      read_line(required(object, "coordinates"), feature);
    } else if (type == "MultiLineString") {
      for_each(required(object, "coordinates"), [&](const JsonValue& item) { read_line(item, feature); });
    } else if (type == "GeometryCollection") {
      for_each(required(object, "geometries"), [&](const JsonValue& item) { read(item, feature); });
    } else if (type == "Feature") {
      const JsonValue geometry = required(object, "geometry");
      if (geometry.kind() == JsonKind::kNull) return pass_over_empty(geometry);
      read(geometry, feature_of(object, feature));
    } else if (type == "FeatureCollection") {
      for_each(required(object, "features"), [&](const JsonValue& item) { read(item, feature); });
    } else if (type == "Point") {
      pass_over_points(type_value, 1);
    } else if (type == "MultiPoint") {
      pass_over_points(type_value, required(object, "coordinates").size());
    } else {
      throw no_walls(type_value);
    }
  }

 private:
  static InputError no_walls(const JsonValue& type) {
    return {where(type),
            quoted_name(type.text()) + " has no walls",
            {"understood: Polygon, MultiPolygon, LineString, MultiLineString, GeometryCollection, Feature, "
             "FeatureCollection",
             "points to look from go with `hottel visibility MAP --points FILE`"}};
  }
  void pass_over_points(const JsonValue& type, std::size_t count) {
    map_.pass_over(PassedKind::kPoint, no_walls(type), count);
  }
  void pass_over_empty(const JsonValue& value) { map_.pass_over(PassedKind::kEmptyGeometry, where(value)); }

  static JsonValue member(const JsonValue& object, std::string_view key) {
    for (const auto& [name, value] : object.members())
      if (name.text() == key) return value;
    return {};
  }
  static JsonValue required(const JsonValue& object, std::string_view key) {
    const JsonValue value = member(object, key);
    if (!value) refuse(object, "a GeoJSON object has no \"" + std::string(key) + "\"");
    return value;
  }
  template <class Read>
  static void for_each(const JsonValue& list, const Read& read_item) {
    require_kind(list, JsonKind::kArray, {"a list of GeoJSON"});
    for (const JsonValue item : list.items()) read_item(item);
  }

  static Feature feature_of(const JsonValue& object, const Feature& outer) {
    Feature feature = outer;
    const auto take_name = [&](const JsonValue& value) {
      feature.name = std::string(value.text());
      feature.name_line = value.line();
    };
    if (const JsonValue id = member(object, "id"); id && id.kind() != JsonKind::kNull) take_name(id);
    const JsonValue properties = member(object, "properties");
    if (!properties || properties.kind() == JsonKind::kNull) return feature;
    require_kind(properties, JsonKind::kObject, {"\"properties\""});
    for (const auto& [key, value] : properties.members()) {
      if (value.kind() == JsonKind::kNull) continue;
      const auto word = [&, k = key, v = value] { return read_string(v, {"property", k.text()}); };
      const bool may_name = value.kind() == JsonKind::kString || value.kind() == JsonKind::kNumber;
      if (key.text() == "name" && may_name && !value.text().empty()) take_name(value);
      if (key.text() == "material" || key.text() == "back") {
        const std::string name = word();
        if (const auto problem = material_name_problem(name); !problem.empty()) refuse(value, problem);
        (key.text() == "back" ? feature.back : feature.material) = name;
      }
      if (key.text() == "elements") feature.elements = read_count(value, kMaxElements, {"property", "elements"});
      if (key.text() == "front") {
        const std::string side = word();
        if (side != "inside" && side != "outside")
          refuse(value, "property: front is " + quoted_name(side) + "; it may be \"inside\" or \"outside\"");
        feature.side = side == "outside" ? MapSide2::kOutside : MapSide2::kInside;
      }
    }
    return feature;
  }

  PolylinePoint2 position(const JsonValue& value) { return {read_position_2(value, map_.passed_over()), value.line()}; }
  Ring positions(const JsonValue& list) {
    Ring ring;
    for_each(list, [&](const JsonValue& item) { ring.push_back(position(item)); });
    return ring;
  }
  static FileLine where(const JsonValue& value) { return {value.file(), value.line()}; }

  void read_polygon(const JsonValue& rings, const Feature& feature) {
    bool is_hole = false, is_empty = false;
    require_kind(rings, JsonKind::kArray, {"a list of GeoJSON"});
    if (rings.size() == 0) return pass_over_empty(rings);
    for_each(rings, [&](const JsonValue& ring) {
      require_kind(ring, JsonKind::kArray, {"a list of GeoJSON"});
      if (ring.size() == 0) {
        pass_over_empty(ring);
        is_empty |= !is_hole;
      } else if (is_empty) {
        refuse(ring, kNoOutline);
      } else {
        map_.add_ring(positions(ring), is_hole, feature, where(ring));
      }
      is_hole = true;
    });
  }
  void read_line(const JsonValue& line, const Feature& feature) {
    require_kind(line, JsonKind::kArray, {"a list of GeoJSON"});
    if (line.size() == 0) return pass_over_empty(line);
    map_.add_line(positions(line), feature, where(line));
  }

  Map& map_;
};

// ---- well-known text

constexpr const char* kUnderstood =
    "understood: POLYGON, MULTIPOLYGON, TRIANGLE, LINESTRING, MULTILINESTRING, LINEARRING, GEOMETRYCOLLECTION";

class WellKnownMap {
 public:
  WellKnownMap(WellKnownText2& text, Map& map, const Feature& feature) : text_(text), map_(map), feature_(feature) {}

  void read_all() {
    while (text_.skip_blanks())
      if (!text_.takes(';')) read_geometry(0);
  }

 private:
  // What a geometry is made of.
  enum class Parts : unsigned char { kRings, kLine, kClosedLine, kPolygons, kLines, kGeometries };

  static std::optional<Parts> parts_of(std::string_view type) {
    if (type == "POLYGON" || type == "TRIANGLE") return Parts::kRings;
    if (type == "LINESTRING") return Parts::kLine;
    if (type == "LINEARRING") return Parts::kClosedLine;
    if (type == "MULTIPOLYGON") return Parts::kPolygons;
    if (type == "MULTILINESTRING") return Parts::kLines;
    if (type == "GEOMETRYCOLLECTION") return Parts::kGeometries;
    return std::nullopt;
  }

  // SRID=4326; which says where on the earth the coordinates are: they are taken as they stand.
  void pass_over_srid() {
    text_.expect('=');
    text_.number();
    text_.expect(';');
  }

  void read_geometry(int depth) {
    text_.skip_blanks();
    const FileLine where = text_.here();
    const std::string type = text_.geometry();
    if (type.empty()) text_.refuse_here("POLYGON, LINESTRING or another geometry");
    if (type == "SRID" && depth == 0) return pass_over_srid();
    if (type == "POINT" || type == "MULTIPOINT") return pass_over_points(type, where);
    const auto parts = parts_of(type);
    if (!parts) throw InputError(where, quoted_name(type) + " is not understood", {kUnderstood});
    if (depth == kMaxJsonDepth) throw InputError(where, "collections are nested too deep");
    if (begins()) read_parts(*parts, where, depth);
  }

  void pass_over_points(const std::string& type, const FileLine& where) {
    if (!begins()) return;
    std::size_t count = 0;
    text_.read_list([&] {
      text_.wrapped_position();
      ++count;
    });
    map_.pass_over(PassedKind::kPoint, {where, quoted_name(type) + " has no walls", {kUnderstood}}, count);
  }

  void read_parts(Parts parts, const FileLine& where, int depth) {
    switch (parts) {
      case Parts::kRings:
        return read_rings();
      case Parts::kLine:
        return map_.add_line(positions(), feature_, where);
      case Parts::kClosedLine:
        return map_.add_closed_line(positions(), feature_, where);
      case Parts::kGeometries:
        return text_.read_list([this, depth] { read_geometry(depth + 1); });
      case Parts::kPolygons:
      case Parts::kLines:
        text_.read_list([&] {
          text_.skip_blanks();
          const FileLine part = text_.here();
          if (begins()) read_parts(parts == Parts::kPolygons ? Parts::kRings : Parts::kLine, part, depth);
        });
    }
  }

  bool begins() {
    const FileLine where = text_.here();
    const bool is_there = text_.begins();
    if (!is_there) map_.pass_over(PassedKind::kEmptyGeometry, where);
    return is_there;
  }

  Ring positions() {
    Ring ring;
    text_.read_list([&] {
      text_.skip_blanks();
      const int line = text_.here().line;
      ring.push_back({text_.position(), line});
    });
    return ring;
  }

  void read_rings() {
    bool is_hole = false, is_empty = false;
    text_.read_list([&] {
      text_.skip_blanks();
      const FileLine where = text_.here();
      if (!begins()) {
        is_empty |= !is_hole;
      } else if (is_empty) {
        throw InputError(where, kNoOutline);
      } else {
        map_.add_ring(positions(), is_hole, feature_, where);
      }
      is_hole = true;
    });
  }

  WellKnownText2& text_;
  Map& map_;
  const Feature& feature_;
};

}  // namespace

bool is_map_2(const std::filesystem::path& file) {
  return file.extension() == ".geojson" || file.extension() == ".wkt";
}

ValidScene2 parse_map_2(std::string_view text, const std::string& name_for_messages, MapSide2 side,
                        PassedOver* passed_over) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  PassedOver untold;
  Map map(name_for_messages, passed_over != nullptr ? *passed_over : untold);
  Feature feature;
  feature.side = side;
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) throw InputError({name_for_messages, 0}, "the file is empty");
  if (text[start] == '{') {
    const JsonDocument document(text, name_for_messages);
    GeoJsonMap(map).read(document.root(), feature);
  } else {
    WellKnownText2 well_known(text, name_for_messages, map.passed_over());
    WellKnownMap(well_known, map, feature).read_all();
  }
  return map.scene();
}

ValidScene2 read_map_2(const std::filesystem::path& file, MapSide2 side, PassedOver* passed_over) {
  return parse_map_2(read_text_file(file), file.string(), side, passed_over);
}

}  // namespace hottel
