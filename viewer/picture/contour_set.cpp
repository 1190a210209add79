#include "viewer/picture/contour_set.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>

#include "kernel/support/failure.h"
#include "viewer/picture/palette.h"

namespace hottel {
namespace {

constexpr double kSimpler = 0.3;  // pixels that a line may be moved by
constexpr double kBucket = 16;    // pixels

struct Segment {
  std::uint32_t line, place;  // from this point of the line to the next one
};

// Segments by the squares of the picture that they come near.
class SegmentBuckets {
 public:
  void add(const PixelLine& line, std::uint32_t number) {
    for (std::uint32_t k = 0; k + 1 < line.size(); ++k)
      for_each_bucket(line[k], line[k + 1], [&](std::uint64_t bucket) { buckets_[bucket].push_back({number, k}); });
  }
  const std::unordered_map<std::uint64_t, std::vector<Segment>>& all() const { return buckets_; }

  template <class Take>
  static void for_each_bucket(const Pixel& a, const Pixel& b, const Take& take) {
    const auto at = [](double place) { return static_cast<std::int64_t>(std::floor(place / kBucket)); };
    for (std::int64_t y = at(std::min(a.y, b.y)); y <= at(std::max(a.y, b.y)); ++y)
      for (std::int64_t x = at(std::min(a.x, b.x)); x <= at(std::max(a.x, b.x)); ++x)
        take(static_cast<std::uint64_t>(y) << 32 ^ (static_cast<std::uint64_t>(x) & 0xFFFFFFFFu));
  }

 private:
  std::unordered_map<std::uint64_t, std::vector<Segment>> buckets_;
};

double side(const Pixel& a, const Pixel& b, const Pixel& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// Whether two segments have a point in common.
bool do_meet(const Pixel& a, const Pixel& b, const Pixel& c, const Pixel& d) {
  return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0 &&
         std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
         std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

// Segments that follow each other on one line share a point.
bool are_neighbours(const PixelLine& line, std::uint32_t a, std::uint32_t b) {
  const std::uint32_t last = static_cast<std::uint32_t>(line.size()) - 2;
  return a + 1 >= b || (a == 0 && b == last && line.front() == line.back());
}

// By line: whether it meets another one, or itself.
std::vector<bool> tangled(const std::vector<PixelLine>& lines) {
  SegmentBuckets buckets;
  for (std::uint32_t k = 0; k < lines.size(); ++k) buckets.add(lines[k], k);
  std::vector<bool> is_tangled(lines.size(), false);
  for (const auto& [bucket, segments] : buckets.all())
    for (std::size_t i = 0; i < segments.size(); ++i)
      for (std::size_t j = i + 1; j < segments.size(); ++j) {
        const Segment &s = segments[i], &t = segments[j];
        if (s.line == t.line && are_neighbours(lines[s.line], std::min(s.place, t.place), std::max(s.place, t.place)))
          continue;
        if (do_meet(lines[s.line][s.place], lines[s.line][s.place + 1], lines[t.line][t.place],
                    lines[t.line][t.place + 1]))
          is_tangled[s.line] = is_tangled[t.line] = true;
      }
  return is_tangled;
}

// Those that would meet others stay as they are.
std::vector<PixelLine> simplified_apart(const std::vector<PixelLine>& lines) {
  std::vector<PixelLine> result;
  for (const PixelLine& line : lines) result.push_back(simplified_line(line, kSimpler));
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    const std::vector<bool> is_tangled = tangled(result);
    for (std::size_t k = 0; k < lines.size(); ++k)
      if (is_tangled[k] && result[k].size() < lines[k].size()) {
        result[k] = lines[k];
        is_changed = true;
      }
  }
  return result;
}

double size_of(const PixelLine& line) {
  const auto [left, right] = std::ranges::minmax(line, {}, &Pixel::x);
  const auto [top, bottom] = std::ranges::minmax(line, {}, &Pixel::y);
  return std::hypot(right.x - left.x, bottom.y - top.y);
}

double length_of(const PixelLine& line) {
  double length = 0;
  for (std::size_t k = 1; k < line.size(); ++k)
    length += std::hypot(line[k].x - line[k - 1].x, line[k].y - line[k - 1].y);
  return length;
}

// The place on a line so far from its begin.
Pixel along(const PixelLine& line, double way) {
  for (std::size_t k = 1; k < line.size(); ++k) {
    const Pixel &a = line[k - 1], &b = line[k];
    const double step = std::hypot(b.x - a.x, b.y - a.y);
    if (way <= step) return step > 0 ? Pixel{std::lerp(a.x, b.x, way / step), std::lerp(a.y, b.y, way / step)} : a;
    way -= step;
  }
  return line.back();
}

struct Box {
  double left, right, top, bottom;

  bool meets(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  bool meets(const Pixel& a, const Pixel& b) const {
    if (std::max(a.x, b.x) < left || std::min(a.x, b.x) > right || std::max(a.y, b.y) < top ||
        std::min(a.y, b.y) > bottom)
      return false;
    const Pixel corners[] = {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
    int above = 0;
    for (const Pixel& corner : corners) above += side(a, b, corner) > 0 ? 1 : 0;
    return above > 0 && above < 4;
  }
};

// Where labels may lie, in pixels of the field.
class LabelPlaces {
 public:
  LabelPlaces(std::span<const Contour> contours, const PixelField& field, double size)
      : contours_(contours), field_(field), size_(size) {
    for (std::uint32_t k = 0; k < contours.size(); ++k) buckets_.add(contours[k].line, k);
  }

  // The middle of the label of a line, so wide; nothing where there is no room.
  std::optional<Pixel> place(std::uint32_t number, double wide) {
    const PixelLine& line = contours_[number].line;
    const double length = length_of(line), step = 6 * size_;
    if (length < 2.5 * wide) return std::nullopt;
    for (const bool keeps_off_lines : {true, false})
      for (double off = 0; off <= length / 2 - wide / 2; off += step)
        for (const double way : {length / 2 + off, length / 2 - off}) {
          const Pixel at = along(line, way);
          const Box box{at.x - wide / 2, at.x + wide / 2, at.y - 8 * size_, at.y + 8 * size_};
          if (is_taken(box) || (keeps_off_lines && has_other_line(box, number))) continue;
          taken_.push_back(box);
          return at;
        }
    return std::nullopt;
  }

 private:
  bool is_taken(const Box& box) const {
    if (box.left < 0 || box.top < 0 || box.right > field_.width || box.bottom > field_.height) return true;
    return std::ranges::any_of(taken_, [&](const Box& other) { return box.meets(other); }) || has_wall(box);
  }
  bool has_wall(const Box& box) const {
    const auto bottom = static_cast<std::size_t>(box.bottom), right = static_cast<std::size_t>(box.right);
    for (auto y = static_cast<std::size_t>(box.top); y <= bottom && y + 1 < field_.height; ++y)
      for (auto x = static_cast<std::size_t>(box.left); x <= right && x + 1 < field_.width; ++x)
        if (std::isnan(field_.values[y * field_.width + x]) ||
            (!field_.cut.empty() && field_.cut[y * (field_.width - 1) + x]))
          return true;
    return false;
  }
  bool has_other_line(const Box& box, std::uint32_t number) const {
    bool has = false;
    SegmentBuckets::for_each_bucket({box.left, box.top}, {box.right, box.bottom}, [&](std::uint64_t bucket) {
      const auto found = buckets_.all().find(bucket);
      if (has || found == buckets_.all().end()) return;
      has = std::ranges::any_of(found->second, [&](const Segment& s) {
        const PixelLine& line = contours_[s.line].line;
        return s.line != number && box.meets(line[s.place], line[s.place + 1]);
      });
    });
    return has;
  }

  std::span<const Contour> contours_;
  const PixelField& field_;
  double size_;
  SegmentBuckets buckets_;
  std::vector<Box> taken_;
};

void draw_lines(PictureCanvas& canvas, std::span<const Contour> contours, Pixel origin, double size) {
  for (const auto& [colour, wide] : {std::pair(palette::kInk.with_alpha(0.55), 2.8), std::pair(palette::kPaper, 1.2)})
    for (const Contour& contour : contours)
      for (std::size_t k = 1; k < contour.line.size(); ++k) {
        const Pixel &a = contour.line[k - 1], &b = contour.line[k];
        canvas.stroke(Mark::kCurve, {a.x + origin.x, a.y + origin.y}, {b.x + origin.x, b.y + origin.y}, colour,
                      wide * size);
      }
}

}  // namespace

std::vector<Contour> contour_set(const PixelField& field, std::span<const double> levels, double least) {
  std::vector<PixelLine> lines;
  std::vector<double> level_of;
  for (const double level : levels)
    for (PixelLine& line : contour_lines(field, level))
      if (size_of(line) >= least) {
        lines.push_back(std::move(line));
        level_of.push_back(level);
      }
  lines = simplified_apart(lines);
  std::vector<Contour> result;
  for (std::size_t k = 0; k < lines.size(); ++k) result.push_back({level_of[k], std::move(lines[k])});
  return result;
}

void draw_contours(PictureCanvas& canvas, std::span<const Contour> contours, std::span<const std::string> names,
                   const PixelField& field, Pixel origin, double size) {
  HOTTEL_REQUIRE(names.size() == contours.size());
  draw_lines(canvas, contours, origin, size);
  LabelPlaces places(contours, field, size);
  const TextStyle style{.size = 13 * size, .colour = palette::kInk, .anchor = TextAnchor::kCentre};
  for (std::uint32_t k = 0; k < contours.size(); ++k) {
    const double wide = canvas.text_width(names[k], style) + 6 * size;
    const std::optional<Pixel> place = places.place(k, wide);
    if (!place) continue;
    const Pixel at{place->x + origin.x, place->y + origin.y};
    canvas.fill_rectangle(Mark::kCurve, {at.x - wide / 2, at.y - 8 * size}, {at.x + wide / 2, at.y + 8 * size},
                          palette::kPaper.with_alpha(0.85));
    canvas.text(Mark::kCurve, {at.x, at.y + style.size / 3}, names[k], style);
  }
}

}  // namespace hottel
