#include "io/results/texel_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/results/csv_field.h"
#include "kernel/support/counted.h"

namespace hottel {
namespace {

// "0.0123 (9.01 %)"
std::string beside_mean(double value, double mean, const std::string& of_mean = "") {
  const std::string text = fmt::format("{:.3g}", value);
  return mean > 0 ? text + fmt::format(" ({:.3g} %{})", 100 * value / mean, of_mean) : text;
}

std::string agreement(const GridErrors& errors, double beyond) {
  if (errors.max == 0) return counted(errors.cells, "texel") + " have the exact light";
  return fmt::format(
      "all {} texels agree with the exact light within {:.2g} of the largest and the digits written (largest "
      "difference {:.2g})",
      errors.cells, beyond, errors.max);
}

std::string disagreement(const JudgedTexels& texels, const GridErrors& errors) {
  const std::array<double, 3> at = texels.place.centre(errors.ix, errors.iy);
  const std::array<double, 2> place = texels.place.fractions(errors.ix, errors.iy);
  return fmt::format(
      "{} of {} {} off by up to {}, {} root mean square, {} on average; the worst is texel {}, {} at S,T = "
      "{:.6g},{:.6g} "
      "({:.6g}, {:.6g}, {:.6g}): {:.6g} instead of {:.6g}",
      errors.off, counted(errors.cells, "texel"), errors.off == 1 ? "is" : "are",
      beside_mean(errors.max, errors.mean, fmt::format(" of the mean {:.3g}", errors.mean)),
      beside_mean(errors.rms, errors.mean), beside_mean(errors.bias, errors.mean), errors.ix, errors.iy, place[0],
      place[1], at[0], at[1], at[2], errors.value, errors.exact);
}

}  // namespace

std::string texel_csv(const JudgedTexels& texels) {
  std::string text = "channel,texels,missing,extra,max_error,rms_error,mean_error,mean,ix,iy,s,t,x,y,z,value,exact\n";
  for (std::size_t c = 0; c < texels.errors.size(); ++c) {
    const GridErrors& each = texels.errors[c];
    const std::array<double, 3> at = texels.place.centre(each.ix, each.iy);
    const std::array<double, 2> place = texels.place.fractions(each.ix, each.iy);
    text += fmt::format("{},{},{},{}", csv_field(texels.channels[c]), each.cells, each.missing, each.extra);
    for (const double value : {each.max, each.rms, each.bias, each.mean}) text += "," + csv_number(value);
    text += fmt::format(",{},{}", each.ix, each.iy);
    for (const double value : {place[0], place[1], at[0], at[1], at[2], each.value, each.exact})
      text += "," + csv_number(value);
    text += "\n";
  }
  return text;
}

std::vector<std::string> texel_sentences(const JudgedTexels& texels) {
  std::vector<std::string> sentences;
  std::uint64_t missing = 0, extra = 0;
  bool any_off = false;
  for (std::size_t c = 0; c < texels.errors.size(); ++c) {
    const GridErrors& each = texels.errors[c];
    missing = std::max(missing, each.missing);
    extra = std::max(extra, each.extra);
    any_off = any_off || each.off > 0;
    sentences.push_back((texels.errors.size() > 1 ? texels.channels[c] + ": " : "") +
                        (each.off == 0 ? agreement(each, texels.beyond) : disagreement(texels, each)));
  }
  if (missing > 0) sentences.push_back("no finite value for " + counted(missing, "texel") + " of the face");
  if (extra > 0) sentences.push_back("values for " + counted(extra, "texel") + " where the face has no light");
  if (any_off && !texels.reading.empty())
    sentences.push_back("the light is " + texels.reading + ": this explains nine tenths of the error");
  return sentences;
}

}  // namespace hottel
