#include "solver/radiosity/gray_exchange.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>

#include "geometry/near_names.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/radiosity/cached_inverses.h"
#include "solver/radiosity/certificate.h"
#include "solver/radiosity/factor_ends.h"
#include "solver/radiosity/high_precision_elimination.h"
#include "solver/radiosity/radiosity_options.h"
#include "solver/radiosity/radiosity_system.h"

namespace hottel {
namespace {

constexpr std::size_t kColumnsBetweenReports = 64;

// One number of a column.
struct ColumnEntry {
  std::uint32_t row = 0;
  double value = 0;
  Enclosure bounds;
};

// The system of one channel, eliminated or factored once, and what solves it for one column after the other.
class GraySystem {
 public:
  // Of the factors as they are.
  GraySystem(const ExchangeMatrix& matrix, const std::vector<Material>& materials, int channel)
      : matrix_(matrix), system_(matrix, materials, channel), elimination_(system_), inverses_(system_) {
    HOTTEL_REQUIRE(!system_.has_negative_factors());
    for (const Material& material : materials)
      emissivity_.push_back(ScaledBall::of(Rational(1 - material.reflectivity.value[channel])));
    // Components that lose nothing have no column: all their emissivities are 0.
    std::vector<char> is_wanted;
    bool is_any_wanted = false;
    for (const SystemComponent& component : system_.components()) {
      is_wanted.push_back(component.loses);
      is_any_wanted |= component.loses;
    }
    if (!is_any_wanted) return;
    if (system_.rows_are_closed()) {
      inverse_ = inverses_.elimination(is_wanted);
      return;
    }
    inverse_ = system_.size() <= kMostDenseUnknowns ? inverses_.lu(is_wanted) : inverses_.bicgstab(is_wanted);
    dies_out_ = inverses_.light_dies_out(is_wanted, *inverse_);
  }

  // Whether light dies out, proven: only then are there columns.
  bool dies_out() const { return dies_out_; }

  // The numbers of one column that are not 0, by rows, with bounds for the factors that are meant. Those of all factors
  // within their bounds may be infinite.
  std::vector<ColumnEntry> column(std::uint32_t to, FactorsMeant meant = FactorsMeant::kAsGiven) const {
    std::vector<ColumnEntry> result;
    const ScaledBall source = emissivity_of(to);
    if (source.is_zero()) return result;
    const std::vector<ScaledBall> irradiance = system_.irradiance(radiosity(system_.unit_source(to), meant), meant);
    for (std::uint32_t i = 0; i < matrix_.size(); ++i) {
      if (!matrix_.has_row(i)) continue;
      const ScaledBall emissivity = emissivity_of(i);
      if (irradiance[i].is_zero() || emissivity.is_zero()) continue;
      const ScaledBall factor = product(emissivity, product(source, irradiance[i]));
      const double most = system_.rows_are_closed() ? std::min(emissivity.upper(), factor.upper()) : factor.upper();
      const Enclosure bounds{std::max(0.0, factor.lower()), most};
      result.push_back({i, std::clamp(factor.nearest(), bounds.lower, bounds.upper), bounds});
    }
    return result;
  }

  // What no entry of a row is above, where rows of factors sum to 1.
  double most_of_row(std::uint32_t from) const { return emissivity_of(from).upper(); }

 private:
  // Of a face, a black back or the sky.
  ScaledBall emissivity_of(std::uint32_t element) const {
    if (element == matrix_.sky() || !matrix_.elements()[element].material)
      return ScaledBall::of(DoubleDoubleBall{1, 0, 0});
    return emissivity_[*matrix_.elements()[element].material];
  }

  // G_kj of all elements k, the sky last, for the column j that is the source.
  std::vector<ScaledBall> radiosity(const Sources& sources, FactorsMeant meant) const {
    std::vector<ScaledBall> result = sources.emission;
    if (!inverse_) return result;
    SplitVector x{std::vector<DoubleDouble>(system_.components().size()), std::vector<DoubleDouble>(system_.size())};
    refine(system_, sources, *inverse_, x);
    CertifiedBounds bounds = certify(system_, sources, *inverse_, x, {.meant = meant});
    if (meant == FactorsMeant::kAsGiven) {
      if (system_.rows_are_closed()) elimination_.narrow(sources, {}, bounds);
      require_bounds(system_, bounds);
    }
    for (std::size_t u = 0; u < system_.size(); ++u) result[system_.rows()[u].element] = bounds.enclosed(u);
    return result;
  }

  const ExchangeMatrix& matrix_;
  RadiositySystem system_;
  HighPrecisionElimination elimination_;
  std::vector<ScaledBall> emissivity_;  // by material
  CachedInverses inverses_;
  std::shared_ptr<const ApproximateInverse> inverse_;
  bool dies_out_ = true;
};

// What ascends with every factor, as script-F does, is least for the least factors and largest for the largest.
class EnclosedGraySystem {
 public:
  EnclosedGraySystem(const ExchangeMatrix& matrix, const std::vector<Material>& materials, int channel)
      : as_given_(matrix, materials, channel), has_closed_rows_(has_closed_enclosures(matrix)) {
    if (!as_given_.dies_out())
      throw RequestError("no script-F: rows of the factors sum to more than 1, and light may not die out");
    if (matrix.guarantee() != Guarantee::kEnclosed) return;
    lower_.emplace(matrix, &Enclosure::lower, materials, channel);
    upper_.emplace(matrix, &Enclosure::upper, materials, channel);
  }

  // The numbers of one column that may not be 0, by rows, with bounds for all factors within theirs.
  std::vector<ColumnEntry> column(std::uint32_t to) const {
    std::vector<ColumnEntry> middle = as_given_.column(to);
    if (!lower_) return middle;
    const bool has_most = upper_->system.dies_out();
    const std::vector<ColumnEntry> least = lower_->system.column(to);
    std::vector<ColumnEntry> result = has_most ? upper_->system.column(to) : middle;
    const auto in = [](const std::vector<ColumnEntry>& column, std::uint32_t row) -> const ColumnEntry* {
      const auto found = std::lower_bound(column.begin(), column.end(), row,
                                          [](const ColumnEntry& entry, std::uint32_t r) { return entry.row < r; });
      return found != column.end() && found->row == row ? &*found : nullptr;
    };
    const std::vector<ColumnEntry> closed =
        has_closed_rows_ ? as_given_.column(to, FactorsMeant::kWithinBounds) : std::vector<ColumnEntry>();
    for (ColumnEntry& entry : result) {
      const ColumnEntry *const value = in(middle, entry.row), *const low = in(least, entry.row);
      const double most = as_given_.most_of_row(entry.row);
      entry.bounds = {low != nullptr ? std::min(low->bounds.lower, most) : 0,
                      has_most ? std::min(entry.bounds.upper, most) : most};
      if (const ColumnEntry* const of_rows = in(closed, entry.row)) {
        entry.bounds = {std::max(entry.bounds.lower, of_rows->bounds.lower),
                        std::min(entry.bounds.upper, of_rows->bounds.upper)};
        HOTTEL_REQUIRE(entry.bounds.lower <= entry.bounds.upper);  // each end is proven
      }
      entry.value = std::clamp(value != nullptr ? value->value : 0, entry.bounds.lower, entry.bounds.upper);
    }
    return result;
  }

 private:
  struct Ends {
    ExchangeMatrix matrix;
    GraySystem system;
    Ends(const ExchangeMatrix& of, double Enclosure::*end, const std::vector<Material>& materials, int channel)
        : matrix(matrix_of_ends(of, end)), system(matrix, materials, channel) {}
    Ends(const Ends&) = delete;
    Ends& operator=(const Ends&) = delete;
  };

  GraySystem as_given_;
  bool has_closed_rows_;
  std::optional<Ends> lower_, upper_;
};

// guarantee: kEnclosed, or kEstimated, of which nothing is said but that it is a fraction.
ExchangeMatrix from_columns(const std::vector<Element>& elements, const std::vector<std::vector<ColumnEntry>>& columns,
                            Guarantee guarantee) {
  ExchangeMatrix result(elements, guarantee);
  std::vector<std::size_t> begin(elements.size() + 1, 0);
  for (const auto& column : columns)
    for (const ColumnEntry& entry : column) ++begin[entry.row + 1];
  for (std::size_t i = 0; i < elements.size(); ++i) begin[i + 1] += begin[i];
  FactorEntries entries(begin.back());
  std::vector<Enclosure> bounds(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::uint32_t j = 0; j < columns.size(); ++j)
    for (const ColumnEntry& entry : columns[j]) {
      const std::size_t place = next[entry.row]++;
      entries.set(place, {j, {entry.value, 0}, std::numeric_limits<double>::quiet_NaN()});
      bounds[place] = entry.bounds;
    }
  if (guarantee == Guarantee::kEstimated) bounds.clear();
  result.assign(std::move(begin), std::move(entries), {}, std::move(bounds));
  return result;
}

// The same with the reflectivities of surfaces.
std::vector<Material> with_surfaces(std::vector<Material> materials) {
  for (Material& material : materials) material.reflectivity = material.surface_reflectivity();
  return materials;
}

}  // namespace

ExchangeMatrix gray_exchange(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                             const GrayExchangeOptions& options) {
  HOTTEL_REQUIRE(options.channel >= 0 && options.channel < 3);
  const EnclosedGraySystem system(matrix, with_surfaces(materials), options.channel);
  std::vector<std::vector<ColumnEntry>> columns(matrix.size() + 1);
  std::atomic<std::uint64_t> pairs{0};
  for (std::size_t begin = 0; begin < columns.size(); begin += kColumnsBetweenReports) {
    const std::size_t end = std::min(columns.size(), begin + kColumnsBetweenReports);
    parallel_for(end - begin, [&](std::size_t k) {
      std::vector<ColumnEntry>& column = columns[begin + k];
      column = system.column(static_cast<std::uint32_t>(begin + k));
      const std::uint64_t bytes = (pairs += column.size()) * kBytesPerGrayPair;
      if (options.memory > 0 && bytes > options.memory)
        throw RequestError(fmt::format("script-F has more than {} pairs, which is all that the {} bytes allowed hold",
                                       options.memory / kBytesPerGrayPair, options.memory));
    });
    if (options.progress) options.progress(static_cast<double>(end) / static_cast<double>(columns.size()));
  }
  const bool is_estimated = matrix.guarantee() == Guarantee::kEstimated;
  return from_columns(matrix.elements(), columns, is_estimated ? Guarantee::kEstimated : Guarantee::kEnclosed);
}

double max_relative_width(const ExchangeMatrix& matrix) {
  double widest = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k)
      if (const double factor = matrix.row(i)[k].factor.value; factor > 0)
        widest = std::max(widest, matrix.bounds(i, k).width() / factor);
  return widest;
}

std::optional<std::uint32_t> first_coloured(const ExchangeMatrix& matrix, const std::vector<Material>& materials) {
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const auto rho = materials[*matrix.elements()[i].material].surface_reflectivity().value;
    if (rho[0] != rho[1] || rho[0] != rho[2]) return i;
  }
  return std::nullopt;
}

int gray_channel(const ExchangeMatrix& matrix, const std::vector<Material>& materials, const std::string& name) {
  constexpr std::string_view kNames = "rgb";
  if (!materials.empty() && materials.front().has_bands) return static_cast<int>(kThermalBand);
  if (!name.empty()) {
    const std::size_t channel = name.size() == 1 ? kNames.find(name) : std::string_view::npos;
    if (channel == std::string_view::npos)
      throw UnknownName("the channel of script-F is r, g or b, not '" + name + "'", name,
                        std::vector<std::string>{"r", "g", "b"});
    return static_cast<int>(channel);
  }
  if (const auto row = first_coloured(matrix, materials)) {
    const Element& element = matrix.elements()[*row];
    throw RequestError("'" + materials[*element.material].name + "', the material of '" + element.name +
                       "', is not gray: choose --channel r, g or b");
  }
  return 0;
}

}  // namespace hottel
