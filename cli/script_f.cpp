#include "cli/script_f.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "kernel/support/naming_file.h"
#include "kernel/support/stopwatch.h"
#include "solver/radiosity/gray_exchange.h"

namespace hottel {
namespace {

constexpr std::array<const char*, 3> kChannels{"r", "g", "b"};

// The channel asked for; without one all materials of faces must be gray.
int channel_of(const FactorsOptions& options, const ExchangeMatrix& matrix, const std::vector<Material>& materials) {
  if (!materials.empty() && materials.front().has_bands) {
    if (!options.channel.empty())
      throw UsageError(options.scene + " has two bands, not r, g and b: script-F is of the thermal one");
    return static_cast<int>(kThermalBand);
  }
  if (!options.channel.empty())
    return static_cast<int>(std::find(kChannels.begin(), kChannels.end(), options.channel) - kChannels.begin());
  if (const auto row = first_coloured(matrix, materials)) {
    const Element& element = matrix.elements()[*row];
    throw RequestError(fmt::format("{}: '{}', the material of '{}', is not gray: choose --channel r, g or b",
                                   options.scene, materials[*element.material].name, element.name));
  }
  return 0;
}

}  // namespace

GrayFactors gray_factors(const FactorsOptions& options, const ExchangeMatrix& matrix,
                         const std::vector<Material>& materials, const Streams& streams) {
  Stopwatch watch;
  const int channel = channel_of(options, matrix, materials);
  ExchangeMatrix gray = naming_file(options.scene, [&] {
    return gray_exchange(
        matrix, materials,
        {.channel = channel, .memory = memory_allowed(options.memory), .progress = streams.progress("script-F")});
  });
  const bool has_bands = !materials.empty() && materials.front().has_bands;
  const std::string told = has_bands ? "thermal" : options.channel.empty() ? "all" : options.channel;
  GrayReport report = gray_report(gray, told, watch.lap());
  return {std::move(gray), channel, std::move(report)};
}

}  // namespace hottel
