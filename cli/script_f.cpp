#include "cli/script_f.h"

#include <utility>

#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "kernel/support/stopwatch.h"
#include "kernel/support/with_file_context.h"
#include "solver/radiosity/gray_exchange.h"

namespace hottel {
namespace {

int channel_of(const FactorsOptions& options, const ExchangeMatrix& matrix, const std::vector<Material>& materials) {
  if (!materials.empty() && materials.front().has_bands && !options.channel.empty())
    throw UsageError(options.scene + " has two bands, not r, g and b: script-F is of the thermal one");
  return with_file_context(options.scene, [&] { return gray_channel(matrix, materials, options.channel); });
}

}  // namespace

GrayFactors gray_factors(const FactorsOptions& options, const ExchangeMatrix& matrix,
                         const std::vector<Material>& materials, const Streams& streams) {
  Stopwatch watch;
  const int channel = channel_of(options, matrix, materials);
  ExchangeMatrix gray = with_file_context(options.scene, [&] {
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
