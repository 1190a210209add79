#include "solver/plane/methods/item_buffer.h"

#include <algorithm>
#include <cmath>

namespace hottel {
namespace {

double cross(const LocalVector2& a, const LocalVector2& b) { return a.x * b.y - a.y * b.x; }

class SoftwareItemBuffer2 final : public ItemBuffer2 {
 public:
  explicit SoftwareItemBuffer2(std::uint32_t resolution)
      : square_(resolution), image_(square_.pixels()), nearness_(square_.pixels()), direction_(square_.pixels()) {
    for (std::size_t k = 0; k < direction_.size(); ++k) direction_[k] = square_.point(static_cast<double>(k) + 0.5);
  }

  std::span<const std::uint32_t> draw(std::span<const BufferItem2> items, std::uint32_t background) override {
    std::fill(image_.begin(), image_.end(), background);
    std::fill(nearness_.begin(), nearness_.end(), 0.0);
    for (const BufferItem2& item : items) draw(item);
    return image_;
  }

 private:
  void draw(const BufferItem2& item) {
    const LocalVector2 along{item.left.x - item.right.x, item.left.y - item.right.y};
    const double area = cross(item.right, item.left);
    const std::size_t first = item.right.y > 0 ? first_centre_from(square_.screen(item.right)) : 0;
    const std::size_t last = item.left.y > 0 ? first_centre_from(square_.screen(item.left)) : image_.size();
    for (std::size_t k = first; k < last; ++k) {
      const double nearness = cross(direction_[k], along) / area;  // one over the distance, in lengths of the direction
      if (nearness > nearness_[k]) {
        nearness_[k] = nearness;
        image_[k] = item.item;
      }
    }
  }

  // The first pixel whose centre is not below.
  static std::size_t first_centre_from(double screen) { return static_cast<std::size_t>(std::ceil(screen - 0.5)); }

  HalfSquare2 square_;
  std::vector<std::uint32_t> image_;
  std::vector<double> nearness_;
  std::vector<LocalVector2> direction_;
};

}  // namespace

double HalfSquare2::screen(const LocalVector2& p) const {
  const double half = resolution_ / 2.0;
  if (p.x >= p.y) return half * (p.y / p.x);
  if (-p.x >= p.y) return 4 * half - half * (p.y / -p.x);
  return 2 * half - half * (p.x / p.y);
}

LocalVector2 HalfSquare2::point(double screen) const {
  const double half = resolution_ / 2.0;
  if (screen <= half) return {1, screen / half};
  if (screen >= 3 * half) return {-1, (4 * half - screen) / half};
  return {(2 * half - screen) / half, 1};
}

double HalfSquare2::weight(std::size_t pixel) const {
  const auto sine = [this](double screen) {  // towards x > 0
    const LocalVector2 p = point(screen);
    return p.x / length(p);
  };
  const auto k = static_cast<double>(pixel);
  return (sine(k) - sine(k + 1)) / 2;
}

std::unique_ptr<ItemBuffer2> software_item_buffer_2(std::uint32_t resolution) {
  return std::make_unique<SoftwareItemBuffer2>(resolution);
}

}  // namespace hottel
