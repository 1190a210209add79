#include "geometry/check/contacts_2.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/arrangement/overlay_2.h"
#include "geometry/arrangement/point_index_2.h"
#include "geometry/check/wording.h"

namespace hottel {
namespace {

// The scene laid over itself; surface s is segment s.
class ContactFinder {
 public:
  explicit ContactFinder(const Scene2& scene) : scene_(scene) {
    PointIndex2 index;
    for (const Surface2& surface : scene.surfaces)
      segments_.push_back({index.insert(to_exact(surface.from)), index.insert(to_exact(surface.to))});
    overlay_ = overlay(index.points(), segments_);
  }

  Contacts2 find() {
    find_points();
    find_overlaps();
    find_duplicates();
    find_areas();
    return std::move(found_);
  }

 private:
  using At = std::pair<VertexId, std::uint32_t>;  // a surface at a vertex

  Point2 place(VertexId v) const { return to_point(overlay_.vertices.to_scene(overlay_.vertices.exact(v))); }

  bool are_parallel(std::uint32_t s, std::uint32_t t) const {  // REQUIRES a common point
    const Segment2 &a = segments_[s], &b = segments_[t];
    return overlay_.vertices.orientation(a.a, a.b, b.a) == 0 && overlay_.vertices.orientation(a.a, a.b, b.b) == 0;
  }

  // Crossings and junctions: vertices inside at least one surface.
  void find_points() {
    std::vector<At> through, ends;
    for (std::size_t p = 0; p < overlay_.pieces.size(); ++p)
      for (const std::uint32_t s : overlay_.sources(p))
        for (const VertexId v : {overlay_.pieces[p].a, overlay_.pieces[p].b})
          if (v != segments_[s].a && v != segments_[s].b) through.emplace_back(v, s);
    std::sort(through.begin(), through.end());
    through.erase(std::unique(through.begin(), through.end()), through.end());
    for (std::uint32_t s = 0; s < segments_.size(); ++s)
      for (const VertexId v : {segments_[s].a, segments_[s].b}) ends.emplace_back(v, s);
    std::sort(ends.begin(), ends.end());

    auto end = ends.begin();
    for (auto begin = through.begin(); begin != through.end();) {
      const VertexId v = begin->first;
      std::vector<std::uint32_t> inside, ending;
      for (; begin != through.end() && begin->first == v; ++begin) inside.push_back(begin->second);
      while (end != ends.end() && end->first < v) ++end;
      for (; end != ends.end() && end->first == v; ++end) ending.push_back(end->second);
      add_point(v, inside, ending);
    }
  }

  void add_point(VertexId v, const std::vector<std::uint32_t>& inside, const std::vector<std::uint32_t>& ending) {
    // All that share a point and are parallel lie on one line: one of them stands for the others.
    const auto are_on_one_line = [this](const std::vector<std::uint32_t>& surfaces) {
      return std::all_of(surfaces.begin(), surfaces.end(),
                         [&](std::uint32_t t) { return are_parallel(surfaces.front(), t); });
    };
    const bool through_one_line = are_on_one_line(inside), ends_on_one_line = are_on_one_line(ending);
    if (!through_one_line) found_.crossings.push_back({place(v), inside});
    Junction2 junction;
    for (const std::uint32_t s : ending)
      if (!through_one_line || !are_parallel(s, inside.front())) junction.ends.push_back(s);
    if (junction.ends.empty()) return;
    for (const std::uint32_t s : inside)
      if (!ends_on_one_line || !are_parallel(s, ending.front())) junction.through.push_back(s);
    junction.at = place(v);
    found_.junctions.push_back(std::move(junction));
  }

  std::vector<PieceSource2> covering(std::size_t piece) const {
    const Vertices2& vertices = overlay_.vertices;
    const bool ascends = vertices.precedes(overlay_.pieces[piece].a, overlay_.pieces[piece].b);
    std::vector<PieceSource2> result;
    for (const std::uint32_t s : overlay_.sources(piece))
      result.push_back({s, 0, vertices.precedes(segments_[s].a, segments_[s].b) != ascends});
    return result;
  }

  // Pieces with several sources are in order along their first source.
  void find_overlaps() {
    std::size_t last = 0;  // the piece before, when it belongs to the overlap that is open
    for (std::size_t p = 0; p < overlay_.pieces.size(); ++p) {
      const auto sources = overlay_.sources(p);
      if (sources.size() < 2) continue;
      const bool goes_on = p > 0 && last + 1 == p && !found_.overlaps.empty() &&
                           overlay_.pieces[last].b == overlay_.pieces[p].a &&
                           std::ranges::equal(sources, overlay_.sources(last));
      if (!goes_on) found_.overlaps.push_back({place(overlay_.pieces[p].a), {}, covering(p)});
      found_.overlaps.back().to = place(overlay_.pieces[p].b);
      last = p;
    }
  }

  void find_duplicates() {
    std::map<std::pair<VertexId, VertexId>, std::vector<std::uint32_t>> by_ends;
    for (std::uint32_t s = 0; s < segments_.size(); ++s)
      by_ends[std::minmax(segments_[s].a, segments_[s].b)].push_back(s);
    for (auto& [ends, surfaces] : by_ends)
      if (surfaces.size() > 1) found_.duplicates.push_back(std::move(surfaces));
  }

  void find_areas() {
    found_.has_area.assign(2 * scene_.surfaces.size(), 0);
    for (std::size_t p = 0; p < overlay_.pieces.size(); ++p) {
      const std::vector<PieceSource2> on_piece = covering(p);
      for (const bool right : {false, true}) {
        const auto [owner, rival] = owner_of_side(scene_, on_piece, right);
        found_.has_area[2 * owner.face.surface + (owner.face.is_back ? 1 : 0)] = 1;
        if (rival) found_.has_area[2 * rival->face.surface + (rival->face.is_back ? 1 : 0)] = 1;
      }
    }
  }

  const Scene2& scene_;
  std::vector<Segment2> segments_;
  Overlay2 overlay_;
  Contacts2 found_;
};

}  // namespace

Contacts2 find_contacts(const Scene2& scene) { return ContactFinder(scene).find(); }

}  // namespace hottel
