#include "solver/memory_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/memory_text.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "solver/radiosity/radiosity_options.h"

namespace hottel {
namespace {

// A system of so few unknowns is held as a dense matrix, another one by its entries; what each takes, and an unknown
// by channel. A cell of light by channel, and a pixel.
constexpr double kBytesPerDenseEntry = 24, kBytesPerEntry = 24, kBytesPerUnknown = 400, kBytesPerCell = 16,
                 kBytesPerPixel = 24;

std::string count_text(double count) {
  return count < 1e6 ? fmt::format("{:.0f}", count) : fmt::format("{:.2g}", count);
}

// Never beyond what a count holds.
std::uint64_t times(std::uint64_t count, double parts) {
  constexpr double kMost = 1e18;
  return static_cast<std::uint64_t>(std::min(kMost, static_cast<double>(count) * parts));
}

// What helps, as sentences.
std::string remedy_text(bool may_allow_more, bool may_take_fewer) {
  if (!may_take_fewer) return may_allow_more ? ". Allow more (--memory)" : "";
  return std::string(may_allow_more ? ". Allow more (--memory), take" : ". Take") +
         " fewer elements, or a larger element size";
}

}  // namespace

MemoryEstimate::MemoryEstimate(std::vector<CountedFace> faces, const MemoryQuestion& question, const TableBytes& bytes,
                               double room, const PairSampling& sampling) {
  if (question.granularity == Granularity::kElement)
    for (CountedFace& face : faces)
      if (face.has_row) face.elements = times(face.elements, question.parts);
  const ElementPairCounts counts = pair_counts(faces);
  const double elements = counts.elements - static_cast<double>(faces.size());
  const double bytes_of_pair = question.pairs_on_disk ? 0 : bytes.pair;
  of_factors_ = elements * bytes.element;
  pairs_ = counts.pairs;
  const char* unit = "visible pairs";
  bool are_known = true;
  if (sampling && pairs_ > 0) {
    unit = "pairs at the most";
    are_known = of_factors_ + pairs_ * bytes_of_pair <= room;
    if (!are_known) {
      const SampledPairs sampled = sampling(faces);
      pairs_ = std::min(pairs_, sampled.pairs);
      are_known = sampled.is_known;
      if (are_known) unit = "visible pairs";
    }
  }
  stages_.push_back({"elements", elements, "elements that dividing adds", of_factors_});
  stages_.push_back({"view factors", pairs_, std::string(unit) + (question.pairs_on_disk ? ", on disk" : ""),
                     pairs_ * bytes_of_pair});
  known_pairs_ = are_known ? pairs_ : 0;
  peak_ = of_factors_ + pairs_ * bytes_of_pair;
  of_factors_ += known_pairs_ * bytes_of_pair;
  add_solution(counts, question, question.pairs_on_disk ? 0 : bytes.cached_pair);
}

void MemoryEstimate::add_solution(const ElementPairCounts& counts, const MemoryQuestion& question, double cached_pair) {
  const double elements = stages_[0].bytes;
  const auto add = [&](const char* name, double count, const char* unit, double bytes, double known_bytes) {
    if (count == 0) return;
    stages_.push_back({name, count, unit, bytes});
    peak_ = std::max(peak_, elements + pairs_ * cached_pair + bytes);
    of_solution_ = std::max(of_solution_, elements + known_pairs_ * cached_pair + known_bytes);
  };
  if (question.solves) {
    const auto bytes_with = [&](double pairs) {
      const bool is_dense = counts.rows <= kMostDenseUnknowns;
      const double entries = question.pairs_on_disk ? 0 : 2 * pairs;
      const double system = is_dense ? counts.rows * counts.rows * kBytesPerDenseEntry : entries * kBytesPerEntry;
      return system + counts.rows * question.channels * kBytesPerUnknown;
    };
    add("radiosity", counts.rows, "unknowns", bytes_with(pairs_), bytes_with(known_pairs_));
  }
  const double of_cells = static_cast<double>(question.cells) * question.channels * kBytesPerCell;
  add("illumination", static_cast<double>(question.cells), "cells", of_cells, of_cells);
  const double of_pixels = static_cast<double>(question.pixels) * kBytesPerPixel;
  add("picture", static_cast<double>(question.pixels), "pixels", of_pixels, of_pixels);
}

MemoryLimits memory_limits(std::uint64_t asked) {
  const std::uint64_t all = memory_allowed();
  return {asked > 0 ? asked : all, all};
}

std::string memory_problem(const MemoryEstimate& estimate, const MemoryLimits& limits) {
  const auto& elements = estimate.stages()[0];
  const auto& pairs = estimate.stages()[1];
  const bool are_factors = estimate.of_factors() > static_cast<double>(limits.of_factors);
  if (!are_factors && estimate.of_solution() <= static_cast<double>(limits.of_all)) return "";
  if (are_factors)
    return fmt::format("about {}{} {} need about {} of memory; the limit is {}{}",
                       elements.count > 0 ? fmt::format("{} {} and ", count_text(elements.count), elements.unit) : "",
                       count_text(pairs.count), pairs.unit, short_bytes(estimate.of_factors()),
                       limit_text(limits.of_factors), remedy_text(limits.of_factors<limits.of_all, elements.count> 0));
  const auto most = std::max_element(estimate.stages().begin() + 2, estimate.stages().end(),
                                     [](const MemoryStage& a, const MemoryStage& b) { return a.bytes < b.bytes; });
  return fmt::format("the {} of {} {} needs about {} of memory, with all that is there {}; the limit is {}", most->name,
                     count_text(most->count), most->unit, short_bytes(most->bytes), short_bytes(estimate.of_solution()),
                     limit_text(limits.of_all));
}

void require_memory_for(const SceneTable& scene, const MemoryQuestion& question, std::uint64_t asked,
                        const std::function<MemoryEstimate(double room)>& estimate) {
  if (question.granularity != Granularity::kElement || (!is_divided(scene) && question.parts <= 1)) return;
  const MemoryLimits limits = memory_limits(asked);
  const auto room = static_cast<double>(std::min(limits.of_factors, limits.of_all));
  if (const std::string problem = memory_problem(estimate(room), limits); !problem.empty())
    throw RequestError((scene.file.empty() ? "" : scene.file + ": ") + problem);
}

}  // namespace hottel
