// A caller who rounds upward, or flushes subnormal numbers to zero, gets what every other caller gets.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include "geometry/plane/exchange/exchange.h"
#include "io/scene/scene_json.h"
#include "kernel/support/parallel.h"
#include "solver/plane/light/illumination_grid.h"
#include "solver/radiosity/radiosity.h"

namespace hottel::floating_point_environment_test {
namespace {

struct Everything {
  std::vector<double> factors, radiosities, light;
  bool operator==(const Everything& other) const {  // bit for bit: places in solids are NaN
    return factors == other.factors && radiosities == other.radiosities &&
           std::equal(light.begin(), light.end(), other.light.begin(), other.light.end(), [](double a, double b) {
             return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
           });
  }
};

Everything everything(const Scene2& scene) {
  Everything result;
  const PreparedScene2 prepared = prepare(scene);
  const ExchangeMatrix matrix = exact_exchange(prepared);
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i)) {
      result.factors.push_back(entry.factor.value);
      result.factors.push_back(entry.visibility);
    }
  const RadiositySolution solution = solve_radiosity(matrix, scene.materials, scene.sky_emission);
  for (const ChannelSolution& channel : solution.channels)
    for (const ElementRadiosity& element : channel.elements)
      for (const double value : {element.radiosity, element.lower, element.upper, element.irradiance})
        result.radiosities.push_back(value);
  const ElementTable2 table(scene, prepared.arrangement, prepared.division, Granularity::kFace);
  result.light = illuminate_points(prepared, default_grid(scene, 24), table, sent_out_2(table, solution, scene)).values;
  // Nothing is seen in solids: NaN, which equals nothing.
  std::replace_if(
      result.light.begin(), result.light.end(), [](double value) { return std::isnan(value); }, -1.0);
  return result;
}

Scene2 apartment() { return read_scene_2(std::string(HOTTEL_SOURCE_DIR) + "/scenes/showcase/apartment.json"); }

TEST(FloatingPointEnvironment, OfTheCallerMayRoundInAnyDirection) {
  const Scene2 scene = apartment();
  const Everything nearest = everything(scene);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const Everything other = everything(scene);
    const int left = std::fegetround();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(left, mode);
    EXPECT_TRUE(other == nearest);
  }
}

#ifdef __SSE2__

// A room with a lamp below, and a crack of 1e-310 in a wall across it: what passes is subnormal.
Scene2 room_with_a_hair_crack() {
  Scene2 scene;
  scene.file = "hair";
  scene.materials = {{"lamp", Spectrum::scalar(Rational(1, 2)), Spectrum::scalar(1)},
                     {"wall", Spectrum::scalar(Rational(1, 2)), {}}};
  const auto add = [&scene](const char* name, const Point2& from, const Point2& to, std::uint32_t material) {
    Surface surface;
    surface.name = name;
    surface.material = material;
    if (scene.surfaces.size() >= 4) surface.back = material;
    surface.group = static_cast<std::uint32_t>(scene.groups.size());
    scene.add(surface, {from, to});
    scene.groups.push_back(name);
  };
  add("bottom", {4, 0}, {0, 0}, 0);
  add("left", {0, 0}, {0, 4}, 1);
  add("top", {0, 4}, {4, 4}, 1);
  add("right", {4, 4}, {4, 0}, 1);
  add("west", {0, 2}, {2, 2}, 1);
  add("east", {2 + parse_rational("1e-310").value(), 2}, {4, 2}, 1);
  validate(scene);
  return scene;
}

constexpr unsigned kFlushResults = 0x8000, kFlushArguments = 0x0040;

// While it lives, subnormal numbers are zero on this thread.
class Flushing {
 public:
  explicit Flushing(unsigned flags) : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | flags); }
  ~Flushing() { _mm_setcsr(saved_); }
  Flushing(const Flushing&) = delete;
  Flushing& operator=(const Flushing&) = delete;

 private:
  unsigned saved_;
};

TEST(FloatingPointEnvironment, OfTheCallerMayFlushSubnormalNumbersToZero) {
  for (const Scene2& scene : {room_with_a_hair_crack(), apartment()}) {
    const Everything kept = everything(scene);
    for (const unsigned flags : {kFlushResults, kFlushArguments, kFlushResults | kFlushArguments}) {
      const Flushing flushing(flags);
      const Everything other = everything(scene);
      EXPECT_EQ(_mm_getcsr() & (kFlushResults | kFlushArguments), flags);
      EXPECT_TRUE(other == kept) << scene.file;
    }
  }
  const Everything hair = everything(room_with_a_hair_crack());
  EXPECT_TRUE(std::any_of(hair.factors.begin(), hair.factors.end(),
                          [](double factor) { return std::fpclassify(factor) == FP_SUBNORMAL; }));
}

// Threads that flush work for each other: each waits for its own inner loops and takes ranges of others meanwhile.
TEST(FloatingPointEnvironment, OfWorkersMayFlushSubnormalNumbersToZero) {
  const Scene2 scene = room_with_a_hair_crack();
  const Everything kept = everything(scene);
  std::vector<Everything> others(16);
  const ThreadLimit limit(4);
  parallel_for(others.size(), [&](std::size_t k) {
    const Flushing flushing(kFlushResults | kFlushArguments);
    others[k] = everything(scene);
  });
  for (const Everything& other : others) EXPECT_TRUE(other == kept);
}

#endif

}  // namespace
}  // namespace hottel::floating_point_environment_test
