#include "geometry/plane/check/region_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <unordered_map>
#include <utility>

#include "geometry/plane/check/wording.h"
#include "geometry/plane/scene/closest_point.h"

namespace hottel {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;
constexpr std::uint32_t kSeveral = 0xfffffffe;

// Joins vertices that pieces connect.
class VertexUnion {
 public:
  VertexId root(VertexId v) {
    for (VertexId* parent = &of(v); *parent != v; parent = &of(v)) v = *parent = of(*parent);
    return v;
  }
  void join(VertexId a, VertexId b) { of(root(a)) = root(b); }

 private:
  VertexId& of(VertexId v) { return parent_.try_emplace(v, v).first->second; }
  std::unordered_map<VertexId, VertexId> parent_;
};

class RegionTeller {
 public:
  RegionTeller(const PreparedScene2& prepared, const FreeRegions2& regions)
      : scene_(prepared.scene), arrangement_(prepared.arrangement), regions_(regions) {
    region_of_face_.assign(2 * scene_.surfaces.size(), kNone);
    for (const PieceSideId side : arrangement_.sides()) {
      if (arrangement_.is_covered(side)) continue;
      std::uint32_t& region = region_of_face_[face(side).number()];
      const std::uint32_t here = regions.of(side);
      region = region == kNone || region == here ? here : kSeveral;
    }
    told_.is_inside_out.assign(scene_.surfaces.size(), 0);
    residents_.resize(regions.count());
    for (std::uint32_t f = 0; f < region_of_face_.size(); ++f)
      if (region_of_face_[f] < regions.count() && material(Face::of(f)) != nullptr)
        residents_[region_of_face_[f]].push_back(Face::of(f));
  }

  RegionFindings2 tell() {
    auto rooms = std::count_if(residents_.begin() + 1, residents_.end(), [](auto& faces) { return !faces.empty(); });
    if (has_outsider()) ++rooms;
    std::vector<std::uint32_t> whole;  // rooms that are not inside out
    for (std::uint32_t region = 1; region < regions_.count(); ++region) {
      if (residents_[region].empty()) continue;  // solid regions too
      const std::vector<PieceSideId> walls = outer_walls(region);
      if (tell_black(walls)) continue;
      if (is_reversed_solid(region, walls)) {
        tell_reversed_solid(walls);
        --rooms;
      } else {
        whole.push_back(region);
      }
    }
    if (rooms > 1)
      for (const std::uint32_t region : whole) tell_isolated(region);
    tell_spanning();
    return std::move(told_);
  }

 private:
  const Face& face(PieceSideId side) const { return arrangement_.owner(side); }
  const Material* material(const Face& face) const {
    const Surface& surface = scene_.surfaces[face.surface];
    if (!face.is_back) return &scene_.materials[surface.material];
    return surface.back ? &scene_.materials[*surface.back] : nullptr;
  }
  const Segment2& piece(PieceSideId side) const { return arrangement_.piece(side); }

  // Some group has all its faces with a material in the unbounded region. (The underside of a box on a floor is there
  // too.)
  bool has_outsider() const {
    std::vector<char> is_outside(scene_.groups.size(), 1);
    for (std::uint32_t f = 0; f < region_of_face_.size(); ++f)
      if (region_of_face_[f] != kNone && region_of_face_[f] != 0 && material(Face::of(f)) != nullptr)
        is_outside[scene_.surfaces[Face::of(f).surface].group] = 0;
    return std::any_of(residents_[0].begin(), residents_[0].end(),
                       [&](const Face& f) { return is_outside[scene_.surfaces[f.surface].group] != 0; });
  }

  // The sides around the region that something else lies behind; those of what stands in it left out.
  std::vector<PieceSideId> outer_walls(std::uint32_t region) const {
    VertexUnion parts;
    VertexId least = piece(regions_.sides(region).front()).a;
    for (const PieceSideId side : regions_.sides(region)) {
      parts.join(piece(side).a, piece(side).b);
      for (const VertexId v : {piece(side).a, piece(side).b})
        if (arrangement_.vertices().precedes(v, least)) least = v;
    }
    std::vector<PieceSideId> walls;
    for (const PieceSideId side : regions_.sides(region))
      if (regions_.of(opposite(side)) != region && parts.root(piece(side).a) == parts.root(least))
        walls.push_back(side);
    return walls;
  }

  std::vector<std::uint32_t> surfaces_of(const std::vector<PieceSideId>& sides) const {
    std::vector<std::uint32_t> surfaces;
    for (const PieceSideId side : sides) surfaces.push_back(face(side).surface);
    std::sort(surfaces.begin(), surfaces.end());
    surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
    return surfaces;
  }

  std::vector<std::uint32_t> black_surfaces(const std::vector<PieceSideId>& walls) const {
    std::vector<PieceSideId> black;
    std::copy_if(walls.begin(), walls.end(), std::back_inserter(black),
                 [this](PieceSideId side) { return material(face(side)) == nullptr; });
    return surfaces_of(black);
  }

  // Walls whose fronts alone stand in the region, do not emit, and turn black backs to one region with other faces in
  // it.
  bool is_reversed_solid(std::uint32_t region, const std::vector<PieceSideId>& walls) const {
    const std::uint32_t around = regions_.of(opposite(walls.front()));
    if (residents_[around].empty() || regions_.sides(region).size() != walls.size()) return false;
    return std::all_of(walls.begin(), walls.end(), [&](PieceSideId side) {
      return !face(side).is_back && !arrangement_.is_covered(opposite(side)) &&
             material(face(side))->emission.is_zero() && regions_.of(opposite(side)) == around &&
             material(face(opposite(side))) == nullptr;
    });
  }

  // Behind these walls nothing stands but their own fronts, which do not emit.
  bool fronts_see_nothing(const std::vector<PieceSideId>& walls) const {
    const std::vector<std::uint32_t> own = surfaces_of(walls);
    const auto is_own = [&](std::uint32_t s) {
      return std::ranges::any_of(
          own, [&](std::uint32_t wall) { return s == wall || arrangement_.patches().rests_on(s, wall); });
    };
    return std::all_of(walls.begin(), walls.end(), [&](PieceSideId side) {
      const auto& behind = residents_[regions_.of(opposite(side))];
      return std::all_of(behind.begin(), behind.end(), [&](const Face& f) {
        return !f.is_back && material(f)->emission.is_zero() && is_own(f.surface);
      });
    });
  }

  void add(Severity severity, const char* kind, const std::vector<std::uint32_t>& surfaces, std::string message,
           std::string suggestion) {
    told_.findings.push_back(
        {severity, kind, surfaces, middle(scene_.edges[surfaces.front()]), std::move(message), std::move(suggestion)});
  }

  void add_inside_out(const std::vector<std::uint32_t>& surfaces, std::string message, std::string suggestion) {
    for (const std::uint32_t s : surfaces) told_.is_inside_out[s] = 1;
    add(Severity::kWarning, "inside-out", surfaces, std::move(message), std::move(suggestion));
  }

  // Returns true when all walls are black.
  bool tell_black(const std::vector<PieceSideId>& walls) {
    const std::vector<std::uint32_t> black = black_surfaces(walls);
    if (black.empty() || black.size() != surfaces_of(walls).size()) return false;
    if (fronts_see_nothing(walls)) told_.certainly_reversed.push_back(black);
    add_inside_out(black,
                   fmt::format("the room within {} has black walls: their fronts look outward, their backs toward what "
                               "stands in the room",
                               names_text(scene_, black)),
                   "list the points the other way round (clockwise around a room), or give a \"back\"");
    return true;
  }

  void tell_reversed_solid(const std::vector<PieceSideId>& walls) {
    const std::vector<std::uint32_t> surfaces = surfaces_of(walls);
    told_.certainly_reversed.push_back(surfaces);
    add_inside_out(
        surfaces,
        fmt::format("{} enclose a space without light that their fronts look into; what stands around them sees black "
                    "backs",
                    names_text(scene_, surfaces)),
        "list the points the other way round (counter-clockwise around a solid), or give a \"back\"");
  }

  void tell_isolated(std::uint32_t region) {
    std::vector<std::uint32_t> surfaces;
    for (const Face& f : residents_[region])
      if (surfaces.empty() || surfaces.back() != f.surface) surfaces.push_back(f.surface);
    add(Severity::kNote, "isolated-cell", surfaces,
        fmt::format("nothing passes between the room of {} and the rest of the scene", names_text(scene_, surfaces)),
        "nothing to do where that is meant");
  }

  // Where a vertex lies on a surface: 0 at its first point, 1 at its second.
  Rational place_on(const Edge2& edge, VertexId v) const {
    return position_on(edge, arrangement_.vertices().to_scene(arrangement_.vertices().exact(v)));
  }

  // The elements of its face that a side begins and ends in. (All between lie on it wholly.)
  std::array<Integer, 2> end_elements(PieceSideId side) const {
    const Surface& surface = scene_.surfaces[face(side).surface];
    const Edge2& edge = scene_.edges[face(side).surface];
    Rational low = place_on(edge, piece(side).a), high = place_on(edge, piece(side).b);
    if (high < low) std::swap(low, high);
    low *= surface.elements;
    high *= surface.elements;
    std::array<Integer, 2> ends;
    mpz_fdiv_q(ends[0].get_mpz_t(), low.get_num_mpz_t(), low.get_den_mpz_t());
    mpz_cdiv_q(ends[1].get_mpz_t(), high.get_num_mpz_t(), high.get_den_mpz_t());
    --ends[1];
    return ends;
  }

  // Faces with an element that a wall divides.
  void tell_spanning() {
    std::map<std::pair<Face, Integer>, std::uint32_t> room_of_element;
    std::vector<char> is_told(region_of_face_.size(), 0);
    for (const PieceSideId side : arrangement_.sides()) {
      if (arrangement_.is_covered(side)) continue;
      const std::uint32_t region = regions_.of(side);
      const Face f = face(side);
      if (region_of_face_[f.number()] != kSeveral || material(f) == nullptr || residents_[region].empty()) continue;
      for (const Integer& element : end_elements(side)) {
        if (room_of_element.try_emplace({f, element}, region).first->second == region || is_told[f.number()] != 0)
          continue;
        is_told[f.number()] = 1;
        add(Severity::kWarning, "spans-rooms", {f.surface},
            fmt::format("the {} of {} stands in several rooms between which nothing passes, but has one radiosity: in "
                        "a solution it carries light from one room to the other",
                        f.is_back ? "back" : "front", names_text(scene_, {f.surface})),
            "give each room a surface of its own, or divide it so that \"elements\" end where the rooms do");
      }
    }
  }

  const Scene2& scene_;
  const Arrangement2& arrangement_;
  const FreeRegions2& regions_;
  std::vector<std::uint32_t> region_of_face_;  // by Face::number(); kNone: owns nothing, kSeveral
  std::vector<std::vector<Face>> residents_;   // by region: faces with a material that are wholly in it
  RegionFindings2 told_;
};

}  // namespace

RegionFindings2 region_findings(const PreparedScene2& prepared, const FreeRegions2& regions) {
  return RegionTeller(prepared, regions).tell();
}

}  // namespace hottel
