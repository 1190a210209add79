// Who owns each side of each piece, and what is said when two claim the same side.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "geometry/plane/arrangement/arrangement.h"
#include "kernel/support/failure.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::arrangement_claims_test {
namespace {

using namespace testing_scenes;
using testing::AllOf;
using testing::HasSubstr;

Arrangement2 arrange(const std::vector<Line>& lines) {
  return Arrangement2(scene_of(lines), Division2(lines.size(), 1));
}

// "left|right" owners of the piece from (x, 0) to (x + 1, 0).
std::string owners(const std::vector<Line>& lines, long x) {
  const Arrangement2 arrangement = arrange(lines);
  const Vertices2& vertices = arrangement.vertices();
  const auto at = [&](VertexId v) { return vertices.to_scene(vertices.exact(v)); };
  const auto name = [&](PieceSideId side) {
    const FacePart2& face = arrangement.owner(side);
    return lines[face.surface].name + (face.is_back ? ":back" : "");
  };
  for (std::size_t k = 0; k < arrangement.pieces().size(); ++k) {
    const Point2 a = at(arrangement.pieces()[k].a), b = at(arrangement.pieces()[k].b);
    if (a == Point2{x, 0} && b == Point2{x + 1, 0}) return name(left_side(k)) + "|" + name(right_side(k));
    if (b == Point2{x, 0} && a == Point2{x + 1, 0}) return name(right_side(k)) + "|" + name(left_side(k));
  }
  return "no such piece";
}

std::string conflict(const std::vector<Line>& lines) {
  try {
    arrange(lines);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no conflict";
}

TEST(Claims2, AFrontIsOnTheRightAndABackWithoutMaterialClaimsNothing) {
  EXPECT_EQ(owners({{"a", "0", "0", "1", "0"}}, 0), "a:back|a");
  EXPECT_EQ(owners({{"a", "1", "0", "0", "0"}}, 0), "a|a:back");
  // The back of the first listed is black; the front of the second claims the same side.
  EXPECT_EQ(owners({{"a", "0", "0", "1", "0"}, {"b", "1", "0", "0", "0", 2}}, 0), "b|a");
}

TEST(Claims2, WithoutClaimsTheFirstListedBackStandsThere) {
  EXPECT_EQ(owners({{"a", "0", "0", "1", "0", 1}, {"b", "0", "0", "1", "0", 1}}, 0), "a:back|a");
}

TEST(Claims2, ASingleClaimWinsWhereverItIsListed) {
  EXPECT_EQ(owners({{"a", "0", "0", "1", "0"}, {"b", "0", "0", "1", "0", 0, 3}}, 0), "b:back|a");
  EXPECT_EQ(owners({{"a", "0", "0", "1", "0", 0, 3}, {"b", "0", "0", "1", "0"}}, 0), "a:back|a");
}

TEST(Claims2, OfEqualClaimsTheFirstListedWins) {
  EXPECT_EQ(owners({{"a", "0", "0", "1", "0", 1, 2}, {"b", "1", "0", "0", "0", 2, 1}}, 0), "a:back|a");
  EXPECT_EQ(owners({{"b", "1", "0", "0", "0", 2, 1}, {"a", "0", "0", "1", "0", 1, 2}}, 0), "b|b:back");
}

TEST(Claims2, HoldForEachPieceByItself) {
  const std::vector<Line> lines{{"a", "0", "0", "2", "0", 1, 1}, {"b", "1", "0", "3", "0", 1, 1}};
  EXPECT_EQ(owners(lines, 0), "a:back|a");
  EXPECT_EQ(owners(lines, 1), "a:back|a");
  EXPECT_EQ(owners(lines, 2), "b:back|b");
}

TEST(Claims2, MaterialsAreComparedByWhatTheyDo) {
  Scene2 scene = scene_of({{"a", "0", "0", "1", "0", 1}, {"b", "0", "0", "1", "0", 2}});
  EXPECT_THROW(Arrangement2(scene, Division2(2, 1)), InputError);
  scene.materials[2].reflectivity = scene.materials[1].reflectivity;
  EXPECT_NO_THROW(Arrangement2(scene, Division2(2, 1))) << "another name, the same material";
}

TEST(Claims2, AConflictNamesBothTheSideAndThePiece) {
  const std::string message = conflict({{"wall", "0", "0", "2", "0", 1}, {"door", "1", "0", "3", "0", 2}});
  EXPECT_THAT(message, AllOf(HasSubstr("test.json: "), HasSubstr("'wall' (front)"), HasSubstr("'door' (front)"),
                             HasSubstr("(1, 0)"), HasSubstr("(2, 0)")));
  EXPECT_EQ(message.find('\n'), std::string::npos) << "one line";
  EXPECT_THAT(conflict({{"wall", "0", "0", "2", "0", 1}, {"door", "3", "0", "1", "0", 2, 3}}),
              AllOf(HasSubstr("'wall' (front)"), HasSubstr("'door' (back)")));
  EXPECT_EQ(conflict({{"wall", "0", "0", "2", "0", 1}, {"door", "3", "0", "1", "0", 2}}), "no conflict")
      << "the back of the door is black and claims nothing";
  EXPECT_EQ(conflict({{"wall", "0", "0", "2", "0", 1, 2}, {"door", "3", "0", "1", "0", 2, 1}}), "no conflict");
  EXPECT_EQ(conflict({{"wall", "0", "0", "2", "0", 1}, {"door", "2", "0", "3", "0", 2}}), "no conflict")
      << "neighbours share a point only";
  // Not only between the first two.
  EXPECT_THAT(conflict({{"a", "0", "0", "2", "0", 1}, {"b", "0", "0", "2", "0", 1}, {"c", "0", "0", "2", "0", 3}}),
              AllOf(HasSubstr("'a' (front)"), HasSubstr("'c' (front)")));
}

TEST(Claims2, AConflictPointsAtTheLineAndHints) {
  Scene2 scene = scene_of({{"wall", "0", "0", "2", "0", 1}, {"door", "1", "0", "3", "0", 2}});
  scene.surfaces[1].line = 14;
  try {
    prepare(scene);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().line, 14);
    EXPECT_THAT(error.what(), HasSubstr("test.json:14: "));
    EXPECT_LE(error.hints().size(), 3u);
    EXPECT_THAT(error.hints(), testing::Contains(AllOf(HasSubstr("material 1"), HasSubstr("material 2"))));
  }
}

TEST(Claims2, SourcesTellTheWayTheyRun) {
  const Arrangement2 arrangement = arrange({{"a", "0", "0", "1", "0"}, {"b", "1", "0", "0", "0", 2}});
  ASSERT_EQ(arrangement.pieces().size(), 1u);
  const auto sources = arrangement.sources(0);
  ASSERT_EQ(sources.size(), 2u);
  EXPECT_EQ(sources[0].surface, 0u);
  EXPECT_EQ(sources[1].surface, 1u);
  EXPECT_NE(sources[0].is_reversed, sources[1].is_reversed);
}

TEST(Claims2, PartsOfADividedSurfaceOwnTheirPieces) {
  const Scene2 scene = scene_of({{"a", "0", "0", "3", "0", 1}, {"b", "1", "0", "2", "0", 1, 2}});
  const Arrangement2 arrangement(scene, {3, 2});
  // a in thirds, b in halves inside the middle third.
  EXPECT_EQ(arrangement.pieces().size(), 4u);
  int owned_backs_of_b = 0;
  for (const PieceSideId side : arrangement.sides()) {
    const FacePart2& face = arrangement.owner(side);
    if (face.surface == 1) {
      EXPECT_TRUE(face.is_back);
      ++owned_backs_of_b;
    }
  }
  EXPECT_EQ(owned_backs_of_b, 2);
}

}  // namespace
}  // namespace hottel::arrangement_claims_test
