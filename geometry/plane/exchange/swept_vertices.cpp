#include "geometry/plane/exchange/swept_vertices.h"

#include <algorithm>
#include <mutex>

#include "geometry/plane/visibility/visible_lines.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

// To look for vertices costs about half of what their sweep does: not worth it where most of them are found.
constexpr std::uint32_t kFew = 8;

bool has_few_rows(const ElementTable2& table) {
  std::uint32_t rows = 0;
  for (std::uint32_t label = 0; label < table.count(); ++label) rows += table.has_row(label) ? 1 : 0;
  return rows < table.count() / kFew;
}

// Follows gaps that have an element with a row at one end, or on them.
class Search {
 public:
  Search(const Arrangement2& arrangement, const ElementTable2& table)
      : arrangement_(arrangement), table_(table), is_found_(arrangement.vertices().size(), 0) {}

  std::vector<VertexId> found() {
    std::vector<VertexId> last = ends_of_rows();
    while (!last.empty()) last = next_to(last);
    return in_order();
  }

 private:
  std::vector<VertexId> ends_of_rows() {
    std::vector<VertexId> ends;
    for (const PieceSideId side : arrangement_.sides())
      if (table_.has_row(table_.of(side)))
        for (const VertexId end : {arrangement_.piece(side).a, arrangement_.piece(side).b}) note(end, ends);
    return ends;
  }
  std::vector<VertexId> next_to(const std::vector<VertexId>& last) {
    std::vector<VertexId> all;
    std::mutex together;
    parallel_ranges(last.size(), 1, [&](std::size_t begin, std::size_t end) {
      std::vector<VertexId> met;
      for (std::size_t k = begin; k < end; ++k) look_from(last[k], met);
      const std::lock_guard lock(together);
      for (const VertexId v : met) note(v, all);
    });
    return all;
  }
  void look_from(VertexId v, std::vector<VertexId>& met) const {
    thread_local View2 view;
    look_around(arrangement_.vertices(), arrangement_.triangulation(), v, view);
    for_each_gap(arrangement_.vertices(), v, view, false, [&](const Gap2& gap) {
      if (has_row(gap)) met.push_back(gap.w);
    });
  }
  bool has_row(const Gap2& gap) const {
    const auto is_row = [this](PieceSideId side) { return table_.has_row(table_.of(side)); };
    if (is_row(gap.behind_left) || is_row(gap.behind_right) || is_row(gap.ahead_left) || is_row(gap.ahead_right))
      return true;
    return gap.covered_left != kNoPiece && (is_row(gap.covered_left) || is_row(gap.covered_right));
  }
  void note(VertexId v, std::vector<VertexId>& first_found) {
    if (is_found_[v.index()] != 0) return;
    is_found_[v.index()] = 1;
    first_found.push_back(v);
  }
  std::vector<VertexId> in_order() const {
    std::vector<VertexId> result;
    for (const VertexId v : arrangement_.triangulation().sweep_order())
      if (is_found_[v.index()] != 0) result.push_back(v);
    return result;
  }

  const Arrangement2& arrangement_;
  const ElementTable2& table_;
  std::vector<char> is_found_;
};

}  // namespace

std::vector<VertexId> swept_vertices(const Arrangement2& arrangement, const ElementTable2& table) {
  const auto all = arrangement.triangulation().sweep_order();
  if (!has_few_rows(table)) return {all.begin(), all.end()};
  return Search(arrangement, table).found();
}

}  // namespace hottel
