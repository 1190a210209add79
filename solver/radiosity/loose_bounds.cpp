#include "solver/radiosity/loose_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hottel {
namespace {

constexpr std::size_t kMostNamed = 3;
constexpr double kNarrow = 1e-9;            // relative
constexpr double kTimesTheBrightest = 1e3;  // so much wider, relatively, than beside the brightest is wide

struct Faint {
  double width = 0;  // relative
  std::uint32_t element = 0;
};

// The widest first.
std::vector<Faint> faint_of(const ChannelSolution& channel) {
  double brightest = 0, widest = 0;
  const auto is_bounded = [](const ElementRadiosity& e) { return e.radiosity > 0 && std::isfinite(e.upper); };
  for (const ElementRadiosity& e : channel.elements) {
    if (!is_bounded(e)) continue;
    brightest = std::max(brightest, e.radiosity);
    widest = std::max(widest, e.upper - e.lower);
  }
  const double ordinary = std::max(kNarrow, kTimesTheBrightest * (brightest > 0 ? widest / brightest : 0));
  std::vector<Faint> result;
  for (std::uint32_t i = 0; i < channel.elements.size(); ++i) {
    const ElementRadiosity& e = channel.elements[i];
    const double width = is_bounded(e) ? (e.upper - e.lower) / e.radiosity : 0;
    if (width > ordinary) result.push_back({width, i});
  }
  std::stable_sort(result.begin(), result.end(), [](const Faint& a, const Faint& b) { return a.width > b.width; });
  return result;
}

}  // namespace

std::vector<std::string> notes_of_loose_bounds(const ExchangeMatrix& matrix, const RadiositySolution& solution) {
  std::vector<std::string> notes;
  for (std::size_t c = 0; c < solution.channels.size(); ++c) {
    const std::vector<Faint> faint = faint_of(solution.channels[c]);
    if (faint.empty()) continue;
    std::string note = fmt::format("relative accuracy is lost in {} radiosit{} far below the brightest", faint.size(),
                                   faint.size() == 1 ? "y" : "ies");
    if (solution.channels.size() > 1) note += fmt::format(" ({})", solution.channel_names[c]);
    const std::size_t named = std::min(faint.size(), kMostNamed);
    for (std::size_t k = 0; k < named; ++k)
      note += fmt::format("{} the bounds of '{}' are {:.2g} times its value apart", k == 0 ? ":" : ",",
                          matrix.elements()[faint[k].element].name, faint[k].width);
    if (named < faint.size()) note += fmt::format(" and {} more", faint.size() - named);
    notes.push_back(note);
  }
  return notes;
}

}  // namespace hottel
