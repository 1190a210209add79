#include "viewer/picture/plane/barred_pixels.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hottel {
namespace {

constexpr double kCertain = 1e-14;  // of the products in side(): far more than they are rounded by
constexpr double kOnWall = 1e-9;    // by how much a place on the line of a wall may stick out at its ends
constexpr std::size_t kFewTests = 48;

// +1 or -1 where the sign of side() is certain for every place so near, else 0.
int certain_sign(double value, double error) { return value > error ? 1 : value < -error ? -1 : 0; }

// A wall that may stand between the centre and some pixels.
struct Candidate {
  const Wall2* wall;
  bool centre_is_right;
};

class Shadows {
 public:
  Shadows(double centre_x, double centre_y, std::uint8_t bit, std::size_t stride)
      : x_(centre_x), y_(centre_y), bit_(bit), stride_(stride) {}

  // Marks the pixels of a block. The candidates are the last ones of the stack, from `first` on; they stay.
  void mark(std::vector<Candidate>& stack, std::size_t first, const PixelBlock2& block, std::uint8_t* marks) const {
    const std::size_t count = stack.size() - first, pixels = block.x.size() * block.y.size();
    if (count == 0 || pixels == 0) return;
    if (count * pixels <= kFewTests || pixels == 1) {
      test_each({stack.data() + first, count}, block, marks);
      return;
    }
    const auto halves = [](std::span<const double> places) {
      const std::size_t half = (places.size() + 1) / 2;
      return std::pair(places.first(half), places.subspan(half));
    };
    const auto [left, right] = halves(block.x);
    const auto [low, high] = halves(block.y);
    for (const auto& y : {low, high})
      for (const auto& x : {left, right}) {
        if (x.empty() || y.empty()) continue;
        std::uint8_t* const part =
            marks + static_cast<std::size_t>(y.data() - block.y.data()) * stride_ + (x.data() - block.x.data());
        const std::size_t own = stack.size();
        bool is_barred = false;
        for (std::size_t k = first; k < first + count && !is_barred; ++k) {
          const Candidate candidate = stack[k];
          const Effect effect = effect_on({x, y}, candidate);
          is_barred = effect == Effect::kAll;
          if (effect == Effect::kSome) stack.push_back(candidate);
        }
        if (is_barred)
          mark_all({x, y}, part);
        else
          mark(stack, own, {x, y}, part);
        stack.resize(own, Candidate{});
      }
  }

  void mark_all(const PixelBlock2& block, std::uint8_t* marks) const {
    for (std::size_t j = 0; j < block.y.size(); ++j)
      for (std::size_t i = 0; i < block.x.size(); ++i) marks[j * stride_ + i] |= bit_;
  }

 private:
  enum class Effect { kNone, kSome, kAll };

  bool is_barred(double x, double y, const Candidate& by) const {
    const Wall2& w = *by.wall;
    if ((side(w.ax, w.ay, w.bx, w.by, x, y) < 0) == by.centre_is_right) return false;
    return (side(x, y, x_, y_, w.ax, w.ay) < 0) != (side(x, y, x_, y_, w.bx, w.by) < 0);
  }

  void test_each(std::span<const Candidate> walls, const PixelBlock2& block, std::uint8_t* marks) const {
    for (std::size_t j = 0; j < block.y.size(); ++j)
      for (std::size_t i = 0; i < block.x.size(); ++i)
        for (const Candidate& wall : walls)
          if (is_barred(block.x[i], block.y[j], wall)) {
            marks[j * stride_ + i] |= bit_;
            break;
          }
  }

  // What a wall does to all pixels of a block: each of the three sides is linear in the place of the pixel, so its
  // corners tell.
  Effect effect_on(const PixelBlock2& block, const Candidate& by) const {
    const Wall2& w = *by.wall;
    const double corner_x[2] = {block.x.front(), block.x.back()}, corner_y[2] = {block.y.front(), block.y.back()};
    const auto farthest = [](const double* corner, double from) {
      return std::max(std::fabs(corner[0] - from), std::fabs(corner[1] - from));
    };
    const double wall_error = kCertain * (std::fabs(w.bx - w.ax) * farthest(corner_y, w.ay) +
                                          std::fabs(w.by - w.ay) * farthest(corner_x, w.ax));
    const double far_x = farthest(corner_x, x_), far_y = farthest(corner_y, y_);
    const auto line_error = [&](double x, double y) {
      return kCertain * (far_x * farthest(corner_y, y) + far_y * farthest(corner_x, x));
    };
    const double a_error = line_error(w.ax, w.ay), b_error = line_error(w.bx, w.by);
    int pixels = 2, a = 2, b = 2;  // one sign for all corners; 0 where it is not certain
    const auto join = [](int& sign, int more) { sign = sign == 2 || sign == more ? more : 0; };
    for (const double x : corner_x)
      for (const double y : corner_y) {
        join(pixels, certain_sign(side(w.ax, w.ay, w.bx, w.by, x, y), wall_error));
        join(a, certain_sign(side(x, y, x_, y_, w.ax, w.ay), a_error));
        join(b, certain_sign(side(x, y, x_, y_, w.bx, w.by), b_error));
      }
    const int centre = by.centre_is_right ? -1 : 1;
    if (pixels == centre || (a != 0 && a == b)) return Effect::kNone;
    return pixels == -centre && a != 0 && a == -b ? Effect::kAll : Effect::kSome;
  }

  double x_, y_;
  std::uint8_t bit_;
  std::size_t stride_;
};

}  // namespace

void mark_barred(const std::vector<Wall2>& all, std::span<const std::uint32_t> walls, const PixelBlock2& block,
                 double centre_x, double centre_y, std::uint8_t bit, std::size_t stride, std::uint8_t* marks) {
  const Shadows shadows(centre_x, centre_y, bit, stride);
  thread_local std::vector<Candidate> stack;
  stack.clear();
  for (const std::uint32_t k : walls) {
    const Wall2& w = all[k];
    const double centre = side(w.ax, w.ay, w.bx, w.by, centre_x, centre_y);
    if (std::fabs(centre) <= w.on_line) {
      // The centre lies on the line of the wall: what it has, both sides mixed, belongs to neither.
      if ((centre_x - w.ax) * (centre_x - w.bx) + (centre_y - w.ay) * (centre_y - w.by) <= kOnWall) {
        shadows.mark_all(block, marks);
        return;
      }
      continue;
    }
    stack.push_back({&w, centre < 0});
  }
  shadows.mark(stack, 0, block, marks);
}

}  // namespace hottel
