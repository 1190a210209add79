#include "solver/compare/sampling_noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/plain_functions.h"
#include "kernel/support/counted.h"
#include "solver/compare/samples.h"

namespace hottel {
namespace {

constexpr double kFewestHits = 5;  // below, a count is no normal number
constexpr std::size_t kFewestPairs = 20;
constexpr double kFewestRays = 8;
constexpr double kAgree = 3;       // ratio of the rays told by median and by mean
constexpr double kFar = 4;         // deviations
constexpr double kMostFar = 0.02;  // share of pairs
constexpr double kMostOneSided = 0.75;
constexpr std::size_t kFewestOfRow = 4;
constexpr double kRareHits = 0.5;  // expected of pairs that a counter mostly misses
constexpr std::size_t kFewestOfThird = 20;
constexpr double kMostGrowth = 3;      // of squares from the third of the small factors to that of the large ones
constexpr double kTooManyRays = 4;     // times as many as the errors tell of
constexpr double kLogOfChance = 9.21;  // 1e-4
constexpr double kDeviationsOfScale = 1.5;

double to_two_digits(double value) {
  const double unit = same_bits::pow(10, std::floor(same_bits::log10(value)) - 1);
  return std::round(value / unit) * unit;
}

// Errors, or what is left of them, as scatter.
class NoiseFit {
 public:
  NoiseFit(const JudgedPairs& judged, const std::vector<char>& leave_out, const std::vector<ScatteredPair>& pairs,
           RaySpread spread, bool is_of_rests)
      : judged_(judged), pairs_(pairs), spread_(spread), is_of_rests_(is_of_rests) {
    double squares = 0, variances = 0;
    for (const JudgedPair& pair : judged.pairs()) {
      if (!leave_out.empty() && leave_out[judged.index_of(pair)]) continue;
      ++count_;
      lit_ += pair.exact == 0 && std::abs(pair.value) > judged_.tolerance(pair.value);
      if (!is_of_rests_) squares += pair.error() * pair.error();
    }
    for (const ScatteredPair& each : pairs_) {
      if (is_of_rests_) squares += each.rest * each.rest;
      variances += each.variance;
    }
    if (!(squares > 0)) return;
    scale_ = variances / squares;
    if (!is_of_rests_) return;
    const ScatterScale by_median = scatter_scale(pairs_, rays(), kFewestHits);
    scale_ = by_median.scale > 0 ? scale_ * by_median.freedom / static_cast<double>(pairs_.size()) : 0;
  }

  double scale() const { return scale_; }
  double rays() const { return rays_of(scale_); }
  double rays_of(double scale) const { return spread_ == RaySpread::kEven ? same_bits::pow(scale, 2.0 / 3) : scale; }

  bool is_like_noise() const;
  bool grows_as_scatter() const;
  bool counts_more() const;
  void explain(std::vector<char>& explains) const;

 private:
  double error(const ScatteredPair& each) const { return is_of_rests_ ? each.rest : each.error; }

  const JudgedPairs& judged_;
  const std::vector<ScatteredPair>& pairs_;
  RaySpread spread_;
  bool is_of_rests_;
  std::size_t count_ = 0, lit_ = 0;  // lit: though nothing goes there
  double scale_ = 0;                 // variance_of_one over the mean square: N, or N^(3/2)
};

bool NoiseFit::is_like_noise() const {
  if (!(rays() >= kFewestRays) || !std::isfinite(rays())) return false;
  if (static_cast<double>(lit_) > kMostFar * static_cast<double>(count_)) return false;
  std::vector<double> squares;
  std::size_t far = 0, off = 0, above = 0;
  for (const ScatteredPair& each : pairs_) {
    if (rays() * std::min(each.pair->exact, 1 - each.pair->exact) < kFewestHits) continue;
    const double square = error(each) * error(each) / each.variance;
    squares.push_back(square);
    far += square * scale_ > kFar * kFar;
    off += each.pair->is_off && std::abs(error(each)) > judged_.tolerance(each.pair->value);
    above += error(each) > 0;
  }
  const auto count = static_cast<double>(squares.size()), over = static_cast<double>(above);
  if (squares.size() < kFewestPairs || static_cast<double>(far) > kMostFar * count ||
      static_cast<double>(off) < count / 2 || std::max(over, count - over) > kMostOneSided * count)
    return false;
  const double by_median = kMedianOfSquares / middle_of(squares);
  return by_median < kAgree * scale_ && scale_ < kAgree * by_median && grows_as_scatter();
}

// Errors in proportion to the factors, whatever makes them, are far larger than scatter where factors are large.
bool NoiseFit::grows_as_scatter() const {
  std::vector<std::pair<double, double>> squares;  // by factor
  for (const ScatteredPair& each : pairs_)
    if (rays() * std::min(each.pair->exact, 1 - each.pair->exact) >= kFewestHits)
      squares.emplace_back(each.pair->exact, error(each) * error(each) / each.variance);
  std::sort(squares.begin(), squares.end());
  const std::size_t third = squares.size() / 3;
  const auto median = [&](std::size_t begin) {
    std::vector<double> part;
    for (std::size_t k = begin; k < begin + third; ++k) part.push_back(squares[k].second);
    return middle_of(part);
  };
  return third < kFewestOfThird || median(squares.size() - third) < kMostGrowth * median(0);
}

// Whether the least factor, taken for one ray, tells of far more rays than the errors. Each row has rays of its own: at
// least as many as the errors of all tell, or twice those of its own.
bool NoiseFit::counts_more() const {
  if (is_symmetric(judged_, pairs_)) return false;  // sums of two counts
  double least = std::numeric_limits<double>::infinity(), expected = 0, hit = 0, most_rays = rays();
  for (std::size_t begin = 0, end = 0; begin < pairs_.size(); begin = end) {
    double squares = 0, variances = 0;
    for (; end < pairs_.size() && pairs_[end].pair->from == pairs_[begin].pair->from; ++end) {
      squares += pairs_[end].error * pairs_[end].error;
      variances += pairs_[end].variance;
    }
    if (end - begin < kFewestOfRow) continue;
    const double rays_here = std::max(rays(), 2 * rays_of(variances / squares));
    for (std::size_t k = begin; k < end; ++k) {
      const double value = pairs_[k].pair->value, hits = rays_here * pairs_[k].pair->exact;
      const bool is_hit = value > judged_.tolerance(value);
      if (is_hit) least = std::min(least, value);
      if (hits > kRareHits) continue;
      expected += 1 - same_bits::exp(-hits);
      hit += is_hit;
    }
    most_rays = std::max(most_rays, rays_here);
  }
  const bool is_often_hit = hit - expected > std::sqrt(2 * kLogOfChance * expected) + 2.0 / 3 * kLogOfChance;
  return is_often_hit && 1 / least > kTooManyRays * most_rays;
}

void NoiseFit::explain(std::vector<char>& explains) const {
  for (const ScatteredPair& each : pairs_) {
    const JudgedPair& pair = *each.pair;
    const double scatter = kFar * std::sqrt(each.variance / scale_) + kFewestHits / rays();
    if (pair.is_off && std::abs(error(each)) <= scatter + judged_.tolerance(pair.value))
      explains[judged_.index_of(pair)] = 1;
  }
}

std::optional<SamplingNoise> noise_of(const JudgedPairs& judged, const std::vector<char>& leave_out, RaySpread spread,
                                      bool may_lean) {
  const std::vector<ScatteredPair> pairs = scattered_pairs(judged, leave_out, spread);
  const NoiseFit whole(judged, leave_out, pairs, spread, false), rests(judged, leave_out, pairs, spread, true);
  const bool is_noise = whole.is_like_noise();
  if (!is_noise && !(may_lean && rests.is_like_noise())) return std::nullopt;
  if (is_noise && whole.counts_more()) return std::nullopt;
  SamplingNoise noise{whole.rays(), spread == RaySpread::kEven, {}, std::vector<char>(judged.pairs().size(), 0)};
  if (is_noise) whole.explain(noise.explains);
  // The median of the rests, less what it may be off; where they are too few, all errors.
  const ScatterScale by_median = scatter_scale(pairs, whole.rays(), kFewestHits);
  const double scale = by_median.scale > 0
                           ? std::max(whole.scale() * (is_noise ? 1 : 0),
                                      by_median.scale / (1 + kDeviationsOfScale * 2.33 / std::sqrt(by_median.freedom)))
                           : whole.scale();
  noise.bias = noise_bias(judged, pairs, spread, scale, whole.rays_of(scale));
  if (!noise.bias.is_biased()) return is_noise ? std::optional(noise) : std::nullopt;
  if (rests.is_like_noise()) {
    noise.rays = rests.rays();
    rests.explain(noise.explains);
  }
  return noise;
}

std::string bias_words(const NoiseBias& bias) {
  std::string words;
  if (bias.is_leaky)
    words = fmt::format("rows of {} sum to what they should, as those of a counter do, and {} not, by up to {:.2g}",
                        counted(bias.rows.exact, "face"),
                        counted(bias.rows.off, "row") + (bias.rows.off == 1 ? " does" : " do"), bias.rows.most);
  for (const SamplingBias& sum : bias.sums) words += (words.empty() ? "" : ", ") + sum.words;
  if (!bias.is_leaky) words += fmt::format(" (by chance less than once in {:.0f})", 1 / kBiasLevel);
  return words;
}

}  // namespace

std::optional<SamplingNoise> sampling_noise(const JudgedPairs& judged, const std::vector<char>& leave_out,
                                            bool may_lean) {
  for (const RaySpread spread : {RaySpread::kRandom, RaySpread::kEven})
    if (auto noise = noise_of(judged, leave_out, spread, may_lean)) return noise;
  return std::nullopt;
}

std::string noise_words(const SamplingNoise& noise) {
  return fmt::format("the errors scatter as about {:.0f} {} rays a face would give, {}", to_two_digits(noise.rays),
                     noise.is_even ? "evenly spread" : "random",
                     noise.bias.is_biased() ? "but biased: " + bias_words(noise.bias) : "unbiased");
}

}  // namespace hottel
