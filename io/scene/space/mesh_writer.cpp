#include "io/scene/space/mesh_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

#include "geometry/name.h"
#include "geometry/planarity.h"
#include "geometry/scene_names.h"
#include "geometry/space/scene/near_plane.h"
#include "geometry/space/scene/patches.h"
#include "io/scene/exact_decimal.h"
#include "io/scene/space/kept_solids.h"
#include "io/scene/space/mesh_adder.h"
#include "io/scene/space/mesh_objects.h"
#include "io/scene/space/mesh_pieces.h"
#include "io/scene/space/patched_faces.h"
#include "kernel/decimal.h"
#include "kernel/exact_double.h"
#include "kernel/support/failure.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

struct PointOrder {
  bool operator()(const Point3& a, const Point3& b) const {
    if (const int c = cmp(a.x, b.x)) return c < 0;
    if (const int c = cmp(a.y, b.y)) return c < 0;
    return a.z < b.z;
  }
};

// A number as a file holds it.
struct Held {
  std::string text;
  Rational value;
};

Held decimal_or_double(const Rational& value) {
  if (auto text = exact_decimal_text(value)) return {*std::move(text), value};
  const double rounded = written_double(value);
  if (!std::isfinite(rounded)) require_double(rounded, "a number, about " + decimal_text(value) + ",");
  return {shortest(rounded), exact_value(rounded)};
}

// The float nearest to a value, ties to even.
float nearest_float(const Rational& value) {
  constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
  const auto guess = static_cast<float>(to_double(value));  // or a neighbour is: it is rounded twice
  std::optional<float> best;
  for (const float candidate : {guess, std::nextafter(guess, -kFloatInfinity), std::nextafter(guess, kFloatInfinity)}) {
    if (!std::isfinite(candidate)) continue;
    if (best) {
      const int order = cmp(Rational(abs(exact_value(candidate) - value)), Rational(abs(exact_value(*best) - value)));
      if (order > 0 || (order == 0 && (std::bit_cast<std::uint32_t>(candidate) & 1) != 0)) continue;
    }
    best = candidate;
  }
  if (!best || abs(value) > exact_value(std::numeric_limits<float>::max()))
    throw RequestError("the coordinate " + short_text(value) + " is beyond the largest float, which STL has");
  if (*best == 0 && value != 0)
    throw RequestError("the coordinate " + short_text(value) + " is below the least float, which STL has");
  return *best;
}

// A face of the file: a polygon of the scene, or a part of one.
struct WrittenFace {
  std::uint32_t surface = 0;
  std::vector<std::uint32_t> corners;  // indices of points
};

class MeshWriter3 {
 public:
  MeshWriter3(const Scene3& scene, MeshFormat3 format) : scene_(scene), format_(format) {}

  WrittenMesh3 write(const std::string& library) {
    if (scene_.polygons.empty()) throw RequestError("the scene has no polygons: there is nothing to write as a mesh");
    for (const Surface& surface : scene_.surfaces)
      if (surface.is_obstruction)
        throw RequestError(quoted_name(surface.name) +
                           " is an obstruction, which a mesh file cannot hold: give it a material, or take it out");
    if (!scene_.masks.empty())
      throw RequestError(quoted_name(scene_.surfaces[scene_.masks.front().surface].name) +
                         " is a mask, which a mesh file cannot hold: take it out");
    collect_faces();
    hold_points();
    switch (format_) {
      case MeshFormat3::kObj:
        write_obj(library);
        break;
      case MeshFormat3::kPly:
        write_ply();
        break;
      case MeshFormat3::kOff:
        write_off();
        break;
      case MeshFormat3::kStl:
        write_stl();
        break;
    }
    note_cuts();
    note_rounding();
    note_materials();
    note_names();
    note_more();
    note_solids(library);
    return std::move(result_);
  }

 private:
  // Whether the file has a point as it is.
  bool holds(const Point3& point) const {
    for (const Rational* value : {&point.x, &point.y, &point.z}) {
      if (format_ != MeshFormat3::kStl && !exact_decimal_text(*value)) return false;
      if (format_ == MeshFormat3::kStl && exact_value(nearest_float(*value)) != *value) return false;
    }
    return true;
  }

  void collect_faces() {
    const PatchCarriers3 carriers(scene_);
    const PatchedFaces3 patched(carriers, [this](const Point3& point) { return holds(point); });
    std::vector<std::vector<Polygon3>> left;
    for (std::uint32_t s = 0; s < scene_.polygons.size(); ++s) left.push_back(patched.of({s, false}));  // fronts alone
    const Rational unit = unit_of(left);
    for (std::uint32_t s = 0; s < scene_.polygons.size(); ++s) {
      const std::string& name = scene_.surfaces[s].name;
      const bool has_patches = !carriers.on({s, false}).empty();
      if (left[s].empty()) covered_.push_back(name);
      bool is_cut = !has_patches && left[s].size() > 1;
      if (has_patches && left[s] != std::vector{scene_.polygons[s]}) bases_.push_back(name);
      for (const Polygon3& polygon : left[s]) is_cut |= !add_polygon(s, polygon, unit);
      cut_ += is_cut ? 1 : 0;
    }
  }

  // What the last digit of the coordinates will stand for; asked only where something is nearly plane.
  Rational unit_of(const std::vector<std::vector<Polygon3>>& faces) const {
    if (format_ == MeshFormat3::kStl ||
        std::ranges::none_of(scene_.polygons, [](const Polygon3& polygon) { return polygon.is_nearly_plane; }))
      return 0;
    FinestDigit finest;
    for (const std::vector<Polygon3>& polygons : faces)
      for (const Polygon3& polygon : polygons)
        for (const Point3& p : corners_of(polygon))
          for (const Rational* value : {&p.x, &p.y, &p.z}) finest.take(decimal_or_double(*value).text);
    return finest.unit();
  }

  // Whether it is whole in the file.
  bool add_polygon(std::uint32_t s, const Polygon3& polygon, const Rational& unit) {
    bool is_held = format_ != MeshFormat3::kStl || polygon.points.size() == 3;
    // What is nearly plane by fewer digits than the file has is none there.
    if (Polygon3 again{polygon.points}; is_held && polygon.is_nearly_plane && !accept_nearly_plane(again, unit))
      is_held = false;
    if (is_held && polygon.facets.empty() && polygon.holes.empty()) {
      add_face(s, polygon);
      return true;
    }
    for (const Polygon3& triangle : mesh_triangles(polygon)) add_face(s, triangle);
    return false;
  }

  void add_face(std::uint32_t surface, const Polygon3& polygon) {
    WrittenFace face{surface, {}};
    for (const Point3& point : polygon.points) {
      const auto [entry, is_new] = index_.emplace(point, static_cast<std::uint32_t>(points_.size()));
      if (is_new) {
        points_.push_back(&entry->first);
        first_face_.push_back(surface);
      }
      face.corners.push_back(entry->second);
    }
    faces_.push_back(std::move(face));
  }

  // Numbers of the points as the file has them.
  void hold_points() {
    for (std::size_t k = 0; k < points_.size(); ++k) {
      std::array<Held, 3> held;
      const std::array<const Rational*, 3> exact{&points_[k]->x, &points_[k]->y, &points_[k]->z};
      bool is_exact = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (format_ == MeshFormat3::kStl) {
          floats_.push_back(nearest_float(*exact[axis]));
          held[axis].value = exact_value(floats_.back());
        } else {
          held[axis] = decimal_or_double(*exact[axis]);
        }
        if (held[axis].value == *exact[axis]) continue;
        is_exact = false;
        ++rounded_;
        if (Rational off = abs(held[axis].value - *exact[axis]); off > worst_) {
          worst_ = std::move(off);
          worst_at_ = fmt::format("{} = {} of a corner of {}", "xyz"[axis], short_text(*exact[axis]),
                                  quoted_name(scene_.surfaces[first_face_[k]].name));
        }
      }
      text_.push_back(held[0].text + " " + held[1].text + " " + held[2].text);
      if (!is_exact) moved_[static_cast<std::uint32_t>(k)] = {held[0].value, held[1].value, held[2].value};
    }
  }

  std::string corners(const WrittenFace& face, std::uint32_t first) const {
    std::string text;
    for (const std::uint32_t corner : face.corners) text += " " + std::to_string(corner + first);
    return text;
  }

  void write_off() {
    std::string& out = result_.bytes;
    out = fmt::format("OFF\n{} {} 0\n", points_.size(), faces_.size());
    for (const std::string& text : text_) out += text + "\n";
    for (const WrittenFace& face : faces_) out += fmt::format("{}{}\n", face.corners.size(), corners(face, 0));
  }

  void write_ply() {
    std::size_t most = 0;
    for (const WrittenFace& face : faces_) most = std::max(most, face.corners.size());
    std::string& out = result_.bytes;
    out = fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
        "element face {}\nproperty list {} int vertex_indices\nend_header\n",
        points_.size(), faces_.size(), most < 256 ? "uchar" : "int");
    for (const std::string& text : text_) out += text + "\n";
    for (const WrittenFace& face : faces_) out += fmt::format("{}{}\n", face.corners.size(), corners(face, 0));
  }

  template <class T>
  void put(T value) {
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    result_.bytes.append(bytes.data(), bytes.size());
  }

  void write_stl() {
    if (faces_.size() > std::numeric_limits<std::uint32_t>::max())
      throw RequestError(fmt::format("an STL file cannot have {} triangles", faces_.size()));
    result_.bytes.assign(80, '\0');
    result_.bytes.replace(0, 14, "mesh by hottel");  // it must not be "solid"
    put(static_cast<std::uint32_t>(faces_.size()));
    for (const WrittenFace& face : faces_) {
      for (const float part : unit_normal(face)) put(part);
      for (const std::uint32_t corner : face.corners)
        for (std::size_t axis = 0; axis < 3; ++axis) put(floats_[3 * corner + axis]);
      put(std::uint16_t{0});
    }
  }

  // As doubles compute it.
  std::array<float, 3> unit_normal(const WrittenFace& face) const {
    const Point3 &a = *points_[face.corners[0]], &b = *points_[face.corners[1]], &c = *points_[face.corners[2]];
    const Vector3 normal = cross(b - a, c - a);
    const Rational most = std::max({Rational(abs(normal.x)), Rational(abs(normal.y)), Rational(abs(normal.z))});
    const double x = to_double(normal.x / most), y = to_double(normal.y / most), z = to_double(normal.z / most);
    const double length = std::sqrt(x * x + y * y + z * z);
    return {static_cast<float>(x / length), static_cast<float>(y / length), static_cast<float>(z / length)};
  }

  // A mesh by itself has the same material without a file of materials.
  static bool is_invented(const Material& material) {
    return material.surface_reflectivity() == Spectrum::scalar(kMeshReflectivity) && material.emission.is_zero();
  }

  // Names that OBJ and MTL files cannot hold as they are: these words are parted by blanks, and have comments.
  static void require_holds(const std::string& name, const std::string& what) {
    const bool has_comment = name.starts_with('#') || name.find(" #") != std::string::npos;
    if (name.empty() || name.front() == ' ' || name.back() == ' ' || name.find("  ") != std::string::npos ||
        name.back() == '\\' || has_comment || name.find(".mtl ") != std::string::npos)
      throw RequestError("an OBJ file cannot hold the name " + quoted_name(name) + " of " + what +
                         ": it has a comment, or blanks that would be lost");
  }

  void write_obj(const std::string& library) {
    std::vector<std::uint32_t> used;
    for (const Surface& surface : scene_.surfaces)
      if (std::find(used.begin(), used.end(), surface.material) == used.end()) used.push_back(surface.material);
    const bool has_library =
        !std::all_of(used.begin(), used.end(), [&](std::uint32_t m) { return is_invented(scene_.materials[m]); });
    std::string& out = result_.bytes;
    if (has_library) {
      require_holds(library, "its file of materials");
      write_library(used);
      out += "mtllib " + library + "\n";
    }
    for (const std::string& text : text_) out += "v " + text + "\n";
    const std::vector<std::string> objects = mesh_objects(scene_);
    std::optional<std::uint32_t> group, material;
    for (const WrittenFace& face : faces_) {
      const Surface& surface = scene_.surfaces[face.surface];
      if (group != surface.group) {
        if (!objects.empty() && (!group || objects[*group] != objects[surface.group])) {
          require_holds(objects[surface.group], "an object");
          out += "o " + objects[surface.group] + "\n";
        }
        group = surface.group;
        require_holds(scene_.groups[*group].name, "a group");
        out += "g " + scene_.groups[*group].name + "\n";
      }
      if (material != surface.material) {
        const std::string& name = scene_.materials[surface.material].name;
        require_holds(name, "a material");
        if (material || has_library || name != kMeshMaterial) out += "usemtl " + name + "\n";
        material = surface.material;
      }
      out += "f" + corners(face, 1) + "\n";
    }
  }

  static Spectrum thermal(const Material& material, const Spectrum& spectrum) {
    return material.has_bands ? Spectrum::scalar(material.thermal(spectrum)) : spectrum;
  }

  void write_library(const std::vector<std::uint32_t>& used) {
    std::vector<std::string> rounded, of_flux;
    const auto statement = [&](const Material& material, const char* key, const Spectrum& spectrum) {
      std::string text = key;
      bool is_exact = true;
      for (const Rational& value : spectrum.value) {
        const Held held = decimal_or_double(value);
        text += " " + held.text;
        is_exact &= held.value == value;
      }
      if (!is_exact && (rounded.empty() || rounded.back() != material.name)) rounded.push_back(material.name);
      return text + "\n";
    };
    for (const std::uint32_t m : used) {
      const Material& material = scene_.materials[m];
      result_.library += (result_.library.empty() ? "" : "\n") + ("newmtl " + material.name + "\n") +
                         statement(material, "Kd", thermal(material, material.surface_reflectivity()));
      const Spectrum emission = thermal(material, material.emission);
      if (material.has_given_flux() && !emission.is_zero())
        of_flux.push_back(material.name);
      else if (!emission.is_zero())
        result_.library += statement(material, "Ke", emission);
    }
    if (scene_.has_bands) result_.notes.push_back("of the two bands the thermal one is written, not the solar one");
    if (!of_flux.empty())
      result_.notes.push_back("the net fluxes of these materials are not written, only how they reflect: " +
                              listed_names(of_flux));
    if (!rounded.empty())
      result_.notes.push_back("materials that are no decimals are rounded to doubles: " + listed_names(rounded));
  }

  void note_cuts() {
    if (!bases_.empty())
      result_.notes.push_back("these have holes where patches lie on them, and are cut into convex faces: " +
                              listed_names(bases_));
    if (!covered_.empty())
      result_.notes.push_back("patches cover these wholly, which have no face: " + listed_names(covered_));
    if (cut_ > 0)
      result_.notes.push_back(fmt::format("{} of {} polygons are cut into triangles: {} faces", cut_,
                                          scene_.polygons.size(), faces_.size()));
  }

  void note_rounding() {
    if (rounded_ == 0) return;
    const bool are_floats = format_ == MeshFormat3::kStl;
    result_.notes.push_back(
        fmt::format("{} of {} coordinates are no {} and are rounded to {}; the worst is off by {}: {}", rounded_,
                    3 * points_.size(), are_floats ? "floats" : "decimals", are_floats ? "floats" : "doubles",
                    shortest(to_double(worst_)), worst_at_));
    std::vector<std::string> broken;
    std::string why;
    for (const WrittenFace& face : faces_) {
      Polygon3 polygon;
      bool is_moved = false;
      for (const std::uint32_t corner : face.corners) {
        const auto moved = moved_.find(corner);
        is_moved |= moved != moved_.end();
        polygon.points.push_back(moved == moved_.end() ? *points_[corner] : moved->second);
      }
      if (!is_moved) continue;
      accept_nearly_plane(polygon, 0);
      const std::string problem = polygon_problem(polygon).text;
      if (problem.empty()) continue;
      if (broken.empty()) why = problem;
      if (const std::string& name = scene_.surfaces[face.surface].name; broken.empty() || broken.back() != name)
        broken.push_back(name);
    }
    if (!broken.empty())
      result_.notes.push_back(
          fmt::format("rounded, these are no polygons any more: {}; the first {}", listed_names(broken), why));
  }

  void note_materials() {
    std::vector<std::string> lost, with_back;
    std::vector<char> is_used(scene_.materials.size(), false);
    for (const Surface& surface : scene_.surfaces) {
      is_used[surface.material] = true;
      if (surface.back) with_back.push_back(surface.name);
    }
    for (std::size_t m = 0; m < scene_.materials.size(); ++m) {
      const Material& material = scene_.materials[m];
      const bool is_default = is_invented(material) && material.name == kMeshMaterial;
      if (format_ == MeshFormat3::kObj ? !is_used[m] : !is_default) lost.push_back(material.name);
    }
    if (!lost.empty()) result_.notes.push_back("materials that are not in the file: " + listed_names(lost));
    if (!with_back.empty()) result_.notes.push_back("backs that are not in the file: of " + listed_names(with_back));
  }

  // Whoever reads the mesh calls the faces NAME[k], of a group in OBJ, of the file in others.
  void note_names() {
    std::vector<std::string> lost;
    std::vector<std::size_t> count(scene_.groups.size());
    const bool has_groups = format_ == MeshFormat3::kObj;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const Surface& surface = scene_.surfaces[faces_[f].surface];
      const std::string expected = piece_name(scene_.groups[surface.group].name, count[surface.group]++);
      const bool is_other_group = !has_groups && surface.group != scene_.surfaces[0].group;
      if ((surface.name != expected || is_other_group) && (lost.empty() || lost.back() != surface.name))
        lost.push_back(surface.name);
    }
    if (!lost.empty())
      result_.notes.push_back(fmt::format("names that are not in the file, its faces are {}[k]: {}",
                                          has_groups ? "GROUP" : "NAME", listed_names(lost)));
  }

  void note_more() {
    std::string lost;
    const auto add = [&](bool is_lost, const char* what) {
      if (is_lost) lost += (lost.empty() ? "" : ", ") + std::string(what);
    };
    add(!scene_.sky_emission.is_zero(), "the sky");
    add(scene_.closed, "the promise \"closed\"");
    add(std::any_of(scene_.surfaces.begin(), scene_.surfaces.end(), [](const Surface& s) { return s.elements != 1; }),
        "elements");
    add(format_ != MeshFormat3::kObj &&
            std::ranges::any_of(scene_.groups, [](const Group& g) { return !g.body.empty(); }),
        "what is one body");
    add(!scene_.grids.empty(), "the grid");
    add(scene_.camera.has_value(), "the camera");
    add(!scene_.expect.empty(), "expectations");
    add(!scene_.about.empty(), "the text about the scene");
    add(!scene_.unit.empty(), "the unit of length");
    if (!lost.empty()) result_.notes.push_back("not kept in the file: " + lost);
  }

  // Only patches and lost groups change what is solid.
  void note_solids(const std::string& library) {
    const bool has_groups = format_ == MeshFormat3::kObj;
    if (std::ranges::none_of(scene_.surfaces, [&](const Surface& s) {
          return s.on || (!has_groups && s.group != scene_.surfaces[0].group);
        }))
      return;
    const auto read = [&] {
      return scene_of(parse_mesh_3(format_, result_.bytes, library, [&](const auto&) { return result_.library; }))
          .scene;
    };
    std::ranges::move(notes_on_solids(scene_, read, [](const std::string& name) { return name; }),
                      std::back_inserter(result_.notes));
  }

  const Scene3& scene_;
  MeshFormat3 format_;
  WrittenMesh3 result_;

  std::map<Point3, std::uint32_t, PointOrder> index_;
  std::vector<const Point3*> points_;      // keys of index_, each once, in the order of the faces
  std::vector<std::uint32_t> first_face_;  // of each point: a surface that has it
  std::vector<WrittenFace> faces_;
  std::size_t cut_ = 0;                       // polygons, not counting what patches cut
  std::vector<std::string> bases_, covered_;  // of patches; wholly covered by them

  std::vector<std::string> text_;          // of each point
  std::vector<float> floats_;              // STL: three of each point
  std::map<std::uint32_t, Point3> moved_;  // where the file has points that it does not hold exactly
  std::size_t rounded_ = 0;                // coordinates
  Rational worst_;                         // how far one is off
  std::string worst_at_;
};

}  // namespace

WrittenMesh3 write_mesh_3(const Scene3& scene, MeshFormat3 format, const std::string& library) {
  return MeshWriter3(scene, format).write(library);
}

}  // namespace hottel
