#include "geometry/check/contact_findings_2.h"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/check/wording.h"
#include "geometry/scene/name.h"

namespace hottel {
namespace {

class ContactTeller {
 public:
  ContactTeller(const Scene2& scene, const Contacts2& contacts) : scene_(scene), contacts_(contacts) {}

  Findings tell() {
    for (const Overlap2& overlap : contacts_.overlaps) find_conflicts(overlap);
    for (const Conflict& conflict : conflicts_) tell_conflict(conflict);
    for (const Overlap2& overlap : contacts_.overlaps)
      if (!is_in_conflict(surfaces_of(overlap))) tell_overlap(overlap);
    for (const auto& surfaces : contacts_.duplicates) tell_duplicate(surfaces);
    for (std::uint32_t s = 0; s < scene_.surfaces.size(); ++s) tell_nothing_left(s);
    for (const Junction2& junction : contacts_.junctions) tell_junction(junction);
    for (const Crossing2& crossing : contacts_.crossings) tell_crossing(crossing);
    return std::move(findings_);
  }

 private:
  std::string name(std::uint32_t s) const { return quoted_name(scene_.surfaces[s].name); }
  std::string name(const FacePart& face) const {
    return fmt::format("the {} of {}", face.is_back ? "back" : "front", name(face.surface));
  }

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
      const SideOwner2 side = owner_of_side(scene_, overlap.covering, right);
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
         "give both the same material, or take one of the surfaces away there"});
  }

  bool is_duplicate(const Overlap2& overlap) const {
    return std::all_of(overlap.covering.begin(), overlap.covering.end(), [&](const PieceSource2& source) {
      const Surface2 &a = scene_.surfaces[overlap.covering.front().surface], &b = scene_.surfaces[source.surface];
      return (a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from);
    });
  }

  void tell_overlap(const Overlap2& overlap) {
    if (is_duplicate(overlap)) return;
    const auto owner_text = [&](bool right) {
      const Claim2 owner = owner_of_side(scene_, overlap.covering, right).owner;
      return owner.material != nullptr ? name(owner.face) : "the black back of " + name(owner.face.surface);
    };
    const std::vector<std::uint32_t> surfaces = surfaces_of(overlap);
    findings_.push_back({Severity::kNote, "overlap", surfaces, middle(overlap.from, overlap.to),
                         fmt::format("{} lie on each other from {} to {}; there light meets {} on the left side and {} "
                                     "on the right",
                                     names_text(scene_, surfaces), place_text(overlap.from), place_text(overlap.to),
                                     owner_text(false), owner_text(true)),
                         "nothing to do where that is meant, as under a box on a floor"});
  }

  void tell_duplicate(const std::vector<std::uint32_t>& surfaces) {
    if (is_in_conflict(surfaces)) return;
    const Surface2& first = scene_.surfaces[surfaces.front()];
    const bool is_wall = surfaces.size() == 2 && scene_.surfaces[surfaces.back()].from == first.to;
    findings_.push_back(
        {is_wall ? Severity::kNote : Severity::kWarning, "duplicate", surfaces, middle(first.from, first.to),
         fmt::format("{} are the same segment, from {} to {}{}", names_text(scene_, surfaces), place_text(first.from),
                     place_text(first.to),
                     is_wall ? ", listed in opposite directions: a thin wall, each the front of one side" : ""),
         is_wall ? "one of them with a \"back\" would do" : "take all but one of them away"});
  }

  void tell_nothing_left(std::uint32_t s) {
    const Surface2& surface = scene_.surfaces[s];
    const bool front = contacts_.has_area[2 * s] == 0;
    const bool back = surface.back && contacts_.has_area[2 * s + 1] == 0;
    if (!front && !back) return;
    findings_.push_back({Severity::kWarning,
                         "nothing-left",
                         {s},
                         middle(surface.from, surface.to),
                         fmt::format("nothing is left of {} of {}: surfaces listed before it own all of it, so it has "
                                     "no rows and takes no part in the exchange of light",
                                     front && back ? "front and back"
                                     : front       ? "the front"
                                                   : "the back",
                                     name(s)),
                         "take it away, or list it before what covers it"});
  }

  void tell_junction(const Junction2& junction) {
    std::vector<std::uint32_t> surfaces = junction.ends;
    surfaces.insert(surfaces.end(), junction.through.begin(), junction.through.end());
    findings_.push_back({Severity::kNote, "t-junction", std::move(surfaces), junction.at,
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
  std::vector<Conflict> conflicts_;
  Findings findings_;
};

}  // namespace

Findings contact_findings(const Scene2& scene, const Contacts2& contacts) {
  return ContactTeller(scene, contacts).tell();
}

}  // namespace hottel
