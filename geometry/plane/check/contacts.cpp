#include "geometry/plane/check/contacts.h"

#include <algorithm>
#include <map>
#include <utility>

namespace hottel {
namespace {

class ContactFinder {
 public:
  ContactFinder(const Scene2& scene, const Arrangement2& arrangement)
      : scene_(scene),
        arrangement_(arrangement),
        rank_(arrangement.vertices().size(), kNoRank),
        is_free_(arrangement.vertices().size(), 0) {
    std::uint32_t next = 0;
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
      segments_.push_back(arrangement.segment(s));
      for (const VertexId v : {segments_[s].a, segments_[s].b})
        if (rank_[v.index()] == kNoRank) rank_[v.index()] = next++;
    }
    for (std::size_t p = 0; p < arrangement.pieces().size(); ++p) {
      covering_.push_back(arrangement.sources(p));
      if (arrangement.is_covered(left_side(p)) && arrangement.is_covered(right_side(p))) continue;
      for (const VertexId v : {arrangement.pieces()[p].a, arrangement.pieces()[p].b}) is_free_[v.index()] = 1;
    }
  }

  Contacts2 find() {
    find_points();
    find_overlaps();
    find_duplicates();
    found_.faces = FaceCover2(scene_, arrangement_);
    return std::move(found_);
  }

 private:
  static constexpr std::uint32_t kNoRank = 0xffffffff;

  // A surface at a vertex. Vertices in the order in which surfaces end there; where none does, as they are numbered.
  struct At {
    std::uint32_t rank;
    VertexId vertex;
    std::uint32_t surface;
    auto operator<=>(const At&) const = default;
  };

  const Vertices2& vertices() const { return arrangement_.vertices(); }
  const std::vector<Segment2>& pieces() const { return arrangement_.pieces(); }
  Point2 place(VertexId v) const { return vertices().to_scene(vertices().exact(v)); }

  bool are_parallel(std::uint32_t s, std::uint32_t t) const {  // REQUIRES a common point
    const Segment2 &a = segments_[s], &b = segments_[t];
    return vertices().orientation(a.a, a.b, b.a) == 0 && vertices().orientation(a.a, a.b, b.b) == 0;
  }

  // Crossings and junctions: vertices inside at least one surface.
  void find_points() {
    std::vector<At> through, ends;
    for (std::size_t p = 0; p < pieces().size(); ++p)
      for (const PieceSource2& source : covering_[p])
        for (const VertexId v : {pieces()[p].a, pieces()[p].b})
          if (v != segments_[source.surface].a && v != segments_[source.surface].b)
            through.push_back({rank_[v.index()], v, source.surface});
    std::sort(through.begin(), through.end());
    through.erase(std::unique(through.begin(), through.end()), through.end());
    for (std::uint32_t s = 0; s < segments_.size(); ++s)
      for (const VertexId v : {segments_[s].a, segments_[s].b}) ends.push_back({rank_[v.index()], v, s});
    std::sort(ends.begin(), ends.end());

    auto end = ends.begin();
    for (auto begin = through.begin(); begin != through.end();) {
      const auto [rank, v, first] = *begin;
      std::vector<std::uint32_t> inside, ending;
      for (; begin != through.end() && begin->vertex == v; ++begin) inside.push_back(begin->surface);
      while (end != ends.end() && end->rank < rank) ++end;
      for (; end != ends.end() && end->vertex == v; ++end) ending.push_back(end->surface);
      add_point(v, inside, ending);
    }
  }

  void add_point(VertexId v, const std::vector<std::uint32_t>& inside, const std::vector<std::uint32_t>& ending) {
    // All that share a point and are parallel lie on one line: one of them stands for the others.
    const auto are_on_one_line = [this](const std::vector<std::uint32_t>& surfaces) {
      return std::all_of(surfaces.begin(), surfaces.end(),
                         [&](std::uint32_t t) { return are_parallel(surfaces.front(), t); });
    };
    const bool is_in_solid = is_free_[v.index()] == 0;
    const bool through_one_line = are_on_one_line(inside), ends_on_one_line = are_on_one_line(ending);
    if (!through_one_line) found_.crossings.push_back({place(v), inside, is_in_solid});
    Junction2 junction;
    for (const std::uint32_t s : ending)
      if (!through_one_line || !are_parallel(s, inside.front())) junction.ends.push_back(s);
    if (junction.ends.empty()) return;
    for (const std::uint32_t s : inside)
      if (!ends_on_one_line || !are_parallel(s, ending.front())) junction.through.push_back(s);
    junction.at = place(v);
    junction.is_in_solid = is_in_solid;
    found_.junctions.push_back(std::move(junction));
  }

  OverlapSide2 overlap_side(PieceSideId side) const {
    if (arrangement_.is_covered(side)) return {arrangement_.solids().maker(side)};
    return {Solids2::kNone, arrangement_.claims(scene_, side)};
  }
  static bool are_same(const OverlapSide2& a, const OverlapSide2& b) {
    return a.solid == b.solid && a.claims.owner.face == b.claims.owner.face;
  }

  // Pieces with several sources are in order along their first source.
  void find_overlaps() {
    std::size_t last = 0;  // the piece before, when it belongs to the overlap that is open
    for (std::size_t p = 0; p < pieces().size(); ++p) {
      if (covering_[p].size() < 2) continue;
      std::array<OverlapSide2, 2> sides{overlap_side(left_side(p)), overlap_side(right_side(p))};
      const bool goes_on =
          p > 0 && last + 1 == p && !found_.overlaps.empty() && pieces()[last].b == pieces()[p].a &&
          std::ranges::equal(covering_[p], covering_[last], {}, &PieceSource2::surface, &PieceSource2::surface) &&
          are_same(sides[0], found_.overlaps.back().sides[0]) && are_same(sides[1], found_.overlaps.back().sides[1]);
      if (!goes_on) found_.overlaps.push_back({place(pieces()[p].a), {}, covering_[p], std::move(sides)});
      found_.overlaps.back().to = place(pieces()[p].b);
      last = p;
    }
  }

  void find_duplicates() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> by_ends;
    for (std::uint32_t s = 0; s < segments_.size(); ++s)
      by_ends[std::minmax(rank_[segments_[s].a.index()], rank_[segments_[s].b.index()])].push_back(s);
    for (auto& [ends, surfaces] : by_ends)
      if (surfaces.size() > 1) found_.duplicates.push_back(std::move(surfaces));
  }

  const Scene2& scene_;
  const Arrangement2& arrangement_;
  std::vector<Segment2> segments_;                   // by surface
  std::vector<std::vector<PieceSource2>> covering_;  // by piece
  std::vector<std::uint32_t> rank_;                  // by vertex
  std::vector<char> is_free_;                        // by vertex: some side of a piece there is not covered
  Contacts2 found_;
};

}  // namespace

Contacts2 find_contacts(const Scene2& scene, const Arrangement2& arrangement) {
  return ContactFinder(scene, arrangement).find();
}

Contacts2 find_contacts(const Scene2& scene) {
  return find_contacts(scene, Arrangement2(scene, Division2(scene.surfaces.size(), 1), Conflicts2::kFirstWins));
}

}  // namespace hottel
