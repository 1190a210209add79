#include "solver/radiosity/factors_as_given.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "kernel/support/counted.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/channel_result.h"
#include "solver/radiosity/system_solver.h"

namespace hottel {

// Channels that reflect alike, and what is kept of them.
struct FactorsAsGiven::Group {
  std::vector<int> channels;
  std::vector<Rational> reflectivity;  // by material
  CachedSystem kept;

  Group(const ExchangeMatrix& matrix, std::vector<int> of, std::vector<Rational> rho)
      : channels(std::move(of)), reflectivity(std::move(rho)), kept(matrix, reflectivity) {}
};

namespace {

// Channels 0, 1, 2 by equal reflectivities of all rows.
std::vector<std::vector<int>> groups_of_channels(const ExchangeMatrix& matrix,
                                                 const std::vector<Spectrum>& reflectivity) {
  std::vector<char> is_used(reflectivity.size(), 0);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const std::uint32_t material = *matrix.elements()[i].material;
    HOTTEL_REQUIRE(material < reflectivity.size());
    is_used[material] = 1;
  }
  const auto are_equal = [&](int a, int b) {
    for (std::size_t m = 0; m < reflectivity.size(); ++m)
      if (is_used[m] && reflectivity[m].value[a] != reflectivity[m].value[b]) return false;
    return true;
  };
  std::vector<std::vector<int>> groups;
  for (int c = 0; c < 3; ++c) {
    const auto group =
        std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return are_equal(g.front(), c); });
    if (group == groups.end())
      groups.push_back({c});
    else
      group->push_back(c);
  }
  return groups;
}

// Refuses what has no solution, and notes what is a limit.
void require_solution(const RadiositySystem& system, const std::vector<char>& is_lit, bool has_given_fluxes,
                      std::set<std::string>& notes) {
  // Where the real factors of a row sum to 1, what estimates lack of it is an error and no way out.
  if (!system.rows_are_closed() && !system.matrix().has_closed_rows()) return;
  for (std::size_t c = 0; c < is_lit.size(); ++c) {
    const SystemComponent& component = system.components()[c];
    if (component.loses) continue;
    const std::string reflectors =
        fmt::format("'{}' and what it exchanges light with ({} in all)",
                    system.matrix().elements()[component.first_element].name, counted(component.size, "element"));
    if (is_lit[c] && has_given_fluxes)
      throw RequestError(
          "no temperatures: " + reflectors +
          " reflect all light or have a given net flux and let none out: give one of them a temperature, or open a way "
          "out");
    if (is_lit[c])
      throw RequestError(
          "no radiosity: " + reflectors +
          " reflect all light, let none out, and emit: give one of them a reflectivity below 1, or open a way out");
    notes.insert(reflectors + " reflect all light, let none out and do not emit: radiosity is 0, the limit");
  }
}

}  // namespace

// One call of solve().
struct FactorsAsGiven::Run {
  const RadiositySources& given;
  const RadiosityOptions& options;
  const ErrorTerms& terms;
  bool may_be_open;
  RadiositySolution solution{};
  std::set<std::string> notes{};
  StageTimes times{};
  std::size_t done = 0;  // channels

  void solve(const Group& group) {
    const RadiositySystem& system = group.kept.system;
    std::vector<int> channels;
    for (const int channel : group.channels)
      if (static_cast<std::size_t>(channel) < solution.channels.size() &&
          channel == given.only_channel.value_or(channel))
        channels.push_back(channel);
    if (channels.empty()) return;
    std::vector<Sources> sources;
    std::vector<char> is_lit(system.components().size(), 0);  // in some channel
    for (const int channel : channels) {
      sources.push_back(system.sources(given, channel));
      for (std::size_t c = 0; c < is_lit.size(); ++c) is_lit[c] |= sources.back().is_lit[c];
    }
    require_solution(system, is_lit, given.has_given_fluxes, notes);
    std::optional<SystemSolver> solver;
    if (std::find(is_lit.begin(), is_lit.end(), 1) != is_lit.end()) {
      solution.used = solver.emplace(group.kept, is_lit, options, may_be_open, times).used();
      ++solution.factorizations;
    }
    solution.unknowns = std::max(solution.unknowns, static_cast<std::uint32_t>(system.size()));
    solution.components = std::max(solution.components, static_cast<std::uint32_t>(system.components().size()));
    const ChannelResults results(system, group.reflectivity, solver && solver->is_refined());
    for (std::size_t k = 0; k < channels.size(); ++k) {
      ChannelSolution& channel = solution.channels[static_cast<std::size_t>(channels[k])];
      const CertifiedBounds bounds =
          solver ? solver->solve(sources[k], terms, channel.residual_history, notes, times) : CertifiedBounds();
      results.fill(given, channels[k], sources[k], bounds, terms.meant, solver ? solver->others() : nullptr, channel);
      times.lap("irradiance");
      if (options.progress)
        options.progress(static_cast<double>(++done) / static_cast<double>(solution.channels.size()));
    }
  }
};

FactorsAsGiven::FactorsAsGiven(const ExchangeMatrix& matrix, const std::vector<Spectrum>& reflectivity)
    : matrix_(matrix),
      has_gray_reflectivities_(std::all_of(reflectivity.begin(), reflectivity.end(),
                                           [](const Spectrum& spectrum) { return spectrum.is_scalar; })) {
  for (std::vector<int>& channels : groups_of_channels(matrix, reflectivity)) {
    std::vector<Rational> rho = in_channel(reflectivity, channels.front());
    groups_.push_back(std::make_unique<const Group>(matrix, std::move(channels), std::move(rho)));
  }
}

FactorsAsGiven::~FactorsAsGiven() = default;

bool FactorsAsGiven::is_gray(const RadiositySources& sources) const {
  if (!has_gray_reflectivities_ || sources.has_channels || !sources.sky.is_scalar()) return false;
  for (std::uint32_t i = 0; i < matrix_.size(); ++i) {
    if (!matrix_.has_row(i)) continue;
    if (!sources.emission[i].is_scalar()) return false;
    if (!sources.direct_irradiance.empty() && !sources.direct_irradiance[i].is_scalar()) return false;
  }
  return true;
}

RadiositySolution FactorsAsGiven::solve(const RadiositySources& sources, const RadiosityOptions& options,
                                        bool may_be_open, const ErrorTerms& terms) const {
  Run run{sources, options, terms, may_be_open};
  RadiositySolution& solution = run.solution;
  solution.channel_names = sources.has_bands  ? std::vector<std::string>{"solar", "thermal"}
                           : is_gray(sources) ? std::vector<std::string>{"all"}
                                              : std::vector<std::string>{"r", "g", "b"};
  solution.channels.resize(solution.channel_names.size());
  for (ChannelSolution& channel : solution.channels) channel.elements.resize(matrix_.size());
  for (const auto& group : groups_) run.solve(*group);
  sum_up_channels(solution);
  solution.seconds = std::move(run.times.seconds);
  solution.notes.assign(run.notes.begin(), run.notes.end());
  return std::move(solution);
}

}  // namespace hottel
