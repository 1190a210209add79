#include "io/scene/plane/map_reader.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "geometry/name.h"
#include "geometry/plane/scene/scene_entries.h"
#include "io/files/text_file.h"
#include "io/scene/json_fields.h"
#include "io/scene/plane/well_known_text.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// What a feature says of its geometry.
struct Feature {
  std::string name;
  int name_line = 0;
  std::string material = kMapMaterial, back;
  std::uint32_t elements = 1;
  MapSide2 side = MapSide2::kInside;
};

using Ring = std::vector<PolylinePoint2>;

// Twice the area, positive counter-clockwise.
Rational doubled_area(const Ring& ring) {
  Rational sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point2 &a = ring[k].at, &b = ring[(k + 1) % ring.size()].at;
    sum += a.x * b.y - b.x * a.y;
  }
  return sum;
}

// Collects polylines.
class Map {
 public:
  explicit Map(const std::string& file) { scene_.file = file; }

  void add_line(Ring line, const Feature& feature, const FileLine& where) {
    if (line.size() < 2) throw InputError(where, "a line has fewer than two points");
    const bool closed = line.size() > 3 && line.front().at == line.back().at;
    if (closed) line.pop_back();
    add(std::move(line), closed, feature);
  }

  // A ring of a polygon; its first one is the outline.
  void add_ring(Ring ring, bool is_hole, const Feature& feature, const FileLine& where) {
    if (ring.size() < 2 || !(ring.front().at == ring.back().at))
      throw InputError(where, "a ring of a polygon is not closed: its last point must be its first");
    ring.pop_back();
    if (ring.size() < 3) throw InputError(where, "a ring of a polygon has fewer than three corners");
    const Rational area = doubled_area(ring);
    if (area == 0) throw InputError(where, "a ring of a polygon has no area");
    // The front is on the right: clockwise looks inward.
    const bool looks_inward = is_hole == (feature.side == MapSide2::kOutside);
    if ((area < 0) != looks_inward) std::reverse(ring.begin() + 1, ring.end());
    add(std::move(ring), true, feature);
  }

  Scene2 scene() {
    validate(scene_);
    return std::move(scene_);
  }

 private:
  void add(Ring points, bool closed, const Feature& feature) {
    Surface like;
    like.material = material(feature.material);
    if (!feature.back.empty()) like.back = material(feature.back);
    like.elements = feature.elements;
    like.group = static_cast<std::uint32_t>(scene_.groups.size());
    const std::string name = free_name(feature);
    scene_.groups.push_back(name);
    add_polyline(scene_, like, name, std::move(points), closed);
  }

  std::string free_name(const Feature& feature) {
    if (feature.name.empty()) return "polyline[" + std::to_string(scene_.groups.size()) + "]";
    if (const auto problem = name_problem(feature.name); !problem.empty())
      throw InputError({scene_.file, feature.name_line},
                       "the name " + quoted_name(feature.name) + " " + std::string(problem));
    std::string name = feature.name;
    for (std::size_t& k = count_[feature.name]; !names_.insert(name).second;)
      name = feature.name + "~" + std::to_string(std::max<std::size_t>(++k, 2));
    return name;
  }

  std::uint32_t material(const std::string& name) {
    const auto [found, is_new] = material_.emplace(name, static_cast<std::uint32_t>(scene_.materials.size()));
    if (is_new) scene_.materials.push_back({name, Spectrum::scalar(kMapReflectivity), {}});
    return found->second;
  }

  Scene2 scene_;
  std::unordered_map<std::string, std::uint32_t> material_;
  std::unordered_map<std::string, std::size_t> count_;
  std::unordered_set<std::string> names_;
};

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
      if (geometry.kind() == JsonKind::kNull) refuse(geometry, "a feature has no shape: its geometry is null");
      read(geometry, feature_of(object, feature));
    } else if (type == "FeatureCollection") {
      for_each(required(object, "features"), [&](const JsonValue& item) { read(item, feature); });
    } else {
      refuse(type_value, quoted_name(type) + " has no walls",
             {"understood: Polygon, MultiPolygon, LineString, MultiLineString, GeometryCollection, Feature, "
              "FeatureCollection",
              "points to look from go with: hottel visibility MAP --points FILE"});
    }
  }

 private:
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
      if (key.text() == "name" && value.kind() == JsonKind::kString && !value.text().empty()) take_name(value);
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

  static PolylinePoint2 position(const JsonValue& value) {
    require_kind(value, JsonKind::kArray, {"a position"});
    if (value.size() != 2)
      refuse(value, "a position in the plane has two coordinates, not " + std::to_string(value.size()));
    const auto items = value.items();
    auto item = items.begin();
    PolylinePoint2 point;
    point.line = value.line();
    point.at.x = read_number(*item, {"a coordinate"});
    ++item;
    point.at.y = read_number(*item, {"a coordinate"});
    return point;
  }
  static Ring positions(const JsonValue& list) {
    Ring ring;
    for_each(list, [&](const JsonValue& item) { ring.push_back(position(item)); });
    return ring;
  }
  static FileLine where(const JsonValue& value) { return {value.file(), value.line()}; }

  void read_polygon(const JsonValue& rings, const Feature& feature) {
    bool is_hole = false;
    for_each(rings, [&](const JsonValue& ring) {
      map_.add_ring(positions(ring), is_hole, feature, where(ring));
      is_hole = true;
    });
  }
  void read_line(const JsonValue& line, const Feature& feature) {
    map_.add_line(positions(line), feature, where(line));
  }

  Map& map_;
};

// ---- well-known text

class WellKnownMap {
 public:
  WellKnownMap(WellKnownText2& text, Map& map, const Feature& feature) : text_(text), map_(map), feature_(feature) {}

  void read_all() {
    while (text_.skip_blanks()) read_geometry(0);
  }

 private:
  void read_geometry(int depth) {
    text_.skip_blanks();
    const FileLine where = text_.here();
    const std::string type = text_.word();
    if (type.empty()) text_.refuse_here("POLYGON, LINESTRING or another geometry");
    const bool is_known = type == "POLYGON" || type == "MULTIPOLYGON" || type == "LINESTRING" ||
                          type == "MULTILINESTRING" || type == "GEOMETRYCOLLECTION";
    if (!is_known)
      throw InputError(where, quoted_name(type) + " has no walls",
                       {"understood: POLYGON, MULTIPOLYGON, LINESTRING, MULTILINESTRING, GEOMETRYCOLLECTION"});
    if (depth == kMaxJsonDepth) throw InputError(where, "collections are nested too deep");
    if (!text_.begins()) return;
    if (type == "POLYGON")
      read_rings();
    else if (type == "LINESTRING")
      map_.add_line(positions(), feature_, where);
    else if (type == "GEOMETRYCOLLECTION")
      text_.read_list([this, depth] { read_geometry(depth + 1); });
    else
      text_.read_list([&] {
        text_.skip_blanks();
        const FileLine part = text_.here();
        if (!text_.begins()) return;
        if (type == "MULTIPOLYGON")
          read_rings();
        else
          map_.add_line(positions(), feature_, part);
      });
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
    bool is_hole = false;
    text_.read_list([&] {
      text_.skip_blanks();
      const FileLine where = text_.here();
      text_.expect('(');
      map_.add_ring(positions(), is_hole, feature_, where);
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

Scene2 parse_map_2(std::string_view text, const std::string& name_for_messages, MapSide2 side) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  Map map(name_for_messages);
  Feature feature;
  feature.side = side;
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) throw InputError({name_for_messages, 0}, "the file is empty");
  if (text[start] == '{') {
    const JsonDocument document(text, name_for_messages);
    GeoJsonMap(map).read(document.root(), feature);
  } else {
    WellKnownText2 well_known(text, name_for_messages);
    WellKnownMap(well_known, map, feature).read_all();
  }
  Scene2 scene = map.scene();
  if (scene.surfaces.empty()) throw InputError({name_for_messages, 0}, "there is no line and no polygon in it");
  return scene;
}

Scene2 read_map_2(const std::filesystem::path& file, MapSide2 side) {
  return parse_map_2(read_text_file(file), file.string(), side);
}

}  // namespace hottel
