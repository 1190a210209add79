#include "solver/compare/composed_scatter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "solver/compare/error_geometry.h"
#include "solver/compare/reading_parts.h"
#include "solver/compare/sampling_noise.h"
#include "solver/compare/scattered_pairs.h"
#include "solver/methods/factor_rows.h"

namespace hottel {
namespace {

constexpr double kWorthAPart = 0.5;  // of the squares of errors that are left
constexpr double kMostLean = 0.2;    // of a sum that is too large
constexpr double kFarFromOne = 5;    // deviations
constexpr double kMostNear = 0.02;   // of a ratio to one with a name

// The numbers of a file as if nothing but the law had been wrong, and what they scatter about.
struct Frame {
  bool is_uniform = false;
  const Orientation* orientation = &kOrientations.front();
  Ratio ratio;
  double square = std::numeric_limits<double>::infinity();  // mean of e^2 / (F (1 - F))

  int price() const { return (is_uniform ? 1 : 0) + orientation->price() + ratio.price(); }
};

class Frames {
 public:
  Frames(const JudgedPairs& judged, const std::vector<char>& leave_out) : judged_(judged), leave_out_(leave_out) {}

  // What stands for F(to, from) where it is transposed, else for F(from, to), before the constant.
  double found(const Frame& frame, const JudgedPair& pair) const {
    return pair.value / frame.orientation->multiple(area(pair.from), area(pair.to));
  }
  // What it scatters about.
  double right(const Frame& frame, const ExchangeMatrix& law, const JudgedPair& pair) const {
    return frame.orientation->is_transposed ? law.factor(pair.to, pair.from).value
                                            : law.factor(pair.from, pair.to).value;
  }
  // The pairs that a frame is measured by: not the sky, nor what has no row to be transposed from.
  template <class Visit>
  void for_each(const Frame& frame, const Visit& visit) const {
    for (const JudgedPair& pair : judged_.pairs()) {
      if (pair.to == judged_.exact().sky() || (!leave_out_.empty() && leave_out_[judged_.index_of(pair)])) continue;
      if (frame.orientation->is_transposed && !judged_.exact().has_row(pair.to)) continue;
      visit(pair);
    }
  }
  void measure(Frame& frame, const ExchangeMatrix& law) const;
  // The file's numbers where the law has them, without orientation and constant.
  ExchangeMatrix straightened(const Frame& frame) const;

 private:
  double area(std::uint32_t i) const { return judged_.exact().elements()[i].area.value; }

  const JudgedPairs& judged_;
  const std::vector<char>& leave_out_;
};

// Fits the constant to the sum of all hits, and measures what is left.
void Frames::measure(Frame& frame, const ExchangeMatrix& law) const {
  double sum = 0, expected = 0;
  for_each(frame, [&](const JudgedPair& pair) {
    sum += found(frame, pair);
    expected += right(frame, law, pair);
  });
  if (!(expected > 0) || sum == 0) return;
  const auto mean_square = [&](double ratio) {
    double squares = 0, count = 0;
    for_each(frame, [&](const JudgedPair& pair) {
      const double factor = right(frame, law, pair), error = found(frame, pair) / ratio - factor;
      if (!(factor > 1e-6 && factor < 1)) return;
      squares += error * error / variance_of_one(factor, RaySpread::kRandom);
      ++count;
    });
    return count > 0 ? squares / count : std::numeric_limits<double>::infinity();
  };
  const double ratio = sum / expected;
  frame.square = mean_square(ratio);
  // The sum of all hits is off by this part.
  const double deviation = std::sqrt(frame.square / std::max(expected, 1e-300));
  if (std::abs(ratio - 1) < std::max(kFarFromOne * deviation, 1e-9)) {
    frame.square = mean_square(1);
    return;
  }
  const auto named = named_ratio(ratio, std::min(kMostNear, std::max(kFarFromOne * deviation, 1e-6)));
  frame.ratio = named ? *named : Ratio{ratio, ""};
  if (named) frame.square = mean_square(named->value);
}

ExchangeMatrix Frames::straightened(const Frame& frame) const {
  const ExchangeMatrix& exact = judged_.exact();
  std::vector<std::vector<FactorEntry>> rows(exact.size());
  for (const JudgedPair& pair : judged_.pairs()) {
    if (pair.value == 0) continue;
    if (pair.to == exact.sky()) {
      // It may have been counted before the constant came in, or after.
      const double scaled = pair.value / frame.ratio.value;
      const bool is_scaled = std::abs(scaled - pair.exact) < std::abs(pair.value - pair.exact);
      rows[pair.from].push_back({pair.to, {is_scaled ? scaled : pair.value, 0}, 1});
      continue;
    }
    const bool is_turned = frame.orientation->is_transposed;
    const std::uint32_t i = is_turned ? pair.to : pair.from, j = is_turned ? pair.from : pair.to;
    if (exact.has_row(i)) rows[i].push_back({j, {found(frame, pair) / frame.ratio.value, 0}, 1});
  }
  for (std::vector<FactorEntry>& row : rows)
    std::sort(row.begin(), row.end(), [](const FactorEntry& a, const FactorEntry& b) { return a.to < b.to; });
  return matrix_of_rows(exact.elements(), rows);
}

// The uniform law with the exact visibilities, which scatter does not change.
ExchangeMatrix with_visibilities(const ExchangeMatrix& factors, const ExchangeMatrix& exact) {
  std::vector<std::vector<FactorEntry>> rows(factors.size());
  for (std::uint32_t i = 0; i < factors.size(); ++i)
    for (FactorEntry entry : factors.row(i)) {
      const auto known = exact.row(i).find(entry.to);
      entry.visibility = known ? known->visibility : 0;
      rows[i].push_back(entry);
    }
  return matrix_of_rows(factors.elements(), rows);
}

bool is_geometric(const JudgedScene& scene, const JudgedPairs& judged, const std::vector<char>& leave_out,
                  bool is_even) {
  const std::vector<ScatteredPair> pairs =
      scattered_pairs(judged, leave_out, is_even ? RaySpread::kEven : RaySpread::kRandom);
  const GeometricShare share = geometric_share(scene, judged, pairs);
  // Rays of one face are spread evenly, and counted; or both ways of a pair are made one afterwards.
  return share.is_geometry() || (is_even && !share.is_closed && !share.is_symmetric);
}

// Whether a sum leans by more than counters lose: then what scatters is another number.
bool leans_far(const NoiseBias& bias) {
  return std::any_of(bias.sums.begin(), bias.sums.end(),
                     [](const SamplingBias& sum) { return sum.relative > kMostLean; });
}

// The best frame, and simpler ones first. uniform: null where that law is not asked for.
std::optional<Frame> best_frame(const Frames& frames, const ExchangeMatrix& exact, const ExchangeMatrix* uniform) {
  std::vector<Frame> all;
  for (const ExchangeMatrix* const law : {&exact, uniform})
    for (const Orientation& orientation : kOrientations) {
      if (law == nullptr) continue;
      Frame frame{law == uniform, &orientation, {}};
      frames.measure(frame, *law);
      all.push_back(frame);
    }
  std::stable_sort(all.begin(), all.end(), [](const Frame& a, const Frame& b) { return a.price() < b.price(); });
  const Frame* best = nullptr;
  for (const Frame& frame : all)
    if (std::isfinite(frame.square) && frame.ratio.price() < 2 &&
        (best == nullptr || frame.square < kWorthAPart * best->square))
      best = &frame;
  return best == nullptr ? std::nullopt : std::optional(*best);
}

constexpr std::uint32_t kFewestRaysOfOne = 1U << 10, kMostRays = 1U << 16;  // of an element
constexpr std::uint64_t kRaysOfAll = 1U << 22;

// How many rays tell the law of so many elements.
std::uint32_t rays_of_law(std::uint32_t elements) {
  std::uint32_t rays = kMostRays;
  while (rays > kFewestRaysOfOne && std::uint64_t{rays} * elements > kRaysOfAll) rays /= 2;
  return rays;
}

// Whether a law of few rays comes as near as the exact factors do, but for a margin: it scatters itself.
bool may_be_uniform(const JudgedScene& scene, const Frames& frames, const ExchangeMatrix& exact) {
  constexpr double kMargin = 4;
  const ExchangeMatrix few = scene.uniform_factors(kFewestRaysOfOne);
  const auto least_square = [&](const ExchangeMatrix& law) {
    double least = std::numeric_limits<double>::infinity();
    for (const Orientation& orientation : kOrientations) {
      Frame frame{false, &orientation, {}};
      frames.measure(frame, law);
      least = std::min(least, frame.square);
    }
    return least;
  };
  return least_square(few) < kMargin * least_square(exact);
}

// The scatter about a frame, as pairs of the file.
Hypothesis about(const JudgedScene& scene, const JudgedPairs& judged, const std::vector<char>& leave_out,
                 const Frames& frames, const Frame& frame, const ExchangeMatrix& law) {
  const Hypothesis nothing = explains_nothing(Fault::kSamplingNoise, judged);
  const ExchangeMatrix straightened = frames.straightened(frame);
  const JudgedPairs straight(law, straightened, judged.tolerance(0) / std::min(1.0, std::abs(frame.ratio.value)),
                             judged.places());
  const auto noise = sampling_noise(straight, {}, false);
  if (!noise || noise->bias.is_biased() || is_geometric(scene, straight, {}, noise->is_even)) return nothing;
  const LeftWrong is_wrong(straight, noise->explains);
  Hypothesis result = nothing;
  for (const JudgedPair& pair : judged.pairs()) {
    const bool is_turned = frame.orientation->is_transposed && pair.to != law.sky();
    const std::uint32_t i = is_turned ? pair.to : pair.from, j = is_turned ? pair.from : pair.to;
    const bool is_left_out = !leave_out.empty() && leave_out[judged.index_of(pair)];
    result.explains[judged.index_of(pair)] = static_cast<char>(pair.is_off && !is_left_out && !is_wrong.at(i, j));
  }
  ToldParts parts;
  if (frame.is_uniform) parts.add(Fault::kEmission, "rays leave evenly in all directions, not by the cosine");
  parts.add(*frame.orientation);
  parts.add(frame.ratio);
  parts.add(Fault::kSamplingNoise, noise_words(*noise));
  parts.tell(result);
  return result;
}

}  // namespace

Hypothesis suppose_scatter(const JudgedScene& scene, const JudgedPairs& judged, const std::vector<char>& leave_out,
                           bool may_lean) {
  Hypothesis plain = explains_nothing(Fault::kSamplingNoise, judged);
  const auto noise = sampling_noise(judged, leave_out, may_lean);
  if (noise && !leans_far(noise->bias) && !is_geometric(scene, judged, leave_out, noise->is_even)) {
    plain.explains = noise->explains;
    plain.words = noise_words(*noise);
  }
  if (judged.exact().size() > kMostApproximated) return plain;
  // The law is only asked for where the errors are no plain scatter: to count uniform rays takes time.
  const Frames frames(judged, leave_out);
  std::optional<ExchangeMatrix> uniform;
  if ((plain.count() == 0 || noise->bias.is_biased()) && may_be_uniform(scene, frames, judged.exact()))
    uniform = with_visibilities(scene.uniform_factors(rays_of_law(judged.exact().size())), judged.exact());
  const auto frame = best_frame(frames, judged.exact(), uniform ? &*uniform : nullptr);
  if (!frame || frame->price() == 0) return plain;
  Hypothesis composed = about(scene, judged, leave_out, frames, *frame, frame->is_uniform ? *uniform : judged.exact());
  return composed.count() > 0 ? composed : plain;
}

}  // namespace hottel
