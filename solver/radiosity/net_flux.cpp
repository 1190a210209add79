#include "solver/radiosity/net_flux.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_map>
#include <utility>

#include "kernel/exact_double.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/radiosity/scaled_ball.h"

namespace hottel {
namespace {

ScaledBall within(double value, double lower, double upper) {
  return ScaledBall::of(DoubleDoubleBall::around({value, 0}, {lower, upper}));
}

NetFlux::Power power_of(const ScaledBall& flux) { return {flux.nearest(), flux.lower(), flux.upper()}; }

// What leaves the elements with rows through each of the others, in one channel.
class Flux {
 public:
  Flux(const ExchangeMatrix& matrix, const ChannelSolution& solution, ScaledBall sky_emission)
      : matrix_(matrix), sky_emission_(std::move(sky_emission)), area_(matrix.size()), radiosity_(matrix.size()) {
    result_.resize(matrix.size() + 1);
    has_row_.resize(matrix.size() + 1, 0);
    parallel_ranges(matrix.size(), 256, [&](std::size_t first, std::size_t last) {
      for (auto i = static_cast<std::uint32_t>(first); i < last; ++i) {
        if (!matrix.has_row(i)) continue;
        has_row_[i] = 1;
        const ElementRadiosity& element = solution.elements[i];
        area_[i] = ScaledBall::of(DoubleDoubleBall::of(matrix.elements()[i].area));
        radiosity_[i] = within(element.radiosity, element.lower, element.upper);
        result_[i] = product(area_[i], within(element.net_value, element.net_lower, element.net_upper));
      }
    });
    constexpr std::size_t kParts = 16;  // by n alone; each goes through all rows
    parallel_ranges(matrix.size() + std::size_t{1}, matrix.size() / kParts + 1,
                    [this](std::size_t first, std::size_t last) { receive(first, last); });
  }

  // Of every element, the sky last.
  std::vector<ScaledBall> take() { return std::move(result_); }

 private:
  // What arrives at those from `first` up to `last` that have no row: what each row sends, one after the other.
  void receive(std::size_t first, std::size_t last) {
    for (std::uint32_t i = 0; i < matrix_.size(); ++i) {
      if (has_row_[i] == 0) continue;
      const std::span<const std::uint32_t> columns = matrix_.row(i).columns();
      for (auto at = std::ranges::lower_bound(columns, first); at != columns.end() && *at < last; ++at)
        if (has_row_[*at] == 0) add(i, static_cast<std::size_t>(at - columns.begin()));
    }
  }

  // Adds what row i sends to its k-th entry.
  void add(std::uint32_t i, std::size_t k) {
    const FactorEntry entry = matrix_.row(i)[k];
    const bool is_any_within =
        matrix_.guarantee() == Guarantee::kEnclosed && matrix_.guarantee(i, k) == Guarantee::kEnclosed;
    const DoubleDoubleBall factor = is_any_within
                                        ? DoubleDoubleBall::around({entry.factor.value, 0}, matrix_.bounds(i, k))
                                        : DoubleDoubleBall::of(entry.factor);
    const ScaledBall sent =
        entry.to == matrix_.sky() ? difference(sky_emission_, radiosity_[i]) : negated(radiosity_[i]);
    result_[entry.to] = sum(result_[entry.to], product(product(area_[i], ScaledBall::of(factor)), sent));
  }

  const ExchangeMatrix& matrix_;
  ScaledBall sky_emission_;
  std::vector<ScaledBall> area_, radiosity_, result_;
  std::vector<char> has_row_;  // of elements, and of the sky: none. An element is looked up far more slowly
};

}  // namespace

NetFlux::Power sum(const NetFlux::Power& a, const NetFlux::Power& b) {
  return power_of(sum(within(a.value, a.lower, a.upper), within(b.value, b.lower, b.upper)));
}

std::vector<NetFlux> net_flux(const ExchangeMatrix& matrix, const RadiositySolution& solution,
                              const SourceSpectrum& sky_emission,
                              const std::function<std::string(const Element&)>& name_of, const ShiningLights& shining) {
  const auto lost = power_without_rows(matrix, shining.lights, shining.shares);
  for (const ChannelSolution& channel : solution.channels) HOTTEL_REQUIRE(channel.elements.size() == matrix.size());
  std::vector<char> is_listed(matrix.size() + 1, 0);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    is_listed[i] = 1;
    for (const FactorEntry& entry : matrix.row(i)) is_listed[entry.to] = 1;
  }
  for (const auto& [element, power] : lost) is_listed[element] = 1;
  std::vector<NetFlux> result;
  std::vector<std::size_t> place(matrix.size() + 1);  // of an element, in the result
  std::vector<ScaledBall> area;
  std::unordered_map<std::string, std::size_t> place_of;
  for (std::uint32_t i = 0; i <= matrix.size(); ++i) {
    if (!is_listed[i]) continue;
    const std::string name = i == matrix.sky() ? matrix.name(i) : name_of(matrix.elements()[i]);
    const auto [known, is_new] = place_of.emplace(name, result.size());
    if (is_new) {
      result.push_back({name, {}, std::vector<NetFlux::Power>(solution.channels.size())});
      area.emplace_back();
    }
    place[i] = known->second;
    if (i == matrix.sky()) continue;
    area[place[i]] = sum(area[place[i]], ScaledBall::of(DoubleDoubleBall::of(matrix.elements()[i].area)));
    result[place[i]].area = area[place[i]].nearest();
  }
  for (std::size_t c = 0; c < solution.channels.size(); ++c) {
    const RationalEnclosure& sky = sky_emission[static_cast<int>(c)];
    std::vector<ScaledBall> flux = Flux(matrix, solution.channels[c], ScaledBall::around(sky.lower, sky.upper)).take();
    for (const auto& [element, power] : lost)
      flux[element] = difference(flux[element], ScaledBall::around(power[c].lower, power[c].upper));
    std::vector<ScaledBall> total(result.size());
    for (std::uint32_t i = 0; i <= matrix.size(); ++i)
      if (is_listed[i]) total[place[i]] = sum(total[place[i]], flux[i]);
    for (std::size_t k = 0; k < result.size(); ++k) result[k].by_channel[c] = power_of(total[k]);
  }
  return result;
}

std::vector<NetFlux> light_flux(const ShiningLights& shining, std::size_t channels) {
  std::vector<NetFlux> result;
  for (std::size_t k = 0; k < shining.lights.size(); ++k) {
    NetFlux& flux = result.emplace_back(NetFlux{shining.lights[k].name, {}, {}});
    for (std::size_t c = 0; c < channels; ++c) {
      const Rational& power = shining.lights[k].power.value[c];
      const Enclosure& whole = shining.shares[k].whole;
      flux.by_channel.push_back(
          shining.shares[k].solid.empty()
              ? power_of(ScaledBall::around(power * exact_value(whole.lower), power * exact_value(whole.upper)))
              : NetFlux::Power{});
    }
  }
  return result;
}

}  // namespace hottel
