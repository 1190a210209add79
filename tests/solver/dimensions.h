// The plane and space as parameters of a test: what is called differently in each, and rooms to be edited.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/space/light/illumination_grid.h"
#include "solver/space/methods/method_catalogue.h"
#include "tests/solver/plane/edited_scenes.h"
#include "tests/solver/space/edited_scenes.h"

namespace hottel {

struct PlaneTests {
  using Scene = Scene2;
  using Simulation = Simulation2;
  using Request = SimulationRequest2;
  using Edits = RandomEdits;
  using Prepared = PreparedScene2;
  using Method = ExchangeMethod2;
  using ElementMethod = ElementMethod2;
  using Catalogue = MethodCatalogue2;
  using Grid = Grid2;
  static constexpr int kEdits = 1000, kRounds = 12;
  static constexpr std::uint64_t kSeed = 20261122;

  // Draws nothing but how many values there are.
  class Painter final : public LightPainter2 {
   public:
    LightPicture2 paint(const PreparedScene2&, const IlluminationGrid2& light) const override {
      return {.bytes = std::to_string(light.values.size())};
    }
  };

  static Scene room() { return room_to_edit(); }
  // A unit square whose walls send out 1 each and reflect the same.
  static Scene furnace(const std::string& reflectivity) {
    return parse_scene_2(R"({"hottel":1,"dimension":2,"materials":{"m":{"emission":1,"reflectivity":)" + reflectivity +
                             R"(}},"polylines":[{"name":"room","points":[[0,0],[0,1],[1,1],[1,0]],"closed":true,
      "material":"m"}]})",
                         "furnace.json");
  }
  // A grid over the room.
  static Grid grid(std::uint32_t nx, std::uint32_t ny) { return {{0, 0}, {8, 8}, nx, ny}; }
  static void set_grid(Request& request, const Grid& grid) { request.grid = grid; }
  static void set_painter(Request& request) { request.painter = std::make_shared<const Painter>(); }
  static void set_memory(Request& request, std::uint64_t bytes) { request.memory = bytes; }
  static void set_method(Request& request, const char* name) { request.method = methods_2().make(name); }
  static void set_store(Request& request, std::shared_ptr<FactorStore> store) { request.store = std::move(store); }
  static void set_granularity(Request& request, Granularity granularity) { request.granularity = granularity; }
  static void set_visibility(Request& request) { request.wants_visibility = true; }
  static const auto& values(const SolvedLight2& light) { return light.grid.values; }
  static const Grid& grid_of(const SolvedLight2& light) { return light.grid.grid; }

  static Catalogue methods() { return methods_2(); }
  // With the elements that surfaces are divided into.
  static Prepared prepared(const Scene& scene) { return prepare(scene, Divided2::kYes); }
  static const auto& arrangement(const PreparedScene2& prepared) { return prepared.shared; }

  // The room with a lamp called torch.
  static Scene lit_room() {
    Scene scene = room();
    Light torch;
    torch.name = "torch";
    torch.power = Spectrum::scalar(2);
    scene.add_light(std::move(torch), {.position = {Rational(9, 2), Rational(5, 2)}});
    return scene;
  }
  // Leaves a gap in a wall.
  static void open(Scene& scene) { scene.edges[4].to.y = 7; }
  static void move_wall(Scene& scene) { scene.edges[3].to.x += 1; }
  static void spoil(Scene& scene) { scene.edges[0].to = scene.edges[0].from; }
};

struct SpaceTests {
  using Scene = Scene3;
  using Simulation = Simulation3;
  using Request = SimulationRequest3;
  using Edits = RandomEdits3;
  using Prepared = PreparedScene3;
  using Method = ExchangeMethod3;
  using ElementMethod = ElementMethod3;
  using Catalogue = MethodCatalogue3;
  using Grid = Grid3;
  static constexpr int kEdits = 100, kRounds = 4;
  static constexpr std::uint64_t kSeed = 20261129;

  class Painter final : public LightPainter3 {
   public:
    LightPicture3 paint(const IlluminationGrid3& light) const override {
      return {.bytes = std::to_string(light.values.size())};
    }
  };

  static Scene room() { return room_to_edit_3(); }
  // A unit cube of such walls.
  static Scene furnace(const std::string& reflectivity) {
    return parse_scene_3(R"({"hottel":1,"dimension":3,"materials":{"m":{"emission":1,"reflectivity":)" + reflectivity +
                             R"(}},"polygons":[
      {"name":"floor","points":[[0,0,0],[1,0,0],[1,1,0],[0,1,0]],"material":"m"},
      {"name":"ceiling","points":[[0,0,1],[0,1,1],[1,1,1],[1,0,1]],"material":"m"},
      {"name":"front","points":[[0,0,0],[0,0,1],[1,0,1],[1,0,0]],"material":"m"},
      {"name":"rear","points":[[0,1,0],[1,1,0],[1,1,1],[0,1,1]],"material":"m"},
      {"name":"left","points":[[0,0,0],[0,1,0],[0,1,1],[0,0,1]],"material":"m"},
      {"name":"right","points":[[1,0,0],[1,0,1],[1,1,1],[1,1,0]],"material":"m"}]})",
                         "furnace.json");
  }
  static Grid grid(std::uint32_t nu, std::uint32_t nv) {
    return {{0, 0, Rational(3, 2)}, {8, 0, 0}, {0, 8, 0}, nu, nv};
  }
  static void set_grid(Request& request, const Grid& grid) { request.light.grid = grid; }
  static void set_painter(Request& request) { request.light.painter = std::make_shared<const Painter>(); }
  static void set_memory(Request& request, std::uint64_t bytes) { request.factors.memory = bytes; }
  static void set_method(Request& request, const char* name) { request.factors.method = methods_3().make(name); }
  static void set_store(Request& request, std::shared_ptr<FactorStore> store) {
    request.factors.store = std::move(store);
  }
  static void set_granularity(Request& request, Granularity granularity) { request.factors.granularity = granularity; }
  static void set_visibility(Request& request) { request.factors.wants_visibility = true; }
  static const auto& values(const IlluminationGrid3& light) { return light.values; }
  static const Grid& grid_of(const IlluminationGrid3& light) { return light.grid; }

  static Catalogue methods() { return methods_3(); }
  static Prepared prepared(const Scene& scene) { return prepare(scene); }
  static const auto& arrangement(const PreparedScene3& prepared) { return prepared.ready; }

  static Scene lit_room() { return room(); }
  static void open(Scene& scene) {
    for (Point3& point : scene.polygons[1].points)
      if (point.x == 8) point.x = 7;
  }
  static void move_wall(Scene& scene) {
    for (Polygon3& polygon : scene.polygons)
      for (Point3& point : polygon.points)
        if (point.x == 8) point.x = 9;
  }
  static void spoil(Scene& scene) { scene.polygons[0].points[2] = scene.polygons[0].points[1]; }
};

using BothDimensions = testing::Types<PlaneTests, SpaceTests>;

// Tests are called after the dimension: Suite/plane.Test, Suite/space.Test.
struct DimensionNames {
  template <class D>
  static std::string GetName(int) {
    return std::is_same_v<D, PlaneTests> ? "plane" : "space";
  }
};

}  // namespace hottel
