#include "solver/dividing/dividing_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "geometry/face.h"
#include "geometry/scene_names.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "solver/compare/face_means.h"
#include "solver/dividing/merged_elements.h"
#include "solver/dividing/sampled_elements.h"
#include "solver/methods/coarsened.h"
#include "solver/radiosity/radiosity_solver.h"
#include "solver/radiosity/radiosity_sources.h"

namespace hottel {
namespace {

double middle(const RationalEnclosure& number) { return to_double((number.lower + number.upper) / 2); }

// The sources of merged elements: emissions stay, direct irradiances are means over the area.
RadiositySources merged_sources(const SolvedElements& solved, const ElementMerging& merging) {
  const RadiositySources fine = sources_of(solved.matrix, solved.scene, solved.lights);
  RadiositySources sources;
  sources.sky = fine.sky;
  sources.has_channels = fine.has_channels;
  sources.has_bands = fine.has_bands;
  if (fine.has_bands) sources.keeps_gains.resize(merging.merged.size());
  sources.emission.resize(merging.merged.size());
  if (!fine.withdrawn.empty()) sources.withdrawn.resize(merging.merged.size());
  std::vector<std::array<double, 3>> power(merging.merged.size(), {0, 0, 0});
  bool is_scalar = true;
  for (std::uint32_t i = 0; i < solved.matrix.size(); ++i) {
    sources.emission[merging.of[i]] = fine.emission[i];
    if (fine.has_bands) sources.keeps_gains[merging.of[i]] = fine.keeps_gains[i];
    if (!fine.withdrawn.empty()) sources.withdrawn[merging.of[i]] = fine.withdrawn[i];
    if (fine.direct_irradiance.empty()) continue;
    const SourceSpectrum& direct = fine.direct_irradiance[i];
    is_scalar = is_scalar && direct.is_scalar();
    for (int c = 0; c < 3; ++c)
      power[merging.of[i]][static_cast<std::size_t>(c)] += solved.matrix.elements()[i].area.value * middle(direct[c]);
  }
  if (fine.direct_irradiance.empty()) return sources;
  for (std::size_t label = 0; label < power.size(); ++label) {
    const double area = merging.merged[label].area.value;
    std::array<Enclosure, 3> direct;
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = area > 0 ? power[label][c] / area : 0;
      direct[c] = {value, value};
    }
    sources.direct_irradiance.push_back(is_scalar ? SourceSpectrum::scalar(direct[0]) : SourceSpectrum::of(direct));
  }
  return sources;
}

// The channels, with the largest radiosity of each; nothing is estimated yet.
DividingEstimate estimate_to_be(const SolvedElements& solved) {
  DividingEstimate estimate;
  for (std::size_t c = 0; c < solved.solution.channels.size(); ++c) {
    DividingEstimate::Channel& channel = estimate.channels.emplace_back();
    channel.name = solved.solution.channel_names[c];
    for (const ElementRadiosity& element : solved.solution.channels[c].elements)
      channel.largest = std::max(channel.largest, element.radiosity);
  }
  for (std::uint32_t i = 0; i < solved.matrix.size(); ++i) estimate.elements += solved.matrix.has_row(i) ? 1 : 0;
  return estimate;
}

// Whether some face with a material reflects.
bool reflects(const SceneTable& scene) {
  return std::ranges::any_of(scene.surfaces, [&](const Surface& surface) {
    return std::ranges::any_of(std::array{false, true}, [&](bool is_back) {
      const auto material = surface.material_of(is_back);
      return material && !scene.materials[*material].reflectivity.is_zero();
    });
  });
}

// Elements to be looked at, `most` at the most (sampled_elements). Of two halves that gather H in the mean none is
// further from it than H: so they are drawn by the square of what their element reflects, and no one of them says more
// than all others together.
std::vector<SampledElement> elements_to_look_at(const SolvedElements& solved, std::uint32_t most) {
  std::vector<double> importance(solved.matrix.size(), 0);
  for (const ChannelSolution& channel : solved.solution.channels) {
    double largest = 0;
    const auto reflected = [](const ElementRadiosity& element) { return element.reflectivity * element.irradiance; };
    for (const ElementRadiosity& element : channel.elements) largest = std::max(largest, reflected(element));
    for (std::size_t i = 0; largest > 0 && i < importance.size(); ++i) {
      const double share = std::max(0.0, reflected(channel.elements[i]) / largest);
      importance[i] += share * share;
    }
  }
  return sampled_elements(solved.matrix, importance, most);
}

// Sets the pointwise estimates. sights: the parts of each sample.
void set_pointwise(const SolvedElements& solved, std::span<const SampledElement> samples,
                   std::span<const std::vector<PartSight>> sights, DividingEstimate& estimate) {
  HOTTEL_REQUIRE(samples.size() == sights.size());
  estimate.looked_at = static_cast<std::uint32_t>(samples.size());
  long double area = 0;
  for (std::uint32_t i = 0; i < solved.matrix.size(); ++i)
    if (solved.matrix.has_row(i)) area += solved.matrix.elements()[i].area.value;
  for (std::size_t c = 0; c < estimate.channels.size(); ++c) {
    long double sum = 0;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const ElementRadiosity& element = solved.solution.channels[c].elements[samples[k].element];
      long double square = 0, share = 0;  // squares of doubles are beyond the range of doubles
      for (const PartSight& part : sights[k]) {
        const long double gathered = element.emission + element.reflectivity * part.irradiance[c];
        square += part.share * (gathered - element.radiosity) * (gathered - element.radiosity);
        share += part.share;
      }
      if (share > 0) sum += samples[k].weight * (square / share);
    }
    estimate.channels[c].pointwise = area > 0 ? static_cast<double>(std::sqrt(sum / area)) : 0;
  }
}

// Sets those of face means, or why there are none.
void set_face_means(const SolvedElements& solved, const ElementMerging& merging, DividingEstimate& estimate) {
  estimate.why_no_face_means = merging.why_none;
  if (!merging.why_none.empty()) return;
  try {
    const auto matrix =
        std::make_shared<const ExchangeMatrix>(merged_matrix(solved.matrix, merging.of, merging.merged));
    // Rows of sums do not sum to 1 to the last digit, so conjugate gradients are not theirs.
    const RadiosityOptions options{.solver = matrix->size() > kMostDenseUnknowns ? Solver::kBicgstab : Solver::kAuto};
    const RadiositySolution coarse = RadiositySolver(matrix, reflectivities_of(solved.scene.materials), options)
                                         .solve(merged_sources(solved, merging));
    const FaceMeans fine = face_mean_radiosities(solved.matrix, solved.solution);
    const FaceMeans merged = face_mean_radiosities(*matrix, coarse);
    for (std::size_t c = 0; c < estimate.channels.size(); ++c) {
      DividingEstimate::Channel& channel = estimate.channels[c];
      channel.face_means = 0;
      for (std::uint32_t face = 0; face < fine[c].size(); ++face) {
        if (!fine[c][face] || !merged[c][face]) continue;
        const double change = std::abs(*fine[c][face] - *merged[c][face]) / 4;
        if (channel.face.empty() || change > *channel.face_means) {
          channel.face_means = change;
          channel.face = face_name(solved.scene, {face / 2, face % 2 != 0});
        }
      }
    }
  } catch (const RequestError& error) {
    for (DividingEstimate::Channel& channel : estimate.channels) channel.face_means.reset();
    estimate.why_no_face_means = std::string("merged elements have no solution: ") + error.what();
  }
}

}  // namespace

DividingEstimate estimate_dividing(const SolvedElements& solved, std::uint32_t most, const SightsOfParts& sights,
                                   const std::function<ElementMerging()>& merging) {
  Stopwatch watch;
  DividingEstimate estimate = estimate_to_be(solved);
  if (!reflects(solved.scene)) {
    for (DividingEstimate::Channel& channel : estimate.channels) channel.pointwise = channel.face_means = 0;
    return estimate;
  }
  if (!sights) {
    estimate.why_no_pointwise =
        "the factors are approximate, and their errors could not be told from those of the size of elements";
  } else {
    try {
      const std::vector<SampledElement> samples = elements_to_look_at(solved, most);
      set_pointwise(solved, samples, sights(samples), estimate);
    } catch (const RequestError& error) {
      estimate.why_no_pointwise = error.what();
    }
  }
  set_face_means(solved, merging(), estimate);
  estimate.seconds = watch.lap();
  return estimate;
}

}  // namespace hottel
