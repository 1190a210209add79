#include "solver/compare/sampling_noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace hottel {
namespace {

constexpr double kMedianOfSquares = 0.4549;  // of a standard normal number
constexpr double kFewestHits = 5;            // below, a count is no normal number
constexpr std::size_t kFewestPairs = 20;
constexpr double kFewestRays = 8;
constexpr double kAgree = 3;       // ratio of the rays told by median and by mean
constexpr double kFar = 4;         // deviations
constexpr double kMostFar = 0.02;  // share of pairs
constexpr double kMostOneSided = 0.75;
constexpr double kDeviations = 5;

double to_two_digits(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::round(value / unit) * unit;
}

// Of one random ray; N have the N-th part of it. Where rays are spread evenly over places and directions only those of
// cells count that a border crosses: the root of it, over N^(3/2).
double variance_of_one(const JudgedPair& pair, bool is_even) {
  const double of_random = pair.exact * (1 - pair.exact);
  return is_even ? std::sqrt(of_random) : of_random;
}

class NoiseFit {
 public:
  NoiseFit(const JudgedPairs& judged, const std::vector<char>& leave_out, bool is_even)
      : judged_(judged), leave_out_(leave_out), is_even_(is_even) {
    double squares = 0, variances = 0, random = 0;
    for_each([&](const JudgedPair& pair) {
      ++pairs_;
      lit_ += pair.exact == 0 && std::abs(pair.value) > judged_.tolerance(pair.value);
      squares += pair.error() * pair.error();
      variances += variance_of_one(pair, is_even_);
      random += variance_of_one(pair, false);
    });
    if (!(squares > 0)) return;
    scale_ = variances / squares;
    rays_ = is_even_ ? std::pow(scale_, 2.0 / 3) : scale_;
    as_random_ = random / squares;
  }

  double rays() const { return rays_; }

  bool is_like_noise() const {
    if (!(rays_ >= kFewestRays) || !std::isfinite(rays_)) return false;
    if (static_cast<double>(lit_) > kMostFar * static_cast<double>(pairs_)) return false;
    std::vector<double> squares;
    std::size_t far = 0, off = 0, above = 0;
    for_each([&](const JudgedPair& pair) {
      if (rays_ * std::min(pair.exact, 1 - pair.exact) < kFewestHits) return;
      const double square = pair.error() * pair.error() / variance_of_one(pair, is_even_);
      squares.push_back(square);
      far += square * scale_ > kFar * kFar;
      off += pair.is_off;
      above += pair.value > pair.exact;
    });
    const auto count = static_cast<double>(squares.size()), over = static_cast<double>(above);
    if (squares.size() < kFewestPairs || static_cast<double>(far) > kMostFar * count ||
        static_cast<double>(off) < count / 2 || std::max(over, count - over) > kMostOneSided * count)
      return false;
    const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
    std::nth_element(squares.begin(), middle, squares.end());
    const double by_median = kMedianOfSquares / *middle;
    return by_median < kAgree * scale_ && scale_ < kAgree * by_median;
  }

  std::optional<SamplingBias> bias() const {
    const std::uint32_t sky = judged_.exact().sky();
    const std::array<std::pair<const char*, std::function<double(const JudgedPair&)>>, 3> sums = {{
        {"factors of the sky", [sky](const JudgedPair& pair) { return pair.to == sky ? 1.0 : 0.0; }},
        {"factors of partly hidden pairs",
         [sky](const JudgedPair& pair) {
           return pair.to != sky && pair.visibility > 0 && pair.visibility < 1 ? 1.0 : 0.0;
         }},
        {"large factors", [](const JudgedPair& pair) { return pair.exact; }},
    }};
    std::optional<SamplingBias> strongest;
    for (const auto& [of, weight] : sums) {
      const SamplingBias bias = lean(of, weight);
      if (std::abs(bias.deviations) > std::abs(strongest ? strongest->deviations : kDeviations)) strongest = bias;
    }
    return strongest;
  }

  std::vector<char> explains() const {
    std::vector<char> result(judged_.pairs().size(), 0);
    for_each([&](const JudgedPair& pair) {
      const double scatter = kFar * std::sqrt(variance_of_one(pair, is_even_) / scale_) + kFewestHits / rays_;
      result[judged_.index_of(pair)] =
          static_cast<char>(pair.is_off && pair.exact > 0 && pair.error() <= scatter + judged_.tolerance(pair.value));
    });
    return result;
  }

 private:
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const JudgedPair& pair : judged_.pairs())
      if (leave_out_.empty() || !leave_out_[judged_.index_of(pair)]) visit(pair);
  }

  // A weighted sum of the errors, in deviations of N independent rays a row.
  SamplingBias lean(const char* of, const std::function<double(const JudgedPair&)>& weight) const {
    double sum = 0, expected = 0, variance = 0;
    for (std::uint32_t i = 0; i < judged_.exact().size(); ++i) {
      double squares = 0, mean = 0;
      for (const JudgedPair& pair : judged_.row(i)) {
        if (!leave_out_.empty() && leave_out_[judged_.index_of(pair)]) continue;
        const double w = weight(pair);
        sum += w * (pair.value - pair.exact);
        mean += w * pair.exact;
        squares += w * w * pair.exact;
      }
      expected += mean;
      variance += std::max(0.0, squares - mean * mean) / as_random_;
    }
    const double least = 1e-12 * expected;  // what roundings leave of a sum that is the same in every row
    if (!(variance > least * least)) return {of, 0, 0};
    return {of, sum / expected, sum / std::sqrt(variance)};
  }

  const JudgedPairs& judged_;
  const std::vector<char>& leave_out_;
  std::size_t pairs_ = 0, lit_ = 0;  // lit: though nothing goes there
  bool is_even_;
  double scale_ = 0;      // variance_of_one over the mean square: N, or N^(3/2)
  double rays_ = 0;       // N
  double as_random_ = 0;  // random rays that scatter as much in the mean
};

}  // namespace

std::optional<SamplingNoise> sampling_noise(const JudgedPairs& judged, const std::vector<char>& leave_out) {
  for (const bool is_even : {false, true})
    if (const NoiseFit fit(judged, leave_out, is_even); fit.is_like_noise())
      return SamplingNoise{fit.rays(), is_even, fit.bias(), fit.explains()};
  return std::nullopt;
}

Hypothesis suppose_sampling_noise(const JudgedPairs& judged, const std::vector<char>& leave_out) {
  const std::optional<SamplingNoise> noise = sampling_noise(judged, leave_out);
  if (!noise) return explains_nothing(Fault::kSamplingNoise, judged);
  Hypothesis result{Fault::kSamplingNoise, noise->explains, ""};
  result.words = fmt::format("the errors scatter as about {:.0f} {} rays a face would give, ",
                             to_two_digits(noise->rays), noise->is_even ? "evenly spread" : "random");
  if (noise->bias)
    result.words += fmt::format("but biased: {} are {:.2g} % too {} in sum, {:.0f} deviations", noise->bias->of,
                                100 * std::abs(noise->bias->relative), noise->bias->relative > 0 ? "large" : "small",
                                std::abs(noise->bias->deviations));
  else
    result.words += "unbiased";
  return result;
}

}  // namespace hottel
