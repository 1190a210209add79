#include "geometry/factor_changes.h"

#include <map>
#include <string_view>
#include <unordered_map>

namespace hottel {
namespace {

using FormerName = std::function<std::string(const Element&)>;

// The faces of both matrices, by name; the sky last.
class FaceTable {
 public:
  FaceTable(const ExchangeMatrix& before, const ExchangeMatrix& after, const FormerName& former_name) {
    for (const Element& element : before.elements()) of_before_.push_back(number_of(element.name));
    for (const Element& element : after.elements()) of_after_.push_back(number_of(former_name(element)));
    for (auto* here : {&of_before_, &of_after_}) here->push_back(number_of(before.name(before.sky())));
    before_ = indices(of_before_);
    after_ = indices(of_after_);
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(names_.size()); }
  const std::string& name(std::uint32_t face) const { return names_[face]; }

  // One row of one of the matrices, by number here; nothing where there is none.
  std::optional<std::map<std::uint32_t, Rounded>> row(const ExchangeMatrix& matrix, bool is_after,
                                                      std::uint32_t face) const {
    const auto own = (is_after ? after_ : before_)[face];
    if (!own || *own == matrix.sky() || !matrix.has_row(*own)) return std::nullopt;
    std::map<std::uint32_t, Rounded> row;
    for (const FactorEntry& entry : matrix.row(*own)) row[(is_after ? of_after_ : of_before_)[entry.to]] = entry.factor;
    return row;
  }
  bool is_in(bool is_after, std::uint32_t face) const { return (is_after ? after_ : before_)[face].has_value(); }

 private:
  std::uint32_t number_of(const std::string& name) {
    const auto [place, is_new] = number_.try_emplace(name, count());
    if (is_new) names_.push_back(name);
    return place->second;
  }
  std::vector<std::optional<std::uint32_t>> indices(const std::vector<std::uint32_t>& here) const {
    std::vector<std::optional<std::uint32_t>> own(names_.size());
    for (std::uint32_t i = 0; i < here.size(); ++i) own[here[i]] = i;
    return own;
  }

  std::vector<std::string> names_;
  std::unordered_map<std::string, std::uint32_t> number_;
  std::vector<std::optional<std::uint32_t>> before_, after_;  // indices in the matrices, by number here
  std::vector<std::uint32_t> of_before_, of_after_;           // and back
};

}  // namespace

std::vector<FactorChange> factor_changes(const ExchangeMatrix& before, const ExchangeMatrix& after,
                                         const FormerName& former_name) {
  const FaceTable faces(before, after, former_name);
  std::vector<FactorChange> changes;
  for (std::uint32_t from = 0; from < faces.count(); ++from) {
    const auto old_row = faces.row(before, false, from), new_row = faces.row(after, true, from);
    std::map<std::uint32_t, std::pair<Rounded, Rounded>> pairs;
    if (old_row)
      for (const auto& [to, factor] : *old_row) pairs[to].first = factor;
    if (new_row)
      for (const auto& [to, factor] : *new_row) pairs[to].second = factor;
    for (const auto& [to, pair] : pairs) {
      FactorChange change{faces.name(from), faces.name(to), std::nullopt, std::nullopt};
      if (old_row && faces.is_in(false, to)) change.before = pair.first.value;
      if (new_row && faces.is_in(true, to)) change.after = pair.second.value;
      if (change.before == change.after) continue;
      changes.push_back(std::move(change));
    }
  }
  return changes;
}

}  // namespace hottel
