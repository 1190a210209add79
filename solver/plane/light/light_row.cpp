#include "solver/plane/light/light_row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "kernel/plain_functions.h"

namespace hottel {
namespace {

using std::numbers::pi;

constexpr double kTurnsPerRadian = 0.5 / pi;

// How many angles are taken at once: the number is known to the compiler, which may use wide registers.
constexpr std::size_t kBlock = 4;

// Angles whose tangent is below this are taken by the series.
constexpr double kSmall = 0.125;

// The arc tangent of a small tangent by its series, less than 2^-57 of which is left out.
inline double small_angle(double t) {
  const double z = t * t;
  const double low = 1.0 / 3 - z * (1.0 / 5 - z * (1.0 / 7 - z * (1.0 / 9)));
  const double high = 1.0 / 11 - z * (1.0 / 13 - z * (1.0 / 15 - z * (1.0 / 17)));
  return t - t * z * (low + z * z * (z * z) * high);
}

constexpr int kRays = 8;
const std::array<double, kRays + 1> kAngleOfRay = [] {
  std::array<double, kRays + 1> angles;
  for (int k = 0; k <= kRays; ++k)
    angles[static_cast<std::size_t>(k)] = same_bits::atan(static_cast<double>(k) / kRays);
  return angles;
}();

// The angle in [0, pi] of (x, y), where y >= 0, as that of the nearest of some rays and a small one
// from there: good to four units of the last place of pi. 0 where both are 0, or one is infinite or no number. No
// branch but one: which way they went would be by chance.
double angle_up_to_half_turn(double y, double x) {
  static constexpr std::array<double, 4> kAxis{0, pi / 2, pi, pi / 2}, kSense{1, -1, -1, 1};
  const double width = std::fabs(x), along = std::max(width, y), beside = std::min(width, y);
  if (!(along > 0 && along < HUGE_VAL && beside >= 0)) return 0;
  const int ray = static_cast<int>(beside / along * kRays + 0.5);
  const double t = (kRays * beside - ray * along) / (kRays * along + ray * beside);
  const std::size_t octant = std::size_t{y > width} + 2 * std::size_t{x < 0};
  return kAxis[octant] + kSense[octant] * (kAngleOfRay[static_cast<std::size_t>(ray)] + small_angle(t));
}

}  // namespace

// What is seen around an eye, step by step: step k leads from seen vertex k to the next one.
class LightRowFinder2::Panorama {
 public:
  Panorama(const Vertices2& vertices, const LightColumns2& columns, const Eye2& eye, const View2& view)
      : vertices_(vertices), columns_(columns), eye_(eye), seen_(view.seen) {}

  std::size_t size() const { return seen_.size(); }
  std::size_t next(std::size_t k) const { return k + 1 == size() ? 0 : k + 1; }
  const View2::Seen& operator[](std::size_t k) const { return seen_[k]; }
  Code code(PieceSideId side) const { return columns_.of(side); }
  Code behind(std::size_t k) const { return columns_.of(seen_[k].behind); }
  Direction direction(std::size_t k) const {
    const auto& p = vertices_.approximate(seen_[k].vertex);
    const Direction way{p.x - eye_.x(), p.y - eye_.y()};
    const double size = std::max(std::fabs(way.x), std::fabs(way.y));
    if (size > kLeastLength && size < kMostLength) return way;
    return std::isfinite(size) ? of_moderate_length(way)
                               : of_moderate_length({p.x / 2 - eye_.x() / 2, p.y / 2 - eye_.y() / 2});
  }

  // Only the sky is seen under half a turn or more.
  double angle(std::size_t k) const {
    const Direction a = direction(k), b = direction(next(k));
    // Known to lie in [0, pi]: rounding must not turn a small one around.
    const auto up_to_half_turn = [](double sine, double cosine) {
      return angle_up_to_half_turn(std::max(sine, 0.0), cosine);
    };
    if (seen_[k].behind != kSky) return up_to_half_turn(cross(a, b), dot(a, b));
    if (size() == 1) return 2 * pi;
    const int turn = eye_.orientation(seen_[k].vertex, seen_[next(k)].vertex);
    if (turn == 0) return pi;
    return turn > 0 ? up_to_half_turn(cross(a, b), dot(a, b)) : 2 * pi - up_to_half_turn(cross(b, a), dot(a, b));
  }

  static double cross(const Direction& a, const Direction& b) { return a.x * b.y - a.y * b.x; }
  static double dot(const Direction& a, const Direction& b) { return a.x * b.x + a.y * b.y; }

 private:
  // Of ways between these, products of two are told by doubles.
  static constexpr double kLeastLength = 0x1p-450, kMostLength = 0x1p450;

  // The way times a power of two; 0 where it is that.
  static Direction of_moderate_length(const Direction& way) {
    const double size = std::max(std::fabs(way.x), std::fabs(way.y));
    if (!(size > 0)) return way;
    const int exponent = std::ilogb(size);
    return {std::scalbn(way.x, -exponent), std::scalbn(way.y, -exponent)};
  }

  const Vertices2& vertices_;
  const LightColumns2& columns_;
  const Eye2& eye_;
  std::span<const View2::Seen> seen_;
};

void LightRowFinder2::begin(const Vertices2& vertices, const LightColumns2& columns, Blacks2 blacks) {
  vertices_ = &vertices;
  of_side_ = &columns;
  lists_blacks_ = blacks == Blacks2::kListed;
  ends_.clear();
  sees_black_.clear();
  known_.clear();
  count_ = 0;
}

// Lists for so many entries, and a block more.
void LightRowFinder2::make_room(std::size_t entries) {
  if (columns_.size() >= entries) return;
  entries += entries / 2;
  columns_.resize(entries);
  large_.resize(entries);
  for (std::vector<double>* list : {&fractions_, &cosines_, &sines_}) list->resize(entries + kBlock);
}

void LightRowFinder2::add_known(Code code, double fraction) {
  if (code.is_black()) sees_black_.back() = 1;
  if (code.is_black() && !lists_blacks_) return;
  make_room(count_ + 1);
  known_.emplace_back(count_, fraction);
  columns_[count_] = code.column();
  cosines_[count_] = 1;
  sines_[count_++] = 0;
}

// Adds entries from the first step on, where what is seen changes.
void LightRowFinder2::add_arcs(const Panorama& around, std::size_t first) {
  const std::size_t m = around.size();
  make_room(count_ + m);
  const Code sky = around.code(kSky);
  bool sees_black = false;
  std::size_t count = count_, k = first, left = m;
  Code next_code = around.behind(k);
  Direction from = around.direction(k);
  while (left > 0) {
    const std::size_t step = k;
    const Code code = next_code;
    Direction to;
    const auto advance = [&] {
      k = around.next(k);
      --left;
      next_code = around.behind(k);
      to = around.direction(k);
    };
    advance();
    while (next_code == code && left > 0 && code != sky && Panorama::dot(from, to) > 0 &&
           Panorama::cross(from, around.direction(around.next(k))) > 0)
      advance();
    sees_black = sees_black || code.is_black();
    if (lists_blacks_ || !code.is_black()) {
      if (code == sky) known_.emplace_back(count, around.angle(step) * kTurnsPerRadian);
      columns_[count] = code.column();
      cosines_[count] = Panorama::dot(from, to);
      sines_[count] = std::max(Panorama::cross(from, to), 0.0);  // known to lie in [0, half a turn]
      ++count;
    }
    from = to;
  }
  sees_black_.back() = sees_black ? 1 : 0;
  count_ = count;
}

void LightRowFinder2::measure() {
  if (count_ == 0) return;
  std::fill_n(&cosines_[count_], kBlock, 1.0);
  std::fill_n(&sines_[count_], kBlock, 0.0);
  for (std::size_t begin = 0; begin < count_; begin += kBlock) {
    std::array<double, kBlock> block;
    for (std::size_t k = 0; k < kBlock; ++k) block[k] = sines_[begin + k] / cosines_[begin + k];
    for (std::size_t k = 0; k < kBlock; ++k) block[k] = small_angle(block[k]) * kTurnsPerRadian;
    std::ranges::copy(block, &fractions_[begin]);
  }
  std::size_t large = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    large_[large] = k;
    large += sines_[k] < kSmall * cosines_[k] ? 0 : 1;
  }
  for (const std::size_t k : std::span(large_).first(large))
    fractions_[k] = angle_up_to_half_turn(sines_[k], cosines_[k]) * kTurnsPerRadian;
  for (const auto& [k, fraction] : known_) fractions_[k] = fraction;
}

// The mean over the directions of approach phi in a sector of angle alpha between two edges. From phi, one sees the
// first edge under pi - phi (if that is positive), the last one under pi - (alpha - phi), and in the rest of the turn
// what the vertex sees in the sector. Integrated over phi, what is seen between psi_1 and psi_2 counts W(psi_2) -
// W(psi_1), and each edge pi m - m²/2 with m = min(alpha, pi). Returns alpha.
double LightRowFinder2::add_sector(const Panorama& around, std::size_t first, std::size_t last) {
  double alpha = 0;
  std::size_t k = first;
  do {
    alpha += around.angle(k);
    k = around.next(k);
  } while (k != last);
  const auto square = [](double value) { return value * value; };
  const auto weight = [&](double psi) {
    return alpha * psi + square(std::max(alpha - psi - pi, 0.0)) / 2 - square(std::max(psi - pi, 0.0)) / 2;
  };
  double psi = 0;
  k = first;
  do {
    const double end = psi + around.angle(k);
    add_known(around.behind(k), std::max(weight(end) - weight(psi), 0.0));
    psi = end;
    k = around.next(k);
  } while (k != last);
  const double m = std::min(alpha, pi);
  add_known(around.code(around[first].left), m * (pi - m / 2));
  add_known(around.code(around[last].right), m * (pi - m / 2));
  return alpha;
}

// From an eye on edges: the mean over the sectors that are free. (Without solids, they are the whole turn.)
void LightRowFinder2::add_sectors(const Panorama& around) {
  const std::size_t before = known_.size();
  double alpha = 0;
  bool is_whole_turn = true;
  for (std::size_t i = 0; i < incident_.size(); ++i) {
    const bool is_free = !around.behind(incident_[i]).is_covered();
    if (is_free) alpha += add_sector(around, incident_[i], incident_[i + 1 == incident_.size() ? 0 : i + 1]);
    is_whole_turn = is_whole_turn && is_free;
  }
  for (auto& [k, fraction] : std::span(known_).subspan(before))
    fraction *= kTurnsPerRadian / (is_whole_turn ? 2 * pi : alpha);
}

// From a point in the open.
void LightRowFinder2::add_turn(const Panorama& around) {
  const std::size_t m = around.size();
  if (m == 0) return add_known(around.code(kSky), 1);
  if (around.behind(0).is_covered()) return;  // then all that is seen is
  const Code before = around.behind(m - 1);
  std::size_t first = 0;
  while (first < m && around.behind(first) == before) ++first;
  if (first == m) return add_known(before, 1);
  add_arcs(around, first);
}

void LightRowFinder2::add(const Eye2& eye, const Location2& location, const View2& view) {
  const Panorama around(*vertices_, *of_side_, eye, view);
  sees_black_.push_back(0);
  incident_.clear();
  if (location.kind != Location2::Kind::kInTriangle)
    for (std::size_t k = 0; k < around.size(); ++k)
      if (around[k].left != kNoPiece) incident_.push_back(k);
  if (incident_.empty())
    add_turn(around);
  else
    add_sectors(around);
  ends_.push_back(count_);
}

}  // namespace hottel
