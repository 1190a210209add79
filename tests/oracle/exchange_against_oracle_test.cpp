// The engine against the brute force: every pair of 500 random scenes, as exact sums of square roots, and every double
// that is printed of them.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "geometry/exchange/exchange_2.h"
#include "tests/oracle/brute_force_2.h"
#include "tests/oracle/random_scene_2.h"
#include "tests/oracle/split_2.h"

#ifndef __has_feature
#define __has_feature(feature) 0
#endif

namespace hottel {
namespace {

#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
constexpr int kScenesPerBatch = 3;
#else
constexpr int kScenesPerBatch = 25;
#endif
constexpr int kBatches = 20;
constexpr unsigned kBits = 512;  // of the reference values

Scene2 to_scene(const std::vector<oracle::InputSegment>& edges) {
  Scene2 scene;
  scene.file = "random scene";
  for (int m = 0; m < 3; ++m) {
    Material material;
    material.name = "material " + std::to_string(m);
    material.reflectivity = Spectrum::scalar(Rational(m, 4));
    material.reflectivity.value[0].canonicalize();
    for (Rational& value : material.reflectivity.value) value.canonicalize();
    scene.materials.push_back(material);
  }
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const oracle::InputSegment& edge = edges[k];
    Surface2 surface;
    surface.name = "e" + std::to_string(k);
    surface.from = {edge.ax, edge.ay};
    surface.to = {edge.bx, edge.by};
    surface.material = static_cast<std::uint32_t>(edge.front_material);
    if (edge.back_material >= 0) surface.back = static_cast<std::uint32_t>(edge.back_material);
    surface.group = static_cast<std::uint32_t>(k);
    scene.surfaces.push_back(surface);
    scene.groups.push_back(surface.name);
  }
  validate(scene);
  return scene;
}

// Both in the oracle's normal form: square-free radicands, ascending. Equal numbers have equal texts.
std::string canonical_text(const RootSum& sum) {
  oracle::ExactSum result;
  for (const RootSum::Term& term : sum.terms()) result.add(term.coefficient, Rational(term.radicand));
  return result.to_string();
}

std::string canonical_text(const oracle::LengthSum& lengths, const Rational& factor) {
  oracle::ExactSum result = oracle::exact_sum(lengths);
  result *= factor;
  return result.to_string();
}

mpf_class value_of(const oracle::LengthSum& lengths) {
  mpf_class sum(0, kBits);
  for (const auto& [squared, coefficient] : lengths) sum += coefficient * sqrt(mpf_class(squared, kBits));
  return sum;
}

// Sign of a - b, where what is left at 400 bits is taken for equality.
int compare(const mpf_class& a, const mpf_class& b) {
  mpf_class tolerance(1, kBits);
  mpf_div_2exp(tolerance.get_mpf_t(), tolerance.get_mpf_t(), 400);
  const mpf_class difference(a - b, kBits);
  if (abs(difference) < tolerance) return 0;
  return sgn(difference);
}

mpf_class half_way(double a, double b) { return (mpf_class(a, kBits) + mpf_class(b, kBits)) / 2; }

// Is the double nearest to the real number, ties to even?
bool is_nearest(double rounded, const mpf_class& real) {
  const double below = std::nextafter(rounded, -HUGE_VAL), above = std::nextafter(rounded, HUGE_VAL);
  const bool is_even = std::fmod(std::scalbn(rounded, 52 - std::ilogb(rounded)), 2) == 0;
  const int low = compare(half_way(below, rounded), real), high = compare(half_way(rounded, above), real);
  return is_even ? low <= 0 && high >= 0 : low < 0 && high > 0;
}

struct Counts {
  std::size_t scenes = 0, pairs = 0, zeros = 0, sums = 0, factors = 0, visibilities = 0, ties = 0;
};

// One scene, both ways.
class Comparison {
 public:
  Comparison(const std::vector<oracle::InputSegment>& edges, Counts& counts)
      : edges_(edges),
        counts_(counts),
        split_(oracle::split(edges)),
        measures_(oracle::exchange_measures(split_.pieces)),
        prepared_(prepare(to_scene(edges))),
        matrix_(exact_exchange(prepared_)),
        sky_(matrix_.sky()) {
    for (const oracle::Segment& piece : split_.pieces) {
      const Rational x = piece.bx - piece.ax, y = piece.by - piece.ay;
      for (const int label : {piece.left, piece.right}) {
        ++length_[label][x * x + y * y];
        owned_[label] += abs(x) + abs(y);
      }
    }
  }

  void run() {
    ++counts_.scenes;
    ASSERT_EQ(matrix_.size(), 2 * edges_.size());
    check_ownership();
    check_sums();
    for (std::uint32_t i = 0; i < matrix_.size(); ++i)
      if (matrix_.has_row(i)) check_row(i);
  }

 private:
  // The oracle's label of an engine's label: fronts and backs alternate in both.
  int label(std::uint32_t i) const { return i == sky_ ? oracle::kInfinity : static_cast<int>(i); }

  bool has_row(std::uint32_t i) const {
    if (i == sky_) return false;
    const oracle::InputSegment& edge = edges_[i / 2];
    return (i % 2 == 0 ? edge.front_material : edge.back_material) >= 0 && owned_.contains(label(i));
  }

  const oracle::LengthSum& measure(std::uint32_t i, std::uint32_t j) const {
    static const oracle::LengthSum nothing;
    const auto place = measures_.find(std::minmax({label(i), label(j)}));
    return place == measures_.end() ? nothing : place->second;
  }

  // Each side of each piece has the same owner, and nothing has an owner that is not there.
  void check_ownership() const {
    const Arrangement2& arrangement = prepared_.arrangement;
    using End = std::pair<Rational, Rational>;
    std::map<std::pair<End, End>, std::pair<int, int>> expected;
    for (const oracle::Segment& s : split_.pieces) expected[{{s.ax, s.ay}, {s.bx, s.by}}] = {s.left, s.right};
    ASSERT_EQ(arrangement.pieces().size(), expected.size());
    const auto owner = [&](PieceSideId side) {
      const FacePart& face = arrangement.owner(side);
      return static_cast<int>(2 * face.surface + (face.is_back ? 1 : 0));
    };
    for (std::size_t k = 0; k < arrangement.pieces().size(); ++k) {
      const Vertices2& vertices = arrangement.vertices();
      const auto end = [&](VertexId v) {
        const ExactPoint2 p = vertices.to_scene(vertices.exact(v));
        return End{p.x, p.y};
      };
      End a = end(arrangement.pieces()[k].a), b = end(arrangement.pieces()[k].b);
      std::pair<int, int> sides{owner(static_cast<PieceSideId>(2 * k)), owner(static_cast<PieceSideId>(2 * k + 1))};
      if (b < a) {
        std::swap(a, b);
        std::swap(sides.first, sides.second);
      }
      const auto place = expected.find({a, b});
      ASSERT_NE(place, expected.end());
      EXPECT_EQ(sides, place->second);
    }
  }

  // All pairs with a row, the sky included: S of the engine has the same text as the oracle's.
  void check_sums() {
    std::vector<LabelPair> pairs;
    for (std::uint32_t i = 0; i < sky_; ++i)
      for (std::uint32_t j = i; j <= sky_; ++j)
        if (has_row(i) || has_row(j)) pairs.emplace_back(i, j);
    const std::vector<RootSum> sums = exact_exchange_measures(prepared_, Per::kFace, pairs);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto [i, j] = pairs[k];
      ++counts_.pairs;
      counts_.sums += !sums[k].is_zero();
      is_zero_[pairs[k]] = sums[k].is_zero();
      EXPECT_EQ(canonical_text(sums[k]), canonical_text(measure(i, j), Rational(1, 2))) << "pair " << i << ", " << j;
    }
  }

  void check_row(std::uint32_t from) {
    ASSERT_TRUE(has_row(from));
    const mpf_class twice_length(2 * value_of(length_.at(label(from))), kBits);
    auto entry = matrix_.row(from).begin();
    for (std::uint32_t to = 0; to <= sky_; ++to) {
      const bool is_listed = entry != matrix_.row(from).end() && entry->to == to;
      EXPECT_EQ(is_listed, !is_zero_.at(std::minmax({from, to}))) << "from " << from << " to " << to;
      if (!is_listed) {
        ++counts_.zeros;
        continue;
      }
      check_factor(entry->factor, mpf_class(value_of(measure(from, to)) / twice_length, kBits));
      if (to == sky_)
        EXPECT_EQ(entry->visibility, entry->factor.value);
      else if (owns_all(from) && owns_all(to))
        check_visibility(entry->visibility, from, to);
      ++entry;
    }
  }

  void check_factor(const Rounded& factor, const mpf_class& real) {
    ++counts_.factors;
    EXPECT_TRUE(is_nearest(factor.value, real)) << factor.value << " for " << real;
    const int side = compare(real, mpf_class(factor.value, kBits));
    EXPECT_EQ(factor.side, side);
    counts_.ties += side == 0;
    const Enclosure enclosure = factor.enclosure();
    EXPECT_LE(compare(mpf_class(enclosure.lower, kBits), real), 0);
    EXPECT_GE(compare(mpf_class(enclosure.upper, kBits), real), 0);
    EXPECT_TRUE(enclosure.contains(factor.value));
    EXPECT_LE(enclosure.upper, std::nextafter(enclosure.lower, 2.0));
  }

  bool owns_all(std::uint32_t i) const {
    const oracle::InputSegment& edge = edges_[i / 2];
    const auto place = owned_.find(label(i));
    return place != owned_.end() && place->second == abs(edge.bx - edge.ax) + abs(edge.by - edge.ay);
  }

  // S / S0, with S0 by the brute force on the two edges alone.
  void check_visibility(double visibility, std::uint32_t from, std::uint32_t to) {
    ++counts_.visibilities;
    ASSERT_NE(from / 2, to / 2) << "a straight edge does not see itself";
    const std::vector<oracle::InputSegment> alone{edges_[from / 2], edges_[to / 2]};
    const auto measures = oracle::exchange_measures(oracle::split(alone).pieces);
    const oracle::LengthSum& free =
        measures.at(std::minmax({static_cast<int>(from % 2), static_cast<int>(2 + to % 2)}));
    const mpf_class real(value_of(measure(from, to)) / value_of(free), kBits);
    EXPECT_GT(visibility, 0);
    EXPECT_LE(visibility, 1);
    const bool nothing_hides = compare(real, mpf_class(1, kBits)) == 0;
    EXPECT_EQ(visibility == 1, nothing_hides) << "from " << from << " to " << to << ": " << visibility;
    if (visibility != std::nextafter(1.0, 0.0)) {
      EXPECT_TRUE(is_nearest(visibility, real)) << visibility << " for " << real;
    } else {
      EXPECT_GT(compare(real, half_way(std::nextafter(visibility, 0.0), visibility)), 0);
    }
  }

  const std::vector<oracle::InputSegment>& edges_;
  Counts& counts_;
  oracle::Split split_;
  oracle::Measures measures_;
  PreparedScene2 prepared_;
  ExchangeMatrix matrix_;
  std::uint32_t sky_;
  std::map<int, oracle::LengthSum> length_;  // by label, as lengths of owned pieces
  std::map<int, Rational> owned_;            // by label, |x| + |y| of the owned pieces
  std::map<LabelPair, bool> is_zero_;
};

class ExchangeAgainstOracle : public testing::TestWithParam<int> {};

// kScenesPerBatch scenes of 10 to 60 edges, half of them on a lattice: 500 in all, 60 in a build with sanitizers.
TEST_P(ExchangeAgainstOracle, AgreesInEveryPairAsAnExactSum) {
  Counts counts;
  for (int k = 0; k < kScenesPerBatch; ++k) {
    const int number = GetParam() * kScenesPerBatch + k;
    const int size = 10 + number * 7 % 51;
    const oracle::RandomScene scene =
        oracle::random_scene(1000 + static_cast<std::uint64_t>(number / 2), size, number % 2 == 0);
    SCOPED_TRACE(fmt::format("scene {} with {} edges", number, size));
    Comparison(scene.edges, counts).run();
    if (HasFailure()) break;
  }
  fmt::print("{} of {} scenes: {} pairs, {} sums; {} factors ({} of them doubles), {} zeros, {} visibilities\n",
             counts.scenes, 500, counts.pairs, counts.sums, counts.factors, counts.ties, counts.zeros,
             counts.visibilities);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExchangeAgainstOracle, testing::Range(0, kBatches));

}  // namespace
}  // namespace hottel
