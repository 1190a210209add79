#include "solver/compare/work_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr double kAsFast = 1.1;  // ratios of times below this are not told apart

// The points that no point as cheap beats: ascending times, falling errors.
std::vector<WorkPoint> front(std::span<const WorkPoint> curve) {
  std::vector<WorkPoint> sorted(curve.begin(), curve.end()), best;
  std::sort(sorted.begin(), sorted.end(), [](const WorkPoint& a, const WorkPoint& b) {
    return std::pair(a.seconds, a.error) < std::pair(b.seconds, b.error);
  });
  for (const WorkPoint& point : sorted)
    if (best.empty() || point.error < best.back().error) best.push_back(point);
  return best;
}

// "exact", "exact:normalised", "arithmetic:doubles"
bool is_exact_again(const std::string& family) {
  const std::string head = family.substr(0, family.find(':'));
  return head == kExactFamily || head == kArithmeticFamily;
}

// "1.23 ms"
std::string duration(double seconds) {
  for (const auto& [unit, scale] : {std::pair("s", 1.0), std::pair("ms", 1e3), std::pair("µs", 1e6)})
    if (seconds * scale >= 1) return fmt::format("{:.3g} {}", seconds * scale, unit);
  return fmt::format("{:.3g} ns", seconds * 1e9);
}

std::string error_words(double error, ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kRmsFactor:
      return fmt::format("a root mean square error of {:g}", error);
    case ErrorKind::kRadiosity:
      return fmt::format("an error of {:g} of the largest radiosity", error);
    case ErrorKind::kFaceRadiosity:
      return fmt::format("an error of {:g} of the largest mean radiosity of a face", error);
    case ErrorKind::kMaxFactor:
      break;
  }
  return fmt::format("an error of {:g}", error);
}

}  // namespace

std::vector<WorkCurve> work_curves(std::span<const MethodResult> results, ErrorKind kind) {
  std::vector<WorkCurve> curves;
  for (const MethodResult& result : results) {
    const double error = error_of(result, kind);
    if (std::isnan(result.timing.median) || std::isnan(error)) continue;
    auto curve = std::find_if(curves.begin(), curves.end(),
                              [&](const WorkCurve& each) { return each.family == result.info.family; });
    if (curve == curves.end()) curve = curves.insert(curve, WorkCurve{result.info.family, {}});
    curve->points.push_back({result.info.name, result.timing.median, error, result.info.parameter});
  }
  return curves;
}

std::optional<double> seconds_to_reach(std::span<const WorkPoint> curve, double error) {
  HOTTEL_REQUIRE(error > 0);
  const std::vector<WorkPoint> points = front(curve);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const WorkPoint& there = points[k];
    if (there.error > error) continue;
    if (k == 0 || there.error == 0 || !std::isfinite(points[k - 1].error)) return there.seconds;
    const WorkPoint& before = points[k - 1];
    const double part = same_bits::log(before.error / error) / same_bits::log(before.error / there.error);
    return before.seconds * same_bits::pow(there.seconds / before.seconds, part);
  }
  return std::nullopt;
}

std::vector<WorkReading> read_off(std::span<const WorkCurve> curves, std::span<const double> errors) {
  const auto exact =
      std::find_if(curves.begin(), curves.end(), [](const WorkCurve& c) { return c.family == kExactFamily; });
  std::vector<WorkReading> readings;
  const bool is_alone = std::all_of(curves.begin(), curves.end(), [](const WorkCurve& curve) {
    return curve.family == kExactFamily || is_exact_again(curve.family);
  });
  if (exact == curves.end() || is_alone) return readings;
  for (const double error : errors) {
    WorkReading reading{error, exact->points.front().seconds, "", std::numeric_limits<double>::infinity()};
    for (const WorkCurve& curve : curves) {
      if (is_exact_again(curve.family)) continue;
      const std::optional<double> seconds = seconds_to_reach(curve.points, error);
      if (seconds && *seconds < reading.seconds) {
        reading.seconds = *seconds;
        reading.family = curve.family;
      }
    }
    readings.push_back(reading);
  }
  return readings;
}

std::string to_sentence(const WorkReading& reading, ErrorKind kind) {
  const std::string at = error_words(reading.error, kind);
  if (reading.family.empty())
    return fmt::format("at {} exact ({}) stands alone: no other method that is timed reaches it", at,
                       duration(reading.exact_seconds));
  const double ratio = reading.seconds / reading.exact_seconds, times = std::max(ratio, 1 / ratio);
  const std::string verdict = times < kAsFast
                                  ? "takes about as long as"
                                  : fmt::format("is {:.3g} times {} than", times, ratio > 1 ? "faster" : "slower");
  return fmt::format("at {} exact ({}) {} the cheapest method that reaches it, {} ({})", at,
                     duration(reading.exact_seconds), verdict, reading.family, duration(reading.seconds));
}

}  // namespace hottel
