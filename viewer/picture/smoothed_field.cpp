#include "viewer/picture/smoothed_field.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "kernel/support/parallel.h"

namespace hottel {
namespace {

constexpr int kPasses = 3;  // of a box: about a bell curve

// A row or a column of pixels, and where it is parted.
struct Strand {
  std::vector<double> values;
  std::vector<bool> ends;  // after this pixel begins another run
};

// Each value of [begin, end) by the mean of those that are at most `radius` away.
void average(std::size_t begin, std::size_t end, std::size_t radius, std::vector<double>& values,
             std::vector<double>& sums) {
  sums.assign(1, 0);
  for (std::size_t k = begin; k < end; ++k) sums.push_back(sums.back() + values[k]);
  const auto [low, high] = std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                               values.begin() + static_cast<std::ptrdiff_t>(end));
  const double least = *low, most = *high;
  for (std::size_t k = begin; k < end; ++k) {
    // As many on both sides, so that what rises evenly stays.
    const std::size_t near = std::min({radius, k - begin, end - 1 - k});
    const double sum = sums[k + near + 1 - begin] - sums[k - near - begin];
    values[k] = std::clamp(sum / static_cast<double>(2 * near + 1), least, most);
  }
}

void average(Strand& strand, std::size_t radius) {
  std::vector<double> sums;
  for (std::size_t begin = 0, end = 0; begin < strand.values.size(); begin = end) {
    end = begin + 1;
    while (end < strand.values.size() && !strand.ends[end - 1]) ++end;
    for (int pass = 0; pass < kPasses; ++pass) average(begin, end, radius, strand.values, sums);
  }
}

class Field {
 public:
  explicit Field(PixelField& field) : field_(field) {}

  Strand row(std::uint32_t y) const {
    Strand strand;
    for (std::uint32_t x = 0; x < field_.width; ++x) {
      strand.values.push_back(at(x, y));
      strand.ends.push_back(x + 1 == field_.width || is_parted(at(x, y), at(x + 1, y)) ||
                            (is_cut(x, y) && is_cut(x, y - std::size_t{1})));
    }
    return strand;
  }
  Strand column(std::uint32_t x) const {
    Strand strand;
    for (std::uint32_t y = 0; y < field_.height; ++y) {
      strand.values.push_back(at(x, y));
      strand.ends.push_back(y + 1 == field_.height || is_parted(at(x, y), at(x, y + 1)) ||
                            (is_cut(x, y) && is_cut(x - std::size_t{1}, y)));
    }
    return strand;
  }
  void set_row(std::uint32_t y, const Strand& strand) {
    for (std::uint32_t x = 0; x < field_.width; ++x) at(x, y) = static_cast<float>(strand.values[x]);
  }
  void set_column(std::uint32_t x, const Strand& strand) {
    for (std::uint32_t y = 0; y < field_.height; ++y) at(x, y) = static_cast<float>(strand.values[y]);
  }

 private:
  float& at(std::uint32_t x, std::uint32_t y) const { return field_.values[std::size_t{y} * field_.width + x]; }
  static bool is_parted(float a, float b) { return std::isnan(a) || std::isnan(b); }
  // A square that is not there is one.
  bool is_cut(std::size_t x, std::size_t y) const {
    if (x >= field_.width - 1 || y >= field_.height - 1) return true;
    return !field_.cut.empty() && field_.cut[y * (field_.width - 1) + x];
  }

  PixelField& field_;
};

}  // namespace

PixelField smoothed_field(PixelField field, double deviation) {
  if (field.width < 2 || field.height < 2) return field;
  // Boxes of this radius three times over have the deviation sqrt(radius (radius + 1)).
  const auto radius = static_cast<std::size_t>(std::max(1.0, std::round(std::hypot(deviation, 0.5) - 0.5)));
  Field strands(field);
  parallel_for(field.height, [&](std::size_t y) {
    Strand row = strands.row(static_cast<std::uint32_t>(y));
    average(row, radius);
    strands.set_row(static_cast<std::uint32_t>(y), row);
  });
  parallel_for(field.width, [&](std::size_t x) {
    Strand column = strands.column(static_cast<std::uint32_t>(x));
    average(column, radius);
    strands.set_column(static_cast<std::uint32_t>(x), column);
  });
  return field;
}

}  // namespace hottel
