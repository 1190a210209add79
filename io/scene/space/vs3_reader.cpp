#include "io/scene/space/vs3_reader.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "geometry/name.h"
#include "geometry/space/scene/near_plane.h"
#include "geometry/space/scene/patch_seats.h"
#include "geometry/space/scene/plane_frame.h"
#include "io/files/text_file.h"
#include "io/scene/space/vs3_deck.h"
#include "kernel/decimal.h"
#include "kernel/support/disjoint_sets.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// A text for the number that is its alone.
std::string exact_text(const Rational& value) {
  std::string text = short_text(value);
  return parse_rational(text) == value ? text : to_string(value);
}

class SceneOfDeck3 {
 public:
  SceneOfDeck3(Vs3Deck3 deck, Triangulator3* triangulator)
      : deck_(std::move(deck)), records_(deck_.records), triangulator_(triangulator) {}

  Vs3Scene3 make() {
    scene_.file = deck_.file;
    scene_.about = deck_.title;
    scene_.closed = deck_.is_enclosure;
    name_records();
    accept_digits();
    seat_subsurfaces();
    for (std::size_t k = 0; k < records_.size(); ++k) check(k);
    cut_bases();
    for (std::size_t k = 0; k < records_.size(); ++k) add(k);
    if (scene_.surfaces.empty())
      throw InputError({deck_.file, records_.front().line}, "the deck has no surface with an area left");
    join_bodies();
    ValidScene3 scene(std::move(scene_));
    take_output();
    add_notes();
    return {std::move(scene), std::move(notes_), output_};
  }

 private:
  std::string text_of(std::size_t k) const {
    return (records_[k].name.empty() ? "obstruction " : "surface ") + std::to_string(k + 1) +
           (records_[k].name.empty() ? "" : " " + quoted_name(records_[k].name));
  }

  [[noreturn]] void refuse(std::size_t k, const std::string& text, const std::string& hint = "") const {
    throw InputError({deck_.file, records_[k].line}, text_of(k) + " " + text,
                     hint.empty() ? std::vector<std::string>() : std::vector{hint});
  }

  void name_records() {
    std::unordered_map<std::string, std::size_t> uses;
    for (const Vs3Record3& record : records_) ++uses[record.name];
    for (std::size_t k = 0; k < records_.size(); ++k) {
      const std::string& name = records_[k].name;
      const bool is_alone = !name.empty() && uses[name] == 1;
      names_.push_back(is_alone ? name : (name.empty() ? "O" : name) + "~" + std::to_string(k + 1));
    }
  }

  // What lies on another one, or has others on it, is exactly plane.
  void accept_digits() {
    std::vector<char> is_base(deck_.records.size(), 0);
    for (const Vs3Record3& record : deck_.records)
      if (record.base >= 1 && record.base <= is_base.size()) is_base[record.base - 1] = 1;
    for (std::size_t k = 0; k < is_base.size(); ++k)
      if (Vs3Record3& record = deck_.records[k]; is_base[k] == 0 && record.base == 0)
        accept_nearly_plane(record.polygon, deck_.unit);
  }

  // What lies on others is put into their planes, as patches are. What lies on none that can be a base is refused
  // later.
  void seat_subsurfaces() {
    Scene3 seated;
    seated.materials.resize(1);
    for (std::size_t k = 0; k < deck_.records.size(); ++k) {
      const Vs3Record3& record = deck_.records[k];
      Surface surface;
      surface.name = std::to_string(k + 1);
      surface.group = static_cast<std::uint32_t>(k);
      if (record.base >= 1 && record.base <= deck_.records.size() && record.base != k + 1) {
        const bool faces_it = record.kind == Vs3Kind3::kMask || record.kind == Vs3Kind3::kNull;
        surface.on = static_cast<std::uint32_t>(seated.bases.size());
        seated.bases.push_back({std::to_string(record.base), faces_it});
      }
      seated.groups.emplace_back(surface.name);
      seated.add(std::move(surface), record.polygon);
    }
    if (seated.bases.empty()) return;
    seat_patches(seated, deck_.unit);
    for (std::size_t k = 0; k < deck_.records.size(); ++k)
      if (deck_.records[k].base != 0) deck_.records[k].polygon = std::move(seated.polygons[k]);
  }

  void check(std::size_t k) const {
    const Vs3Record3& record = records_[k];
    if (triangulator_ == nullptr || triangles_of_not_plane(record.polygon).empty())
      if (const auto& [problem, hint] = polygon_problem(record.polygon); !problem.empty()) refuse(k, problem, hint);
    check_partner(k);
    check_base(k);
    if (record.base != 0) check_neighbours(k);
  }

  // A mask lies beside all others that have its base.
  void check_neighbours(std::size_t k) const {
    const PlaneFrame3 frame(records_[k].polygon.points);
    for (std::size_t other = 0; other < k; ++other) {
      const bool is_mask = records_[k].kind == Vs3Kind3::kMask || records_[other].kind == Vs3Kind3::kMask;
      if (!is_mask || records_[other].base != records_[k].base) continue;
      // What is not convex is left to the arrangement, which finds the same.
      if (!is_convex(records_[k].polygon) || !is_convex(records_[other].polygon)) continue;
      if (!common_part(frame.outline(records_[k].polygon.points), frame.outline(records_[other].polygon.points))
               .empty())
        refuse(k, "shares an area with " + text_of(other) + ": both lie on " + text_of(records_[k].base - 1) +
                      ", and one of them is a mask");
    }
  }

  void check_partner(std::size_t k) const {
    const std::size_t partner = records_[k].combined_with;
    if (partner == 0) return;
    if (records_[k].kind != Vs3Kind3::kSurface) refuse(k, "is combined with another: only S records are");
    if (partner > k) refuse(k, "is combined with surface " + std::to_string(partner) + ", which must stand before it");
    if (records_[partner - 1].kind != Vs3Kind3::kSurface)
      refuse(k, "is combined with " + text_of(partner - 1) + ", which is no S record");
    if (records_[partner - 1].combined_with != 0)
      refuse(k, "is combined with " + text_of(partner - 1) + ", which is combined with another itself",
             "combine both with surface " + std::to_string(records_[partner - 1].combined_with));
  }

  void check_base(std::size_t k) const {
    const Vs3Record3& record = records_[k];
    const bool faces_it = record.kind == Vs3Kind3::kMask || record.kind == Vs3Kind3::kNull;
    if (record.base == 0) {
      if (faces_it) refuse(k, "has no base");
      return;
    }
    if (record.base > records_.size())
      refuse(k, "has the base " + std::to_string(record.base) + ", which is not there");
    const std::size_t b = record.base - 1;
    const Vs3Record3& base = records_[b];
    const bool is_surface = base.kind == Vs3Kind3::kSurface;
    if (!is_surface && (faces_it || base.kind != Vs3Kind3::kObstruction))
      refuse(k, "has the base " + text_of(b) + (faces_it ? ", which is no S record" : ", which is no S or O record"));
    if (is_surface && b >= k) refuse(k, "has the base " + text_of(b) + ", which must stand before it");
    if (const auto& [problem, hint] = polygon_problem(base.polygon); !problem.empty()) refuse(b, problem, hint);
    const Vector3 normal = doubled_area(base.polygon);
    for (const Point3& point : record.polygon.points) {
      if (const Rational off = dot(normal, point - base.polygon.points[0]); off != 0)
        refuse(k,
               "is not in the plane of its base, " + text_of(b) + ": it lies " +
                   length_text(off * off / dot(normal, normal)) + " off",
               "View3D lets 0.00001 of its size pass; here points are where they are said to be");
      if (!contains(base.polygon, point)) refuse(k, "is not within its base, " + text_of(b));
    }
    if ((dot(normal, doubled_area(record.polygon)) > 0) == faces_it)
      refuse(k, faces_it ? "faces the same way as its base, " + text_of(b) + "; N and M face it"
                         : "faces the other way than its base, " + text_of(b));
  }

  void cut_bases() {
    for (std::size_t k = 0; k < records_.size(); ++k) outlines_.push_back(records_[k].polygon);
    for (const Vs3Record3& record : records_)
      if (record.base != 0 && record.kind != Vs3Kind3::kMask)
        outlines_[record.base - 1].holes.push_back(record.polygon.points);
  }

  // Whether the holes cover it. Holes that overlap are refused: their surfaces do.
  bool is_covered(std::size_t k) const {
    const Vector3 normal = doubled_area(records_[k].polygon);
    Rational left = dot(normal, normal);
    for (const std::vector<Point3>& hole : outlines_[k].holes) {
      const Polygon3 part{hole};
      left -= abs(dot(normal, doubled_area(part)));
    }
    return left <= 0;
  }

  void add(std::size_t k) {
    if (is_covered(k)) {
      covered_.push_back(names_[k]);
      return;
    }
    const Vs3Record3& record = records_[k];
    Surface surface;
    surface.name = names_[k];
    surface.line = record.line;
    surface.is_obstruction = record.kind == Vs3Kind3::kNull || record.kind == Vs3Kind3::kObstruction;
    if (!surface.is_obstruction) surface.material = material_of(record.emittance);
    const std::size_t leader = leader_of(k);
    const auto [group, is_new] = groups_.emplace(leader, static_cast<std::uint32_t>(scene_.groups.size()));
    if (is_new) scene_.groups.emplace_back(names_[leader]);
    surface.group = group->second;
    if (records_[leader].emittance != record.emittance) mixes_emittances_ = true;
    if (triangulator_ != nullptr && triangulator_->add(scene_, surface, outlines_[k])) return;
    if (const auto& [problem, hint] = polygon_problem(outlines_[k]); !problem.empty()) refuse(k, problem, hint);
    place_.emplace(k, static_cast<std::uint32_t>(scene_.surfaces.size()));
    if (record.kind == Vs3Kind3::kMask) scene_.masks.push_back({place_[k], place_.at(record.base - 1)});
    scene_.add(std::move(surface), std::move(outlines_[k]));
  }

  // A base has a hole where its subsurface is: what is combined with either can close with both together only. Nothing
  // closes in which no three surfaces are combined.
  void join_bodies() {
    const auto n = static_cast<std::uint32_t>(scene_.groups.size());
    DisjointSets joined(n);
    std::vector<std::size_t> combined(records_.size());
    for (std::size_t k = 0; k < records_.size(); ++k) ++combined[leader_of(k)];
    std::vector<char> may_close(n, 0);
    // Of a base that is covered wholly the group may be none of the scene.
    const auto group_of = [&](std::size_t k) {
      const auto found = groups_.find(leader_of(k));
      return found == groups_.end() ? std::nullopt : std::optional(found->second);
    };
    for (std::size_t k = 0; k < records_.size(); ++k) {
      const auto own = group_of(k);
      if (own && combined[leader_of(k)] >= 3) may_close[joined.root(*own)] = 1;
      if (!own || records_[k].kind != Vs3Kind3::kSurface || records_[k].base == 0) continue;
      const std::size_t base = records_[k].base - 1;
      const auto under = group_of(base);
      if (!under || records_[base].kind != Vs3Kind3::kSurface || joined.root(*under) == joined.root(*own)) continue;
      if (may_close[joined.root(*own)] != 0) may_close[joined.root(*under)] = 1;
      joined.join(*under, *own);
    }
    std::vector<std::size_t> count(n);
    for (std::uint32_t g = 0; g < n; ++g) ++count[joined.root(g)];
    for (std::uint32_t g = 0; g < n; ++g)
      if (const std::uint32_t first = joined.root(g); count[first] > 1 && may_close[first] != 0)
        scene_.groups[g].body = scene_.groups[first].name;
  }

  std::size_t leader_of(std::size_t k) const {
    return records_[k].combined_with == 0 ? k : records_[k].combined_with - 1;
  }

  std::uint32_t material_of(const Rational& emittance) {
    const auto [entry, is_new] = materials_.emplace(emittance, static_cast<std::uint32_t>(scene_.materials.size()));
    if (is_new)
      scene_.materials.push_back(
          {"emittance " + exact_text(emittance), Spectrum::scalar(1 - emittance), Spectrum::scalar(0)});
    return entry->second;
  }

  void take_output() {
    const Vs3Output3& asked = deck_.output;
    output_ = {surface_of(asked.row, "row"), surface_of(asked.column, "col"), asked.out, asked.list,
               asked.wants_script_f};
  }

  // The surface that a control names by the number of its record; nothing for 0.
  std::optional<std::uint32_t> surface_of(std::uint32_t number, const std::string& control) const {
    if (number == 0) return std::nullopt;
    const auto refuse_it = [&](const std::string& text) {
      throw InputError({deck_.file, deck_.output.line}, control + "=" + std::to_string(number) + ": " + text);
    };
    if (number > records_.size()) refuse_it("the deck has " + std::to_string(records_.size()) + " surfaces");
    const std::size_t k = number - 1;
    const auto place = place_.find(k);
    if (records_[k].kind == Vs3Kind3::kNull || records_[k].kind == Vs3Kind3::kObstruction)
      refuse_it(text_of(k) + " has no row: only those of S and M records are there");
    if (place == place_.end())
      refuse_it(text_of(k) + " has no row: " +
                (std::find(covered_.begin(), covered_.end(), names_[k]) == covered_.end()
                     ? "it is cut into triangles"
                     : "subsurfaces cover it wholly"));
    return place->second;
  }

  void add_notes() {
    const auto note = [this](std::string text) { notes_.push_back(std::move(text)); };
    if (!deck_.not_obeyed.empty()) {
      std::string names;
      for (const std::string& name : deck_.not_obeyed) names += (names.empty() ? "" : ", ") + name;
      note(names + ": read, not obeyed (docs/coming_from_view3d.md says what takes their place)");
    }
    if (deck_.is_enclosure) note("encl=1 promises that the scene is closed; rows are not rescaled");
    if (!materials_.empty() &&
        (materials_.begin()->first < Rational(1, 1000) || materials_.rbegin()->first > Rational(999, 1000)))
      note("emittances are as written; View3D takes 0.001 for those below it and 0.999 for those above");
    if (deck_.has_inexact_angles)
      note("azimuths and tilts that are no multiples of 90 degrees have rational sines, less than 3e-16 radians away");
    if (!covered_.empty()) note("subsurfaces cover " + listed_names(covered_) + " wholly: of these there is no row");
    if (mixes_emittances_)
      note("surfaces of different emittances are combined; a row of theirs is told with the emittance of the last");
  }

  Vs3Deck3 deck_;
  const std::vector<Vs3Record3>& records_;
  Triangulator3* triangulator_;
  Scene3 scene_;
  std::vector<std::string> notes_;
  DeckOutput3 output_;
  std::vector<std::string> names_, covered_;
  std::vector<Polygon3> outlines_;                         // with what subsurfaces cut out
  std::unordered_map<std::size_t, std::uint32_t> groups_;  // by the record that gives the name
  std::unordered_map<std::size_t, std::uint32_t> place_;   // of a record among the surfaces
  std::map<Rational, std::uint32_t> materials_;            // by emittance
  bool mixes_emittances_ = false;
};

}  // namespace

bool is_vs3(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  return ending.size() == 4 && std::equal(ending.begin(), ending.end(), ".vs3", [](char c, char lower) {
           return c == lower || (c >= 'A' && c <= 'Z' && c - 'A' + 'a' == lower);
         });
}

Vs3Scene3 read_vs3_3(const std::filesystem::path& file, Triangulator3* triangulator) {
  return parse_vs3_3(read_text_file(file), file.string(), triangulator);
}

Vs3Scene3 parse_vs3_3(std::string_view text, const std::string& file, Triangulator3* triangulator) {
  return SceneOfDeck3(parse_vs3_deck_3(text, file), triangulator).make();
}

}  // namespace hottel
