#include "geometry/plane/generate/generator_canvas.h"

#include <algorithm>
#include <string>
#include <utility>

#include "geometry/plane/scene/scene_entries.h"
#include "kernel/int128.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

int sign_of_turn(const Dot2& a, const Dot2& b, const Dot2& c) {
  const Int128 turn = static_cast<Int128>(b.x - a.x) * (c.y - a.y) - static_cast<Int128>(b.y - a.y) * (c.x - a.x);
  return (turn > 0) - (turn < 0);
}

std::int64_t power_of_ten(int exponent) {
  std::int64_t power = 1;
  for (; exponent > 0; --exponent) power *= 10;
  return power;
}

// splitmix64's output function: a fixed permutation of 64-bit words that mixes well.
std::uint64_t mix(std::uint64_t word) {
  word += 0x9e3779b97f4a7c15;
  word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9;
  word = (word ^ (word >> 27)) * 0x94d049bb133111eb;
  return word ^ (word >> 31);
}

// The command that makes the scene again.
std::string command_of(const GeneratorRequest2& request) {
  std::string text = numbered(("hottel generate " + request.kind + " --n ").c_str(), request.n);
  text += numbered(" --seed ", request.seed);
  if (request.digits != 0) text += numbered(" --digits ", request.digits);
  if (request.length != 1) text += " --length " + to_string(request.length);
  if (request.k != 0) text += numbered(" --k ", request.k);
  return text;
}

}  // namespace

bool share_a_point(const Dot2& a, const Dot2& b, const Dot2& c, const Dot2& d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) {
    return false;
  }
  // With overlapping boxes the segments meet unless one lies strictly on one side of the other's line.
  return sign_of_turn(a, b, c) * sign_of_turn(a, b, d) <= 0 && sign_of_turn(c, d, a) * sign_of_turn(c, d, b) <= 0;
}

GeneratorCanvas2::GeneratorCanvas2(const GeneratorRequest2& request, int placed_decimals)
    : about_(command_of(request)),
      seed_(mix(request.seed)),
      denominator_(static_cast<long>(power_of_ten(placed_decimals))) {
  scene_.materials = paints();
}

GeneratorCanvas2 GeneratorCanvas2::of_placed_points(const GeneratorRequest2& request, int decimals) {
  return GeneratorCanvas2(request, decimals);
}

GeneratorCanvas2::GeneratorCanvas2(const GeneratorRequest2& request, int decimals, std::int64_t extent)
    : GeneratorCanvas2(request, decimals) {
  if (request.digits == 0) return;
  int digits_of_unit = 1;  // of the offset, and of each coordinate in units once it is added
  for (offset_ = 1; offset_ < extent; offset_ *= 10) ++digits_of_unit;
  const int added = request.digits - digits_of_unit;
  if (added < 1) {
    throw UsageError("--digits " + std::to_string(request.digits) + " is too few for this scene: it needs " +
                     std::to_string(digits_of_unit + 1));
  }
  added_digits_ = power_of_ten(added);
  denominator_ *= static_cast<long>(added_digits_);
}

Dot2 GeneratorCanvas2::place(const Dot2& unit) const {
  if (added_digits_ == 1) return unit;
  // The digits are a function of the point, so that a vertex shared by edges stays one. The last is not zero.
  const std::uint64_t word_x =
      mix(seed_ ^ mix(static_cast<std::uint64_t>(unit.x) ^ mix(static_cast<std::uint64_t>(unit.y))));
  const std::uint64_t word_y = mix(word_x);
  const auto digits = [this](std::uint64_t word) {
    const auto tens = static_cast<std::uint64_t>(added_digits_ / 10);
    return static_cast<std::int64_t>(word % tens * 10 + 1 + (word >> 58) % 9);
  };
  return {(unit.x + offset_) * added_digits_ + digits(word_x), (unit.y + offset_) * added_digits_ + digits(word_y)};
}

Rational GeneratorCanvas2::coordinate(std::int64_t placed) const {
  Rational value(Integer(static_cast<long>(placed)), denominator_);
  value.canonicalize();
  return value;
}

Edge2 GeneratorCanvas2::edge(const Dot2& from, const Dot2& to) const {
  return {{coordinate(from.x), coordinate(from.y)}, {coordinate(to.x), coordinate(to.y)}};
}

void GeneratorCanvas2::add_edge(std::string name, const Dot2& from, const Dot2& to, Paint paint,
                                std::optional<Paint> back) {
  scene_.groups.push_back(name);
  Surface surface;
  surface.name = std::move(name);
  surface.material = paint;
  if (back) surface.back = *back;
  surface.group = static_cast<std::uint32_t>(scene_.groups.size() - 1);
  hottel::add_edge(scene_, std::move(surface), edge(from, to));
}

void GeneratorCanvas2::add_polygon(const std::string& name, const std::vector<Dot2>& corners, Paint paint) {
  Surface surface;
  surface.material = paint;
  surface.group = static_cast<std::uint32_t>(polygons_.groups.size());
  std::vector<PolylinePoint2> points;
  for (const Dot2& corner : corners) points.push_back({{coordinate(corner.x), coordinate(corner.y)}});
  add_polyline(polygons_, surface, name, std::move(points), true);
  polygons_.groups.push_back(name);
}

Scene2 GeneratorCanvas2::finish(bool closed) {
  append_polylines(scene_, std::exchange(polygons_, {}));
  drop_unused_materials(scene_);
  scene_.closed = closed;
  scene_.file = about_;
  scene_.about = about_;
  return std::move(scene_);
}

}  // namespace hottel
