// Every contact of an occluder with the lines of a pair of faces, and every two of them at once.
//
//   0     1     2     3     4
//   └──────── ceiling ──────┘ 4      fronts towards each other; the lines of the pair fill the square
//
//   ■━━━━━▶ 2: the left occluder      comes in from the left at height 2, up to x = a
//
//              1: the right occluder ◀━━━━━━━■      comes in from the right at height 1, down to x = b
//   ┌──────── floor ────────┐ 0
//
// The answers are 2 S = crossed - uncrossed strings, pulled tight round the tips (a, 2) and (b, 1), where light passes
// between them. What an occluder does that only touches the square, or lies along its side, is nothing: a = 0, b = 4.
//
//   uncrossed, left    (0,0) (a,2) (0,4)        a = 0: 4          1: 2 sqrt(5)           2: 4 sqrt(2)
//   uncrossed, right   (4,0) (b,1) (4,4)        b = 4: 4          3: sqrt(2) + sqrt(10)  2: sqrt(5) + sqrt(13)
//   crossed upwards to the right                (0,0) (4,4): 4 sqrt(2), and to the left (4,0) (0,4): 4 sqrt(2), but
//                                               round (2,1) for b = 2: sqrt(5) + sqrt(13),
//                                               and then round (2,2) too for a = 2: sqrt(5) + 1 + 2 sqrt(2)
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/comparison/plane/engine_comparison.h"
#include "tests/geometry/plane/exchange_scenes.h"
#include "tests/oracle/plane/laws.h"

namespace hottel::contact_table_test {
namespace {

using namespace testing_scenes;

enum Contact { kNone, kTouches, kAlong, kCrosses, kHalf, kCovers };
constexpr Contact kContacts[] = {kNone, kTouches, kAlong, kCrosses, kHalf, kCovers};

const char* to_string(Contact contact) {
  const char* names[] = {"none", "touches", "lies along", "crosses", "half covers", "covers"};
  return names[contact];
}

Line left_occluder(Contact contact) {
  switch (contact) {
    case kNone:
      return {"left", "-2", "2", "-1", "2", 1, 2};
    case kTouches:
      return {"left", "-2", "2", "0", "2", 1, 2};
    case kAlong:
      return {"left", "0", "1", "0", "3", 1, 2};
    case kCrosses:
      return {"left", "-1", "2", "1", "2", 1, 2};
    case kHalf:
      return {"left", "0", "2", "2", "2", 1, 2};
    case kCovers:
      break;
  }
  return {"left", "0", "2", "4", "2", 1, 2};
}

// The same from the right, at height 1.
Line right_occluder(Contact contact) {
  switch (contact) {
    case kNone:
      return {"right", "6", "1", "5", "1", 1, 2};
    case kTouches:
      return {"right", "6", "1", "4", "1", 1, 2};
    case kAlong:
      return {"right", "4", "1", "4", "3", 1, 2};
    case kCrosses:
      return {"right", "5", "1", "3", "1", 1, 2};
    case kHalf:
      return {"right", "4", "1", "2", "1", 1, 2};
    case kCovers:
      break;
  }
  return {"right", "4", "1", "0", "1", 1, 2};
}

// 2 S(floor, ceiling): a row for each contact of the left occluder, and in it those of the right one: none, touches,
// lies along; crosses, half covers, covers.
constexpr const char* kTable[6][6] = {
    // none
    {"-8 + 8*sqrt(2)", "-8 + 8*sqrt(2)", "-8 + 8*sqrt(2)",  //
     "-4 + 7*sqrt(2) - 1*sqrt(10)", "-4 + 4*sqrt(2)", "0"},
    // touches
    {"-8 + 8*sqrt(2)", "-8 + 8*sqrt(2)", "-8 + 8*sqrt(2)",  //
     "-4 + 7*sqrt(2) - 1*sqrt(10)", "-4 + 4*sqrt(2)", "0"},
    // lies along
    {"-8 + 8*sqrt(2)", "-8 + 8*sqrt(2)", "-8 + 8*sqrt(2)",  //
     "-4 + 7*sqrt(2) - 1*sqrt(10)", "-4 + 4*sqrt(2)", "0"},
    // crosses
    {"-4 + 8*sqrt(2) - 2*sqrt(5)", "-4 + 8*sqrt(2) - 2*sqrt(5)", "-4 + 8*sqrt(2) - 2*sqrt(5)",  //
     "7*sqrt(2) - 2*sqrt(5) - 1*sqrt(10)", "4*sqrt(2) - 2*sqrt(5)", "0"},
    // half covers
    {"-4 + 4*sqrt(2)", "-4 + 4*sqrt(2)", "-4 + 4*sqrt(2)",  //
     "3*sqrt(2) - 1*sqrt(10)", "1 + 2*sqrt(2) - 1*sqrt(13)", "0"},
    // covers
    {"0", "0", "0", "0", "0", "0"},
};

class Contacts : public testing::TestWithParam<std::tuple<Contact, Contact>> {
 protected:
  Contact left() const { return std::get<0>(GetParam()); }
  Contact right() const { return std::get<1>(GetParam()); }
  Scene2 scene() const {
    return scene_of({{"floor", "4", "0", "0", "0"},
                     {"ceiling", "0", "4", "4", "4"},
                     left_occluder(left()),
                     right_occluder(right())});
  }
};

TEST_P(Contacts, HideWhatTheTableSays) {
  const Exact exact(scene());
  const RootSum twice = exact.measure("floor", "ceiling") * Rational(2);
  EXPECT_EQ(twice.to_string(), kTable[left()][right()]);
  EXPECT_TRUE(exact.report().closure_is_exact);
  const bool hides_nothing = left() <= kAlong && right() <= kAlong;
  const bool hides_all = left() == kCovers || right() == kCovers;
  EXPECT_EQ(exact.visibility("floor", "ceiling") == 1, hides_nothing);
  EXPECT_EQ(exact.visibility("floor", "ceiling") == -1, hides_all) << "no entry";
}

TEST_P(Contacts, AgreeWithTheBruteForceAndTheSweep) {
  oracle::ComparisonCounts counts;
  EXPECT_EQ(oracle::disagreement(scene(), counts), "");
  const std::vector<oracle::Segment> pieces = oracle::split(oracle::to_edges(scene())).pieces;
  EXPECT_EQ(oracle::broken_integer_closure(pieces), "");
  EXPECT_EQ(oracle::broken_sweep(pieces), "");
}

INSTANTIATE_TEST_SUITE_P(, Contacts, testing::Combine(testing::ValuesIn(kContacts), testing::ValuesIn(kContacts)),
                         [](const auto& test) {
                           std::string name = std::string(to_string(std::get<0>(test.param))) + " and " +
                                              to_string(std::get<1>(test.param));
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

}  // namespace
}  // namespace hottel::contact_table_test
