#include "viewer/picture/contours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

#include "kernel/plain_functions.h"
#include "viewer/picture/picture_options.h"

namespace hottel {
namespace {

// The sides of squares by number: side 2 (y width + x) runs right from the centre (x, y), the next one down from it.
class LevelLines {
 public:
  LevelLines(const PixelField& field, double level) : field_(field), level_(level) {}

  std::vector<PixelLine> all() {
    for (std::uint32_t y = 0; y + 1 < field_.height; ++y)
      for (std::uint32_t x = 0; x + 1 < field_.width; ++x) add_square(x, y);
    std::vector<PixelLine> lines;
    // Open lines from their ends, then what is left: closed ones. In the order in which they were met.
    for (const std::uint64_t side : met_)
      if (is_end(side)) follow(side, lines);
    for (const std::uint64_t side : met_) follow(side, lines);
    return lines;
  }

 private:
  static constexpr std::uint64_t kNone = ~std::uint64_t{0};
  struct Links {
    std::uint64_t one = kNone, other = kNone;
  };

  float value(std::uint32_t x, std::uint32_t y) const { return field_.values[std::size_t{y} * field_.width + x]; }
  bool is_end(std::uint64_t side) const {
    const Links& links = links_.at(side);
    return (links.one == kNone) != (links.other == kNone);
  }

  void add_square(std::uint32_t x, std::uint32_t y) {
    if (!field_.cut.empty() && field_.cut[std::size_t{y} * (field_.width - 1) + x]) return;
    const float corners[] = {value(x, y), value(x + 1, y), value(x + 1, y + 1), value(x, y + 1)};
    int above = 0;
    for (int k = 0; k < 4; ++k) {
      if (std::isnan(corners[k])) return;
      above |= (corners[k] >= level_ ? 1 : 0) << k;
    }
    if (above == 0 || above == 15) return;
    const std::uint64_t first = 2 * (std::uint64_t{y} * field_.width + x);
    const std::uint64_t sides[] = {first, first + 3, first + 2 * std::uint64_t{field_.width},
                                   first + 1};  // of k, k + 1
    if (above == 5 || above == 10) {
      // Two lines, around the corners that the mean of all sets apart.
      const double mean = (double{corners[0]} + corners[1] + corners[2] + corners[3]) / 4;
      const int apart = (mean >= level_) == (above == 5) ? 1 : 0;  // corners 1 and 3, or 0 and 2
      for (const int k : {apart, apart + 2}) link(sides[(k + 3) % 4], sides[k]);
      return;
    }
    std::uint64_t crossed[2] = {kNone, kNone};
    int count = 0;
    for (int k = 0; k < 4; ++k)
      if (((above >> k) & 1) != ((above >> ((k + 1) % 4)) & 1)) crossed[count++] = sides[k];
    link(crossed[0], crossed[1]);
  }

  void link(std::uint64_t a, std::uint64_t b) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      const auto [entry, is_new] = links_.try_emplace(from);
      if (is_new) met_.push_back(from);
      (entry->second.one == kNone ? entry->second.one : entry->second.other) = to;
    }
  }

  void unlink(std::uint64_t from, std::uint64_t to) {
    Links& links = links_.at(from);
    (links.one == to ? links.one : links.other) = kNone;
  }

  void follow(std::uint64_t side, std::vector<PixelLine>& lines) {
    PixelLine line{place(side)};
    for (;;) {
      const Links& links = links_.at(side);
      const std::uint64_t next = links.one != kNone ? links.one : links.other;
      if (next == kNone) break;
      unlink(side, next);
      unlink(next, side);
      side = next;
      line.push_back(place(side));
    }
    if (line.size() > 1) lines.push_back(std::move(line));
  }

  // Where the level lies on a side, in pixels of the picture.
  Pixel place(std::uint64_t side) const {
    const bool is_down = side % 2 == 1;
    const auto x = static_cast<std::uint32_t>(side / 2 % field_.width);
    const auto y = static_cast<std::uint32_t>(side / 2 / field_.width);
    const double a = value(x, y), b = is_down ? value(x, y + 1) : value(x + 1, y);
    const double t = std::isinf(a) || std::isinf(b) ? 0.5 : (level_ - a) / (b - a);
    return {x + 0.5 + (is_down ? 0 : t), y + 0.5 + (is_down ? t : 0)};
  }

  const PixelField& field_;
  const double level_;
  std::unordered_map<std::uint64_t, Links> links_;
  std::vector<std::uint64_t> met_;
};

// The distance of a point from the segment between two others.
double distance(const Pixel& p, const Pixel& a, const Pixel& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const double t = squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

}  // namespace

void cut_along(Pixel a, Pixel b, Pixel origin, PixelField& field) {
  if (field.width < 2 || field.height < 2) return;
  if (field.cut.empty()) field.cut.assign(std::size_t{field.width - 1} * (field.height - 1), false);
  // In squares: the centre of pixel (0, 0) is the corner of square (0, 0).
  for (Pixel* p : {&a, &b}) *p = {p->x - origin.x - 0.5, p->y - origin.y - 0.5};
  if (a.y > b.y) std::swap(a, b);
  const double last_x = field.width - 2, last_y = field.height - 2;
  const double low = std::max(std::floor(a.y - 0.5), 0.0), high = std::min(std::floor(b.y + 0.5), last_y);
  for (double y = low; y <= high; ++y) {
    // Where the edge is within half a square of this row of squares.
    const auto x_at = [&](double at) { return std::lerp(a.x, b.x, std::clamp((at - a.y) / (b.y - a.y), 0.0, 1.0)); };
    const double p = b.y > a.y ? x_at(y - 0.5) : a.x, q = b.y > a.y ? x_at(y + 1.5) : b.x;
    const double left = std::max(std::floor(std::min(p, q) - 0.5), 0.0);
    const double right = std::min(std::floor(std::max(p, q) + 0.5), last_x);
    for (double x = left; x <= right; ++x)
      field.cut[static_cast<std::size_t>(y) * (field.width - 1) + static_cast<std::size_t>(x)] = true;
  }
}

std::vector<PixelLine> contour_lines(const PixelField& field, double level) {
  if (field.width < 2 || field.height < 2) return {};
  return LevelLines(field, level).all();
}

PixelLine simplified_line(std::span<const Pixel> line, double tolerance) {
  if (line.size() < 3) return {line.begin(), line.end()};
  std::vector<bool> is_kept(line.size(), false);
  is_kept.front() = is_kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> waiting{{0, line.size() - 1}};
  while (!waiting.empty()) {
    const auto [first, last] = waiting.back();
    waiting.pop_back();
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t k = first + 1; k < last; ++k)
      if (const double d = distance(line[k], line[first], line[last]); d > most) {
        most = d;
        farthest = k;
      }
    if (farthest == first) continue;
    is_kept[farthest] = true;
    waiting.insert(waiting.end(), {{first, farthest}, {farthest, last}});
  }
  PixelLine result;
  for (std::size_t k = 0; k < line.size(); ++k)
    if (is_kept[k]) result.push_back(line[k]);
  return result;
}

std::vector<double> contour_levels(double lower, double upper, int limit) {
  if (!(upper > 0) || !(lower < upper)) return {};
  std::vector<double> levels;
  const auto inside = [&](double level) { return lower < level && level < upper; };
  if (lower > 0 && upper >= 10 * lower) {
    const int first = static_cast<int>(std::floor(same_bits::log10(lower))),
              last = static_cast<int>(std::ceil(same_bits::log10(upper)));
    const auto add = [&](int step, std::initializer_list<double> factors) {
      levels.clear();
      for (int k = first; k <= last; ++k)
        for (const double factor : factors)
          if (const double level = k < 0 ? factor / same_bits::pow(10, -k) : factor * same_bits::pow(10, k);
              k % step == 0 && inside(level))
            levels.push_back(level);
      return levels.size() <= static_cast<std::size_t>(limit);
    };
    if (!add(1, {1, 2, 5}) && !add(1, {1, 3}))
      for (int step = 1; !add(step, {1}); ++step) {
      }
    if (!levels.empty()) return levels;
  }
  for (const double level : ColourScale{.lower = lower, .upper = upper}.ticks(limit))
    // As it is read: 6 times 0.2 is not 1.2.
    if (const double round = std::stod(fmt::format("{:.12g}", level)); inside(round)) levels.push_back(round);
  return levels;
}

}  // namespace hottel
