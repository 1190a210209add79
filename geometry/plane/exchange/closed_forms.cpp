#include "geometry/plane/exchange/closed_forms.h"

#include <algorithm>

#include "geometry/plane/exchange/exact_sums.h"
#include "geometry/plane/exchange/pair_alone.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// S(i, j) in scene units.
std::vector<RootSum> scaled_sums(const PreparedScene2& prepared, const ElementTable2& table,
                                 const std::vector<ElementPair>& pairs) {
  std::vector<RootSum> sums = exact_sums(prepared.arrangement, table, pairs);
  for (RootSum& sum : sums) sum *= prepared.arrangement.vertices().scale() / 2;
  return sums;
}

}  // namespace

std::vector<RootSum> exact_exchange_measures(const PreparedScene2& prepared, Granularity granularity,
                                             const std::vector<ElementPair>& pairs) {
  return scaled_sums(prepared, *prepared.elements(granularity), pairs);
}

ExactPair2 exact_pair(const PreparedScene2& prepared, Granularity granularity, std::uint32_t from, std::uint32_t to) {
  return exact_pair(prepared, *prepared.elements(granularity), granularity, from, to);
}

ExactPair2 exact_pair(const PreparedScene2& prepared, const ElementTable2& table, Granularity granularity,
                      std::uint32_t from, std::uint32_t to) {
  HOTTEL_REQUIRE(from < table.count() && to <= table.sky());
  const Vertices2& vertices = prepared.arrangement.vertices();
  ExactPair2 result;
  result.exchange = scaled_sums(prepared, table, {{std::min(from, to), std::max(from, to)}}).front();
  result.area_from = table.exact_length(from, vertices) * vertices.scale();
  if (to == table.sky()) {
    result.unobstructed = result.area_from;
  } else {
    result.area_to = table.exact_length(to, vertices) * vertices.scale();
    result.unobstructed = PairsAlone2(prepared, table, granularity).exact(from, to);
  }
  return result;
}

std::vector<RootSum> exact_areas(const PreparedScene2& prepared, Granularity granularity) {
  const ElementTable2& table = *prepared.elements(granularity);
  const Vertices2& vertices = prepared.arrangement.vertices();
  std::vector<RootSum> areas;
  for (std::uint32_t label = 0; label < table.count(); ++label)
    areas.push_back(table.exact_length(label, vertices) * vertices.scale());
  return areas;
}

ExactPair2 exact_pair(const PreparedScene2& prepared, const std::optional<Face>& a, const std::optional<Face>& b) {
  const ElementTable2& table = *prepared.elements(Granularity::kFace);
  const auto label_of = [&](const std::optional<Face>& face) {
    if (!face) return table.sky();
    HOTTEL_REQUIRE(face->surface < prepared.scene.surfaces.size());
    const auto& elements = table.elements();
    return static_cast<std::uint32_t>(
        std::find_if(elements.begin(), elements.end(),
                     [&](const Element& e) { return e.surface == face->surface && e.is_back == face->is_back; }) -
        elements.begin());
  };
  if (a) return exact_pair(prepared, table, Granularity::kFace, label_of(a), label_of(b));
  ExactPair2 pair = exact_pair(prepared, table, Granularity::kFace, label_of(b), label_of(a));
  std::swap(pair.area_from, pair.area_to);
  return pair;
}

}  // namespace hottel
