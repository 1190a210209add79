#include "geometry/space/check/visibility_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/gray_temperature.h"
#include "geometry/name.h"
#include "geometry/space/check/wording.h"
#include "geometry/space/scene/patches.h"

namespace hottel {
namespace {

using Surfaces = std::vector<std::uint32_t>;

bool is_black(const ExchangeMatrix& matrix, std::uint32_t to) {
  return to != matrix.sky() && !matrix.elements()[to].material;
}

// What a face sees at all.
struct Sight {
  bool materials = false, black = false, sky = false;
};

// Who loses most light on a back.
struct Loss {
  std::uint32_t from = 0;
  double factor = -1;     // none so far
  std::size_t faces = 0;  // that lose any
};

// Whether two polygons lie in one plane, and the first has a point of it.
bool lies_on(const Polygon3& polygon, const Polygon3& other, const Point3& at) {
  const Vector3 normal = doubled_area(polygon);
  const auto is_in_plane = [&](const Point3& p) { return dot(normal, p - polygon.points[0]) == 0; };
  return is_in_plane(at) && std::all_of(other.points.begin(), other.points.end(), is_in_plane) && contains(polygon, at);
}

class SightTeller {
 public:
  SightTeller(const Scene3& scene, const Meshes3& meshes, const ExchangeMatrix& matrix, bool is_whole)
      : scene_(scene), meshes_(meshes), matrix_(matrix), is_whole_(is_whole), losses_(scene.surfaces.size()) {
    told_.assign(scene.surfaces.size(), 0);
    for (const std::uint32_t s : meshes.reversed) told_[s] = 1;
    for (std::uint32_t face = 0; face < matrix.size(); ++face) look_from(face);
  }

  Findings3 tell() {
    tell_open();
    if (is_whole_) tell_inside_out();
    tell_black_backs();
    if (is_whole_) tell_lonely();
    return std::move(findings_);
  }

 private:
  std::uint32_t surface(std::uint32_t face) const { return matrix_.elements()[face].surface; }
  std::uint32_t group(std::uint32_t face) const { return scene_.surfaces[surface(face)].group; }
  std::string name(std::uint32_t face) const { return quoted_name(matrix_.elements()[face].name); }
  Point3 place(const Surfaces& surfaces) const { return middle(scene_.polygons[surfaces.front()]); }

  void look_from(std::uint32_t face) {
    sights_.emplace_back();
    if (!matrix_.has_row(face)) return;
    Sight& sight = sights_.back();
    for (const FactorEntry& entry : matrix_.row(face)) {
      if (entry.to == matrix_.sky()) {
        sight.sky = true;
      } else if (!is_black(matrix_, entry.to)) {
        sight.materials = true;
      } else {
        sight.black = true;
        Loss& loss = losses_[surface(entry.to)];
        ++loss.faces;
        if (entry.factor.value > loss.factor) {
          loss.factor = entry.factor.value;
          loss.from = face;
        }
      }
    }
  }

  void add(Severity severity, const char* kind, Surfaces surfaces, std::string message, std::string suggestion) {
    const Point3 at = place(surfaces);
    findings_.push_back({severity, kind, std::move(surfaces), at, std::move(message), std::move(suggestion)});
  }

  void tell_open() {
    std::vector<std::uint32_t> open;
    double out = 0, all = 0;
    std::uint32_t most = 0;
    for (std::uint32_t face = 0; face < matrix_.size(); ++face) {
      if (matrix_.elements()[face].is_back || !matrix_.has_row(face)) continue;
      const double area = matrix_.elements()[face].area.value;
      all += area;
      if (!sights_[face].sky) continue;
      out += area * sky(face);
      if (open.empty() || sky(face) > sky(most)) most = face;
      open.push_back(face);
    }
    if (open.empty() || (!scene_.closed && (!is_whole_ || out >= kLeakPart3 * all))) return;
    Surfaces surfaces;
    for (const std::uint32_t face : open) surfaces.push_back(surface(face));
    std::string text = open.size() == 1 ? fmt::format("the front of {} sees the sky (F = {})",
                                                      names_text(scene_, surfaces), shortest(sky(most)))
                                        : fmt::format("the fronts of {} see the sky, {} the most (F = {})",
                                                      names_text(scene_, surfaces), name(most), shortest(sky(most)));
    Point3 at = place(surfaces);
    if (meshes_.leak) {
      at = meshes_.leak->at;
      text += "; " + meshes_.leak->text;
    } else if (const EdgeStretch3* edge = bare_edge_of(surfaces)) {
      at = middle(edge->from, edge->to);
      text += fmt::format("; {} of {} from {} to {} lies on nothing", meshes_.bare.size() == 1 ? "the edge" : "an edge",
                          quoted_name(scene_.surfaces[edge->uses.front().surface].name), place_text(edge->from),
                          place_text(edge->to));
    }
    if (scene_.closed)
      findings_.push_back({Severity::kError, "not-closed", std::move(surfaces), at,
                           "the scene promises to be closed, but " + text,
                           "close it (`--fix OUT --within D` closes gaps), reverse what has its front outside, or take "
                           "the promise \"closed\" away"});
    else
      findings_.push_back({Severity::kNote, "opening", std::move(surfaces), at, text,
                           "if the room should be closed, close it, and promise it: \"closed\": true"});
  }

  // An edge that lies on nothing, of one of these, which ascend; null where there is none. What hangs free in a room
  // has such edges too, and is not where it is open.
  const EdgeStretch3* bare_edge_of(const Surfaces& surfaces) const {
    for (const EdgeStretch3& edge : meshes_.bare)
      if (std::ranges::binary_search(surfaces, edge.uses.front().surface)) return &edge;
    return nullptr;
  }

  double sky(std::uint32_t face) const { return matrix_.factor(face, matrix_.sky()).value; }

  // The fronts of a closed mesh see nothing but each other, in the dark.
  void tell_inside_out() {
    std::vector<char> is_dark = meshes_.is_room;
    std::vector<Surfaces> surfaces(scene_.groups.size());
    for (std::uint32_t face = 0; face < matrix_.size(); ++face) {
      if (matrix_.elements()[face].is_back) continue;
      const std::uint32_t own = group(face);
      surfaces[own].push_back(surface(face));
      const auto material = matrix_.elements()[face].material;
      if (!material || !scene_.materials[*material].emission.is_zero()) is_dark[own] = 0;
      for (const FactorEntry& entry : matrix_.row(face))
        if (entry.to == matrix_.sky() || group(entry.to) != own || matrix_.elements()[entry.to].is_back)
          is_dark[own] = 0;
    }
    for (std::size_t own = 0; own < surfaces.size(); ++own) {
      if (is_dark[own] == 0) continue;
      const bool is_seen = std::any_of(surfaces[own].begin(), surfaces[own].end(),
                                       [&](std::uint32_t s) { return losses_[s].factor >= 0; });
      for (const std::uint32_t s : surfaces[own]) told_[s] = 1;
      add(is_seen ? Severity::kWarning : Severity::kNote, "inside-out", surfaces[own],
          fmt::format("{} is closed with its fronts inward, where it is empty and dark{}",
                      quoted_name(scene_.groups[own].name), is_seen ? "; others see its black backs" : ""),
          "was a room meant? For a body list the points of each polygon the other way round");
    }
  }

  // Once a group, where most light is lost.
  void tell_black_backs() {
    std::vector<Surfaces> lost(scene_.groups.size());
    for (std::uint32_t s = 0; s < losses_.size(); ++s)
      if (losses_[s].factor >= 0 && told_[s] == 0 && !scene_.surfaces[s].is_obstruction)
        lost[scene_.surfaces[s].group].push_back(s);
    for (Surfaces& surfaces : lost)
      if (!surfaces.empty()) tell_black_backs_of(std::move(surfaces));
  }

  void tell_black_backs_of(Surfaces surfaces) {
    const std::uint32_t most = *std::max_element(surfaces.begin(), surfaces.end(),
                                                 [&](auto a, auto b) { return losses_[a].factor < losses_[b].factor; });
    const auto& [from, factor, faces] = losses_[most];
    std::string message = fmt::format("the back of {} is black: there {} loses F = {} of its light",
                                      quoted_name(scene_.surfaces[most].name), name(from), shortest(factor));
    if (faces > 1) message += fmt::format(", the most of {} faces", faces);
    if (surfaces.size() > 1)
      message += fmt::format("; so are {} more of {} that others see", surfaces.size() - 1,
                             quoted_name(scene_.groups[scene_.surfaces[most].group].name));
    const bool is_alone = surfaces.size() == 1;
    findings_.push_back({Severity::kWarning, "black-back", std::move(surfaces), middle(scene_.polygons[most]),
                         std::move(message), remedy(scene_.surfaces[most], is_alone)});
  }

  // Of one back, or of those of its group that are seen.
  std::string remedy(const Surface& surface, bool is_alone) const {
    const std::string mesh = quoted_name(scene_.groups[surface.group].name);
    const std::string give =
        surface.in_mesh.file > 0
            ? fmt::format("give {} a material in \"backs\" of its mesh, or its material \"two_sided\": true", mesh)
            : fmt::format("give {} a \"back\", or its material \"two_sided\": true",
                          is_alone ? quoted_name(surface.name) : mesh);
    const bool is_of_mesh = std::count_if(scene_.surfaces.begin(), scene_.surfaces.end(),
                                          [&](const Surface& other) { return other.group == surface.group; }) > 1;
    if (!is_of_mesh) return give;
    if (meshes_.is_room[surface.group] != 0)
      return fmt::format(
          "{} is closed with its fronts inward: for a body list the points of each polygon the other way "
          "round; else {}",
          mesh, give);
    if (meshes_.is_closed[surface.group] != 0) return give;
    return fmt::format("close the mesh {}, its bottom too, where nothing is in it; else {}", mesh, give);
  }

  void tell_covered(std::uint32_t face) {
    const auto material = matrix_.elements()[face].material;
    if (!material) return;
    if (const Surfaces patches = patches_on(face); !patches.empty())
      return add(Severity::kNote, "covered", {surface(face)},
                 fmt::format("nothing is left of {} beside the patch{} on it, {}: it has no rows", name(face),
                             patches.size() == 1 ? "" : "es", names_text(scene_, patches)),
                 "nothing to do where that is meant");
    const bool emits =
        !scene_.materials[*material].emission.is_zero() && !is_as_warm_as_cover(surface(face), *material);
    add(emits ? Severity::kWarning : Severity::kNote, "covered", {surface(face)},
        fmt::format("nothing is left of {}: others cover all of it{}", name(face),
                    emits ? ", and its emission is lost" : ""),
        emits ? "move it out of what covers it" : "nothing to do here: it has no part in the exchange");
  }

  Surfaces patches_on(std::uint32_t face) const {
    const Element& element = matrix_.elements()[face];
    return carriers_.on({element.surface, element.is_back});
  }

  // Whether something that lies in its plane, over its middle, has its temperature: what covers it, or it stands on.
  bool is_as_warm_as_cover(std::uint32_t s, std::uint32_t material) const {
    const std::optional<Rational> own = gray_temperature(scene_.materials[material]);
    if (!own) return false;
    const Point3 at = middle(scene_.polygons[s]);
    for (std::uint32_t other = 0; other < scene_.surfaces.size(); ++other) {
      if (other == s || !lies_on(scene_.polygons[other], scene_.polygons[s], at)) continue;
      for (const bool is_back : {false, true})
        if (const auto its = scene_.surfaces[other].material_of(is_back);
            its && gray_temperature(scene_.materials[*its]) == own)
          return true;
    }
    return false;
  }

  void tell_lonely() {
    struct Group {
      std::size_t faces = 0;
      Surfaces only_sky;
    };
    std::vector<Group> groups(scene_.groups.size());
    for (std::uint32_t face = 0; face < matrix_.size(); ++face) {
      if (!matrix_.has_row(face)) {
        tell_covered(face);
        continue;
      }
      const Sight& sight = sights_[face];
      Group& own = groups[group(face)];
      ++own.faces;
      if (!sight.materials && !sight.black && sight.sky && told_[surface(face)] == 0) own.only_sky.push_back(face);
      if (!sight.materials && sight.black && !sight.sky && told_[surface(face)] == 0)
        add(Severity::kNote, "sees-only-backs", {surface(face)},
            fmt::format("{} sees nothing but black backs: no light comes from there", name(face)),
            "if something covers it, it has no part in the exchange; else list the points of one the other way round");
    }
    for (const Group& own : groups) {
      // That a part of a body looks away from everything is in the nature of bodies.
      if (own.faces == 0 || own.only_sky.size() < own.faces) continue;
      Surfaces surfaces;
      for (const std::uint32_t face : own.only_sky)
        if (surfaces.empty() || surfaces.back() != surface(face)) surfaces.push_back(surface(face));
      std::string message = fmt::format("{} {} nothing but the sky: no surface gets light from there or sends any",
                                        names_text(scene_, surfaces), surfaces.size() == 1 ? "sees" : "see");
      add(Severity::kNote, "sees-only-sky", std::move(surfaces), std::move(message),
          "if others should be seen, list the points the other way round");
    }
  }

  const Scene3& scene_;
  const PatchCarriers3 carriers_{scene_};
  const Meshes3& meshes_;
  const ExchangeMatrix& matrix_;
  const bool is_whole_;
  std::vector<Sight> sights_;  // by face
  std::vector<Loss> losses_;   // by surface, on its back
  std::vector<char> told_;     // by surface: something else was said of its back
  Findings3 findings_;
};

}  // namespace

Findings3 visibility_findings(const Scene3& scene, const Meshes3& meshes, const ExchangeMatrix& matrix, bool is_whole) {
  return SightTeller(scene, meshes, matrix, is_whole).tell();
}

}  // namespace hottel
