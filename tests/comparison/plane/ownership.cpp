#include "tests/comparison/plane/ownership.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/patch_bases.h"
#include "kernel/support/failure.h"

namespace hottel::oracle {

namespace {

using Behind = hottel::Behind;

Behind to_engine(oracle::Behind said) {
  switch (said) {
    case oracle::Behind::kSolid:
      return Behind::kSolid;
    case oracle::Behind::kOpen:
      return Behind::kOpen;
    case oracle::Behind::kNothingSaid:
      break;
  }
  return Behind::kByOutline;
}

oracle::Behind to_oracle(Behind behind) {
  switch (behind) {
    case Behind::kSolid:
      return oracle::Behind::kSolid;
    case Behind::kOpen:
      return oracle::Behind::kOpen;
    case Behind::kByOutline:
      break;
  }
  return oracle::Behind::kNothingSaid;
}

Rational part_of(const Rational& from, const Rational& to, std::uint32_t k, std::uint32_t parts) {
  Rational share(k, parts);
  share.canonicalize();
  return from + share * (to - from);
}

std::string name_of(const std::optional<FacePart2>& face) {
  return face ? fmt::format("{}{}#{}", face->surface, face->is_back ? ":back" : "", face->part) : "a solid";
}

// The face of a label of the oracle, or nothing for what is covered.
std::optional<FacePart2> face_of(int label, const std::vector<FacePart2>& parts) {
  if (label == kCovered) return std::nullopt;
  FacePart2 face = parts[static_cast<std::size_t>(label / 2)];
  face.is_back = label % 2 == 1;
  return face;
}

}  // namespace

Scene2 to_scene(const std::vector<InputSegment>& edges) {
  Scene2 scene;
  scene.file = "edges";
  for (int m = 0; m < 3; ++m) {
    Material material;
    material.name = "material " + std::to_string(m);
    Rational reflectivity(m, 4);
    reflectivity.canonicalize();
    material.reflectivity = Spectrum::scalar(reflectivity);
    material.emission = Spectrum::scalar(m == 2 ? 1 : 0);
    scene.materials.push_back(material);
  }
  std::vector<std::string> names;  // a patch stands after what it lies on
  for (const std::vector<std::size_t>& group : groups_of(edges)) {
    const InputSegment& first = edges[group.front()];
    const bool is_polyline = first.group != kAlone;
    const std::string name = (is_polyline ? "p" : "e") + std::to_string(group.front());
    for (const std::size_t k : group) {
      const InputSegment& edge = edges[k];
      Surface surface;
      surface.name = is_polyline ? fmt::format("{}[{}]", name, k - group.front()) : name;
      surface.material = static_cast<std::uint32_t>(edge.front_material);
      if (edge.back_material >= 0) surface.back = static_cast<std::uint32_t>(edge.back_material);
      surface.group = static_cast<std::uint32_t>(scene.groups.size());
      if (!edge.on.empty()) {
        surface.on = static_cast<std::uint32_t>(scene.bases.size());
        scene.bases.push_back({names.at(edge.on.front()), edge.is_on_back});
      }
      names.push_back(surface.name);
      scene.add(surface, {{edge.ax, edge.ay}, {edge.bx, edge.by}});
    }
    scene.groups.push_back({name, to_engine(first.behind)});
  }
  validate(scene);
  return scene;
}

std::vector<InputSegment> to_edges(const Scene2& scene, Divided2 divided) {
  const auto& materials = scene.materials;
  const auto number = [&](std::uint32_t material) {  // materials that act alike have one number
    return static_cast<int>(std::find(materials.begin(), materials.end(), materials[material]) - materials.begin());
  };
  std::vector<InputSegment> edges;
  std::vector<std::vector<std::size_t>> parts_of;  // by surface; a patch stands after what it lies on
  const PatchBases bases(scene);
  for (std::uint32_t place = 0; place < scene.surfaces.size(); ++place) {
    const Surface& s = scene.surfaces[place];
    const auto& [from, to] = scene.edges[place];
    const std::uint32_t parts = divided == Divided2::kYes ? s.elements : 1;
    std::vector<std::size_t> on;
    if (bases.is_patch(place))
      for (const std::uint32_t base : bases.under(place))
        on.insert(on.end(), parts_of.at(base).begin(), parts_of.at(base).end());
    parts_of.emplace_back();
    for (std::uint32_t k = 0; k < parts; ++k) {
      parts_of.back().push_back(edges.size());
      edges.push_back({part_of(from.x, to.x, k, parts), part_of(from.y, to.y, k, parts),
                       part_of(from.x, to.x, k + 1, parts), part_of(from.y, to.y, k + 1, parts), number(s.material),
                       s.back ? number(*s.back) : -1, static_cast<int>(s.group),
                       to_oracle(scene.groups[s.group].behind), on, s.on && bases.is_on_backs(place)});
    }
  }
  return edges;
}

std::string ownership_differs(const PreparedScene2& prepared, const Split& split) {
  const Arrangement2& arrangement = prepared.arrangement;
  std::vector<FacePart2> parts;  // by edge of the oracle
  for (std::uint32_t s = 0; s < prepared.division.size(); ++s)
    for (std::uint32_t k = 0; k < prepared.division[s].count(); ++k) parts.push_back({{s, false}, k});
  using End = std::pair<Rational, Rational>;
  using Sides = std::pair<std::optional<FacePart2>, std::optional<FacePart2>>;
  std::map<std::pair<End, End>, Sides> expected;
  for (const Segment& s : split.pieces)
    expected[{{s.ax, s.ay}, {s.bx, s.by}}] = {face_of(s.left, parts), face_of(s.right, parts)};
  if (arrangement.pieces().size() != expected.size())
    return fmt::format("{} pieces, the oracle has {}\n", arrangement.pieces().size(), expected.size());
  const auto owner = [&](PieceSideId side) {
    return arrangement.is_covered(side) ? std::nullopt : std::optional(arrangement.owner(side));
  };
  std::string wrong;
  for (std::size_t k = 0; k < arrangement.pieces().size(); ++k) {
    const Vertices2& vertices = arrangement.vertices();
    const auto end = [&](VertexId v) {
      const Point2 p = vertices.to_scene(vertices.exact(v));
      return End{p.x, p.y};
    };
    End a = end(arrangement.pieces()[k].a), b = end(arrangement.pieces()[k].b);
    Sides sides{owner(left_side(k)), owner(right_side(k))};
    if (b < a) {
      std::swap(a, b);
      std::swap(sides.first, sides.second);
    }
    const auto place = expected.find({a, b});
    const std::string where =
        fmt::format("({}, {})-({}, {})", a.first.get_str(), a.second.get_str(), b.first.get_str(), b.second.get_str());
    if (place == expected.end())
      wrong += where + " is no piece\n";
    else if (place->second != sides)
      wrong +=
          fmt::format("{}: {} on the left and {} on the right, the oracle has {} and {}\n", where, name_of(sides.first),
                      name_of(sides.second), name_of(place->second.first), name_of(place->second.second));
  }
  return wrong;
}

std::string verdict_differs(const Scene2& scene, const Split& expected) {
  try {
    const PreparedScene2 prepared = prepare(scene);
    if (!expected.is_refused()) return ownership_differs(prepared, expected);
    return fmt::format("accepted; the oracle has {} conflicts, {} unbounded, {} contradictions\n",
                       expected.conflicts.size(), expected.unbounded.size(), expected.contradictions.size());
  } catch (const InputError& error) {
    const std::string text = error.what();
    const auto says = [&](const char* words) { return text.find(words) != std::string::npos; };
    const bool is_expected = says("claim the same side")             ? !expected.conflicts.empty()
                             : says("says that a region is solid")   ? !expected.contradictions.empty()
                             : says("\"behind\" is \"solid\", but ") ? !expected.unbounded.empty()
                                                                     : false;
    return is_expected ? "" : "refused: " + text + "\n";
  }
}

}  // namespace hottel::oracle
