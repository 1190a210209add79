#include <algorithm>
#include <unordered_map>

#include "geometry/name.h"
#include "geometry/near_names.h"
#include "io/files/text_file.h"
#include "io/scene/exact_json.h"
#include "io/scene/json_fields.h"
#include "io/scene/scene_json.h"

namespace hottel {
namespace {

// sigma in W/(m² K⁴).
const Rational& stefan_boltzmann() {
  static const Rational sigma = *parse_rational("5.670374419e-8");
  return sigma;
}

bool in_range(const Spectrum& spectrum, bool at_most_one) {
  return std::all_of(spectrum.value.begin(), spectrum.value.end(),
                     [&](const Rational& v) { return sgn(v) >= 0 && (!at_most_one || v <= 1); });
}

// A spectrum that is not negative, and not above one where that is asked.
Spectrum read_spectrum_in_range(const JsonValue& value, const Subject& subject, bool at_most_one) {
  Spectrum result = read_spectrum(value, subject);
  if (!in_range(result, at_most_one))
    refuse(value, subject.text() + (at_most_one ? " must be from 0 to 1" : " must not be negative"));
  return result;
}

// Reflectivity 1 - e and emission e sigma T⁴.
void set_grey_body(const Spectrum& emissivity, const Spectrum& temperature, Material& material) {
  material.reflectivity.is_scalar = emissivity.is_scalar;
  material.emission.is_scalar = emissivity.is_scalar && temperature.is_scalar;
  for (std::size_t c = 0; c < 3; ++c) {
    const Rational& t = temperature.value[c];
    material.reflectivity.value[c] = 1 - emissivity.value[c];
    material.emission.value[c] = emissivity.value[c] * stefan_boltzmann() * t * t * t * t;
  }
}

Material read_material(const JsonValue& key, const JsonValue& value) {
  const std::string owner = "material " + quoted_name(key.text());
  const auto [about, reflectivity, emission, emissivity, temperature] =
      read_members(value, {owner},
                   std::array<std::string_view, 5>{"about", "reflectivity", "emission", "emissivity", "temperature"});
  Material material;
  material.name = key.text();
  if (about) read_string(about, {owner, "about"});
  if ((reflectivity || emission) && (emissivity || temperature))
    refuse(value, owner + " has both reflectivity or emission and emissivity or temperature",
           {"give either reflectivity and emission, or emissivity and temperature"});
  if (temperature && !emissivity) refuse(value, owner + " has a temperature but no emissivity");
  if (reflectivity) material.reflectivity = read_spectrum_in_range(reflectivity, {owner, "reflectivity"}, true);
  if (emission) material.emission = read_spectrum_in_range(emission, {owner, "emission"}, false);
  if (emissivity) {
    const Spectrum e = read_spectrum_in_range(emissivity, {owner, "emissivity"}, true);
    const Spectrum t = temperature ? read_spectrum_in_range(temperature, {owner, "temperature"}, false) : Spectrum();
    set_grey_body(e, t, material);
  }
  return material;
}

class SceneReader {
 public:
  SceneReader(std::string_view text, const std::string& name) : document_(text, name) { scene_.file = name; }

  Scene2 read() {
    const JsonValue root = document_.root();
    require_kind(root, JsonKind::kObject, {"the scene"});
    read_versions(root);
    const auto [hottel, dimension, about, materials, edges, polylines, polygons, mesh, sky, closed, grid, camera,
                lights, expect] =
        read_members(root, {"the scene"},
                     std::array<std::string_view, 14>{"hottel", "dimension", "about", "materials", "edges", "polylines",
                                                      "polygons", "mesh", "sky", "closed", "grid", "camera", "lights",
                                                      "expect"});
    if (about) scene_.about = read_string(about, {"about"});
    if (materials) read_materials(materials);
    if (edges) read_list(edges, "edges", "edge", &SceneReader::read_edge);
    if (polylines) read_list(polylines, "polylines", "polyline", &SceneReader::read_polyline);
    refuse_space_only(polygons, mesh, camera);
    if (sky) read_sky(sky);
    if (closed) scene_.closed = read_boolean(closed, {"closed"});
    if (grid) read_grid(grid);
    if (lights) refuse_lights(lights);
    if (expect) read_list(expect, "expect", "expectation", &SceneReader::read_expectation);
    validate(scene_);
    refuse_duplicate_groups();
    return std::move(scene_);
  }

 private:
  // What edges and polylines have in common.
  struct Entry {
    JsonValue value;
    std::string name;
    std::string owner;  // for messages
    JsonValue points, closed;
    Surface2 surface;  // without name and points
  };

  void read_versions(const JsonValue& root) const {
    const auto require = [&](std::string_view key, std::initializer_list<const char*> allowed) {
      for (const auto [k, value] : root.members()) {
        if (k.text() != key) continue;
        require_kind(value, JsonKind::kNumber, {key});
        const Rational number = read_number(value, {key});
        for (const char* a : allowed)
          if (number == Rational(a)) return number;
        refuse(value,
               std::string(key) + " is " + quoted_name(value.text()) + "; this version reads " + *allowed.begin());
      }
      refuse(root, "the scene has no \"" + std::string(key) + "\"",
             {"a scene begins { \"hottel\": 1, \"dimension\": 2,"});
    };
    require("hottel", {"1"});
    if (require("dimension", {"2", "3"}) == 3)
      for (const auto [key, value] : root.members())
        if (key.text() == "dimension") refuse(value, "dimension 3 is not supported by this version");
  }

  void read_materials(const JsonValue& materials) {
    require_kind(materials, JsonKind::kObject, {"materials"});
    for (const auto [key, value] : materials.members()) {
      // A material may be called as it likes; it only has to print on one line.
      if (key.text().empty()) refuse(key, "the name of a material must not be empty");
      if (has_control_character(key.text()))
        refuse(key, "the name of material " + quoted_name(key.text()) + " must not contain a control character");
      material_index_.emplace(key.text(), static_cast<std::uint32_t>(scene_.materials.size()));
      scene_.materials.push_back(read_material(key, value));
    }
  }

  void read_list(const JsonValue& list, std::string_view key, const std::string& noun,
                 void (SceneReader::*read_item)(const JsonValue&, const std::string&)) {
    require_kind(list, JsonKind::kArray, {key});
    scene_.surfaces.reserve(scene_.surfaces.size() + list.size());
    scene_.groups.reserve(scene_.groups.size() + list.size());
    std::size_t k = 0;
    for (const JsonValue item : list.items()) (this->*read_item)(item, noun + "[" + std::to_string(k++) + "]");
  }

  template <std::size_t N>
  Entry read_entry(const JsonValue& value, const std::string& default_name, std::string_view noun,
                   const std::array<std::string_view, N>& keys) {
    Entry entry;
    entry.value = value;
    entry.name = default_name;
    require_kind(value, JsonKind::kObject, {default_name});
    for (const auto [key, member] : value.members())
      if (key.text() == "name") {
        entry.name = read_string(member, {default_name, "name"});
        if (const auto problem = name_problem(entry.name); !problem.empty())
          refuse(member, default_name + ": the name " + quoted_name(entry.name) + " " + std::string(problem));
      }
    entry.owner = std::string(noun) + " " + quoted_name(entry.name);

    // keys begin with these; "closed" follows for polylines.
    const auto members = read_members(value, {entry.owner}, keys);
    const JsonValue points = members[1], material = members[2], back = members[3], elements = members[4],
                    about = members[5], behind = members[6];
    if constexpr (N > 7) entry.closed = members[7];
    require_member(points, "points", value, {entry.owner});
    require_member(material, "material", value, {entry.owner});
    require_kind(points, JsonKind::kArray, {entry.owner, "points"});
    entry.points = points;
    entry.surface.material = material_of(material, {entry.owner, "material"});
    if (back) entry.surface.back = material_of(back, {entry.owner, "back"});
    if (elements) entry.surface.elements = read_count(elements, kMaxElements, {entry.owner, "elements"});
    if (about) read_string(about, {entry.owner, "about"});

    entry.surface.group = static_cast<std::uint32_t>(scene_.groups.size());
    scene_.groups.emplace_back(entry.name,
                               behind ? suppose_behind(behind, {entry.owner, "behind"}) : Behind::kByOutline);
    return entry;
  }

  static Behind suppose_behind(const JsonValue& value, const Subject& subject) {
    const std::string text = read_string(value, subject);
    if (text == "solid") return Behind::kSolid;
    if (text == "open") return Behind::kOpen;
    refuse(value, subject.text() + " is " + quoted_name(text) + "; it may be \"solid\" or \"open\"");
  }

  void read_edge(const JsonValue& value, const std::string& default_name) {
    Entry entry = read_entry(
        value, default_name, "edge",
        std::array<std::string_view, 7>{"name", "points", "material", "back", "elements", "about", "behind"});
    if (entry.points.size() < 2) refuse(entry.points, entry.owner + " has fewer than two points");
    if (entry.points.size() > 2)
      refuse(entry.points, entry.owner + " has " + std::to_string(entry.points.size()) + " points; an edge has two",
             {"a chain of edges is an entry of \"polylines\""});
    Surface2& surface = entry.surface;
    surface.name = std::move(entry.name);
    surface.line = value.line();
    Point2* point = &surface.from;
    for (const JsonValue item : entry.points.items()) {
      *point = read_point(item, {entry.owner, "point"});
      point = &surface.to;
    }
    if (surface.from == surface.to) refuse(value, entry.owner + " has length zero");
    scene_.surfaces.push_back(std::move(surface));
  }

  void read_polyline(const JsonValue& value, const std::string& default_name) {
    const Entry entry = read_entry(
        value, default_name, "polyline",
        std::array<std::string_view, 8>{"name", "points", "material", "back", "elements", "about", "behind", "closed"});
    polyline_line_.emplace_back(value.line());
    const bool closed = entry.closed && read_boolean(entry.closed, {entry.owner, "closed"});
    if (entry.points.size() < 2) refuse(entry.points, entry.owner + " has fewer than two points");
    Point2 first, previous;
    JsonValue at;
    std::size_t k = 0;
    const auto add = [&](const Point2& to, bool closes) {
      const std::string name = entry.name + "[" + std::to_string(k - 1) + "]";
      if (previous == to)
        refuse(at, entry.owner + ": its piece " + quoted_name(name) + " has length zero",
               {closes ? "\"closed\" joins the last point to the first: leave the repeated point out"
                       : "a point stands twice in a row"});
      Surface2 surface = entry.surface;
      surface.name = name;
      surface.from = previous;
      surface.to = to;
      surface.line = at.line();
      scene_.surfaces.push_back(std::move(surface));
    };
    for (const JsonValue item : entry.points.items()) {
      Point2 point = read_point(item, {entry.owner, "point"});
      if (k == 0)
        first = point;
      else
        add(point, false);
      previous = std::move(point);
      at = item;
      ++k;
    }
    if (closed) add(first, true);
  }

  // Edges differ from each other already; a polyline has to differ from edges and other polylines.
  void refuse_duplicate_groups() const {
    const std::size_t edges = scene_.groups.size() - polyline_line_.size();
    std::unordered_map<std::string_view, int> polylines;
    for (std::size_t i = 0; i < polyline_line_.size(); ++i)
      polylines.emplace(scene_.groups[edges + i].name, polyline_line_[i]);
    if (polylines.empty()) return;
    for (std::size_t i = 0; i < edges; ++i)
      if (const auto found = polylines.find(scene_.groups[i].name); found != polylines.end())
        throw InputError({scene_.file, found->second}, "polyline " + quoted_name(found->first) +
                                                           " has the name of an edge, the one in line " +
                                                           std::to_string(scene_.surfaces[i].line));
  }

  Point2 read_point(const JsonValue& value, const Subject& subject) const {
    require_kind(value, JsonKind::kArray, subject);
    if (value.size() != 2)
      refuse(value,
             subject.text() + " has " + std::to_string(value.size()) + " coordinates; in dimension 2 it has two");
    Point2 point;
    Rational* coordinate = &point.x;
    for (const JsonValue item : value.items()) {
      *coordinate = read_number(item, {subject.owner, "coordinate"});
      coordinate = &point.y;
    }
    return point;
  }

  std::uint32_t material_of(const JsonValue& value, const Subject& subject) const {
    require_kind(value, JsonKind::kString, subject);
    if (const auto found = material_index_.find(value.text()); found != material_index_.end()) return found->second;
    std::string defined = material_index_.empty() ? "the scene defines no materials" : "defined are:";
    constexpr std::size_t kMost = 10;
    for (std::size_t i = 0; i < scene_.materials.size() && i < kMost; ++i)
      defined += (i > 0 ? ", " : " ") + quoted_name(scene_.materials[i].name);
    if (scene_.materials.size() > kMost) defined += ", ...";
    std::vector<std::string> names;
    for (const Material& material : scene_.materials) names.push_back(material.name);
    std::vector<std::string> hints = near_name_hints(value.text(), names);
    hints.push_back(defined);
    refuse(value, subject.text() + " " + quoted_name(value.text()) + " is not defined", std::move(hints));
  }

  static void refuse_space_only(const JsonValue& polygons, const JsonValue& mesh, const JsonValue& camera) {
    if (polygons) {
      require_kind(polygons, JsonKind::kArray, {"polygons"});
      if (polygons.size() > 0) refuse(polygons, "polygons belong to dimension 3; this scene has dimension 2");
    }
    if (mesh) refuse(mesh, "mesh belongs to dimension 3; this scene has dimension 2");
    if (camera) refuse(camera, "camera belongs to dimension 3; this scene has dimension 2");
  }

  static void refuse_lights(const JsonValue& lights) {
    require_kind(lights, JsonKind::kArray, {"lights"});
    if (lights.size() > 0) refuse(lights, "lights are not simulated by this version");
  }

  void read_sky(const JsonValue& sky) {
    const auto [emission] = read_members(sky, {"sky"}, std::array<std::string_view, 1>{"emission"});
    if (emission) scene_.sky_emission = read_spectrum_in_range(emission, {"sky", "emission"}, false);
  }

  void read_grid(const JsonValue& grid) {
    const auto [min, max, cells] = read_members(grid, {"grid"}, std::array<std::string_view, 3>{"min", "max", "cells"});
    require_member(min, "min", grid, {"grid"});
    require_member(max, "max", grid, {"grid"});
    require_member(cells, "cells", grid, {"grid"});
    Grid2 result;
    result.min = read_point(min, {"grid", "min"});
    result.max = read_point(max, {"grid", "max"});
    if (result.max.x <= result.min.x || result.max.y <= result.min.y)
      refuse(max, "grid: max must be greater than min in both coordinates");
    require_kind(cells, JsonKind::kArray, {"grid", "cells"});
    if (cells.size() != 2) refuse(cells, "grid: cells must be two numbers, along x and along y");
    std::uint32_t* count = &result.nx;
    for (const JsonValue item : cells.items()) {
      *count = read_count(item, kMaxGridCells, {"grid", "cells"});
      count = &result.ny;
    }
    scene_.grid = std::move(result);
  }

  // The number as it is typed.
  static std::string number_text(const JsonValue& value, const Subject& subject) {
    read_number(value, subject);
    return std::string(value.text());
  }

  void read_expectation(const JsonValue& value, const std::string& owner) {
    const auto [name, kind, quantity, of, at, expected, form, derivation] = read_members(
        value, {owner},
        std::array<std::string_view, 8>{"name", "kind", "quantity", "of", "at", "value", "form", "derivation"});
    require_member(kind, "kind", value, {owner});
    require_member(quantity, "quantity", value, {owner});
    require_member(expected, "value", value, {owner});
    Expectation result;
    result.line = value.line();
    result.kind = read_string(kind, {owner, "kind"});
    result.quantity = read_string(quantity, {owner, "quantity"});
    if (of) {
      require_kind(of, JsonKind::kArray, {owner, "of"});
      for (const JsonValue item : of.items()) result.of.push_back(read_string(item, {owner, "of"}));
    }
    if (name) result.name = read_string(name, {owner, "name"});
    if (at) result.at = number_text(at, {owner, "at"});
    result.value = number_text(expected, {owner, "value"});
    if (form) result.form = read_string(form, {owner, "form"});
    if (derivation) result.derivation = read_string(derivation, {owner, "derivation"});
    scene_.expect.push_back(std::move(result));
  }

  JsonDocument document_;
  Scene2 scene_;
  std::unordered_map<std::string_view, std::uint32_t> material_index_;
  std::vector<int> polyline_line_;
};

}  // namespace

Scene2 read_scene_2(const std::filesystem::path& file) { return parse_scene_2(read_text_file(file), file.string()); }

Scene2 parse_scene_2(std::string_view text, const std::string& name_for_messages) {
  return SceneReader(text, name_for_messages).read();
}

}  // namespace hottel
