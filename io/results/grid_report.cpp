#include "io/results/grid_report.h"

#include <fmt/format.h>

#include <cmath>

#include "io/results/csv_field.h"
#include "kernel/rational.h"
#include "kernel/support/counted.h"

namespace hottel {
std::array<double, 3> GridPlace::centre(std::uint32_t iu, std::uint32_t iv) const {
  const std::array<double, 2> part = fractions(iu, iv);
  std::array<double, 3> point = origin;
  for (std::size_t k = 0; k < 3; ++k) point[k] += part[0] * u[k] + part[1] * v[k];
  return point;
}

std::array<double, 2> GridPlace::fractions(std::uint32_t iu, std::uint32_t iv) const {
  return {(iu + 0.5) / nu, (iv + 0.5) / nv};
}

std::string grid_csv(std::span<const GridErrors> errors, std::span<const std::string> channels,
                     const GridPlace& place) {
  std::string text = "channel,cells,missing,extra,max_error,rms_error,largest,ix,iy,x,y,z,value,exact\n";
  for (std::size_t c = 0; c < errors.size(); ++c) {
    const GridErrors& each = errors[c];
    const std::array<double, 3> at = place.centre(each.ix, each.iy);
    text += fmt::format("{},{},{},{},{},{},{}", csv_field(channels[c]), each.cells, each.missing, each.extra,
                        csv_number(each.max), csv_number(each.rms), csv_number(each.largest));
    if (each.cells == 0)
      text += ",,,,,,,\n";
    else
      text += fmt::format(",{},{},{},{},{},{},{}\n", each.ix, each.iy, csv_number(at[0]), csv_number(at[1]),
                          place.is_in_space ? csv_number(at[2]) : "", csv_number(each.value), csv_number(each.exact));
  }
  return text;
}

std::vector<std::string> grid_sentences(std::span<const GridErrors> errors, std::span<const std::string> channels,
                                        const GridPlace& place, double beyond, const std::string& reading) {
  std::vector<std::string> sentences;
  std::uint64_t missing = 0, extra = 0;
  bool any_off = false;
  for (std::size_t c = 0; c < errors.size(); ++c) {
    const GridErrors& each = errors[c];
    missing = std::max(missing, each.missing);
    extra = std::max(extra, each.extra);
    const std::string of = errors.size() > 1 ? channels[c] + ": " : "";
    if (each.cells == 0) {
      sentences.push_back(of + "no cell can be compared");
      continue;
    }
    if (each.max == 0) {
      sentences.push_back(of + counted(each.cells, "cell") + " hold the exact light");
      continue;
    }
    if (each.off == 0) {
      sentences.push_back(
          fmt::format("{}all {} cells agree with the exact light within {:.2g} of the largest and the digits written "
                      "(largest difference {:.2g})",
                      of, each.cells, beyond, each.max));
      continue;
    }
    any_off = true;
    const std::array<double, 3> at = place.centre(each.ix, each.iy);
    const std::string where =
        fmt::format("{:.6g}, {:.6g}", at[0], at[1]) + (place.is_in_space ? fmt::format(", {:.6g}", at[2]) : "");
    sentences.push_back(fmt::format(
        "{}{} of {} {} off{} {:.3g}, {:.3g} root mean square over all, of up to {:.3g}; the worst is cell {}, {} at "
        "({}): {:.6g} instead of {:.6g}",
        of, each.off, counted(each.cells, "cell"), each.off == 1 ? "is" : "are", each.off == 1 ? " by" : " by up to",
        each.max, each.rms, each.largest, each.ix, each.iy, where, each.value, each.exact));
  }
  if (missing > 0) sentences.push_back(counted(missing, "cell") + " of the room have no finite value");
  if (extra > 0) sentences.push_back(counted(extra, "cell") + " in solids, or at lights, have a value");
  if (any_off && !reading.empty())
    sentences.push_back("the light is " + reading + ": this explains nine tenths of the error");
  return sentences;
}

}  // namespace hottel
