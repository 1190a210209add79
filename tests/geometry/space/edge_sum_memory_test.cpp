// What a pair takes while it is measured: arcs that are given up are made again, and beyond its room it is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/space/arrangement/surface_boxes.h"
#include "geometry/space/exchange/edge_sum.h"
#include "geometry/space/exchange/element_table.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/moment_origin.h"
#include "geometry/space/exchange/pair_setting.h"
#include "geometry/space/exchange/pair_stretches.h"
#include "geometry/space/exchange/prepared_scene.h"
#include "geometry/space/exchange/surface_stretches.h"
#include "geometry/space/generate/generators.h"
#include "kernel/support/failure.h"
#include "kernel/support/working_room.h"

namespace hottel {
namespace {

// Triangles that pierce each other: many pieces.
class PairMemory : public testing::Test {
 protected:
  const PreparedScene3 prepared_ = prepare(generate_3({.kind = "triangle-soup", .n = 12, .seed = 1}));
  const Blockers3& blockers_ = prepared_.blockers();
  const ElementTable3 table_{prepared_.scene, prepared_.arrangement(), blockers_, Granularity::kFace};
  const SurfaceBoxes3 boxes_{blockers_};
  const SurfaceStretches3 stretches_{blockers_, boxes_};

  // Calls it for the pairs of patches that something stands between.
  template <class Visit>
  void for_each_mixed(const Visit& visit) const {
    for (std::uint32_t i = 0; i < table_.count(); ++i)
      for (std::uint32_t j = i + 1; j < table_.count(); ++j) {
        if (table_.parts(i).empty() || table_.parts(j).empty()) continue;
        const Patch3 &a = table_.parts(i).front().patch, &b = table_.parts(j).front().patch;
        const PairSetting3 setting(blockers_, boxes_, a, b);
        if (setting.sight == Sight3::kMixed)
          visit(setting, pair_stretches(setting, stretches_, blockers_.vertices(), a, b));
      }
  }
};

TEST_F(PairMemory, DecidesNoNumber) {
  constexpr double kNoShift[3] = {0, 0, 0};
  const long shift = blockers_.vertices().shift();
  std::size_t pieces = 0;
  for_each_mixed([&](const PairSetting3& setting, const std::vector<PairStretch3>& stretches) {
    const MomentOrigin3 origin(setting.bodies, kNoShift, shift);
    EdgeSum3 keeps(setting.bodies, origin.point(), shift, std::size_t{1} << 40);
    EdgeSum3 gives_up(setting.bodies, origin.point(), shift, 0);
    PairMeasure3 of_keeps, of_gives_up;
    ASSERT_TRUE(keeps.add(stretches, of_keeps));
    ASSERT_TRUE(gives_up.add(stretches, of_gives_up));
    if (keeps.is_empty()) return;
    for (EdgeSum3* sum : {&keeps, &gives_up}) {
      sum->refine(1e-12, 1e-12);
      sum->refine(1e-15, 1e-15);
    }
    EXPECT_EQ(keeps.value(), gives_up.value());
    EXPECT_EQ(keeps.error(), gives_up.error());
    EXPECT_EQ(keeps.residual(), gives_up.residual());
    EXPECT_EQ(keeps.nodes(), gives_up.nodes());
    EXPECT_EQ(of_keeps.signs, of_gives_up.signs);
    PairDetails3 told, told_again;
    keeps.tell(told);
    gives_up.tell(told_again);
    ASSERT_EQ(told.stretches.size(), told_again.stretches.size());
    for (std::size_t s = 0; s < told.stretches.size(); ++s)
      for (std::size_t p = 0; p < told.stretches[s].pieces.size(); ++p)
        EXPECT_EQ(told.stretches[s].pieces[p].arcs, told_again.stretches[s].pieces[p].arcs);
    pieces += of_keeps.pieces;
  });
  EXPECT_GT(pieces, 3000u);
}

TEST_F(PairMemory, BeyondTheRoomOfTheThreadIsRefused) {
  std::size_t refused = 0;
  for_each_mixed([&](const PairSetting3& setting, const std::vector<PairStretch3>& stretches) {
    const WorkingRoom room(1000);
    constexpr double kNoShift[3] = {0, 0, 0};
    const MomentOrigin3 origin(setting.bodies, kNoShift, blockers_.vertices().shift());
    EdgeSum3 sum(setting.bodies, origin.point(), blockers_.vertices().shift());
    PairMeasure3 result;
    try {
      sum.add(stretches, result);
    } catch (const RequestError& error) {
      ++refused;
      EXPECT_THAT(error.what(), testing::HasSubstr("more than 1000 bytes of memory"));
    }
  });
  EXPECT_GT(refused, 10u);
  EXPECT_EQ(WorkingRoom::bytes(), std::numeric_limits<std::size_t>::max()) << "the room is given back";
}

// What is allowed bounds the pair that is measured, and changes none that fits.
TEST_F(PairMemory, IsNotTakenFromSmallScenes) {
  const ExchangeMatrix free = exact_exchange(prepared_, {.wants_visibility = false, .tolerance = 1e-6});
  const ExchangeMatrix bounded =
      exact_exchange(prepared_, {.wants_visibility = false, .tolerance = 1e-6, .memory = 200'000});
  ASSERT_EQ(free.entry_count(), bounded.entry_count());
  for (std::uint32_t i = 0; i < free.size(); ++i)
    for (std::size_t k = 0; k < free.row(i).size(); ++k)
      EXPECT_EQ(free.row(i)[k].factor.value, bounded.row(i)[k].factor.value);
}

}  // namespace
}  // namespace hottel
