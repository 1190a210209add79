#include "io/scene/passed_over.h"

#include <utility>

namespace hottel {
namespace {

// One of a kind, and several.
using Noun = std::pair<const char*, const char*>;
constexpr std::array<Noun, 8> kNouns{{{"repeated point", "repeated points"},
                                      {"empty geometry", "empty geometries"},
                                      {"face without area", "faces without area"},
                                      {"line without length", "lines without length"},
                                      {"point", "points"},
                                      {"line", "lines"},
                                      {"third coordinate", "third coordinates"},
                                      {"missing file of materials", "missing files of materials"}}};

}  // namespace

void PassedOver::add(PassedKind kind, const FileLine& where, const std::string& name, std::size_t count) {
  Kind& own = all_[static_cast<std::size_t>(kind)];
  if (own.count == 0 && count > 0) own.first = (name.empty() ? "" : name + " ") + "at " + where.text();
  own.count += count;
}

void PassedOver::add(const PassedOver& other) {
  for (std::size_t k = 0; k < kKinds; ++k) {
    if (all_[k].count == 0) all_[k].first = other.all_[k].first;
    all_[k].count += other.all_[k].count;
  }
}

std::string PassedOver::note() const {
  static_assert(kNouns.size() == kKinds);
  std::string text;
  for (std::size_t k = 0; k < kKinds; ++k) {
    const Kind& own = all_[k];
    if (own.count == 0) continue;
    text += text.empty() ? "" : "\n";
    text += std::to_string(own.count) + " " + (own.count == 1 ? kNouns[k].first : kNouns[k].second) + " passed over" +
            (own.count == 1 ? own.first.starts_with("at ") ? " " : ": " : ", the first ") + own.first;
  }
  return text;
}

}  // namespace hottel
