#include "geometry/space/exchange/edge_sum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "kernel/legendre_rule.h"

namespace hottel {
namespace {

constexpr int kCoarse = 6, kFine = 9;  // points of the two rules
// Two rules may agree by chance: their difference is held to this part of the tolerance.
constexpr double kSafety = 8;
// Parts of a stretch are not divided below this.
constexpr double kShortest = 0x1p-48;
constexpr double kTiny = 0x1p-49;
constexpr std::uint32_t kMostBisections = 20000;

// The integral of Lambda by a rule of n points.
Direction3 integral(int n, const StretchPiece3& piece, double low, double high, double* rounding) {
  const LegendreRule<double>& rule = legendre_rule<double>(n);
  Direction3 sum;
  for (int k = 0; k < n; ++k) sum = sum + rule.weight[k] * piece.lambda(low, rule.node[k] * (high - low), rounding);
  return (high - low) * sum;
}

// numerator / denominator * 2^-shift, to the last digits.
Direction3 ratio(const IntegerVector& numerator, const Integer& denominator, long shift) {
  return {rounded_quotient(numerator.x, denominator, shift), rounded_quotient(numerator.y, denominator, shift),
          rounded_quotient(numerator.z, denominator, shift)};
}

WeightedPoint3 end_of(const Stretch3& s) {
  return {{s.from.x + s.way.x, s.from.y + s.way.y, s.from.z + s.way.z}, s.weight};
}

}  // namespace

double EdgeSum3::error() const { return kSafety * error_ + rounding_; }

double EdgeSum3::residual_error() const { return kSafety * residual_error_ + residual_rounding_; }

bool EdgeSum3::add(const std::vector<PairStretch3>& stretches, PairMeasure3& result) {
  StretchMapper3 mapper(bodies_);
  for (const PairStretch3& stretch : stretches) {
    const std::size_t first = pieces_.size();
    const std::uint32_t relied = mapper.relied_polynomials();
    if (!mapper.divide(stretch, pieces_)) return false;
    if (pieces_.size() == first) continue;
    seen_.push_back({&stretch, first, mapper.relied_polynomials() - relied});
    const auto place = static_cast<std::uint32_t>(ways_.size());
    const Stretch3& s = stretch.line();
    ways_.push_back(ratio(s.way, s.weight, shift_));
    const IntegerVector offset = difference(multiple(origin_.weight, s.from), multiple(s.weight, origin_.numerator));
    moments_.push_back(ratio(cross(offset, s.way), s.weight * s.weight * origin_.weight, 2 * shift_));
    for (std::size_t p = first; p < pieces_.size(); ++p) {
      const StretchPiece3& piece = pieces_[p];
      add_parts(static_cast<std::uint32_t>(p), place, piece.low, piece.high);
    }
  }
  result.is_whole = !mapper.is_anything_hidden();
  result.maps = mapper.maps();
  result.pieces = static_cast<std::uint32_t>(pieces_.size());
  result.signs = mapper.counts();
  return true;
}

void EdgeSum3::refine(double tolerance, double residual_tolerance) {
  const auto badness = [&](const Part& part) {
    return std::max(part.error / tolerance, part.residual_error / residual_tolerance);
  };
  const auto is_better = [&](const std::pair<double, std::uint32_t>& a, const std::pair<double, std::uint32_t>& b) {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  };
  std::vector<std::pair<double, std::uint32_t>> heap;
  for (std::uint32_t k = 0; k < parts_.size(); ++k) heap.emplace_back(badness(parts_[k]), k);
  std::make_heap(heap.begin(), heap.end(), is_better);
  for (std::uint32_t count = 0; count < kMostBisections && !heap.empty(); ++count) {
    if (count % 64 == 0) sum_up();
    const bool is_hopeless = rounding_ > tolerance && kSafety * error_ <= rounding_;
    const bool is_done = kSafety * error_ + rounding_ <= 0.99 * tolerance;
    if ((is_done || is_hopeless) && residual_error_ <= residual_tolerance) break;
    std::pop_heap(heap.begin(), heap.end(), is_better);
    const std::uint32_t worst = heap.back().second;
    heap.pop_back();
    const Part part = parts_[worst];
    const double middle = (part.low + part.high) / 2;
    if (part.high - part.low < kShortest) continue;
    if (part.error <= part.rounding && part.residual_error <= part.residual_rounding) continue;
    parts_[worst] = make_part(part.piece, part.stretch, part.low, middle);
    parts_.push_back(make_part(part.piece, part.stretch, middle, part.high));
    error_ += parts_[worst].error + parts_.back().error - part.error;
    residual_error_ += parts_[worst].residual_error + parts_.back().residual_error - part.residual_error;
    for (const std::uint32_t k : {worst, static_cast<std::uint32_t>(parts_.size() - 1)}) {
      heap.emplace_back(badness(parts_[k]), k);
      std::push_heap(heap.begin(), heap.end(), is_better);
    }
  }
  sum_up();
}

void EdgeSum3::tell(PairDetails3& details) const {
  std::vector<double> of_piece(pieces_.size(), 0);
  for (const Part& part : parts_)
    of_piece[part.piece] += dot(moments_[part.stretch], part.value) / (2 * std::numbers::pi);
  for (std::size_t s = 0; s < seen_.size(); ++s) {
    const PairStretch3& stretch = *seen_[s].stretch;
    const Stretch3& line = stretch.line();
    PairDetails3::Stretch& told = details.stretches.emplace_back(PairDetails3::Stretch{
        stretch.role, stretch.own, {line.from, line.weight}, end_of(line), {}, seen_[s].relied, {}});
    for (const PairStretch3::Face& face : stretch.faces) told.surfaces.push_back(bodies_.bodies[face.body].surface);
    std::sort(told.surfaces.begin(), told.surfaces.end());
    const std::size_t end = s + 1 < seen_.size() ? seen_[s + 1].first_piece : pieces_.size();
    for (std::size_t p = seen_[s].first_piece; p < end; ++p) {
      const StretchPiece3& piece = pieces_[p];
      told.pieces.push_back(
          {piece.low, piece.high, static_cast<std::uint32_t>(piece.arcs.size()), of_piece[p], piece.signature});
    }
  }
}

void EdgeSum3::add_parts(std::uint32_t piece, std::uint32_t stretch, double low, double high) {
  if (high - low > kShortest && pieces_[piece].is_steep(low, high)) {
    add_parts(piece, stretch, low, (low + high) / 2);
    add_parts(piece, stretch, (low + high) / 2, high);
  } else {
    parts_.push_back(make_part(piece, stretch, low, high));
  }
}

EdgeSum3::Part EdgeSum3::make_part(std::uint32_t piece, std::uint32_t stretch, double low, double high) {
  if (high - low < kTiny) return tiny_part(piece, stretch, low, high);
  double rounding = 0;
  const Direction3 coarse = integral(kCoarse, pieces_[piece], low, high, nullptr);
  const Direction3 fine = integral(kFine, pieces_[piece], low, high, &rounding);
  rounding *= high - low;
  nodes_ += kCoarse + kFine;
  Part part{piece, stretch, low, high, fine, 0, 0, 0, 0};
  part.rounding = rounding * length(moments_[stretch]);
  part.residual_rounding = rounding * length(ways_[stretch]);
  part.error = std::fabs(dot(moments_[stretch], fine - coarse));
  part.residual_error = length(cross(ways_[stretch], fine - coarse));
  return part;
}

EdgeSum3::Part EdgeSum3::tiny_part(std::uint32_t piece, std::uint32_t stretch, double low, double high) {
  const double width = high - low, rounding = std::numbers::pi * width;
  ++nodes_;
  return {piece,
          stretch,
          low,
          high,
          width * pieces_[piece].lambda(low, width / 2),
          0,
          0,
          rounding * length(moments_[stretch]),
          rounding * length(ways_[stretch])};
}

void EdgeSum3::sum_up() {
  value_ = error_ = rounding_ = residual_error_ = residual_rounding_ = 0;
  residual_ = {};
  for (const Part& part : parts_) {
    value_ += dot(moments_[part.stretch], part.value);
    error_ += part.error;
    rounding_ += part.rounding;
    residual_ = residual_ + cross(ways_[part.stretch], part.value);
    residual_error_ += part.residual_error;
    residual_rounding_ += part.residual_rounding;
  }
}

}  // namespace hottel
