// What --memory allows, where more is seen than was foreseen.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace hottel::testing_cli::memory_test::memory_test {
namespace {

TEST(Memory, ThatRunsOutInTheSweepIsAnUnmetRequestAndLeavesNoFiles) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel generate comb --n 300 --seed 5 -o comb.json --quiet").code, 0);
  const std::string solve = "hottel solve comb.json -o out --grid 4x4 --quiet --memory ";
  const Outcome outcome = place.run(solve + "140000");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, testing::StartsWith("comb.json: the scene has more than 700 visible pairs"));
  EXPECT_EQ(place.files(), std::vector<std::string>{"comb.json"});
  EXPECT_EQ(place.run(solve + "200000").code, 0);
}

}  // namespace
}  // namespace hottel::testing_cli::memory_test::memory_test
