#include "geometry/plane/prepared/element_table.h"

#include <algorithm>
#include <limits>
#include <map>

#include "geometry/face.h"
#include "geometry/plane/scene/division.h"
#include "geometry/scene_names.h"
#include "geometry/unit_of_length.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// For each part of a surface that is cut, the leaf it lies in.
std::vector<std::uint32_t> leaf_of_parts(const SurfaceCuts2& cuts, std::uint32_t parts,
                                         const std::vector<TreeNode>& leaves) {
  std::vector<std::uint32_t> result;
  std::uint32_t leaf = 0;
  for (std::size_t k = 0; k < cuts.count(); ++k) {
    if (k > 0 && EdgeSpan2::of(parts, leaves[leaf]).to <= cuts.at[k - 1]) ++leaf;
    result.push_back(leaf);
  }
  return result;
}

}  // namespace

ElementTable2::ElementTable2(const Scene2& scene, const Arrangement2& arrangement, const Division2& division,
                             Granularity granularity)
    : metres_(metres_per_unit(scene)) {
  // First label of each front and back.
  std::vector<std::uint32_t> first[2];
  first[0].resize(scene.surfaces.size());
  first[1].resize(scene.surfaces.size());
  std::vector<std::uint32_t> group_label[2];
  // Where a face has fewer leaves than its surface has parts: by surface.
  std::map<std::uint32_t, std::vector<std::uint32_t>> leaf_of_part[2];
  for (auto& table : group_label) table.assign(scene.groups.size(), std::numeric_limits<std::uint32_t>::max());
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    for (const bool back : {false, true}) {
      const std::optional<std::uint32_t> material = surface.material_of(back);
      if (granularity == Granularity::kGroup) {
        // Both labels of a group are made with its first surface, so that front stands before back.
        if (group_label[back][surface.group] == std::numeric_limits<std::uint32_t>::max()) {
          group_label[back][surface.group] = count();
          elements_.push_back({side_text({scene.groups[surface.group].name, back}), s, 0, 1, back, material, {}});
        } else if (material) {
          elements_[group_label[back][surface.group]].material = material;
        }
        first[back][s] = group_label[back][surface.group];
        continue;
      }
      const std::string name = face_name(scene, {s, back});
      first[back][s] = count();
      const bool is_divided = granularity == Granularity::kElement && material && division[s].is_cut();
      if (!is_divided) {
        elements_.push_back({name, s, 0, 1, back, material, {}});
        continue;
      }
      const std::uint32_t parts = surface.elements;
      const std::vector<TreeNode>& trees = surface.trees.of(back);
      const std::vector<TreeNode> leaves = trees.empty() ? uniform_leaves(parts, 2, 0) : trees;
      for (const TreeNode& leaf : leaves)
        elements_.push_back({element_name(name, parts, leaf), s, leaf.part, parts, back, material, {}, leaf.path});
      if (leaves.size() < division[s].count()) leaf_of_part[back].emplace(s, leaf_of_parts(division[s], parts, leaves));
    }
  }

  const auto leaf_of = [&leaf_of_part](const FacePart2& owner) {
    const auto& table = leaf_of_part[owner.is_back];
    const auto place = table.find(owner.surface);
    return place == table.end() ? owner.part : place->second[owner.part];
  };
  are_straight_ = granularity != Granularity::kGroup;
  of_side_.assign(arrangement.side_count() + 1, covered());
  of_side_[place_after_sky(kSky)] = sky();
  for (const PieceSideId side : arrangement.sides()) {
    if (arrangement.is_covered(side)) continue;
    const FacePart2& owner = arrangement.owner(side);
    const std::uint32_t label = first[owner.is_back][owner.surface];
    of_side_[place_after_sky(side)] = label + (elements_[label].is_part() ? leaf_of(owner) : 0);
  }
  measure(arrangement);
}

ElementTable2 ElementTable2::restricted_to(std::uint32_t i, std::uint32_t j, const std::vector<std::uint32_t>& pieces,
                                           const Arrangement2& arrangement_of_pieces) const {
  ElementTable2 result;
  result.are_straight_ = are_straight_;
  result.metres_ = metres_;
  result.elements_.push_back(elements_[i]);
  if (j != i) result.elements_.push_back(elements_[j]);
  result.of_side_.push_back(result.sky());
  for (const std::uint32_t piece : pieces)
    for (const PieceSideId side : sides_of(piece)) {
      const std::uint32_t label = of(side);
      result.of_side_.push_back(label == i ? 0 : label == j ? 1 : result.covered());
    }
  result.measure(arrangement_of_pieces);
  return result;
}

void ElementTable2::keep_rows(const std::vector<bool>& is_chosen) {
  HOTTEL_REQUIRE(is_chosen.size() == count());
  for (std::uint32_t label = 0; label < count(); ++label)
    labels_[label].has_row = labels_[label].has_row && is_chosen[label];
}

void ElementTable2::measure(const Arrangement2& arrangement) {
  const Vertices2& vertices = arrangement.vertices();
  length_.assign(elements_.size(), {});
  for (const PieceSideId side : arrangement.sides()) {
    if (of(side) >= count()) continue;
    const Segment2& piece = arrangement.piece(side);
    const FixedLength2 length = vertices.distance(piece.a, piece.b);
    FixedSum& sum = length_[of(side)];
    sum.value += length.value;
    if (!length.is_exact) sum.error += vertices.length_error();
  }
  find_runs(arrangement);

  const Rational scale = vertices.scale() * metres_;
  const FixedScale unit(vertices.fixed_unit() * scale);
  for (std::uint32_t label = 0; label < count(); ++label)
    if (const auto quick = round_scaled(length_[label], unit))
      elements_[label].area = quick->number;
    else
      elements_[label].area = round_quotient(exact_length(label, vertices) * scale, RootSum(Rational(1))).number;
  labels_.assign(elements_.size() + 2, {VertexId::none(), VertexId::none(), false});
  for (std::uint32_t label = 0; label < count(); ++label) {
    labels_[label].has_row = elements_[label].material.has_value() && !runs(label).empty();
    if (runs(label).size() != 1) continue;
    labels_[label].from = runs(label).front().a;
    labels_[label].to = runs(label).front().b;
  }
}

void ElementTable2::find_runs(const Arrangement2& arrangement) {
  // Sides by label, each run with its front on the right.
  std::vector<std::size_t> begin(elements_.size() + 1, 0);
  const auto is_covered = [this](PieceSideId side) { return of(side) >= count(); };
  for (const PieceSideId side : arrangement.sides())
    if (!is_covered(side)) ++begin[of(side) + 1];
  for (std::size_t label = 0; label < elements_.size(); ++label) begin[label + 1] += begin[label];
  std::vector<Segment2> directed(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (const PieceSideId side : arrangement.sides())
    if (!is_covered(side)) directed[next[of(side)]++] = arrangement.turned_piece(side);
  const Vertices2& vertices = arrangement.vertices();
  runs_begin_.push_back(0);
  for (std::size_t label = 0; label < elements_.size(); ++label) {
    const auto from = directed.begin() + static_cast<std::ptrdiff_t>(begin[label]);
    const auto to = directed.begin() + static_cast<std::ptrdiff_t>(begin[label + 1]);
    if (are_straight_)
      std::sort(from, to, [&](const Segment2& s, const Segment2& t) {
        return s.a != t.a && vertices.precedes(s.a, s.b) == vertices.precedes(s.a, t.a);
      });
    const std::size_t first_run = runs_.size();
    for (auto piece = from; piece != to; ++piece) {
      // A run that turns back on itself is two.
      const bool continues = runs_.size() > first_run && runs_.back().b == piece->a &&
                             vertices.orientation(runs_.back().a, runs_.back().b, piece->b) == 0 &&
                             vertices.is_between(runs_.back().a, piece->b, piece->a);
      if (continues)
        runs_.back().b = piece->b;
      else
        runs_.push_back(*piece);
    }
    runs_begin_.push_back(runs_.size());
  }
}

RootSum ElementTable2::exact_length(std::uint32_t label, const Vertices2& vertices) const {
  RootSum length;
  for (const Segment2& run : runs(label)) length.add(1, vertices.squared_distance(run.a, run.b));
  return length;
}

}  // namespace hottel
