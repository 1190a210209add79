// Some furnished rooms in every run of the tests (more: hottel_storm --dimension 3 --rooms), and the storm itself.
#include "tests/storm/space/room_storm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/sanitizers.h"

namespace hottel::storm::room_storm_test {
namespace {

constexpr std::uint64_t kRooms = kHasAddressSanitizer ? 5 : 30;

TEST(RoomStorm3, ManyRoomsObeyTheLaws) {
  StormOptions options;
  options.scenes = kRooms;
  options.threads = 2;
  const std::vector<RoomLaw3>& laws = room_laws_3();
  const RoomStormResult3 result = run_room_storm_3(options, laws);
  const std::string text = report(result, laws);
  std::printf("%s", text.c_str());
  EXPECT_EQ(result.scenes, kRooms);
  EXPECT_EQ(result.disputed, 0u);
  EXPECT_EQ(result.all_failures(), 0u) << text;
  for (std::size_t l = 0; l < laws.size(); ++l) EXPECT_GE(result.checks[l], kRooms / laws[l].every / 2) << laws[l].name;
  for (std::size_t n = 0; n < kRoomNumbers3 && !kHasAddressSanitizer; ++n)
    EXPECT_GE(result.numbers[n], 1u) << to_string(static_cast<RoomNumbers3>(n));
}

bool has_seven_polygons(const SolidBodies3& bodies) {
  std::size_t count = 0;
  for (const SolidBody3& body : bodies) count += body.faces.size();
  return count >= 7;
}
std::string six_polygons_at_most(const RoomSubject3& subject) {
  return has_seven_polygons(subject.bodies()) ? "seven polygons\n" : "";
}

TEST(RoomStorm3, ShrinksAFailureToItsCauseAndPrintsItAsAScene) {
  StormOptions options;
  options.scenes = 2;
  const std::vector<RoomLaw3> planted{{"six polygons at most", six_polygons_at_most, 1, true}};
  const RoomStormResult3 result = run_room_storm_3(options, planted);
  ASSERT_EQ(result.examples.size(), 1u);
  std::size_t count = 0;
  for (const SolidBody3& body : result.examples[0].scene) count += body.faces.size();
  EXPECT_EQ(count, 7u);
  const std::string text = report(result, planted);
  EXPECT_THAT(text, testing::HasSubstr("breaks six polygons at most"));
  EXPECT_THAT(text, testing::HasSubstr("\"dimension\": 3"));
}

TEST(FurnishedRoom3, IsValidSmallAndTheSameForItsNumber) {
  for (std::uint64_t number = 0; number < 300; ++number) {
    const SolidBodies3 bodies = furnished_room_3(number).bodies;
    EXPECT_TRUE(is_valid_3(bodies)) << number;
    EXPECT_EQ(bodies, furnished_room_3(number).bodies);
    std::size_t polygons = 0;
    for (const SolidBody3& body : bodies) polygons += body.faces.size();
    EXPECT_LE(polygons, static_cast<std::size_t>(kMostRoomPolygons)) << number;
    EXPECT_GE(polygons, 6u) << number;
  }
}

}  // namespace
}  // namespace hottel::storm::room_storm_test
