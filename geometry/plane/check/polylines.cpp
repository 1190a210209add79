#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "geometry/name.h"
#include "geometry/plane/check/repair.h"
#include "geometry/plane/scene/patches.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

struct Piece {
  Surface surface;
  Edge2 edge;
  std::string former_name;
  std::uint32_t place;  // where it stood
};
using Pieces = std::vector<Piece>;

bool follow_each_other(const Pieces& pieces) {
  return std::adjacent_find(pieces.begin(), pieces.end(),
                            [](const Piece& a, const Piece& b) { return a.edge.to != b.edge.from; }) == pieces.end();
}

class PolylineRestorer {
 public:
  explicit PolylineRestorer(Repair2& repair) : repair_(repair), scene_(repair.scene) {
    HOTTEL_REQUIRE(repair.former_names.size() == scene_.surfaces.size());
  }

  void restore() {
    for (std::size_t begin = 0, end = 0; begin < scene_.surfaces.size(); begin = end) {
      const std::uint32_t group = scene_.surfaces[begin].group;
      Pieces pieces;
      for (; end < scene_.surfaces.size() && scene_.surfaces[end].group == group; ++end)
        pieces.push_back(
            {scene_.surfaces[end], scene_.edges[end], repair_.former_names[end], static_cast<std::uint32_t>(end)});
      const std::string& name = scene_.groups[group].name;
      const bool was_polyline = pieces.front().surface.name.starts_with(name + "[");
      Pieces& list = was_polyline && is_restored(name, pieces) ? polylines_ : edges_;
      std::move(pieces.begin(), pieces.end(), std::back_inserter(list));
    }
    const Scene2 before = scene_.bases.empty() ? Scene2() : scene_;
    std::vector<std::optional<std::uint32_t>> place(before.surfaces.size());
    scene_.surfaces.clear();
    scene_.edges.clear();
    repair_.former_names.clear();
    for (Pieces* list : {&edges_, &polylines_})
      for (Piece& piece : *list) {
        if (!place.empty()) place[piece.place] = static_cast<std::uint32_t>(scene_.surfaces.size());
        if (list == &edges_) part_from_group(piece.surface);
        scene_.add(std::move(piece.surface), std::move(piece.edge));
        repair_.former_names.push_back(std::move(piece.former_name));
      }
    rename_bases(before, place, scene_);
  }

 private:
  // A file has no group for edges that were a polyline: what lies on that has to name one of them.
  void part_from_group(Surface& surface) {
    const Group& group = scene_.groups[surface.group];
    if (scene_.bases.empty() || group.name == surface.name) return;
    Group own(surface.name, group.behind);
    surface.group = static_cast<std::uint32_t>(scene_.groups.size());
    scene_.groups.push_back(std::move(own));
  }

  // Whether the pieces are a polyline; then they are listed and named as its pieces.
  bool is_restored(const std::string& name, Pieces& pieces) {
    const bool is_as_listed = follow_each_other(pieces);
    if (!is_as_listed) {
      Pieces turned(pieces.rbegin(), pieces.rend());
      if (!follow_each_other(turned)) {
        repair_.steps.push_back(
            {"split", name,
             fmt::format("the pieces of {} do not follow each other any more: they are edges now", quoted_name(name))});
        return false;
      }
      pieces = std::move(turned);
    }
    std::string first;  // that has another name
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const std::string now = piece_name(name, k);
      if (std::string& own = pieces[k].surface.name; own != now) {
        if (first.empty()) first = fmt::format("{} is {} now", quoted_name(own), quoted_name(now));
        own = now;
      }
    }
    if (!first.empty())
      repair_.steps.push_back({"renumbered", name,
                               fmt::format("the pieces of {} are {}: {}", quoted_name(name),
                                           is_as_listed ? "counted anew" : "listed the other way round", first)});
    return true;
  }

  Repair2& repair_;
  Scene2& scene_;
  Pieces edges_, polylines_;
};

}  // namespace

void restore_polylines(Repair2& repair) { PolylineRestorer(repair).restore(); }

}  // namespace hottel
