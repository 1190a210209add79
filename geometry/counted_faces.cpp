#include "geometry/counted_faces.h"

#include <algorithm>
#include <cmath>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::size_t kLeastFound = 4;

// Faces, drawn as often as they have elements.
class Urn {
 public:
  Urn(std::span<const CountedFace> faces, bool takes_all) {
    for (const CountedFace& face : faces) {
      if (!takes_all && !face.has_row) continue;
      faces_.push_back(face);
      ends_.push_back((ends_.empty() ? 0 : ends_.back()) + static_cast<double>(face.elements));
    }
  }

  double elements() const { return ends_.empty() ? 0 : ends_.back(); }

  DrawnFace draw(SampleChance& chance) const {
    const double place = chance.share() * elements();
    const auto end = std::upper_bound(ends_.begin(), ends_.end() - 1, place);
    const CountedFace& face = faces_[static_cast<std::size_t>(end - ends_.begin())];
    const double before = *end - static_cast<double>(face.elements);
    return {face, std::clamp((place - before) / static_cast<double>(face.elements), 0.0, std::nextafter(1.0, 0.0))};
  }

 private:
  std::vector<CountedFace> faces_;
  std::vector<double> ends_;
};

}  // namespace

std::vector<CountedFace> counted_faces(const SceneTable& scene, Granularity granularity,
                                       const std::function<std::uint64_t(std::uint32_t surface)>& parts) {
  std::vector<CountedFace> faces;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    std::uint64_t whole = 0;  // parts of the surface, once they are known
    for (const bool is_back : {false, true}) {
      CountedFace face{s, is_back, 1, surface.material_of(is_back).has_value()};
      if (granularity == Granularity::kElement && face.has_row) {
        const std::uint64_t leaves = surface.trees.of(is_back).size();
        if (leaves == 0 && surface.elements > 1 && whole == 0) whole = parts(s);
        face.elements = std::max<std::uint64_t>({1, leaves, leaves == 0 ? whole : 0});
      }
      faces.push_back(face);
    }
  }
  return faces;
}

ElementPairCounts pair_counts(std::span<const CountedFace> faces) {
  ElementPairCounts counts;
  double within = 0;  // twice the pairs of elements of one face with rows
  for (const CountedFace& face : faces) {
    const auto n = static_cast<double>(face.elements);
    counts.elements += n;
    if (!face.has_row) continue;
    counts.rows += n;
    within += n * (n - 1);
  }
  counts.pairs = (counts.rows * (counts.rows - 1) - within) / 2 + counts.rows * (counts.elements - counts.rows);
  return counts;
}

SampledPairs sampled_pairs(
    std::span<const CountedFace> faces, std::size_t samples,
    const std::function<bool(const DrawnFace& a, const DrawnFace& b, SampleChance& chance)>& sees) {
  const Urn rows(faces, false), all(faces, true);
  HOTTEL_REQUIRE(samples > 0 && rows.elements() > 0 && all.elements() > 1);
  SampleChance chance;
  std::size_t found = 0;
  double sum = 0;
  for (std::size_t k = 0; k < samples; ++k) {
    const DrawnFace a = rows.draw(chance), b = all.draw(chance);
    const bool is_one_surface = a.face.surface == b.face.surface;
    if (is_one_surface || !sees(a, b, chance)) continue;
    ++found;
    sum += b.face.has_row ? 0.5 : 1;  // a pair of two rows is drawn from both ends
  }
  const double population = rows.elements() * all.elements() / static_cast<double>(samples);
  return {(found >= kLeastFound ? sum : static_cast<double>(kLeastFound)) * population, found >= kLeastFound};
}

}  // namespace hottel
