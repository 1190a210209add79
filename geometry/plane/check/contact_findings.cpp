#include "geometry/plane/check/contact_findings.h"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/name.h"
#include "geometry/patch_bases.h"
#include "geometry/plane/check/wording.h"
#include "geometry/plane/scene/patches.h"

namespace hottel {
namespace {

class ContactTeller {
 public:
  ContactTeller(const Scene2& scene, const Contacts2& contacts)
      : scene_(scene), contacts_(contacts), carriers_(scene) {}

  Findings2 tell() {
    find_silent();
    for (const Overlap2& overlap : contacts_.overlaps) find_conflicts(overlap);
    for (const Conflict& conflict : conflicts_) tell_conflict(conflict);
    for (const Overlap2& overlap : contacts_.overlaps)
      if (const auto surfaces = surfaces_of(overlap);
          !is_in_conflict(surfaces) && !is_held(surfaces) && !is_said(surfaces))
        tell_overlap(overlap);
    for (const auto& surfaces : contacts_.duplicates)
      if (!is_held(surfaces) && !is_said(surfaces)) tell_duplicate(surfaces);
    for (std::uint32_t s = 0; s < scene_.surfaces.size(); ++s) tell_nothing_left(s);
    for (Junction2 junction : contacts_.junctions) {
      leave_out_patches(junction.ends);
      leave_out_patches(junction.through);
      if (junction.ends.empty() || junction.through.empty()) continue;
      if (!junction.is_in_solid && !is_held(united(junction.ends, junction.through))) tell_junction(junction);
    }
    for (Crossing2 crossing : contacts_.crossings) {
      leave_out_patches(crossing.surfaces);
      if (crossing.surfaces.size() > 1 && !crossing.is_in_solid && !is_held(crossing.surfaces)) tell_crossing(crossing);
    }
    return std::move(findings_);
  }

 private:
  std::string name(std::uint32_t s) const { return quoted_name(scene_.surfaces[s].name); }
  std::string name(const Face& face) const {
    return fmt::format("the {} of {}", face.is_back ? "back" : "front", name(face.surface));
  }

  static std::vector<std::uint32_t> united(std::vector<std::uint32_t> a, const std::vector<std::uint32_t>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  // Whether the innermost of the surfaces is a patch that lies on all others: then they say what is there.
  bool is_said(const std::vector<std::uint32_t>& surfaces) const {
    return std::ranges::any_of(surfaces, [&](std::uint32_t patch) {
      return std::ranges::all_of(surfaces, [&](std::uint32_t s) { return s == patch || patches_.rests_on(patch, s); });
    });
  }
  // What touches a patch touches what that lies on.
  void leave_out_patches(std::vector<std::uint32_t>& surfaces) const {
    std::erase_if(surfaces, [this](std::uint32_t s) { return patches_.is_patch(s); });
  }

  // At most one of the surfaces is not held by a solid.
  bool is_held(const std::vector<std::uint32_t>& surfaces) const {
    return std::count_if(surfaces.begin(), surfaces.end(), [this](std::uint32_t s) { return !is_held(s); }) < 2;
  }
  bool is_held(std::uint32_t s) const { return contacts_.faces.holder[scene_.surfaces[s].group] != Solids2::kNone; }

  static std::vector<std::uint32_t> surfaces_of(const Overlap2& overlap) {
    std::vector<std::uint32_t> surfaces;
    for (const PieceSource2& source : overlap.covering) surfaces.push_back(source.surface);
    return surfaces;
  }

  // Two faces that claim one side of a stretch, whatever else lies on parts of it.
  struct Conflict {
    Claim2 owner, rival;
    bool is_right = false;
    Point2 from, to;
  };

  void find_conflicts(const Overlap2& overlap) {
    for (const bool right : {false, true}) {
      const SideOwner2& side = overlap.sides[right ? 1 : 0].claims;
      if (!side.rival) continue;
      const auto before = std::find_if(conflicts_.begin(), conflicts_.end(), [&](const Conflict& other) {
        return other.is_right == right && other.to == overlap.from && other.owner.face == side.owner.face &&
               other.rival.face == side.rival->face;
      });
      if (before == conflicts_.end())
        conflicts_.push_back({side.owner, *side.rival, right, overlap.from, overlap.to});
      else
        before->to = overlap.to;
    }
  }

  bool is_in_conflict(const std::vector<std::uint32_t>& surfaces) const {
    const auto has = [&](const Claim2& claim) {
      return std::find(surfaces.begin(), surfaces.end(), claim.face.surface) != surfaces.end();
    };
    return std::any_of(conflicts_.begin(), conflicts_.end(),
                       [&](const Conflict& conflict) { return has(conflict.owner) && has(conflict.rival); });
  }

  void tell_conflict(const Conflict& conflict) {
    const auto& [owner, rival, is_right, from, to] = conflict;
    findings_.push_back(
        {Severity::kError,
         "conflicting-claims",
         {owner.face.surface, rival.face.surface},
         middle(from, to),
         fmt::format("{} and {} claim the {} side from {} to {} with different materials, {} and {}: which of them "
                     "light meets there is not defined",
                     name(owner.face), name(rival.face), is_right ? "right" : "left", place_text(from), place_text(to),
                     quoted_name(owner.material->name), quoted_name(rival.material->name)),
         "give both the same material, or take one of the surfaces away there; " +
             shorter_patch_hint(scene_, owner.face, rival.face)});
  }

  static bool is_solid(const OverlapSide2& side) { return side.solid != Solids2::kNone; }
  static bool touches_solid(const Overlap2& overlap) {
    return is_solid(overlap.sides[0]) || is_solid(overlap.sides[1]);
  }

  // Of these overlaps tell_duplicate does.
  bool is_duplicate(const Overlap2& overlap) const {
    return !touches_solid(overlap) &&
           std::all_of(overlap.covering.begin(), overlap.covering.end(), [&](const PieceSource2& source) {
             const Edge2 &a = scene_.edges[overlap.covering.front().surface], &b = scene_.edges[source.surface];
             return (a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from);
           });
  }

  bool has_material(const Face& face) const { return !face.is_back || scene_.surfaces[face.surface].back.has_value(); }
  bool has_area(const Face& face) const { return contacts_.faces.has_area[face.number()] != 0; }
  bool looks_into_solid(const Face& face) const { return contacts_.faces.covered_by[face.number()] != Solids2::kNone; }

  std::vector<std::uint32_t> silent_surfaces(const Overlap2& overlap) const {
    std::vector<std::uint32_t> surfaces;
    for (const PieceSource2& source : overlap.covering) {
      const Face front{source.surface, false};
      if (!has_area(front) && !looks_into_solid(front) && is_silent_[source.surface] != 0)
        surfaces.push_back(source.surface);
    }
    return surfaces;
  }

  void tell_overlap(const Overlap2& overlap) {
    const std::vector<std::uint32_t> surfaces = surfaces_of(overlap);
    if (is_duplicate(overlap) || (is_solid(overlap.sides[0]) && is_solid(overlap.sides[1]) &&
                                  std::all_of(surfaces.begin(), surfaces.end(), [&](std::uint32_t s) {
                                    return !has_area({s, false}) && !has_area({s, true});
                                  })))
      return;
    const auto side_text = [&](bool right) {
      const OverlapSide2& side = overlap.sides[right ? 1 : 0];
      if (is_solid(side)) return solid_text(scene_, side.solid);
      const Claim2& owner = side.claims.owner;
      return owner.material != nullptr ? name(owner.face) : "the black back of " + name(owner.face.surface);
    };
    const std::vector<std::uint32_t> silent = silent_surfaces(overlap);
    findings_.push_back(
        {Severity::kNote, "overlap", surfaces, middle(overlap.from, overlap.to),
         fmt::format("{} lie on each other from {} to {}; there light meets {} on the left side and {} on the right{}",
                     names_text(scene_, surfaces), place_text(overlap.from), place_text(overlap.to), side_text(false),
                     side_text(true),
                     silent.empty() ? ""
                                    : fmt::format("; {} exchange{} nothing and {} no rows", names_text(scene_, silent),
                                                  silent.size() == 1 ? "s" : "", silent.size() == 1 ? "has" : "have")),
         "nothing to do where that is meant, as under a box on a floor"});
  }

  // A thin wall, one side of which is covered, is told as an overlap.
  void tell_duplicate(const std::vector<std::uint32_t>& surfaces) {
    if (is_in_conflict(surfaces)) return;
    const Edge2& first = scene_.edges[surfaces.front()];
    const bool is_wall = surfaces.size() == 2 && scene_.edges[surfaces.back()].from == first.to;
    if (is_wall && std::any_of(surfaces.begin(), surfaces.end(), [&](std::uint32_t s) {
          return looks_into_solid({s, false}) || looks_into_solid({s, true});
        }))
      return;
    findings_.push_back(
        {is_wall ? Severity::kNote : Severity::kWarning, "duplicate", surfaces, middle(first),
         fmt::format("{} are the same segment, from {} to {}{}", names_text(scene_, surfaces), place_text(first.from),
                     place_text(first.to),
                     is_wall ? ", listed in opposite directions: a thin wall, each the front of one side" : ""),
         is_wall ? "one of them with a \"back\" would do" : "take all but one of them away"});
  }

  // Surfaces whose front makes no claim on some stretch, since it lies on the solid of its own.
  void find_silent() {
    is_silent_.assign(scene_.surfaces.size(), 0);
    for (const Overlap2& overlap : contacts_.overlaps)
      for (const PieceSource2& source : overlap.covering) {
        const bool back_is_right = source.is_reversed;
        const auto is_own = [&](std::uint32_t group) { return group == scene_.surfaces[source.surface].group; };
        if (is_solid(overlap.sides[back_is_right ? 1 : 0]) && !is_solid(overlap.sides[back_is_right ? 0 : 1]) &&
            has_material_on(scene_, patches_, overlap.covering, back_is_right, is_own))
          is_silent_[source.surface] = 1;
      }
  }

  void tell_nothing_left(std::uint32_t s) {
    const auto is_lost = [&](const Face& face) {
      return has_material(face) && !has_area(face) && !looks_into_solid(face);
    };
    const bool front = !is_held(s) && is_lost({s, false}) && is_silent_[s] == 0,
               back = !is_held(s) && is_lost({s, true});
    if (!front && !back) return;
    const std::string lost = front && back ? "front and back" : front ? "the front" : "the back";
    if (const std::vector<std::uint32_t> patches = patches_of(s); !patches.empty()) {
      findings_.push_back({Severity::kNote,
                           "nothing-left",
                           {s},
                           middle(scene_.edges[s]),
                           fmt::format("nothing is left of {} of {} beside the patch{} on it, {}: it has no rows", lost,
                                       name(s), patches.size() == 1 ? "" : "es", names_text(scene_, patches)),
                           "nothing to do where that is meant"});
      return;
    }
    findings_.push_back({Severity::kWarning,
                         "nothing-left",
                         {s},
                         middle(scene_.edges[s]),
                         fmt::format("nothing is left of {} of {}: surfaces listed before it own all of it, so it has "
                                     "no rows and takes no part in the exchange of light",
                                     lost, name(s)),
                         "take it away, or list it before what covers it"});
  }

  std::vector<std::uint32_t> patches_of(std::uint32_t s) const {
    std::vector<std::uint32_t> patches;
    for (std::uint32_t p = 0; p < scene_.surfaces.size(); ++p)
      if (patches_.lies_on(p, s) && std::ranges::count(carriers_.of(p), s) > 0) patches.push_back(p);
    return patches;
  }

  void tell_junction(const Junction2& junction) {
    findings_.push_back({Severity::kNote, "t-junction", united(junction.ends, junction.through), junction.at,
                         fmt::format("{} end{} inside {} at {}, exactly: no light passes between them",
                                     names_text(scene_, junction.ends), junction.ends.size() == 1 ? "s" : "",
                                     names_text(scene_, junction.through), place_text(junction.at)),
                         "nothing to do here; programs that round coordinates may need the vertex on both"});
  }

  void tell_crossing(const Crossing2& crossing) {
    findings_.push_back({Severity::kNote, "crossing", crossing.surfaces, crossing.at,
                         fmt::format("{} cross at {}: each hides and reflects on both sides of the crossing",
                                     names_text(scene_, crossing.surfaces), place_text(crossing.at)),
                         "nothing to do where that is meant"});
  }

  const Scene2& scene_;
  const Contacts2& contacts_;
  const PatchCarriers2 carriers_;
  const PatchBases& patches_ = carriers_.bases();
  std::vector<Conflict> conflicts_;
  std::vector<char> is_silent_;  // by surface
  Findings2 findings_;
};

}  // namespace

Findings2 contact_findings(const Scene2& scene, const Contacts2& contacts) {
  return ContactTeller(scene, contacts).tell();
}

}  // namespace hottel
