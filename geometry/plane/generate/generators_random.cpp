// Scenes without a plan: clutter and lattice.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "geometry/plane/generate/generate_kinds.h"
#include "geometry/plane/generate/generator_canvas.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::int64_t kSpacing = 1000;  // units between neighbours, on the average
constexpr std::int64_t kMargin = 10;     // units kept from the walls
constexpr int kTries = 64;               // before a segment is halved

Paint random_paint(Chance& chance) {
  constexpr std::array<Paint, 4> kPaints = {kWhite, kRed, kBlue, kGrey};
  return kPaints[chance.below(kPaints.size())];
}

// Disjoint segments in a uniform grid. Cells are in units, segments in placed points.
class SegmentGrid {
 public:
  SegmentGrid(std::int64_t side, std::int64_t cell)
      : cell_(cell), columns_(side / cell + 1), first_(static_cast<std::size_t>(columns_ * columns_), -1) {}

  // Adds the segment unless it has a point in common with one that is there.
  bool add(const Dot2& unit_a, const Dot2& unit_b, const Dot2& a, const Dot2& b) {
    // Placing moves a point upwards by less than a unit.
    const std::int64_t x0 = std::min(unit_a.x, unit_b.x) / cell_, x1 = (std::max(unit_a.x, unit_b.x) + 1) / cell_;
    const std::int64_t y0 = std::min(unit_a.y, unit_b.y) / cell_, y1 = (std::max(unit_a.y, unit_b.y) + 1) / cell_;
    for (std::int64_t y = y0; y <= y1; ++y)
      for (std::int64_t x = x0; x <= x1; ++x)
        if (meets(x, y, a, b)) return false;
    segments_.push_back({a, b});
    for (std::int64_t y = y0; y <= y1; ++y)
      for (std::int64_t x = x0; x <= x1; ++x) {
        auto& first = first_[static_cast<std::size_t>(y * columns_ + x)];
        entries_.push_back({static_cast<std::int32_t>(segments_.size() - 1), first});
        first = static_cast<std::int32_t>(entries_.size() - 1);
      }
    return true;
  }

 private:
  struct Entry {
    std::int32_t segment, next;
  };

  bool meets(std::int64_t x, std::int64_t y, const Dot2& a, const Dot2& b) const {
    for (std::int32_t e = first_[static_cast<std::size_t>(y * columns_ + x)]; e >= 0;) {
      const auto& [segment, next] = entries_[static_cast<std::size_t>(e)];
      const auto& [c, d] = segments_[static_cast<std::size_t>(segment)];
      if (share_a_point(a, b, c, d)) return true;
      e = next;
    }
    return false;
  }

  std::int64_t cell_, columns_;
  std::vector<std::int32_t> first_;
  std::vector<Entry> entries_;
  std::vector<std::pair<Dot2, Dot2>> segments_;
};

// A vector whose length is between 4/5 of length and length.
Dot2 random_vector(Chance& chance, std::int64_t length) {
  while (true) {
    const Dot2 v{chance.between(-length, length), chance.between(-length, length)};
    const std::int64_t squared = v.x * v.x + v.y * v.y;
    if (squared <= length * length && 25 * squared >= 16 * length * length) return v;
  }
}

}  // namespace

Scene2 generate_clutter_2(const GeneratorRequest2& request) {
  if (request.length < Rational(1, 50) || request.length > 4)
    throw UsageError("--length must be between 1/50 and 4 mean distances");
  const auto side = static_cast<std::int64_t>(integer_root(request.n - 1) + 1) * kSpacing;
  const Integer scaled = request.length.get_num() * kSpacing / request.length.get_den();
  const std::int64_t full_length = std::min<std::int64_t>(scaled.get_si(), side / 3);

  Chance chance(request.seed);
  GeneratorCanvas2 canvas(request, 3, side);
  const std::array<Dot2, 4> corners = {canvas.place({0, 0}), canvas.place({0, side}), canvas.place({side, side}),
                                       canvas.place({side, 0})};
  for (std::size_t i = 0; i < 4; ++i)
    canvas.add_edge(numbered("wall", i), corners[i], corners[(i + 1) % 4], i == 0 ? kLamp : kWhite);

  SegmentGrid grid(side, std::max(kSpacing, full_length));
  for (std::uint64_t i = 4; i < request.n; ++i) {
    std::int64_t length = full_length;
    for (int tries = 0;; ++tries) {
      if (tries == kTries && length >= 8) {
        length /= 2;
        tries = 0;
      }
      const Dot2 a{chance.between(kMargin, side - kMargin), chance.between(kMargin, side - kMargin)};
      const Dot2 v = random_vector(chance, length);
      const Dot2 b{a.x + v.x, a.y + v.y};
      if (std::min(b.x, b.y) < kMargin || std::max(b.x, b.y) > side - kMargin) continue;
      const Dot2 from = canvas.place(a), to = canvas.place(b);
      if (!grid.add(a, b, from, to)) continue;
      const Paint front = i % 50 == 0 ? kLamp : random_paint(chance);
      const Paint behind = random_paint(chance);
      canvas.add_edge(numbered("s", i - 4), from, to, front, i % 2 == 0 ? std::optional<Paint>(behind) : std::nullopt);
      break;
    }
  }
  return canvas.finish(true);
}

namespace {

// The similarity that takes the lattice point (i, j) to a placed point: exact, so it keeps every coincidence.
struct LatticeMap {
  std::int64_t along = 1, across = 0, offset_x = 0, offset_y = 0;
  int decimals = 0;

  Dot2 operator()(const Dot2& p) const {
    return {offset_x + along * p.x - across * p.y, offset_y + across * p.x + along * p.y};
  }
};

// Coordinates between 1 and 3 times 10^(digits - 1), the lattice a little turned.
LatticeMap map_of_digits(int digits, std::int64_t k, Chance& chance) {
  if (digits == 0) return {};
  std::int64_t power = 1;
  for (int d = 1; d < digits; ++d) power *= 10;
  const std::int64_t step = power / (3 * k);
  if (step < 4) throw UsageError("--digits " + std::to_string(digits) + " is too few for a lattice of this size");
  LatticeMap map;
  map.along = chance.between(step - step / 4, step);
  map.across = chance.between(step / 8, step / 4);
  map.offset_x = 2 * power + chance.between(0, step);
  map.offset_y = power + chance.between(0, step);
  for (std::int64_t unit = step; unit >= 10; unit /= 10) ++map.decimals;
  return map;
}

}  // namespace

Scene2 generate_lattice_2(const GeneratorRequest2& request) {
  constexpr std::uint64_t kMaxSide = 100'000;
  if (request.k > kMaxSide) throw UsageError("--k must be at most " + std::to_string(kMaxSide));
  const auto k = static_cast<std::int64_t>(request.k ? request.k : std::max<std::uint64_t>(4, integer_root(request.n)));
  constexpr std::int64_t kReach = 3;  // longest step of an edge in either coordinate

  Chance chance(request.seed);
  const LatticeMap map = map_of_digits(request.digits, k, chance);
  GeneratorCanvas2 canvas = GeneratorCanvas2::of_placed_points(request, map.decimals);
  const std::array<Dot2, 4> corners = {Dot2{0, 0}, Dot2{0, k}, Dot2{k, k}, Dot2{k, 0}};
  for (std::size_t i = 0; i < 4; ++i)
    canvas.add_edge(numbered("wall", i), map(corners[i]), map(corners[(i + 1) % 4]), kGlow);

  for (std::uint64_t i = 4; i < request.n;) {
    Dot2 a{chance.between(0, k), chance.between(0, k)};
    Dot2 b{a.x + chance.between(-kReach, kReach), a.y + chance.between(-kReach, kReach)};
    const bool has_back = chance.below(2) == 0;
    if (a == b || std::min(b.x, b.y) < 0 || std::max(b.x, b.y) > k) continue;
    // Along a wall the front looks into the room, as the wall's own front does.
    const bool on_wall = (a.x == b.x && (a.x == 0 || a.x == k)) || (a.y == b.y && (a.y == 0 || a.y == k));
    const bool looks_out = (a.x == b.x && (a.x == 0) != (b.y > a.y)) || (a.y == b.y && (a.y == 0) != (b.x < a.x));
    if (on_wall && looks_out) std::swap(a, b);
    canvas.add_edge(numbered("e", i - 4), map(a), map(b), kGlow,
                    has_back && !on_wall ? std::optional<Paint>(kGlow) : std::nullopt);
    ++i;
  }
  return canvas.finish(true);
}

}  // namespace hottel
