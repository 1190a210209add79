#include "geometry/plane/exchange/pair_alone.h"

#include <algorithm>
#include <iterator>

#include "geometry/plane/exchange/exact_sums.h"
#include "geometry/plane/exchange/unobstructed.h"

namespace hottel {

PairsAlone2::PairsAlone2(const PreparedScene2& prepared, const ElementTable2& table, Granularity granularity)
    : prepared_(prepared), table_(table) {
  if (granularity != Granularity::kGroup) return;
  const Scene2& scene = prepared.scene;
  size_ = group_sizes(scene);
  pieces_of_.resize(scene.groups.size());
  for (std::uint32_t piece = 0; piece < prepared.arrangement.pieces().size(); ++piece)
    for (const PieceSource2& source : prepared.arrangement.sources(piece))
      if (auto& pieces = pieces_of_[scene.surfaces[source.surface].group]; pieces.empty() || pieces.back() != piece)
        pieces.push_back(piece);
}

std::optional<FixedSum> PairsAlone2::quick(std::uint32_t i, std::uint32_t j) const {
  if (!are_straight(i, j)) return std::nullopt;
  FixedSum total;
  for (const Segment2& f : table_.runs(i))
    for (const Segment2& g : table_.runs(j)) {
      const auto sum = unobstructed_sum(prepared_.arrangement.vertices(), f, g);
      if (!sum) return std::nullopt;
      total.value += sum->value;
      total.error += sum->error;
    }
  return total;
}

RootSum PairsAlone2::exact(std::uint32_t i, std::uint32_t j) const {
  const Vertices2& vertices = prepared_.arrangement.vertices();
  RootSum sum;
  if (are_straight(i, j)) {
    for (const Segment2& f : table_.runs(i))
      for (const Segment2& g : table_.runs(j)) sum += unobstructed_exact(vertices, f, g);
    sum *= vertices.scale() / 2;
    return sum;
  }
  if (!have_facing_runs(i, j)) return sum;
  std::vector<std::uint32_t> pieces;
  std::set_union(pieces_of_[group_of(i)].begin(), pieces_of_[group_of(i)].end(), pieces_of_[group_of(j)].begin(),
                 pieces_of_[group_of(j)].end(), std::back_inserter(pieces));
  const Arrangement2 alone = prepared_.arrangement.restricted_to(pieces);
  const ElementTable2 table = table_.restricted_to(i, j, pieces, alone);
  sum = exact_sums(alone, table, {{0, j == i ? 0 : 1}}).front();
  sum *= alone.vertices().scale() / 2;
  return sum;
}

bool PairsAlone2::have_facing_runs(std::uint32_t i, std::uint32_t j) const {
  for (const Segment2& f : table_.runs(i))
    for (const Segment2& g : table_.runs(j))
      if (face_each_other(prepared_.arrangement.vertices(), f, g)) return true;
  return false;
}

bool PairsAlone2::is_positive(std::uint32_t i, std::uint32_t j) const {
  return have_facing_runs(i, j) && (are_straight(i, j) || !exact(i, j).is_zero());
}

double PairsAlone2::factor(std::uint32_t i, std::uint32_t j) const {
  const Vertices2& vertices = prepared_.arrangement.vertices();
  const auto free = quick(i, j);
  if (free && free->value == 0 && free->error == 0) return 0;
  const FixedSum length{2 * table_.length(i).value, 2 * table_.length(i).error};
  if (free && static_cast<double>(length.value) > length.error)
    if (const auto rounded = round_quotient(*free, length)) return rounded->number.value;
  const RootSum sum = exact(i, j);
  if (sum.is_zero()) return 0;
  return round_quotient(sum, table_.exact_length(i, vertices) * vertices.scale()).number.value;
}

}  // namespace hottel
