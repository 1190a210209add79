// What pair_report says of pairs: numbers, how they were settled, stretches and pieces.
#include "geometry/space/exchange/pair_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "geometry/scene_names.h"
#include "geometry/space/exchange/exchange.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel::pair_report_test {
namespace {

using ::testing::ElementsAre;

constexpr double kTolerance = 1e-9;

PreparedScene3 scene_file(const std::string& name) {
  return prepare(read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name));
}

// Two unit squares that look at each other at distance 2, and what is between.
PreparedScene3 plates(const std::string& between) {
  return prepare(parse_scene_3(
      R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
        {"name": "low", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"},
        {"name": "high", "points": [[0,0,2],[0,1,2],[1,1,2],[1,0,2]], "material": "m"})" +
          between + "]}",
      "scene.json"));
}

PairReport3 report_of(const PreparedScene3& prepared, const std::string& from, const std::string& to) {
  const auto face = [&](const std::string& name) {
    return name == "sky" ? std::nullopt : std::optional(face_of(prepared.scene, name));
  };
  return pair_report(prepared, face(from), face(to), kTolerance);
}

std::set<StretchRole3> roles_of(const PairReport3& report) {
  std::set<StretchRole3> roles;
  for (const PairReport3::Stretch& stretch : report.stretches) roles.insert(stretch.role);
  return roles;
}

double sum_of_pieces(const PairReport3& report) {
  double sum = 0;
  for (const PairReport3::Stretch& stretch : report.stretches)
    for (const PairDetails3::Piece& piece : stretch.pieces) sum += piece.measure;
  return sum;
}

constexpr const char* kScreen =
    R"(, {"name": "screen", "points": [[-9,-9,1],[9,-9,1],[9,9,1],[-9,9,1]], "material": "m"})";
constexpr const char* kTwoScreens =
    R"(, {"name": "west", "points": [[-9,-9,1],["1/3",-9,1],["1/3",9,1],[-9,9,1]], "material": "m"},
         {"name": "east", "points": [["1/3",-9,1],[9,-9,1],[9,9,1],["1/3",9,1]], "material": "m"})";
// The same, one above the other.
constexpr const char* kStaggeredScreens =
    R"(, {"name": "west", "points": [[-9,-9,1],["1/3",-9,1],["1/3",9,1],[-9,9,1]], "material": "m"},
         {"name": "east", "points": [["1/8",-9,"5/4"],[9,-9,"5/4"],[9,9,"5/4"],["1/8",9,"5/4"]], "material": "m"})";
constexpr const char* kSmallScreen =
    R"(, {"name": "screen", "points": [[0,0,1],["1/2",0,1],["1/2","1/2",1],[0,"1/2",1]], "material": "m"})";
constexpr const char* kSmallScreenInParts =
    R"(, {"name": "screen.low", "points": [[0,0,1],["1/2",0,1],["1/2","1/2",1]], "material": "m"},
         {"name": "screen.high", "points": [[0,0,1],["1/2","1/2",1],[0,"1/2",1]], "material": "m"})";
// On the edge of the hull of both plates.
constexpr const char* kGrazing =
    R"(, {"name": "screen", "points": [[1,-9,1],[9,-9,1],[9,9,1],[1,9,1]], "material": "m"})";
constexpr const char* kWall =
    R"(, {"name": "wall", "points": [["1/2","1/4",0],["1/2","3/4",0],["1/2","3/4",1],["1/2","1/4",1]], "material": "m"})";

TEST(PairReport3, HasTheNumbersOfTheMatrix) {
  for (const char* name : {"cube.json", "two_boxes.json"}) {
    const PreparedScene3 prepared = scene_file(name);
    const ExchangeMatrix matrix = exact_exchange(prepared, {.wants_measures = true});
    for (std::uint32_t i = 0; i < matrix.size(); i += 2)
      for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
        const FactorEntry& entry = matrix.row(i)[k];
        const PairReport3 report =
            pair_report(prepared, Face::of(i),
                        entry.to == matrix.size() ? std::nullopt : std::optional(Face::of(entry.to)), kTolerance);
        EXPECT_EQ(report.exchange.value, matrix.measures(i)[k]);
        EXPECT_EQ(report.visibility->value, entry.visibility);
        EXPECT_EQ(report.factor_from->value, entry.factor.value);
        EXPECT_EQ(report.factor_from->bounds, matrix.bounds(i, k));
        EXPECT_EQ(report.is_enclosed(), matrix.guarantee(i, k) == Guarantee::kEnclosed);
        EXPECT_TRUE(report.exchange.bounds.contains(report.exchange.value));
        EXPECT_TRUE(report.visibility->bounds.contains(report.visibility->value));
      }
  }
}

TEST(PairReport3, PiecesSumUpToTheMeasure) {
  const PreparedScene3 prepared = scene_file("two_boxes.json");
  for (const auto& [from, to] :
       {std::pair{"lamp", "floor"}, {"floor", "rear"}, {"floor", "left"}, {"low.top", "left"}}) {
    const PairReport3 report = report_of(prepared, from, to);
    EXPECT_NEAR(sum_of_pieces(report), report.along_edges.value, 1e-13) << from;
    EXPECT_NEAR(report.along_edges.value, report.exchange.value, report.along_edges.error + report.exchange.error);
    EXPECT_LE(report.residual, report.residual_bound);
    std::size_t pieces = 0;
    for (const PairReport3::Stretch& stretch : report.stretches) {
      double sum = 0;
      for (const PairDetails3::Piece& piece : stretch.pieces) sum += piece.measure;
      EXPECT_DOUBLE_EQ(sum, stretch.measure);
      pieces += stretch.pieces.size();
    }
    EXPECT_EQ(pieces, report.pieces);
  }
}

TEST(PairReport3, ClosedFormsAreTheSumAlongEdgesToo) {
  const PairReport3 report = report_of(plates(""), "low", "high");
  EXPECT_EQ(report.sight, PairVisibility3::kClear);
  EXPECT_TRUE(report.is_whole);
  EXPECT_THAT(report.between, ElementsAre());
  EXPECT_NEAR(report.along_edges.value, report.exchange.value, 1e-12);
  EXPECT_EQ(report.exchange.value, report.unobstructed.value);
  EXPECT_EQ(report.visibility->value, 1);
  // The eight edges, in a piece each.
  EXPECT_EQ(report.looked_at, 8u);
  ASSERT_EQ(report.stretches.size(), 8u);
  for (const PairReport3::Stretch& stretch : report.stretches) {
    EXPECT_EQ(stretch.role, StretchRole3::kSource);
    EXPECT_NE(stretch.is_on_from, stretch.is_on_to);
    EXPECT_EQ(stretch.from.z, stretch.is_on_from ? 0 : 2);
    EXPECT_EQ(stretch.pieces.size(), 1u);
    EXPECT_EQ(stretch.pieces[0].arcs, 4u);
    EXPECT_EQ(stretch.pieces[0].low, 0);
    EXPECT_EQ(stretch.pieces[0].high, 1);
  }
}

TEST(PairReport3, TellsHowAPairWasSettled) {
  const PairReport3 away = report_of(plates(""), "low:back", "high");
  EXPECT_EQ(away.sight, PairVisibility3::kHidden);
  EXPECT_FALSE(away.is_facing());
  EXPECT_FALSE(away.visibility);
  EXPECT_TRUE(away.hiders.empty());

  const PreparedScene3 screened = plates(kScreen);
  const PairReport3 hidden = report_of(screened, "low", "high");
  EXPECT_EQ(hidden.sight, PairVisibility3::kHidden);
  EXPECT_THAT(hidden.hiders, ElementsAre(*screened.scene.find("screen")));
  EXPECT_EQ(hidden.exchange.bounds, (Enclosure{0, 0}));
  EXPECT_EQ(hidden.visibility->value, 0);
  EXPECT_TRUE(hidden.stretches.empty());

  const PairReport3 as_one = report_of(plates(kTwoScreens), "low", "high");
  EXPECT_EQ(as_one.sight, PairVisibility3::kHidden);
  EXPECT_THAT(as_one.hiders, ElementsAre(2u, 3u));

  const PairReport3 together = report_of(plates(kStaggeredScreens), "low", "high");
  EXPECT_EQ(together.sight, PairVisibility3::kMixed);
  EXPECT_THAT(together.between, ElementsAre(2u, 3u));
  EXPECT_TRUE(together.hiders.empty());
  EXPECT_EQ(together.exchange.bounds, (Enclosure{0, 0}));
  EXPECT_FALSE(together.is_whole);
  EXPECT_TRUE(together.is_facing());
  EXPECT_GT(together.looked_at, 0u);
  EXPECT_TRUE(together.stretches.empty());

  const PairReport3 mixed = report_of(plates(kSmallScreen), "low", "high");
  EXPECT_EQ(mixed.sight, PairVisibility3::kMixed);
  EXPECT_THAT(mixed.between, ElementsAre(2u));
  EXPECT_FALSE(mixed.is_whole);
  EXPECT_GT(mixed.visibility->value, 0);
  EXPECT_LT(mixed.visibility->value, 1);

  const PairReport3 grazed = report_of(plates(kGrazing), "low", "high");
  EXPECT_TRUE(grazed.is_whole);
  EXPECT_EQ(grazed.visibility->value, 1);
}

// By symmetry, the screen halfway above a quarter of the plate hides a quarter.
TEST(PairReport3, AQuarterScreenHidesAQuarter) {
  const PairReport3 report = report_of(plates(kSmallScreen), "low", "high");
  EXPECT_NEAR(report.visibility->value, 0.75, 1e-9);
}

TEST(PairReport3, StretchesSayWhereTheyAre) {
  const PreparedScene3 prepared = plates(kSmallScreen);
  const PairReport3 outlined = report_of(prepared, "low", "high");
  EXPECT_EQ(roles_of(outlined), (std::set{StretchRole3::kSource, StretchRole3::kOutline}));
  for (const PairReport3::Stretch& stretch : outlined.stretches) {
    const bool is_outline = stretch.role == StretchRole3::kOutline;
    EXPECT_EQ(stretch.from.z, is_outline ? 1 : stretch.is_on_from ? 0 : 2);
    EXPECT_EQ(stretch.from.z, stretch.to.z);
    EXPECT_EQ(stretch.is_on_from || stretch.is_on_to, !is_outline);
    EXPECT_EQ(stretch.surfaces.empty(), !is_outline);
  }
  const PairReport3 standing = report_of(plates(kWall), "low", "high");
  EXPECT_EQ(roles_of(standing), (std::set{StretchRole3::kSource, StretchRole3::kFoot, StretchRole3::kOutline}));
  for (const PairReport3::Stretch& stretch : standing.stretches) {
    if (stretch.role != StretchRole3::kFoot) continue;
    EXPECT_TRUE(stretch.is_on_from);
    EXPECT_EQ(std::min(stretch.from, stretch.to, [](const Point3& a, const Point3& b) { return a.y < b.y; }),
              (Point3{Rational(1, 2), Rational(1, 4), 0}));
    EXPECT_THAT(stretch.surfaces, ElementsAre(2u));
  }
}

// Of polygons that hide as one, a stretch is on that which has it for an edge; the measure is that of one polygon.
TEST(PairReport3, ScreensInPartsHideAsOneAndAreNamedByPart) {
  const PairReport3 whole = report_of(plates(kSmallScreen), "low", "high");
  const PairReport3 parts = report_of(plates(kSmallScreenInParts), "low", "high");
  EXPECT_EQ(parts.exchange.value, whole.exchange.value);
  EXPECT_EQ(parts.stretches.size(), whole.stretches.size());
  EXPECT_THAT(parts.between, ElementsAre(2u, 3u));
  std::set<std::uint32_t> named;
  for (const PairReport3::Stretch& stretch : parts.stretches) {
    if (stretch.role != StretchRole3::kOutline) continue;
    ASSERT_EQ(stretch.surfaces.size(), 1u);
    named.insert(stretch.surfaces.front());
    const bool is_of_low = stretch.from.y == 0 || stretch.to.y == 0;
    if (stretch.from.y == stretch.to.y) {
      EXPECT_EQ(stretch.surfaces.front(), is_of_low ? 2u : 3u);
    }
  }
  EXPECT_EQ(named.size(), 2u);
}

TEST(PairReport3, PiecesAreInOrderAndDifferFromTheirNeighbours) {
  const PreparedScene3 prepared = scene_file("two_boxes.json");
  for (const char* to : {"floor", "rear", "left", "high.side_2"}) {
    const PairReport3 report = report_of(prepared, "lamp", to);
    for (const PairReport3::Stretch& stretch : report.stretches) {
      ASSERT_FALSE(stretch.pieces.empty());
      EXPECT_GT(stretch.relied, 0u);
      double last = 0;
      for (std::size_t p = 0; p < stretch.pieces.size(); ++p) {
        const PairDetails3::Piece& piece = stretch.pieces[p];
        EXPECT_LE(last, piece.low);
        EXPECT_LT(piece.low, piece.high);
        EXPECT_LE(piece.high, 1);
        EXPECT_GE(piece.arcs, 3u);
        EXPECT_FALSE(piece.signature.empty());
        if (p > 0 && last == piece.low) {
          EXPECT_NE(piece.signature, stretch.pieces[p - 1].signature);
        }
        last = piece.high;
      }
    }
  }
}

TEST(PairReport3, ReversedThePairIsTheSame) {
  const PreparedScene3 prepared = scene_file("two_boxes.json");
  const PairReport3 forth = report_of(prepared, "lamp", "floor"), back = report_of(prepared, "floor", "lamp");
  EXPECT_EQ(forth.exchange.value, back.exchange.value);
  for (std::size_t s = 0; s < forth.stretches.size(); ++s)
    EXPECT_EQ(forth.stretches[s].is_on_from, back.stretches[s].is_on_to);
  EXPECT_EQ(forth.stretches.size(), back.stretches.size());
  EXPECT_EQ(forth.area_from, back.area_to);
  EXPECT_EQ(forth.between, back.between);
}

TEST(PairReport3, TheSkyHasNeitherAreaNorFactor) {
  const PreparedScene3 prepared = plates("");
  const PairReport3 sky = report_of(prepared, "low", "sky"), plate = report_of(prepared, "low", "high");
  EXPECT_NEAR(sky.exchange.value + plate.exchange.value, 1, 1e-8);
  EXPECT_FALSE(sky.area_to);
  EXPECT_EQ(sky.unobstructed.value, 1);
  EXPECT_EQ(sky.visibility->value, sky.exchange.value);
  EXPECT_EQ(report_of(prepared, "sky", "low").exchange.value, sky.exchange.value);
  const PairReport3 closed = report_of(scene_file("cube.json"), "floor", "sky");
  EXPECT_EQ(closed.exchange.bounds, (Enclosure{0, 0}));
  EXPECT_EQ(closed.visibility->value, 0);
}

TEST(PairReport3, MeasuresAreOfTheScenesUnit) {
  const auto cube_of = [](const std::string& side) {
    std::string text = R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
      {"name": "low", "points": [[0,0,0],[S,0,0],[S,S,0],[0,S,0]], "material": "m"},
      {"name": "high", "points": [[0,0,S],[0,S,S],[S,S,S],[S,0,S]], "material": "m"}]})";
    for (std::size_t at = text.find('S'); at != std::string::npos; at = text.find('S')) text.replace(at, 1, side);
    return prepare(parse_scene_3(text, "scene.json"));
  };
  const PairReport3 one = report_of(cube_of("1"), "low", "high");
  const PairReport3 three = report_of(cube_of("3"), "low", "high");
  EXPECT_DOUBLE_EQ(three.exchange.value, 9 * one.exchange.value);
  EXPECT_EQ(three.area_from->value, 9);
  EXPECT_EQ(three.stretches[0].to.x + three.stretches[0].to.y, 3);
  EXPECT_THROW(report_of(cube_of("1e200"), "low", "high"), RequestError);
}

}  // namespace
}  // namespace hottel::pair_report_test
