#include "geometry/space/check/contact_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "geometry/name.h"
#include "geometry/space/check/wording.h"
#include "geometry/space/contacts/corner_table.h"
#include "geometry/space/scene/bent_loops.h"
#include "geometry/space/scene/polygon_places.h"
#include "kernel/decimal.h"

namespace hottel {
namespace {

using Surfaces = std::vector<std::uint32_t>;
using Kind = NearContact3::Kind;

Surfaces all_of(const NearContact3& contact) {
  Surfaces all;
  std::set_union(contact.surfaces.begin(), contact.surfaces.end(), contact.targets.begin(), contact.targets.end(),
                 std::back_inserter(all));
  return all;
}

const char* part_of_first(Kind kind) { return kind == Kind::kEdgeEdge ? "an edge" : "the corner"; }
const char* part_of_second(Kind kind) {
  switch (kind) {
    case Kind::kCornerCorner:
      return "the corner";
    case Kind::kCornerFace:
      return "the face";
    case Kind::kCornerEdge:
    case Kind::kEdgeEdge:
      break;
  }
  return "an edge";
}

Finding3 tell(const Scene3& scene, const NearContact3& contact) {
  const std::string first = names_text(scene, contact.surfaces), second = names_text(scene, contact.targets);
  const std::string distance = length_text(contact.squared);
  if (contact.sticks_out)
    return {
        Severity::kWarning,
        "overshoot",
        all_of(contact),
        contact.from,
        fmt::format("the corner of {} at {} sticks out of {} by {}", first, place_text(contact.from), second, distance),
        "if it should end there, let it end exactly on the other; `--fix OUT --within D` does"};
  std::string message =
      fmt::format("{} of {} at {} is {} from {} of {}, {}", part_of_first(contact.kind), first,
                  place_text(contact.from), distance, part_of_second(contact.kind), second, place_text(contact.to));
  if (contact.is_angle)
    return {Severity::kNote,
            "needle",
            all_of(contact),
            contact.from,
            message + ": they meet in an angle below 1/1024",
            "if they should lie on each other, `--fix OUT --within D` puts them there"};
  return {Severity::kWarning,
          "near-contact",
          all_of(contact),
          contact.from,
          message + ": light passes through the gap between them",
          contact.kind == Kind::kEdgeEdge
              ? "if they should touch, give both a corner at the same point"
              : "if they should touch, give both the same point, or let it lie exactly on the other (a coordinate may "
                "be a fraction); `--fix OUT --within D` does"};
}

// The corners around, from the smallest one on in the direction of the smaller neighbour; and whether that is against
// the order of the polygon.
std::pair<Surfaces, bool> normal_form(Surfaces outline) {
  const auto smallest_first = [](Surfaces& around) {
    std::rotate(around.begin(), std::min_element(around.begin(), around.end()), around.end());
  };
  Surfaces other(outline.rbegin(), outline.rend());
  smallest_first(outline);
  smallest_first(other);
  return other < outline ? std::pair(std::move(other), true) : std::pair(std::move(outline), false);
}

void tell_duplicates(const Scene3& scene, const CornerTable3& corners, Findings3& findings) {
  std::map<std::vector<Surfaces>, std::vector<std::pair<std::uint32_t, bool>>>
      same;  // by rings, that of the outline last
  for (std::uint32_t s = 0; s < corners.of_polygon.size(); ++s) {
    if (scene.surfaces[s].on) continue;  // it says that it lies there
    auto corner = corners.of_polygon[s].begin();
    const auto ring = [&](std::size_t count) {
      const auto begin = corner;
      corner += static_cast<std::ptrdiff_t>(count);
      return normal_form(Surfaces(begin, corner));
    };
    auto [outline, is_reversed] = ring(scene.polygons[s].points.size());
    std::vector<Surfaces> rings;
    for (const auto& hole : scene.polygons[s].holes) rings.push_back(ring(hole.size()).first);
    std::sort(rings.begin(), rings.end());
    rings.push_back(std::move(outline));
    same[std::move(rings)].emplace_back(s, is_reversed);
  }
  for (const auto& [form, list] : same) {
    if (list.size() < 2) continue;
    Surfaces surfaces;
    for (const auto& [s, is_reversed] : list) surfaces.push_back(s);
    const auto is_mask = [&those = list](const Mask3& mask) {
      return those.size() == 2 && std::minmax(mask.surface, mask.base) == std::minmax(those[0].first, those[1].first);
    };
    if (std::any_of(scene.masks.begin(), scene.masks.end(), is_mask)) continue;  // it says that they do
    const bool is_thin_wall = list.size() == 2 && list[0].second != list[1].second;
    findings.push_back({is_thin_wall ? Severity::kNote : Severity::kWarning, "duplicate", surfaces,
                        middle(scene.polygons[surfaces[0]]),
                        fmt::format("{} have the same corners{}", names_text(scene, surfaces),
                                    is_thin_wall ? ", their fronts on different sides: a thin wall" : ""),
                        is_thin_wall ? "one polygon with a \"back\" does the same" : "remove all but one"});
  }
}

void tell_needle(const Scene3& scene, std::uint32_t s, Findings3& findings) {
  const std::vector<Point3> points = corners_of(scene.polygons[s]);
  Rational longest;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) longest = std::max(longest, squared_distance(points[a], points[b]));
  const Rational width = squared_width(scene.polygons[s]);
  if (width * kNeedlePart3 * kNeedlePart3 >= longest) return;
  findings.push_back({Severity::kNote,
                      "needle",
                      {s},
                      middle(scene.polygons[s]),
                      fmt::format("{} is {} long and somewhere only {} wide", quoted_name(scene.surfaces[s].name),
                                  length_text(longest), length_text(width)),
                      "approximate methods lose digits here; if it is not meant, move its points together"});
}

void tell_nearly_plane(const Scene3& scene, std::uint32_t s, Findings3& findings) {
  const Polygon3& polygon = scene.polygons[s];
  if (!polygon.is_nearly_plane || !polygon.facets.empty()) return;  // of a patch its base is named
  const Bend3 bend = bend_of(corners_of(polygon));
  findings.push_back({Severity::kNote,
                      "not-plane",
                      {s},
                      bend.farthest,
                      fmt::format("{} is not plane: {} lies {} off the plane of three other corners, which rounding to "
                                  "the digits of the file may make; it is {} triangles under one name",
                                  quoted_name(scene.surfaces[s].name), place_text(bend.farthest),
                                  length_text(bend.squared_distance), facets_of(polygon).size()),
                      "fractions, or more digits, say what is meant"});
}

}  // namespace

Findings3 contact_findings(const Scene3& scene, const Contacts3& contacts) {
  Findings3 findings;
  std::set<std::pair<std::uint32_t, std::uint32_t>> sticking_out;
  for (const NearContact3& contact : contacts.near) {
    findings.push_back(tell(scene, contact));
    if (!contact.sticks_out) continue;
    for (const std::uint32_t s : contact.surfaces)
      for (const std::uint32_t t : contact.targets) sticking_out.insert(std::minmax(s, t));
  }
  for (const Junction3& junction : contacts.junctions) {
    Surfaces all;
    std::set_union(junction.ends.begin(), junction.ends.end(), junction.through.begin(), junction.through.end(),
                   std::back_inserter(all));
    findings.push_back(
        {Severity::kNote, "t-junction", std::move(all), junction.at,
         fmt::format("a corner of {} lies inside an edge of {} at {}, exactly: no light passes between "
                     "them",
                     names_text(scene, junction.ends), names_text(scene, junction.through), place_text(junction.at)),
         "nothing to do here; programs that round coordinates may need the corner on both"});
  }
  for (const Crossing3& crossing : contacts.crossings) {
    const auto [first, second] = std::minmax(crossing.surface, crossing.through);
    if (sticking_out.count({first, second}) != 0) continue;
    findings.push_back({Severity::kNote,
                        "crossing",
                        {first, second},
                        crossing.at,
                        fmt::format("{} pass through each other", names_text(scene, {first, second})),
                        "this is legal; parts behind the other are hidden as they should be"});
  }
  return findings;
}

Findings3 shape_findings(const Scene3& scene) {
  Findings3 findings;
  tell_duplicates(scene, CornerTable3(scene.polygons), findings);
  for (std::uint32_t s = 0; s < scene.polygons.size(); ++s) {
    tell_needle(scene, s, findings);
    tell_nearly_plane(scene, s, findings);
  }
  return findings;
}

}  // namespace hottel
