#include "io/scene/space/vs3_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "geometry/name.h"
#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/scene/patches.h"
#include "geometry/space/scene/plane_frame.h"
#include "io/scene/exact_decimal.h"
#include "io/scene/space/kept_solids.h"
#include "io/scene/space/mesh_pieces.h"
#include "io/scene/space/patched_faces.h"
#include "io/scene/space/vs3_reader.h"
#include "kernel/support/failure.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

// A line of a deck may have 255 characters: View3D reads no more.
constexpr std::size_t kMostOfNumber = 48, kMostOfTitle = 200;

// Polygons of three or four corners, none of them straight, that together are the polygon.
std::vector<Polygon3> pieces_of(const Polygon3& polygon) {
  if (!is_convex(polygon)) return mesh_triangles(polygon);
  std::vector<Point3> corners;
  const std::size_t n = polygon.points.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Point3 &before = polygon.points[(k + n - 1) % n], &here = polygon.points[k];
    if (!cross(here - before, polygon.points[(k + 1) % n] - here).is_zero()) corners.push_back(here);
  }
  if (corners.size() <= 4) return {Polygon3{corners}};
  std::vector<Polygon3> pieces;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) pieces.push_back({{corners[0], corners[k], corners[k + 1]}});
  return pieces;
}

bool have_the_same_corners(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&](const Point3& point) {
           return std::find(b.begin(), b.end(), point) != b.end();
         });
}

// Whether a record can say it: a triangle or a convex quadrilateral, its holes aside. What is nearly plane is cut.
bool is_one_record(const Polygon3& polygon) {
  if (polygon.is_nearly_plane) return false;
  const Polygon3 outline{polygon.points};
  return is_convex(outline) && polygon.points.size() <= 4 && pieces_of(outline)[0] == outline;
}

// The later surface that fills each hole of a polygon of the scene and can be a subsurface of it; empty where one of
// them is not filled so.
std::vector<std::size_t> fillers_of(const Scene3& scene, std::size_t s) {
  const Polygon3& polygon = scene.polygons[s];
  if (!is_one_record(polygon)) return {};
  std::vector<std::size_t> fillers;
  for (const std::vector<Point3>& hole : polygon.holes) {
    const auto fills = [&](std::size_t t) {
      const Polygon3& other = scene.polygons[t];
      return have_the_same_corners(hole, other.points) && is_one_record(other) &&
             (scene.surfaces[t].is_obstruction ? other.holes.empty()
                                               : dot(doubled_area(polygon), doubled_area(Polygon3{other.points})) > 0);
    };
    std::size_t t = s + 1;
    while (t < scene.polygons.size() && !fills(t)) ++t;
    if (t == scene.polygons.size()) return {};
    fillers.push_back(t);
  }
  return fillers;
}

// The surfaces with a face that has a material and not all of its polygon: what others have or what looks into solids.
std::vector<std::string> surfaces_that_lose(const Scene3& scene) {
  const Arrangement3 arrangement(scene);
  if (arrangement.is_plain()) return {};
  const PatchCarriers3 carriers(scene);
  const auto loses = [&](std::uint32_t s, bool is_back) {
    const Vector3 normal = doubled_area(scene.polygons[s]);
    Rational rest;
    for (const Polygon3& piece : beside_patches(carriers, {s, is_back})) rest += dot(normal, doubled_area(piece));
    if (!is_back)
      for (const Mask3& mask : scene.masks)
        if (mask.surface == s || mask.base == s) rest -= abs(dot(normal, doubled_area(scene.polygons[mask.surface])));
    for (const PieceSide3& side : arrangement.sides({s, is_back})) {
      const Piece3& piece = arrangement.pieces()[side.piece];
      if (piece.side(side.is_back).cover != Piece3::Cover::kFree) return true;
      rest -= abs(dot(normal, doubled_area(piece.polygon)));
    }
    return rest != 0;
  };
  std::vector<std::string> names;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    for (const bool is_back : {false, true})
      if (scene.surfaces[s].material_of(is_back) && loses(s, is_back) &&
          (names.empty() || names.back() != scene.surfaces[s].name))
        names.push_back(scene.surfaces[s].name);
  return names;
}

// Fit for a word of a deck.
std::string word_of(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ' ' || c == ',' || c == '!'; }, '_');
  if (name.starts_with('*')) name.front() = '_';
  return name;
}

std::string title_of(const std::string& about) {
  std::string title = about.substr(0, about.find_first_of("\r\n"));
  std::replace(title.begin(), title.end(), '\t', ' ');
  if (title.size() <= kMostOfTitle) return title;
  std::size_t end = kMostOfTitle;
  while (end > 0 && (static_cast<unsigned char>(title[end]) & 0xC0) == 0x80) --end;
  return title.substr(0, end);
}

// Whether patches can be subsurfaces of what they lie on.
class Subsurfaces3 {
 public:
  explicit Subsurfaces3(const PatchCarriers3& carriers) : carriers_(carriers) {}

  // The faces of patches that a face is the base of: all that take something of it, where each is a later single record
  // within it, with subsurfaces of its own or none, and no two share an area; nothing where one of them is not so.
  std::optional<std::vector<Face>> of(const Face& face) const {
    std::vector<Face> found;
    const Scene3& scene = carriers_.scene();
    const std::vector<std::uint32_t> patches = carriers_.on(face);
    if (patches.empty()) return found;
    const Polygon3& base = scene.polygons[face.surface];
    if (!is_one_record(base) || !base.holes.empty()) return std::nullopt;
    const PlaneFrame3 frame(base.points);
    std::vector<std::vector<FlatPoint3>> outlines;
    for (const std::uint32_t t : patches) {
      const Face patch{t, carriers_.bases().is_on_backs(t) != face.is_back};
      const Polygon3& polygon = scene.polygons[t];
      if (polygon.is_nearly_plane) return std::nullopt;
      if (PlaneFrame3(polygon.points).key() != frame.key()) continue;
      std::vector<FlatPoint3> outline = frame.outline(polygon.points);
      const auto shares = [&](const std::vector<FlatPoint3>& other) { return !common_part(outline, other).empty(); };
      if (is_convex(polygon) && !shares(frame.outline(base.points))) continue;
      const auto is_within = [&](const Point3& p) { return contains(base, p); };
      if (t < face.surface || !is_one_record(polygon) || !polygon.holes.empty() ||
          !std::ranges::all_of(polygon.points, is_within) || std::ranges::any_of(outlines, shares) || !of(patch))
        return std::nullopt;
      outlines.push_back(std::move(outline));
      found.push_back(patch);
    }
    return found;
  }

  // Whether a surface is written as it is, and all patches on it as subsurfaces: not where one lies on a back that is
  // not written.
  bool says(std::uint32_t s) const {
    const Scene3& scene = carriers_.scene();
    if (!is_one_record(scene.polygons[s]) || scene.surfaces[s].is_obstruction || !of({s, false})) return false;
    if (scene.surfaces[s].back) return of({s, true}).has_value();
    for (std::uint32_t t = 0; t < scene.surfaces.size(); ++t)
      if (carriers_.bases().lies_on(t, s) && (carriers_.bases().is_on_backs(t) || scene.surfaces[t].back)) return false;
    return true;
  }

 private:
  const PatchCarriers3& carriers_;
};

bool is_held(const Rational& value) {
  const auto text = exact_decimal_text(value);
  return text && text->size() <= kMostOfNumber;
}

class DeckWriter3 {
 public:
  DeckWriter3(const Scene3& scene, bool combines_groups)
      : scene_(scene),
        carriers_(scene),
        subsurfaces_(carriers_),
        patched_(
            carriers_, [](const Point3& p) { return is_held(p.x) && is_held(p.y) && is_held(p.z); },
            [this](std::uint32_t s) { return subsurfaces_.says(s); }),
        combines_groups_(combines_groups),
        leaders_(2 * scene.groups.size()),
        base_of_(2 * scene.surfaces.size()),
        record_of_(scene.surfaces.size()) {}

  WrittenVs3Deck3 write() {
    for (std::size_t s = 0; s < scene_.surfaces.size(); ++s) {
      if (scene_.surfaces[s].is_obstruction) {
        if (base_of_[2 * s] != 0) add_null(s);
        continue;
      }
      if (!add_mask(s)) add_face(s, false);
      if (scene_.surfaces[s].back) add_face(s, true);
    }
    for (std::size_t s = 0; s < scene_.surfaces.size(); ++s)
      if (scene_.surfaces[s].is_obstruction && base_of_[2 * s] == 0) add_obstruction(s);
    WrittenVs3Deck3 deck;
    if (const std::string title = title_of(scene_.about); !title.empty()) deck.text = "T " + title + "\n";
    deck.text += fmt::format("C encl={}\nF 3\n!  #   x y z\n", scene_.closed ? 1 : 0);
    deck.text += vertices_ + "!  #   v1 v2 v3 v4   base cmb   emit   name\n" + records_ + "End\n";
    add_notes(deck.notes);
    std::ranges::move(notes_on_solids(
                          scene_, [&] { return parse_vs3_3(deck.text, "deck.vs3").scene; }, word_of),
                      std::back_inserter(deck.notes));
    return deck;
  }

 private:
  void add_face(std::size_t s, bool is_back) {
    const Surface& surface = scene_.surfaces[s];
    const Face face{static_cast<std::uint32_t>(s), is_back};
    const bool is_left = patched_.leaves(face.surface);
    const std::vector<Face> subsurfaces = is_left ? *subsurfaces_.of(face) : std::vector<Face>();
    const std::vector<Polygon3> left = is_left ? std::vector{scene_.polygons[s]} : patched_.of(face);
    if (left.empty()) return covered_.push_back(surface.name);
    for (const Face& patch : subsurfaces) base_of_[patch.number()] = count_ + 1;
    const bool leads = combines_groups_ && !leaders_[2 * surface.group + is_back];
    const std::string& own = leads ? scene_.groups[surface.group].name : surface.name;
    const std::string name = word_of(own);
    changed_names_ += name != own;
    const std::string emittance = emittance_of(s, is_back);
    const std::vector<std::size_t> fillers =
        is_back || patched_.cuts(face.surface) ? std::vector<std::size_t>() : fillers_of(scene_, s);
    for (const std::size_t t : fillers) {
      base_of_[2 * t] = count_ + 1;
      if (scene_.surfaces[t].is_obstruction) normal_of_base_[t] = doubled_area(scene_.polygons[s]);
    }
    std::vector<Polygon3> pieces;
    if (fillers.empty())
      for (const Polygon3& polygon : left) std::ranges::move(pieces_of(polygon), std::back_inserter(pieces));
    else
      pieces.push_back({scene_.polygons[s].points});
    if (pieces.size() > 1) cut_.push_back(surface.name);
    if (!is_back && pieces.size() == 1) record_of_[s] = count_ + 1;
    const std::size_t base = base_of_[face.number()];
    std::size_t leader = combines_groups_ ? leaders_[2 * surface.group + is_back].value_or(0) : 0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      records_ += fmt::format("S {} {}   {} {}   {}   {}{}{}\n", ++count_, vertices_of(pieces[k], is_back), base,
                              leader, emittance, name, is_back ? "-back" : "", k == 0 ? "" : fmt::format(".{}", k + 1));
      if (leader == 0) leader = count_;
    }
    leaders_[2 * surface.group + is_back] = leader;
    backs_ += is_back;
  }

  // Writes the front of a surface that is a mask; false where it is none.
  bool add_mask(std::size_t s) {
    const auto mask =
        std::find_if(scene_.masks.begin(), scene_.masks.end(), [s](const Mask3& other) { return other.surface == s; });
    if (mask == scene_.masks.end()) return false;
    const std::string own = quoted_name(scene_.surfaces[s].name), base = quoted_name(scene_.surfaces[mask->base].name);
    if (record_of_[mask->base] == 0)
      throw RequestError(own + " masks " + base + ", which is no single record before it: a deck cannot say that");
    if (!is_one_record(scene_.polygons[s]) || !scene_.polygons[s].holes.empty())
      throw RequestError(own + " masks " + base +
                         ", and is no triangle or convex quadrilateral: a deck has such masks");
    const std::string name = word_of(scene_.surfaces[s].name);
    changed_names_ += name != scene_.surfaces[s].name;
    ++count_;
    records_ += fmt::format("M {} {}   {} 0   {}   {}\n", count_, vertices_of(scene_.polygons[s], false),
                            record_of_[mask->base], emittance_of(s, false), name);
    return true;
  }

  // Its vertices run so that it faces its base.
  void add_null(std::size_t s) {
    const Polygon3& polygon = scene_.polygons[s];
    const std::string name = word_of(scene_.surfaces[s].name);
    changed_names_ += name != scene_.surfaces[s].name;
    const bool faces_it = dot(doubled_area(polygon), normal_of_base_.at(s)) < 0;
    records_ +=
        fmt::format("N {} {}   {} 0   0.5   {}\n", count_ + 1, vertices_of(polygon, !faces_it), base_of_[2 * s], name);
    ++count_;
  }

  void add_obstruction(std::size_t s) {
    const std::vector<Polygon3> pieces = pieces_of(scene_.polygons[s]);
    if (pieces.size() > 1) cut_.push_back(scene_.surfaces[s].name);
    for (const Polygon3& piece : pieces) records_ += fmt::format("O {} {}\n", ++count_, vertices_of(piece, false));
  }

  // The numbers of its corners, and 0 for the fourth of a triangle.
  std::string vertices_of(const Polygon3& piece, bool is_back) {
    std::vector<Point3> points = piece.points;
    if (is_back) std::reverse(points.begin() + 1, points.end());
    std::string text;
    for (const Point3& point : points) text += fmt::format(" {}", vertex(point));
    return points.size() == 3 ? text + " 0" : text;
  }

  std::size_t vertex(const Point3& point) {
    const std::string text = fmt::format("{} {} {}", coordinate(point.x), coordinate(point.y), coordinate(point.z));
    const auto [entry, is_new] = numbers_.emplace(text, numbers_.size() + 1);
    if (is_new) vertices_ += fmt::format("V {} {}\n", entry->second, text);
    return entry->second;
  }

  std::string coordinate(const Rational& value) {
    if (auto text = exact_decimal_text(value); text && text->size() <= kMostOfNumber) return *std::move(text);
    rounded_.insert(value);
    const double written = written_double(value);
    require_double(written, "a coordinate", ", in which View3D computes");
    return shortest(written);
  }

  std::string emittance_of(std::size_t s, bool is_back) {
    const Material& material = scene_.materials[*scene_.surfaces[s].material_of(is_back)];
    const Spectrum reflectivity = material.surface_reflectivity();
    const auto& value = reflectivity.value;
    has_colours_ |= !material.has_bands && (value[1] != value[0] || value[2] != value[0]);
    emits_ |= !material.emission.is_zero();
    const Rational emittance = material.surface_emissivity();
    is_clamped_ |= emittance < Rational(1, 1000) || emittance > Rational(999, 1000);
    if (auto text = exact_decimal_text(emittance); text && text->size() <= kMostOfNumber) return *std::move(text);
    has_rounded_emittance_ = true;
    return shortest(to_double(emittance));
  }

  void add_notes(std::vector<std::string>& notes) const {
    const auto note_if = [&](bool condition, std::string text) {
      if (condition) notes.push_back(std::move(text));
    };
    const auto& surfaces = scene_.surfaces;
    note_if(!cut_.empty(), listed_names(cut_) +
                               ": cut into pieces of three or four corners, which cmb combines again (not those of "
                               "obstructions)");
    note_if(!covered_.empty(), "patches cover these faces wholly, which have no record: " + listed_names(covered_));
    const std::vector<std::string> losers = surfaces_that_lose(scene_);
    note_if(!losers.empty(), listed_names(losers) +
                                 ": whole in the deck, though parts are covered or belong to others; View3D does not "
                                 "settle that");
    note_if(!rounded_.empty(),
            fmt::format("{} coordinates are no short decimals: rounded to the nearest doubles", rounded_.size()));
    note_if(has_rounded_emittance_, "emittances that are no short decimals are rounded to the nearest doubles");
    note_if(has_colours_, "materials that are not gray have the mean of their channels");
    note_if(is_clamped_, "View3D takes 0.001 for emittances below it, and 0.999 for those above");
    note_if(backs_ > 0, backs_ == 1 ? std::string("1 back with a material is a surface NAME-back")
                                    : fmt::format("{} backs with a material are surfaces NAME-back", backs_));
    note_if(
        std::any_of(surfaces.begin(), surfaces.end(), [](const Surface& s) { return !s.back && !s.is_obstruction; }),
        "black backs are not in the deck: View3D's surfaces have one side");
    note_if(emits_ || !scene_.sky_emission.is_zero(), "a deck does not say what surfaces and the sky emit");
    note_if(std::any_of(surfaces.begin(), surfaces.end(), [](const Surface& s) { return s.elements > 1; }),
            "surfaces are whole in the deck, not divided into elements");
    const std::vector<std::size_t> sizes = group_sizes(scene_);
    note_if(!combines_groups_ && std::any_of(sizes.begin(), sizes.end(), [](std::size_t n) { return n > 1; }),
            "groups are not combined: --per group does that");
    note_if(changed_names_ > 0, fmt::format("{} names have '_' where View3D would take them to end", changed_names_));
  }

  const Scene3& scene_;
  const PatchCarriers3 carriers_;
  const Subsurfaces3 subsurfaces_;
  const PatchedFaces3 patched_;
  const bool combines_groups_;
  std::string vertices_, records_;
  std::size_t count_ = 0, backs_ = 0, changed_names_ = 0;
  std::vector<std::optional<std::size_t>> leaders_;  // of the fronts and the backs of each group
  std::vector<std::size_t> base_of_;                 // by face: the record that is its base, 0 without one
  std::vector<std::size_t> record_of_;               // of the front of a surface, 0 where it is several
  std::map<std::size_t, Vector3> normal_of_base_;    // of obstructions
  std::map<std::string, std::size_t> numbers_;       // of vertices, by what is written of them
  std::vector<std::string> cut_, covered_;           // into several records; by patches, wholly
  std::set<Rational> rounded_;
  bool has_colours_ = false, emits_ = false, is_clamped_ = false, has_rounded_emittance_ = false;
};

}  // namespace

WrittenVs3Deck3 write_vs3_3(const Scene3& scene, bool combines_groups) {
  return DeckWriter3(scene, combines_groups).write();
}

}  // namespace hottel
