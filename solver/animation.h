// The frames of a scene whose lights move: factors of elements that were active before are not computed again.
#pragma once

#include <algorithm>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/element.h"
#include "geometry/exchange_matrix.h"
#include "kernel/rational.h"
#include "kernel/support/failure.h"
#include "kernel/support/stage.h"
#include "kernel/support/stopwatch.h"
#include "solver/cached_report.h"
#include "solver/refinement.h"
#include "solver/store.h"

namespace hottel {

// What a frame took.
struct FrameCounts {
  std::uint64_t elements = 0;            // active: with a row
  std::uint64_t activated = 0;           // of these, not active in the frame before; in the first one all
  std::uint64_t computed = 0, read = 0;  // pairs that exchange light: computed, and taken from what was kept
  double seconds = 0;                    // until there are radiosities
  double row_defect = 0;                 // how far the sum of a row is from 1, at most, before it is divided by it
};

// The elements of a matrix that have a row, ascending.
inline std::vector<ElementId> active_elements(const ExchangeMatrix& matrix) {
  std::vector<ElementId> active;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const Element& element = matrix.elements()[i];
    if (matrix.has_row(i)) active.push_back({{element.surface, element.is_back}, element.node()});
  }
  std::ranges::sort(active);
  return active;
}

// Throws RequestError naming the first frame that has a light on a surface, before any is computed.
template <class Scene>
void require_lights_beside_surfaces(const Scene& scene, std::uint32_t frames, const Rational& per_second) {
  for (std::uint32_t k = 0; k < frames; ++k) {
    const Rational time = Rational(k) / per_second;
    try {
      validate(scene_after(scene, time));
    } catch (const InputError& error) {
      const std::string place = FileLine{scene.file, error.where().line}.text(), what = error.what();
      throw RequestError(place + ": frame " + std::to_string(k) + ", at " + shortest(to_double(time)) +
                         " s: " + (what.starts_with(place + ": ") ? what.substr(place.size() + 2) : what));
    }
  }
}

// Frames of a scene, in any order.
//
//   (1) a frame is a function of the scene and its time: at(t).simulation has the values, bit for bit, of a new
//       simulation of scene_after(scene, t) with the trees of refined_trees
//   (2) where the same elements are active as in a frame before, no factor is computed; nor is one of a pair that a
//       store has. Matrices are kept, with what is ready to solve, as far as the memory goes; then those used longest
//       ago are given up
//   (3) the arrangement is made once, and trees once for each place of the lights
//   (4) counts depend on the frames before; how many elements are activated on the last one alone, or on that which
//       was told by follow()
//
// Simulation: Simulation2 or Simulation3, of the scene at rest; in space with rows by element. Kept: what a caller
// likes to keep beside a list of active elements, with about how many bytes() it takes.
template <class Simulation, class Kept>
class Animation {
 public:
  // memory: bytes for what is kept. store: that of the simulation's request, or null.
  Animation(Simulation still, const RefinementLevels& levels, std::uint64_t memory, std::shared_ptr<FactorStore> store)
      : still_(std::move(still)), levels_(levels), memory_(memory), store_(std::move(store)) {}

  struct Frame {
    Simulation simulation;
    FrameCounts counts;
    std::shared_ptr<Kept> kept;
  };

  // The frame after some seconds, with its radiosities. Throws as the stages of simulations do. REQUIRES that
  // scene_after is valid at that time.
  Frame at(const Rational& time, const StageProgress& progress = {}) {
    Stopwatch watch;
    FrameCounts counts;
    const Simulation moved = still_.with_scene(scene_after(still_.scene(), time));
    const Known& known = known_for(moved, counts, progress);
    Frame frame{known.simulation.with_scene(with_trees(moved.scene(), known.trees)), counts, known.kept};
    const auto factors = frame.simulation.factors(progress);
    frame.counts.row_defect = factors->row_defect();
    std::vector<ElementId> active = active_elements(factors->matrix);
    frame.counts.elements = active.size();
    frame.counts.activated = active.size() - common(active, active_);
    active_ = std::move(active);
    frame.simulation.radiosities(progress);
    frame.counts.seconds = watch.lap();
    give_up_what_is_too_much();
    return frame;
  }

  // The next frame comes after that of this time, which was made elsewhere. Where it is not called, the next one comes
  // after the last of at(). COST: that of the trees and of a table of elements; no factor is computed.
  void follow(const Rational& time, const StageProgress& progress = {}) {
    const Simulation moved = still_.with_scene(scene_after(still_.scene(), time));
    const Simulation divided = still_.with_trees(trees_of(moved, progress));
    const ExchangeMatrix empty(divided.prepared(progress)->elements(Granularity::kElement)->elements(),
                               Guarantee::kEstimated);
    active_ = active_elements(empty);
  }

 private:
  using Places = std::decay_t<decltype(std::declval<const Simulation&>().scene().light_places)>;

  // Trees, where lights stood that gave them, and what follows from them.
  struct Known {
    std::vector<SurfaceTrees> trees;
    std::vector<Places> lit;
    Simulation simulation;
    std::shared_ptr<Kept> kept;
    std::uint64_t bytes;

    bool came_of(const Places& places) const { return std::ranges::find(lit, places) != lit.end(); }
    void add(const Places& places) {
      if (lit.size() < kMostPlaces && !came_of(places)) lit.push_back(places);
    }
  };
  static constexpr std::size_t kMostPlaces = 1000;

  // What is known of the elements that the lights of a scene ask for: it is the first of the list then. Its simulation
  // has the lights where they stood at the beginning, so that nothing of a frame but what it shares is kept.
  const Known& known_for(const Simulation& moved, FrameCounts& counts, const StageProgress& progress) {
    const Places& places = moved.scene().light_places;
    auto place = std::ranges::find_if(known_, [&](const Known& known) { return known.came_of(places); });
    if (place == known_.end()) {
      std::vector<SurfaceTrees> trees = trees_of(moved, progress);
      place = std::ranges::find(known_, trees, &Known::trees);
      if (place == known_.end()) {
        make_known(std::move(trees), counts, progress);
        place = known_.begin();
      }
    }
    if (counts.computed == 0 && counts.read == 0) counts.read = pair_count(place->simulation.factors(progress)->matrix);
    known_.splice(known_.begin(), known_, place);
    place->add(places);
    return *place;
  }

  void make_known(std::vector<SurfaceTrees> trees, FrameCounts& counts, const StageProgress& progress) {
    Known known{trees, {}, still_.with_trees(trees), std::make_shared<Kept>(), 0};
    const StoreUse before = store_ ? store_->use() : StoreUse();
    const auto factors = known.simulation.factors(progress);
    known.simulation.system(progress);
    const StoreUse after = store_ ? store_->use() : StoreUse();
    counts.computed = store_ ? after.computed - before.computed : pair_count(factors->matrix);
    counts.read = after.read - before.read;
    known.bytes = bytes_of(factors->matrix);
    known_.push_front(std::move(known));
  }

  std::vector<SurfaceTrees> trees_of(const Simulation& moved, const StageProgress& progress) const {
    if (!levels_.is_any()) return std::vector<SurfaceTrees>(moved.scene().surfaces.size());
    return refined_trees(*moved.prepared(progress), levels_);
  }

  static std::uint64_t bytes_of(const ExchangeMatrix& matrix) {
    std::uint64_t entries = 0;
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      if (matrix.has_row(i)) entries += matrix.row(i).size();
    return 2 * entries * ExchangeMatrix::kBytesAnEntry + std::uint64_t{4} * matrix.size() * matrix.size();
  }

  static std::size_t common(const std::vector<ElementId>& a, const std::vector<ElementId>& b) {
    std::vector<ElementId> both;
    std::ranges::set_intersection(a, b, std::back_inserter(both));
    return both.size();
  }

  // Never what was used last.
  void give_up_what_is_too_much() {
    std::uint64_t all = 0;
    for (const Known& known : known_) all += known.bytes + known.kept->bytes();
    for (; all > memory_ && known_.size() > 1; known_.pop_back())
      all -= known_.back().bytes + known_.back().kept->bytes();
  }

  Simulation still_;
  RefinementLevels levels_;
  std::uint64_t memory_;
  std::shared_ptr<FactorStore> store_;
  std::list<Known> known_;  // what was used last comes first
  std::vector<ElementId> active_;
};

}  // namespace hottel
