#include "cli/machine_speed.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/generate/generators.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/files/output_file.h"
#include "io/files/text_file.h"
#include "kernel/rational.h"
#include "kernel/support/parallel.h"
#include "kernel/version.h"

namespace hottel {
namespace {

constexpr double kReferenceSeconds = 7.2e-4;  // what measure() finds on the machine of the constants
constexpr int kRuns = 7;
constexpr const char* kWhat = "sweep";

std::optional<double> positive(const std::string& text) {
  const std::optional<Rational> number = parse_rational(text);
  if (!number) return std::nullopt;
  const double value = to_double(*number);
  return value > 0 && value < std::numeric_limits<double>::infinity() ? std::optional(value) : std::nullopt;
}

// The exact factors of a small scene, at their fastest, in time of the processor: what else runs does not count.
double measure() {
  const ThreadLimit one(1);
  const PreparedScene2 prepared = prepare(generate_2({.kind = "clutter", .n = 100, .seed = 1}));
  double fastest = std::numeric_limits<double>::infinity();
  for (int run = 0; run < kRuns; ++run) {
    const std::clock_t start = std::clock();
    exact_exchange(prepared, {.wants_visibility = false});
    fastest = std::min(fastest, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return fastest / kReferenceSeconds;
}

// Empty where there is no such folder to be.
std::filesystem::path kept_in() {
  for (const auto& [variable, below] : {std::pair("XDG_CACHE_HOME", ""), std::pair("HOME", ".cache")})
    if (const char* const folder = std::getenv(variable); folder != nullptr && *folder == '/')
      return std::filesystem::path(folder) / below / "hottel" / "speed";
  return {};
}

// "0.2.0 sweep 1.25": the version that measured, of what, and how slow it is.
std::optional<double> kept(const std::filesystem::path& file) {
  std::error_code ignored;
  if (file.empty() || !std::filesystem::exists(file, ignored)) return std::nullopt;
  std::istringstream words(read_text_file(file));
  std::string version, what, speed;
  words >> version >> what >> speed;
  return version == kVersion && what == kWhat ? positive(speed) : std::nullopt;
}

void keep(const std::filesystem::path& file, double speed) {
  if (file.empty()) return;
  std::filesystem::create_directories(file.parent_path());
  OutputFile out(file);
  out.write(std::string(kVersion) + " " + kWhat + " " + shortest(speed) + "\n");
  out.finish();
  out.commit();
}

}  // namespace

MachineSpeed machine_speed() noexcept {
  try {
    if (const char* const told = std::getenv("HOTTEL_SPEED"); told != nullptr)
      if (const auto speed = positive(told)) return {*speed, 1};
    const std::filesystem::path file = kept_in();
    if (const auto speed = kept(file)) return {*speed, threads_allowed()};
    const double speed = measure();
    try {
      keep(file, speed);
    } catch (...) {  // a cache that cannot be written is none
    }
    return {speed, threads_allowed()};
  } catch (...) {
    return {};
  }
}

}  // namespace hottel
