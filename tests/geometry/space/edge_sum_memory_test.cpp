// The arcs that a sum over edges gives up, and makes again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "geometry/space/arrangement/surface_boxes.h"
#include "geometry/space/between/pair_occluders.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/generate/generators.h"
#include "geometry/space/integrals/moment_origin.h"
#include "geometry/space/pairs/edge_sum.h"
#include "geometry/space/pairs/pair_stretches.h"
#include "geometry/space/pieces/arc_end.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/stretches/surface_stretches.h"

namespace hottel::edge_sum_memory_test {
namespace {

TEST(ArcEnds, AreWhatWasPacked) {
  EXPECT_THAT(packed_ends_3({}), testing::IsEmpty());
  EXPECT_THAT(unpacked_ends_3({}), testing::IsEmpty());
  constexpr int kMost = std::numeric_limits<int>::max(), kLeast = std::numeric_limits<int>::min();
  std::vector<ArcEnd3> ends;
  std::mt19937_64 random(1);
  const auto some_bits = [&] { return random() >> (random() % 64); };
  for (std::int32_t plane = 0; plane >= 0 && plane < kMost / 2; plane += static_cast<std::int32_t>(some_bits() >> 34))
    for (const int count : {-1, 1, static_cast<int>(some_bits()), kMost, kLeast})
      ends.push_back({PlaneId3(plane), some_bits() ^ (some_bits() << 63), count});
  ends.push_back({PlaneId3(kMost), ~std::uint64_t{0}, 0});
  EXPECT_EQ(unpacked_ends_3(packed_ends_3(ends)), ends);
}

TEST(ArcEnds, TakeSomeFiveBytes) {
  std::vector<ArcEnd3> ends;
  for (std::uint32_t k = 0; k < 100; ++k) {
    const std::uint64_t of_point = (std::uint64_t{1} << 63) | (2 * k + 1),
                        of_planes = (std::uint64_t{k} << 32) | (400 - k);
    ends.push_back({PlaneId3(k), of_point, -1});
    ends.push_back({PlaneId3(k), of_planes, 1});
  }
  EXPECT_LE(packed_ends_3(ends).size(), 5.5 * static_cast<double>(ends.size()));
}

// What a sum is, to the last bit.
struct Sum {
  std::vector<double> numbers;
  PairDetails3 told;
  std::uint32_t nodes = 0;
};

// Triangles that pierce each other: many pieces.
class EdgeSumMemory : public testing::Test {
 protected:
  // Calls it for the pairs of patches that something stands between.
  template <class Visit>
  void for_each_mixed(const Visit& visit) const {
    for (std::uint32_t i = 0; i < table_.count(); ++i)
      for (std::uint32_t j = i + 1; j < table_.count(); ++j) {
        if (table_.parts(i).empty() || table_.parts(j).empty()) continue;
        const Patch3 &a = table_.parts(i).front().patch, &b = table_.parts(j).front().patch;
        const PairOccluders3 setting(occluders_, boxes_, a, b);
        if (setting.sight == PairVisibility3::kMixed) visit(setting, pair_stretches(setting, stretches_, a, b));
      }
  }

  // `digits`: 0 of doubles, 1 of long doubles, 2 of LongerReal, 3 of WideReal.
  Sum sum_of(const PairOccluders3& setting, const std::vector<PairStretch3>& stretches, int digits,
             std::size_t most_bytes) const {
    constexpr double kNoShift[3] = {0, 0, 0};
    const long shift = occluders_.vertices().shift();
    const MomentOrigin3 origin(setting.bodies, kNoShift, shift);
    EdgeSum3 sum(setting.bodies, origin, shift, most_bytes);
    PairResult3 result;
    EXPECT_TRUE(sum.add(stretches, result));
    for (int k = 0; k < digits; ++k) sum.take_more_digits();
    sum.refine(1e-9, 1e-9);
    if (digits < 2) sum.refine(1e-15, 1e-15);
    const EdgeValues3& values = sum.values();
    Sum all;
    all.numbers = {values.value,
                   values.error,
                   values.residual.x,
                   values.residual.y,
                   values.residual.z,
                   values.residual_error,
                   sum.jumps(),
                   sum.reach(),
                   static_cast<double>(result.pieces),
                   static_cast<double>(result.maps)};
    all.nodes = sum.nodes();
    sum.tell(all.told);
    return all;
  }

  const PreparedScene3 prepared_ = prepare(generate_3({.kind = "triangle-soup", .n = 10, .seed = 1}));
  const Occluders3& occluders_ = prepared_.occluders();
  const ElementTable3 table_{prepared_.scene, prepared_.arrangement(), occluders_, Granularity::kFace};
  const SurfaceBoxes3 boxes_{occluders_};
  const SurfaceStretches3 stretches_{occluders_, boxes_};
};

TEST_F(EdgeSumMemory, DecidesNoNumber) {
  constexpr std::size_t kAll = std::size_t{1} << 40;
  std::size_t pairs = 0, pieces = 0;
  for_each_mixed([&](const PairOccluders3& setting, const std::vector<PairStretch3>& stretches) {
    const int digits = ++pairs % 8 != 0 ? 0 : pairs % 24 != 0 ? 1 : pairs % 48 != 0 ? 2 : 3;
    const Sum keeps = sum_of(setting, stretches, digits, kAll), gives_up = sum_of(setting, stretches, digits, 0),
              keeps_some = sum_of(setting, stretches, digits, 100'000);
    for (const Sum* other : {&gives_up, &keeps_some}) {
      EXPECT_EQ(keeps.numbers, other->numbers);
      EXPECT_EQ(keeps.nodes, other->nodes);
      ASSERT_EQ(keeps.told.stretches.size(), other->told.stretches.size());
      for (std::size_t s = 0; s < keeps.told.stretches.size(); ++s) {
        const auto &one = keeps.told.stretches[s].pieces, &two = other->told.stretches[s].pieces;
        ASSERT_EQ(one.size(), two.size());
        for (std::size_t p = 0; p < one.size(); ++p, ++pieces) {
          EXPECT_EQ(one[p].arcs, two[p].arcs);
          EXPECT_EQ(one[p].measure, two[p].measure);
          EXPECT_EQ(one[p].signature, two[p].signature);
        }
      }
    }
  });
  EXPECT_GT(pairs, 30u);
  EXPECT_GT(pieces, 3000u);
}

TEST_F(EdgeSumMemory, MoreDigitsAddNoOther) {
  std::size_t pairs = 0;
  for_each_mixed([&](const PairOccluders3& setting, const std::vector<PairStretch3>& stretches) {
    if (++pairs % 16 != 0) return;
    const Sum most = sum_of(setting, stretches, 3, 0);
    for (const int digits : {1, 2}) {
      const Sum some = sum_of(setting, stretches, digits, 0);
      EXPECT_LE(std::fabs(some.numbers[0] - most.numbers[0]), some.numbers[1] + most.numbers[1]) << pairs;
    }
  });
  EXPECT_GT(pairs, 30u);
}

// The least memory that the tables of the scene fit into leaves room for one thread.
TEST_F(EdgeSumMemory, LeavesFactorsWhateverIsAllowed) {
  const ExchangeMatrix free = exact_exchange(prepared_, {.tolerance = 1e-6});
  const ExchangeMatrix bounded = exact_exchange(prepared_, {.tolerance = 1e-6, .memory = 200'000});
  ASSERT_EQ(free.entry_count(), bounded.entry_count());
  for (std::uint32_t i = 0; i < free.size(); ++i)
    for (std::size_t k = 0; k < free.row(i).size(); ++k) {
      EXPECT_EQ(free.row(i)[k].to, bounded.row(i)[k].to);
      EXPECT_EQ(free.row(i)[k].factor.value, bounded.row(i)[k].factor.value);
      EXPECT_EQ(free.row(i)[k].visibility, bounded.row(i)[k].visibility);
    }
}

}  // namespace
}  // namespace hottel::edge_sum_memory_test
