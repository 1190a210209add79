#include "geometry/plane/arrangement/solids.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "geometry/plane/arrangement/behind_errors.h"
#include "geometry/plane/arrangement/winding.h"

namespace hottel {
namespace {

using Groups = std::vector<std::uint32_t>;

// What a closed outline may be.
enum class Role : unsigned char { kNone, kSolid, kRoom };

// Whose "behind" is looked at.
enum class Looks : bool { kStated, kAll };

class SolidFinder {
 public:
  explicit SolidFinder(const BarePieces2& pieces, Looks looks = Looks::kStated)
      : scene_(pieces.scene),
        free_regions_(pieces.regions),
        overlay_(pieces.overlay),
        looks_(looks),
        group_count_(scene_.groups.size()) {
    find_roles(pieces.closed);
    const std::size_t piece_count = free_regions_.side_count() / 2;
    for (std::size_t piece = 0; piece < piece_count; ++piece) look_at(piece, pieces.sources(piece));
    std::sort(backs_.begin(), backs_.end());
  }

  void find() {
    judge_windings();
    find_rooms_within();
    solid_.assign(free_regions_.count(), Solids2::kNone);
    open_.assign(free_regions_.count(), Solids2::kNone);
    fill_outlines();
    fill_behind();
    refuse_conflicts();
  }

  std::vector<std::uint32_t> makers() const {
    std::vector<std::uint32_t> makers(free_regions_.side_count());
    for (const PieceSideId side : IdRange<PieceSideId>(makers.size()))
      makers[side.index()] = solid_[free_regions_.of(side)];
    return makers;
  }
  // REQUIRES Looks::kAll, and find() before.
  std::vector<Groups> regions_behind() {
    std::vector<Groups> regions(group_count_);
    for (auto& [group, sight] : sight_) {
      if (behind(group) != Behind::kByOutline || is_contested(group)) continue;
      std::sort(sight.fronted.begin(), sight.fronted.end());
      Groups& region = regions[group];
      bool is_refused = false;
      for (const PieceSideId side : sight.backs) {
        const std::uint32_t free_region = free_regions_.of(side);
        if (!is_behind(sight, free_region)) continue;
        is_refused |= open_[free_region] != Solids2::kNone;
        if (solid_[free_region] == Solids2::kNone) region.push_back(free_region);
      }
      std::sort(region.begin(), region.end());
      region.erase(std::unique(region.begin(), region.end()), region.end());
      if (is_refused) region.clear();
    }
    return regions;
  }
  std::vector<std::pair<PieceSideId, std::uint32_t>> bounding() {
    std::sort(bounding_.begin(), bounding_.end());
    bounding_.erase(std::unique(bounding_.begin(), bounding_.end()), bounding_.end());
    return std::move(bounding_);
  }

 private:
  // What a group with "behind" looks at.
  struct Sight {
    std::vector<PieceSideId> backs;      // sides where a back of it without material looks
    std::vector<std::uint32_t> fronted;  // regions that a front of it looks into
  };

  Behind behind(std::uint32_t group) const { return scene_.groups[group].behind; }
  // A bounded region that no front of the group looks into. REQUIRES sorted fronted regions.
  static bool is_behind(const Sight& sight, std::uint32_t free_region) {
    return free_region != 0 && !std::binary_search(sight.fronted.begin(), sight.fronted.end(), free_region);
  }

  // Does the outline of a group enclose what another one says is open?
  bool is_contested(std::uint32_t group) const {
    return std::any_of(outlined_.lower_bound({group, 0}), outlined_.lower_bound({group + 1, 0}),
                       [&](const auto& outlined) { return open_[outlined.second] != Solids2::kNone; });
  }

  void find_roles(const std::vector<ClosedGroup2>& closed_groups) {
    role_.assign(group_count_, Role::kNone);
    for (const ClosedGroup2& closed : closed_groups) {
      if (closed.turn > 0 && !closed.has_back) role_[closed.group] = Role::kSolid;
      if (closed.turn < 0) role_[closed.group] = Role::kRoom;
    }
  }

  void look_at(std::size_t piece, const std::vector<PieceSource2>& sources) {
    std::vector<NetRun2> runs;
    for (const PieceSource2& source : sources) {
      const Surface& surface = scene_.surfaces[source.surface];
      if (surface.on) continue;  // a patch bounds nothing: what it lies on does
      if (looks_ == Looks::kAll || behind(surface.group) != Behind::kByOutline) {
        const PieceSideId left = left_side(piece), right = right_side(piece);
        Sight& sight = sight_[surface.group];
        sight.fronted.push_back(free_regions_.of(source.is_reversed ? left : right));
        if (!surface.back) sight.backs.push_back(source.is_reversed ? right : left);
      }
      if (role_[surface.group] == Role::kNone) continue;
      if (role_[surface.group] == Role::kSolid)
        backs_.emplace_back(source.is_reversed ? right_side(piece) : left_side(piece), surface.group);
      const auto run =
          std::find_if(runs.begin(), runs.end(), [&](const NetRun2& r) { return r.group == surface.group; });
      const std::int32_t step = source.is_reversed ? -1 : 1;
      if (run == runs.end())
        runs.push_back({surface.group, step});
      else
        run->net += step;
    }
    std::erase_if(runs, [](const NetRun2& run) { return run.net == 0; });
    runs_.add_piece(runs);
  }

  // Outlines with other winding numbers are neither solids nor rooms.
  void judge_windings() {
    walk_regions(
        free_regions_, runs_, group_count_,
        [this](std::uint32_t group, std::int32_t, std::int32_t now) {
          if (now != 0 && now != (role_[group] == Role::kSolid ? 1 : -1)) role_[group] = Role::kNone;
        },
        [](std::uint32_t) {});
  }

  // The side of a piece where the winding number of a room is not 0.
  static PieceSideId inner_side_of_room(std::size_t piece, const NetRun2& run) {
    return run.net > 0 ? right_side(piece) : left_side(piece);
  }

  // For each room the solids that it is in.
  void find_rooms_within() {
    if (std::find(role_.begin(), role_.end(), Role::kRoom) == role_.end()) return;
    std::vector<char> is_known(group_count_, 0);
    within_.resize(group_count_);
    std::set<std::uint32_t> around;
    walk_regions(
        free_regions_, runs_, group_count_,
        [&](std::uint32_t group, std::int32_t, std::int32_t now) {
          if (role_[group] != Role::kSolid) return;
          if (now == 1)
            around.insert(group);
          else
            around.erase(group);
        },
        [&](std::uint32_t free_region) {
          for (const PieceSideId side : free_regions_.sides(free_region))
            for (const NetRun2& run : runs_.of(piece_of(side))) {
              if (role_[run.group] != Role::kRoom || inner_side_of_room(piece_of(side), run) != side) continue;
              Groups& within = within_[run.group];
              if (is_known[run.group] == 0)
                within.assign(around.begin(), around.end());
              else
                std::erase_if(within, [&](std::uint32_t solid) { return !around.contains(solid); });
              is_known[run.group] = 1;
            }
        });
  }

  void fill_outlines() {
    std::vector<std::uint32_t> rooms(group_count_, 0);  // by solid: how many rooms in it hold the region
    std::vector<char> is_around(group_count_, 0);
    std::set<std::uint32_t> makers[2];  // of solid, of open regions
    const auto update = [&](std::uint32_t solid) {
      std::set<std::uint32_t>& set = makers[behind(solid) == Behind::kOpen ? 1 : 0];
      if (is_around[solid] != 0 && rooms[solid] == 0)
        set.insert(solid);
      else
        set.erase(solid);
    };
    walk_regions(
        free_regions_, runs_, group_count_,
        [&](std::uint32_t group, std::int32_t before, std::int32_t now) {
          if (role_[group] == Role::kSolid) {
            is_around[group] = now == 1;
            update(group);
          } else if (role_[group] == Role::kRoom) {
            for (const std::uint32_t solid : within_[group]) {
              if (now == -1) ++rooms[solid];
              if (before == -1) --rooms[solid];
              update(solid);
            }
          }
        },
        [&](std::uint32_t free_region) {
          if (!makers[0].empty()) solid_[free_region] = *makers[0].begin();
          if (!makers[1].empty()) open_[free_region] = *makers[1].begin();
          for (const std::uint32_t maker : makers[0]) {
            if (behind(maker) == Behind::kSolid) stated_solid_.emplace(free_region, maker);
            if (looks_ == Looks::kAll) outlined_.emplace(maker, free_region);
          }
          if (makers[0].empty()) return;
          for (const PieceSideId side : free_regions_.sides(free_region))
            for (auto back = std::lower_bound(backs_.begin(), backs_.end(), std::pair(side, std::uint32_t{0}));
                 back != backs_.end() && back->first == side; ++back)
              if (makers[0].contains(back->second)) bounding_.push_back(*back);
        });
  }

  void fill_behind() {
    for (auto& [group, sight] : sight_) {
      if (behind(group) == Behind::kByOutline) continue;
      std::sort(sight.fronted.begin(), sight.fronted.end());
      const bool is_outline = role_[group] == Role::kSolid;
      if (behind(group) == Behind::kOpen && is_outline) continue;
      bool bounds_some = false;
      for (const PieceSideId side : sight.backs) {
        const std::uint32_t free_region = free_regions_.of(side);
        if (!is_behind(sight, free_region)) continue;
        bounds_some = true;
        if (behind(group) == Behind::kOpen) {
          open_[free_region] = std::min(open_[free_region], group);
          continue;
        }
        solid_[free_region] = std::min(solid_[free_region], group);
        stated_solid_.emplace(free_region, group);
        bounding_.emplace_back(side, group);
      }
      if (behind(group) == Behind::kSolid && !bounds_some && !is_outline)
        refuse_unbounded({scene_, overlay_, free_regions_, group, sight.backs});
    }
  }

  // One group says that a region is solid, another that it is open.
  void refuse_conflicts() const {
    for (const auto& [free_region, solid] : stated_solid_)
      if (open_[free_region] != Solids2::kNone) refuse_conflict(scene_, solid, open_[free_region]);
  }

  const Scene2& scene_;
  const FreeRegions2& free_regions_;
  const Overlay2& overlay_;
  const Looks looks_;
  const std::size_t group_count_;
  std::vector<Role> role_;  // by group
  NetRuns2 runs_;
  std::vector<std::pair<PieceSideId, std::uint32_t>> backs_;        // of outlines: side and group, sorted
  std::map<std::uint32_t, Sight> sight_;                            // by group whose "behind" is looked at
  std::vector<Groups> within_;                                      // by room: the solids it is in
  std::vector<std::uint32_t> solid_;                                // by region: the first group that makes it solid
  std::vector<std::uint32_t> open_;                                 // by region: the first group that says it is open
  std::set<std::pair<std::uint32_t, std::uint32_t>> stated_solid_;  // region and group that says so
  std::set<std::pair<std::uint32_t, std::uint32_t>> outlined_;      // group and region that its outline makes solid
  std::vector<std::pair<PieceSideId, std::uint32_t>> bounding_;
};

}  // namespace

Solids2::Solids2(const BarePieces2& pieces) {
  SolidFinder finder(pieces);
  finder.find();
  maker_ = finder.makers();
  if (std::all_of(maker_.begin(), maker_.end(), [](std::uint32_t maker) { return maker == kNone; })) maker_.clear();
  bounding_ = finder.bounding();
}

bool Solids2::is_inside_of(PieceSideId side, std::uint32_t group) const {
  return std::binary_search(bounding_.begin(), bounding_.end(), std::pair(side, group));
}

Solids2 Solids2::restricted_to(const std::vector<std::uint32_t>& pieces) const {
  Solids2 result;
  if (is_empty()) return result;
  for (const std::uint32_t piece : pieces)
    for (const PieceSideId side : sides_of(piece)) result.maker_.push_back(maker_[side.index()]);
  return result;
}

Solids2 Solids2::cut_into(const std::vector<std::uint32_t>& whole) const {
  Solids2 result = restricted_to(whole);
  for (std::uint32_t part = 0; part < whole.size() && !bounding_.empty(); ++part) {
    const auto sides = sides_of(part), before = sides_of(whole[part]);
    for (std::size_t k = 0; k < sides.size(); ++k)
      for (auto at = std::ranges::lower_bound(bounding_, before[k], {}, &std::pair<PieceSideId, std::uint32_t>::first);
           at != bounding_.end() && at->first == before[k]; ++at)
        result.bounding_.emplace_back(sides[k], at->second);
  }
  return result;
}

std::vector<std::vector<std::uint32_t>> regions_behind(const BarePieces2& pieces) {
  SolidFinder finder(pieces, Looks::kAll);
  finder.find();
  return finder.regions_behind();
}

bool may_have_solids(const Scene2& scene, const std::vector<ClosedGroup2>& closed) {
  const auto says = [](const Group& group) { return group.behind != Behind::kByOutline; };
  if (std::any_of(scene.groups.begin(), scene.groups.end(), says)) return true;
  return std::any_of(closed.begin(), closed.end(),
                     [](const ClosedGroup2& group) { return group.turn > 0 && !group.has_back; });
}

}  // namespace hottel
