#include "geometry/space/exchange/exchange.h"

#include <fmt/format.h>

#include <string>

#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/space/exchange/facing.h"
#include "geometry/space/exchange/groups_alone.h"
#include "geometry/space/exchange/pair_names.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/rational.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"

namespace hottel {

ExchangeMatrix exact_exchange(const PreparedScene3& prepared, const ExchangeRequest& request, ExchangeReport3* report) {
  ExchangeRows3 rows(prepared, request);
  rows.add_all(request.progress);
  return rows.matrix(report);
}

std::vector<ElementPair> hidden_pairs(const PreparedScene3& prepared, Granularity granularity,
                                      const ExchangeMatrix& matrix, const RowChoice& chosen) {
  const DefaultFloatingPoint arithmetic;
  const ElementTable3& table = *prepared.elements(granularity);
  const GroupsAlone3 groups(prepared, table, ExchangeRequest().tolerance);
  const auto is_positive = [&](std::uint32_t i, std::uint32_t j) {
    if (table.parts(i).empty() || table.parts(j).empty()) return false;
    if (!table.is_one_patch(i) || !table.is_one_patch(j)) return groups.measure(i, j).value > 0;
    return i != j && face_each_other(prepared.occluders(), table.parts(i).front(), table.parts(j).front());
  };
  std::vector<std::vector<ElementPair>> rows(table.count());
  parallel_for(table.count(), [&](std::size_t row) {
    throw_if_interrupted();
    const auto i = static_cast<std::uint32_t>(row);
    if (!matrix.has_row(i) || !chosen.has(matrix.elements()[i])) return;
    const auto entries = matrix.row(i);
    auto entry = entries.begin();
    for (std::uint32_t j = 0; j < table.count(); ++j) {
      while (entry != entries.end() && entry->to < j) ++entry;
      const bool is_there = entry != entries.end() && entry->to == j;
      if (!is_there && is_positive(i, j)) rows[row].emplace_back(i, j);
    }
    if (entries.empty() || entries.back().to != table.sky()) rows[row].emplace_back(i, table.sky());
  });
  std::vector<ElementPair> result;
  for (const auto& row : rows) result.insert(result.end(), row.begin(), row.end());
  return result;
}

namespace {

// Pairs that have no enclosure: how many, and the first of them.
class PairsWithoutEnclosure {
 public:
  void add(const ExchangeMatrix& matrix, const RowRange& rows) {
    for (std::uint32_t i = rows.first; i < rows.end; ++i)
      for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
        const std::uint32_t to = matrix.row(i)[k].to;
        // Each pair once: (to, i) is there too where `to` has a row.
        const bool is_told = to < i && matrix.has_row(to);
        if (is_told || matrix.guarantee(i, k) != Guarantee::kEstimated) continue;
        if (count_++ < kNamedPairs) text_ += (text_.empty() ? "" : "; ") + pair_text(matrix.elements(), i, to);
      }
  }
  void require_none(double tolerance) const {
    if (count_ == 0) return;
    throw RequestError(fmt::format("{} no enclosure within {}: {}{}",
                                   count_ == 1 ? "a pair has" : fmt::format("{} pairs have", count_),
                                   shortest(tolerance), text_, count_ > kNamedPairs ? "; ..." : ""));
  }

 private:
  std::size_t count_ = 0;
  std::string text_;
};

}  // namespace

void require_enclosed_3(const ExchangeMatrix& matrix, double tolerance) {
  PairsWithoutEnclosure pairs;
  pairs.add(matrix, {0, matrix.size()});
  pairs.require_none(tolerance);
}

void require_enclosed_3(RowRanges& rows, double tolerance) {
  PairsWithoutEnclosure pairs;
  for (std::size_t k = 0; k < rows.count(); ++k) {
    const RowRange range = rows.load(k);
    pairs.add(rows.matrix(), range);
  }
  pairs.require_none(tolerance);
}

}  // namespace hottel
