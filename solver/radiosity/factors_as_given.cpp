#include "solver/radiosity/factors_as_given.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "solver/radiosity/approximate_inverse.h"
#include "solver/radiosity/certificate.h"
#include "solver/radiosity/high_precision_elimination.h"
#include "solver/radiosity/iterations.h"
#include "solver/radiosity/matrix_checks.h"

namespace hottel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDefaultUntil = 1e-12;
constexpr int kDefaultIterations = 10'000;
constexpr int kDefaultShots = 100'000;
constexpr double kWorthANote = 1e-9;  // a relative residual, where it was not said how small it should be

// The double nearest to an exact number, and doubles around it.
struct Printed {
  double nearest, lower, upper;

  explicit Printed(const Rational& exact) : nearest(to_double(exact)), lower(nearest), upper(nearest) {
    const bool is_beyond = std::isinf(nearest);
    if (is_beyond || exact < Rational(nearest)) lower = std::nextafter(nearest, -kInfinity);
    if (!is_beyond && exact > Rational(nearest)) upper = std::nextafter(nearest, kInfinity);
  }
};

bool is_symmetric_only(Solver solver) { return solver == Solver::kCholesky || solver == Solver::kCg; }

// Everything for the channels of one reflectivity vector.
class Group {
 public:
  Group(const ExchangeMatrix& matrix, const std::vector<Material>& materials, const Spectrum& sky_emission,
        std::vector<int> channels, const RadiosityOptions& options, const ErrorTerms& terms,
        std::map<std::string, double>& seconds)
      : matrix_(matrix),
        materials_(materials),
        channels_(std::move(channels)),
        options_(options),
        terms_(terms),
        seconds_(seconds),
        system_(matrix, materials, channels_.front()),
        wide_(system_),
        is_wanted_(system_.components().size(), 0) {
    for (const int channel : channels_) {
      sources_.push_back(system_.sources(materials, sky_emission, channel));
      for (std::size_t c = 0; c < is_wanted_.size(); ++c) is_wanted_[c] |= sources_.back().is_lit[c];
    }
  }

  const RadiositySystem& system() const { return system_; }
  bool needs_solving() const { return std::find(is_wanted_.begin(), is_wanted_.end(), 1) != is_wanted_.end(); }

  // Refuses what has no solution, and notes what is a limit.
  void require_solution(std::set<std::string>& notes) const {
    for (std::size_t c = 0; c < is_wanted_.size(); ++c) {
      const SystemComponent& component = system_.components()[c];
      if (!system_.rows_are_closed() || component.loses) continue;
      const std::string& name = matrix_.elements()[component.first_element].name;
      if (is_wanted_[c])
        throw RequestError(
            fmt::format("no radiosity: '{}' and what it exchanges light with ({} in all) reflect all "
                        "light, let none out, and emit",
                        name, component.size));
      notes.insert(
          fmt::format("'{}' and what it exchanges light with ({} in all) reflect all light, let none out and "
                      "do not emit: radiosity is 0, the limit",
                      name, component.size));
    }
  }

  // Prepares the solvers and returns the one that is used. Refuses factors for which light may not die out, unless
  // bounds may be open.
  Solver prepare(bool may_be_open) {
    std::uint32_t largest = 0;
    for (std::size_t c = 0; c < is_wanted_.size(); ++c)
      if (is_wanted_[c]) largest = std::max(largest, system_.components()[c].size);
    const bool is_dense = largest <= kMostDenseUnknowns;
    if (system_.rows_are_closed()) {
      used_ = options_.solver != Solver::kAuto ? options_.solver : is_dense ? Solver::kCholesky : Solver::kCg;
      const bool by_elimination = used_ == Solver::kCholesky || (used_ != Solver::kCg && is_dense);
      inverse_ = by_elimination ? make_elimination(system_, is_wanted_) : make_conjugate_gradient(system_, is_wanted_);
    } else {
      if (is_symmetric_only(options_.solver))
        throw RequestError(
            fmt::format("'{}' needs a symmetric matrix, and one whose rows do not sum to 1 is not: use 'lu' or "
                        "'bicgstab'",
                        to_string(options_.solver)));
      const bool is_small = system_.size() <= kMostDenseUnknowns;  // lu takes all components at once
      used_ = options_.solver != Solver::kAuto ? options_.solver : is_small ? Solver::kLu : Solver::kBicgstab;
      const std::size_t components = system_.components().size();
      plain_ = PlainSystem(system_, is_wanted_);
      inverse_ = is_small ? make_lu(plain_, components) : make_bicgstab(plain_, components);
      if (!may_be_open && !system_.has_negative_factors() &&
          !spectral_radius_is_below_one(system_, *inverse_, is_wanted_))
        throw RequestError(
            "no radiosity: the spectral radius of reflectivity times factors is not below 1 (or too near it to tell); "
            "rows of the matrix sum to more than 1");
    }
    lap(is_refined() ? "radiosity" : "certificate");
    if (!is_refined()) {
      if (plain_.begin.empty()) plain_ = PlainSystem(system_, is_wanted_);
      lap("radiosity");
    }
    return used_;
  }

  std::size_t count() const { return channels_.size(); }
  int channel(std::size_t k) const { return channels_[k]; }

  // Bounds of all unknowns. REQUIRES prepare().
  CertifiedBounds solve(std::size_t k, ChannelSolution& solution, std::set<std::string>& notes) {
    const Sources& sources = sources_[k];
    SplitVector x{std::vector<DoubleDouble>(is_wanted_.size()), std::vector<DoubleDouble>(system_.size())};
    if (is_refined())
      solution.residual_history = refine(system_, sources, *inverse_, x);
    else
      run_as_named(sources, x, solution.residual_history, notes);
    lap("radiosity");
    CertifiedBounds bounds = certify(system_, sources, *inverse_, x, terms_);
    if (system_.rows_are_closed()) wide_.narrow(sources, {is_refined(), !is_refined()}, bounds);
    lap("certificate");
    if (matrix_.guarantee() == Guarantee::kExact) require_bounds(system_, bounds);
    if (const auto open = std::count(bounds.upper.begin(), bounds.upper.end(), kInfinity); open > 0)
      notes.insert(fmt::format("no upper bound could be proven for {} of {} radiosities", open, bounds.upper.size()));
    return bounds;
  }

  // What follows from them.
  void fill(std::size_t k, const CertifiedBounds& bounds, ChannelSolution& solution) {
    const Sources& sources = sources_[k];
    const int channel = channels_[k];
    for (std::size_t c = 0; c < sources.is_lit.size(); ++c)
      if (!sources.is_lit[c])
        solution.dark.push_back({system_.components()[c].first_element, system_.components()[c].size});

    MaterialNumbers numbers;
    for (const Material& m : materials_) {
      numbers.emission.emplace_back(m.emission.value[channel]);
      numbers.reflectivity.emplace_back(m.reflectivity.value[channel]);
      numbers.loss.push_back(ScaledBall::of(Rational(1 - m.reflectivity.value[channel])));
    }
    const std::vector<ScaledBall> radiosity = fill_radiosities(sources, bounds, numbers, solution);
    fill_irradiances(sources, radiosity, numbers, solution);
    lap("irradiance");
  }

 private:
  // What a channel of the materials is.
  struct MaterialNumbers {
    std::vector<Printed> emission, reflectivity;
    std::vector<ScaledBall> loss;  // 1 - reflectivity
  };

  // Returns the radiosities, enclosed.
  std::vector<ScaledBall> fill_radiosities(const Sources& sources, const CertifiedBounds& bounds,
                                           const MaterialNumbers& numbers, ChannelSolution& solution) const {
    std::vector<ScaledBall> radiosity = sources.emission;  // right for all that is known
    solution.elements.resize(matrix_.size());
    for (std::uint32_t i = 0; i < matrix_.size(); ++i) {
      if (!matrix_.has_row(i)) continue;
      ElementRadiosity& element = solution.elements[i];
      const Printed& e = numbers.emission[*matrix_.elements()[i].material];
      element.emission = e.nearest;
      element.reflectivity = numbers.reflectivity[*matrix_.elements()[i].material].nearest;
      const std::int32_t u = system_.unknown(i);
      if (u < 0) {
        element.radiosity = e.nearest;
        element.lower = e.lower;
        element.upper = e.upper;
      } else if (sources.is_lit[system_.rows()[static_cast<std::size_t>(u)].component]) {
        const auto place = static_cast<std::size_t>(u);
        radiosity[i] = bounds.enclosed(place);
        element.lower = lower_scaled(bounds.lower[place], bounds.exponent[place]);
        element.upper = upper_scaled(bounds.upper[place], bounds.exponent[place]);
        if (!system_.has_negative_factors()) element.lower = std::max(element.lower, e.lower);  // B >= E
        const double value = std::ldexp(radiosity[i].mantissa.hi, radiosity[i].exponent);
        element.radiosity = std::clamp(value, element.lower, element.upper);
        if (value < e.lower)
          radiosity[i] =
              ScaledBall::of(DoubleDoubleBall::around({element.radiosity, 0}, {element.lower, element.upper}));
        if (element.radiosity > 0)
          solution.max_relative_width =
              std::max(solution.max_relative_width, (element.upper - element.lower) / element.radiosity);
      }
    }
    return radiosity;
  }

  void fill_irradiances(const Sources& sources, const std::vector<ScaledBall>& radiosity,
                        const MaterialNumbers& numbers, ChannelSolution& solution) const {
    const std::vector<ScaledBall> irradiance = system_.irradiance(radiosity);
    EnergySum energy(matrix_);
    for (std::uint32_t i = 0; i < matrix_.size(); ++i) {
      if (!matrix_.has_row(i)) continue;
      const std::uint32_t material = *matrix_.elements()[i].material;
      const ScaledBall absorbed = product(numbers.loss[material], irradiance[i]);
      // Two forms of one number. Where the equations are not solved, the second is what the radiosities exchange.
      const ScaledBall net = difference(sources.emission[i], absorbed);
      const ScaledBall exchanged = is_refined() ? net : difference(radiosity[i], irradiance[i]);
      ElementRadiosity& element = solution.elements[i];
      element.irradiance = std::max(0.0, irradiance[i].nearest());
      element.net_value = exchanged.nearest();
      element.net_lower = std::min(net.lower(), element.net_value);
      element.net_upper = net.upper();
      if (!system_.has_negative_factors())  // H >= 0
        element.net_upper = std::min(element.net_upper, numbers.emission[material].upper);
      element.net_upper = std::max(element.net_upper, element.net_value);
      energy.add(i, sources.emission[i], absorbed, radiosity[i], sources.emission[matrix_.sky()]);
    }
    solution.energy = energy.balance();
  }

  void lap(const char* stage) { seconds_[stage] += watch_.lap(); }

  bool is_refined() const {
    const bool is_limited = options_.iterations || options_.until;
    return used_ == Solver::kCholesky || (used_ == Solver::kCg && !is_limited) ||
           (options_.solver == Solver::kAuto && !system_.rows_are_closed());
  }

  void run_as_named(const Sources& sources, SplitVector& x, std::vector<double>& history,
                    std::set<std::string>& notes) {
    plain_.set_source(system_, sources);
    const int most = options_.iterations.value_or(used_ == Solver::kShooting ? kDefaultShots : kDefaultIterations);
    const double until = options_.until.value_or(options_.iterations ? 0 : kDefaultUntil);
    const CgLimits limits{most, until};
    const std::size_t components = is_wanted_.size();
    if (used_ == Solver::kJacobi || used_ == Solver::kGaussSeidel || used_ == Solver::kShooting) {
      const auto run = used_ == Solver::kJacobi ? jacobi : used_ == Solver::kGaussSeidel ? gauss_seidel : shooting;
      IterationResult result = run(plain_, {most, until});
      take({std::vector<double>(components, 0), std::move(result.x)}, x);
      history = std::move(result.history);
    } else if (used_ == Solver::kLu) {
      const Correction result = make_lu(plain_, components)->solve(plain_.source);
      history.push_back(plain_.relative(plain_.residual(plain_.source, result.rest)));
      take(result, x);
      return;
    } else {
      const auto solver = used_ == Solver::kCg ? make_conjugate_gradient(system_, is_wanted_, limits, &history)
                                               : make_bicgstab(plain_, components, limits, &history);
      take(solve_by_component(system_, *solver, plain_.source), x);
    }
    if (!(history.back() <= (options_.until || !options_.iterations ? until : kWorthANote)))
      notes.insert(fmt::format(
          "{} stopped after {} iterations with a relative residual of {:.2g}: by so much radiosities differ "
          "from emission + reflectivity * irradiance",
          to_string(used_), history.size() - 1, history.back()));
  }

  static void take(const Correction& from, SplitVector& x) {
    for (std::size_t c = 0; c < x.constant.size(); ++c)
      x.constant[c] = {std::isfinite(from.constant[c]) ? from.constant[c] : 0, 0};
    for (std::size_t i = 0; i < x.rest.size(); ++i) x.rest[i] = {std::isfinite(from.rest[i]) ? from.rest[i] : 0, 0};
  }

  const ExchangeMatrix& matrix_;
  const std::vector<Material>& materials_;
  std::vector<int> channels_;
  const RadiosityOptions& options_;
  ErrorTerms terms_;
  std::map<std::string, double>& seconds_;
  Stopwatch watch_;
  RadiositySystem system_;
  HighPrecisionElimination wide_;
  std::vector<char> is_wanted_;
  PlainSystem plain_;
  std::vector<Sources> sources_;
  std::unique_ptr<ApproximateInverse> inverse_;
  Solver used_ = Solver::kAuto;
};

// Channels 0, 1, 2 (or 0 alone) by equal reflectivities of all rows.
std::vector<std::vector<int>> groups_of_channels(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                                                 int channels) {
  std::vector<char> is_used(materials.size(), 0);
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i)) is_used[*matrix.elements()[i].material] = 1;
  const auto are_equal = [&](int a, int b) {
    for (std::size_t m = 0; m < materials.size(); ++m)
      if (is_used[m] && materials[m].reflectivity.value[a] != materials[m].reflectivity.value[b]) return false;
    return true;
  };
  std::vector<std::vector<int>> groups;
  for (int c = 0; c < channels; ++c) {
    const auto group =
        std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return are_equal(g.front(), c); });
    if (group == groups.end())
      groups.push_back({c});
    else
      group->push_back(c);
  }
  return groups;
}

}  // namespace

RadiositySolution solve_as_given(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                                 const Spectrum& sky_emission, const RadiosityOptions& options, bool may_be_open,
                                 const ErrorTerms& terms) {
  const bool is_gray = sky_emission.is_scalar && std::all_of(materials.begin(), materials.end(), [](const Material& m) {
                         return m.reflectivity.is_scalar && m.emission.is_scalar;
                       });
  RadiositySolution solution;
  solution.channel_names = is_gray ? std::vector<std::string>{"all"} : std::vector<std::string>{"r", "g", "b"};
  const int channels = static_cast<int>(solution.channel_names.size());
  solution.channels.resize(solution.channel_names.size());
  std::set<std::string> notes;
  int done = 0;
  for (auto& channels_of_group : groups_of_channels(matrix, materials, channels)) {
    Group group(matrix, materials, sky_emission, std::move(channels_of_group), options, terms, solution.seconds);
    group.require_solution(notes);
    if (group.needs_solving()) {
      solution.used = group.prepare(may_be_open);
      ++solution.factorizations;
    }
    solution.unknowns = std::max(solution.unknowns, static_cast<std::uint32_t>(group.system().size()));
    solution.components = std::max(solution.components, static_cast<std::uint32_t>(group.system().components().size()));
    for (std::size_t k = 0; k < group.count(); ++k) {
      ChannelSolution& channel = solution.channels[group.channel(k)];
      group.fill(k, group.needs_solving() ? group.solve(k, channel, notes) : CertifiedBounds(), channel);
      if (options.progress) options.progress(static_cast<double>(++done) / channels);
    }
  }
  for (const ChannelSolution& channel : solution.channels) {
    solution.max_relative_width = std::max(solution.max_relative_width, channel.max_relative_width);
    solution.energy.emitted += channel.energy.emitted;
    solution.energy.absorbed += channel.energy.absorbed;
    solution.energy.to_sky += channel.energy.to_sky;
    solution.energy.defect += channel.energy.defect;
  }
  solution.closure_defect = closure_defect(matrix);
  solution.reciprocity_defect = reciprocity_defect(matrix);
  solution.notes.assign(notes.begin(), notes.end());
  return solution;
}

}  // namespace hottel
