#include "viewer/window/mode_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "kernel/decimal.h"
#include "kernel/support/interrupt.h"

namespace hottel {
namespace {

constexpr auto kBetweenSweeps = std::chrono::milliseconds(100);

}  // namespace

std::vector<std::string> error_lines(const MethodResult& found) {
  std::vector<std::string> lines{found.info.name,
                                 fmt::format("largest error of a view factor {:.3g}", found.errors.max)};
  if (found.max_radiosity_error && std::isfinite(*found.max_radiosity_error))
    lines.push_back(fmt::format("of a radiosity {:.3g} of the largest", *found.max_radiosity_error));
  else
    lines.push_back("its radiosities cannot be had: there is no error to draw");
  return lines;
}

SweepTexts sweep_texts(Solver solver, int sweeps, const RadiositySolution& radiosities) {
  double residual = 0;
  for (const ChannelSolution& channel : radiosities.channels)
    if (!channel.residual_history.empty()) residual = std::max(residual, channel.residual_history.back());
  return {{fmt::format("{}, {} {}", to_string(solver), sweeps, solver == Solver::kShooting ? "shots" : "sweeps"),
           fmt::format("residual {:.3g} of the largest source", residual)},
          shortest(residual)};
}

void wait_between_sweeps() {
  for (auto waited = std::chrono::milliseconds(0); waited < kBetweenSweeps; waited += kBetweenSweeps / 10) {
    std::this_thread::sleep_for(kBetweenSweeps / 10);
    throw_if_interrupted();
  }
}

}  // namespace hottel
