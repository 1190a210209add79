#include "solver/plane/simulation/queries.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/near_names.h"
#include "geometry/plane/scene/scene_builder.h"
#include "geometry/scene_names.h"
#include "io/external/plane/named_methods.h"
#include "kernel/rounding.h"
#include "kernel/support/failure.h"
#include "solver/plane/simulation/simulation.h"

namespace hottel::queries_test {
namespace {

using ::testing::ElementsAre;
using ::testing::ThrowsMessage;

// A room with a lamp under its ceiling; the lamp has two elements where they are asked for.
SceneBuilder2 room(std::uint32_t elements) {
  SceneBuilder2 builder("room");
  builder.add_material("white", {.reflectivity = "1/2"})
      .add_material("glow", {.emission = 10})
      .add_material("mirror", {.reflectivity = 1});
  builder.add_polyline("room", {{0, 0}, {0, 3}, {4, 3}, {4, 0}}, "white", {.closed = true});
  builder.add_edge("lamp", {1, "2.9"}, {2, "2.9"}, "glow", {.elements = elements});
  return builder;
}

TEST(Queries2, TellClosedFormsByName) {
  for (const std::uint32_t elements : {1u, 2u}) {
    const Simulation2 simulation(room(elements).build());
    const std::string lamp = elements == 1 ? "lamp" : "lamp#1";
    const ExactPair2 pair = exact_pair(simulation, lamp, "room[3]");
    EXPECT_EQ(round_quotient(pair.exchange, pair.area_from).number, view_factor(simulation, lamp, "room[3]"));
  }
  EXPECT_THROW(exact_pair(Simulation2(room(1).build()), "sky", "lamp"), UsageError);
}

// A row that was not chosen is empty, which says nothing of its factors.
TEST(Queries2, OfRowsThatWereNotChosenNothingIsTold) {
  const Scene2 scene = room(1).build();
  const Simulation2 simulation(scene, {.rows = RowChoice::of(scene, "lamp", Granularity::kFace)});
  EXPECT_GT(view_factor(simulation, "lamp", "room[3]").value, 0);
  EXPECT_THAT([&] { view_factor(simulation, "room[3]", "lamp"); },
              ThrowsMessage<UsageError>("'room[3]' has a row, but it was not chosen: nothing is known of its factors"));
  EXPECT_THAT([&] { simulation.radiosities(); },
              ThrowsMessage<UsageError>("radiosities need the view factors of all rows, and only some were chosen"));
}

TEST(Queries2, LightAtAPointIsThatOfACellWithThisCentre) {
  SceneBuilder2 builder = room(1);
  builder.set_grid({0, 0}, {4, 3}, 4, 3);
  const Simulation2 simulation(builder.build());
  const auto light = simulation.light();
  for (std::uint32_t y = 0; y < 3; ++y)
    for (std::uint32_t x = 0; x < 4; ++x) {
      const Point2 centre{Rational(2 * x + 1) / 2, Rational(2 * y + 1) / 2};
      EXPECT_THAT(light_at(simulation, centre).mean_irradiance, ElementsAre(light->grid.at(x, y)));
    }
}

TEST(NamedMethods2, AreThoseOfTheProgram) {
  EXPECT_EQ(method_2("gauss:4")->info().name, "gauss:4");
  EXPECT_EQ(method_2("gauss:4:normalised")->info().name, "gauss:4:normalised");
  EXPECT_EQ(method_2("exact")->info().guarantee, Guarantee::kExact);
  EXPECT_EQ(method_2("file:a.csv")->info().name, "file:a.csv");
  EXPECT_THROW(method_2("gaus:4"), UnknownName);
  EXPECT_EQ(method_patterns_2().front(), "exact");
  Scene2 scene = room(1).build();
  const Simulation2 by_gauss(std::move(scene), {.method = method_2("gauss:4")});
  EXPECT_NEAR(view_factor(by_gauss, "lamp", "room[3]").value, 0.3, 0.3);
}

TEST(MaterialCalled, IsFoundOrRefused) {
  Scene2 scene = room(1).build();
  material_called(scene, "glow").emission = Spectrum::scalar(1);
  EXPECT_EQ(scene.materials[1].emission.value[0], 1);
  EXPECT_THAT([&] { material_called(scene, "glwo"); }, ThrowsMessage<UsageError>("there is no material called 'glwo'"));
}

}  // namespace
}  // namespace hottel::queries_test
