// Light of scenes that promise to be closed: NaN outside, in all ways it is computed, and as it is within.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/scene/scene_json.h"
#include "solver/plane/light/solved_light.h"
#include "solver/plane/simulation/queries.h"
#include "solver/plane/simulation/simulation.h"

namespace hottel::closed_light_test {
namespace {

// A room from 0 to 4, in it a box without an inside, beside it a chamber of black backs; a grid from -2 to 6.
std::string closed_room(bool is_closed, const std::string& more = "") {
  return std::string(R"({"hottel": 1, "dimension": 2, "materials": {"w": {"reflectivity": 0.5, "emission": 1}},)") +
         (is_closed ? "\"closed\": true," : "") + R"("sky": {"emission": 3}, "polylines": [
  {"name": "room", "points": [[0, 0], [0, 4], [4, 4], [4, 0]], "closed": true, "material": "w"})" +
         more + R"(], "grid": {"min": [-2, -2], "max": [6, 6], "cells": [8, 8]}})";
}

IlluminationGrid2 light_of(const std::string& text, LightKind2 kind, bool keeps_rows = false) {
  SimulationRequest2 request;
  request.light = kind;
  request.keeps_rows = keeps_rows;
  return Simulation2(parse_scene_2(text, "s.json"), request).light()->grid;
}

bool is_inside(std::uint32_t ix, std::uint32_t iy) { return ix >= 2 && ix < 6 && iy >= 2 && iy < 6; }

TEST(ClosedLight2, CellsOutsideAreNanHoweverLightIsComputed) {
  for (const LightKind2 kind : {LightKind2::kPoint, LightKind2::kAverage, LightKind2::kInverseSquare})
    for (const bool keeps_rows : {false, true}) {
      const IlluminationGrid2 closed = light_of(closed_room(true), kind, keeps_rows);
      const IlluminationGrid2 open = light_of(closed_room(false), kind, keeps_rows);
      for (std::uint32_t iy = 0; iy < 8; ++iy)
        for (std::uint32_t ix = 0; ix < 8; ++ix) {
          const std::size_t cell = iy * 8 + ix;
          EXPECT_EQ(std::isnan(closed.values[cell]), !is_inside(ix, iy)) << to_string(kind) << " " << ix << " " << iy;
          EXPECT_FALSE(std::isnan(open.values[cell])) << to_string(kind);
          if (is_inside(ix, iy)) {
            EXPECT_NEAR(closed.values[cell], open.values[cell], 1e-12 * open.values[cell]) << to_string(kind);
          }
        }
    }
}

// Half of a cell is outside: its mean is over the other half.
TEST(ClosedLight2, AveragesAreOverWhatIsInside) {
  std::string text = closed_room(true);
  text.replace(text.find("[-2, -2]"), 8, "[-2.5, -2.5]");
  text.replace(text.find("[6, 6]"), 6, "[5.5, 5.5]");
  const IlluminationGrid2 light = light_of(text, LightKind2::kAverage);
  for (std::uint32_t iy = 0; iy < 8; ++iy)
    for (std::uint32_t ix = 0; ix < 8; ++ix) {
      const bool has_some = ix >= 2 && ix < 7 && iy >= 2 && iy < 7;
      const double value = light.values[iy * 8 + ix];
      EXPECT_EQ(std::isnan(value), !has_some) << ix << " " << iy;
      if (has_some) {
        EXPECT_NEAR(value, 2, 1e-9) << ix << " " << iy;  // E / (1 - rho), wherever one looks
      }
    }
}

TEST(ClosedLight2, AVoidOfBlackBacksIsOutsideToo) {
  // A square of fronts outward that is no solid: within it one sees black backs.
  const std::string open_box = R"(,
  {"name": "box", "points": [[1, 1], [2, 1], [2, 2], [1, 2]], "closed": true, "material": "w", "behind": "open"})";
  for (const LightKind2 kind : {LightKind2::kPoint, LightKind2::kAverage, LightKind2::kInverseSquare}) {
    const IlluminationGrid2 light = light_of(closed_room(true, open_box), kind);
    for (std::uint32_t iy = 0; iy < 8; ++iy)
      for (std::uint32_t ix = 0; ix < 8; ++ix)
        EXPECT_EQ(std::isnan(light.values[iy * 8 + ix]), !is_inside(ix, iy) || (ix == 3 && iy == 3))
            << to_string(kind) << " " << ix << " " << iy;
  }
}

// Backs with a material shine outside.
TEST(ClosedLight2, WhereABackWithMaterialIsSeenThereIsLight) {
  std::string text = closed_room(true);
  text.replace(text.find("\"material\": \"w\""), 15, "\"material\": \"w\", \"back\": \"w\"");
  for (const LightKind2 kind : {LightKind2::kPoint, LightKind2::kAverage})
    for (const double value : light_of(text, kind).values) EXPECT_FALSE(std::isnan(value)) << to_string(kind);
}

TEST(ClosedLight2, PointsOutsideAreNan) {
  for (const bool is_closed : {false, true}) {
    const Simulation2 simulation(parse_scene_2(closed_room(is_closed), "s.json"));
    for (const Point2& point : {Point2{-1, 1}, Point2{5, 5}, Point2{100, 1}})
      EXPECT_EQ(std::isnan(light_at(simulation, point).mean_irradiance.at(0)), is_closed);
    for (const Point2& point : {Point2{1, 1}, Point2{0, 1}, Point2{0, 0}})
      EXPECT_FALSE(std::isnan(light_at(simulation, point).mean_irradiance.at(0)));
  }
}

// Rows are kept when the promise changes, light is not.
TEST(ClosedLight2, FollowsThePromiseOfEachVersion) {
  SimulationRequest2 request;
  request.keeps_rows = true;
  const Simulation2 open(parse_scene_2(closed_room(false), "s.json"), request);
  const Simulation2 closed = open.with_scene(parse_scene_2(closed_room(true), "s.json"));
  EXPECT_FALSE(std::isnan(open.light()->grid.values[0]));
  EXPECT_TRUE(std::isnan(closed.light()->grid.values[0]));
  EXPECT_FALSE(std::isnan(closed.with_scene(open.scene()).light()->grid.values[0]));
}

}  // namespace
}  // namespace hottel::closed_light_test
