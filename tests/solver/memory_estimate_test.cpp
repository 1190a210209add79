// What a simulation is said to take of memory, and what it takes.
#include "solver/memory_estimate.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "benchmarks/peak_memory.h"
#include "geometry/plane/generate/generators.h"
#include "geometry/plane/scene/division.h"
#include "geometry/space/exchange/exchange_memory.h"
#include "geometry/space/generate/generators.h"
#include "geometry/space/pairs/pair_integrator.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/plane/scene_memory.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/scene_memory.h"
#include "solver/space/simulation/simulation.h"
#include "tests/sanitizers.h"

namespace hottel::memory_estimate_test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::string shown(const std::string& file) { return std::string(HOTTEL_SOURCE_DIR) + "/scenes/" + file; }

const std::vector<CountedFace> kSixSides = [] {
  std::vector<CountedFace> faces;
  for (std::uint32_t s = 0; s < 6; ++s) {
    faces.push_back({s, false, 100, true});
    faces.push_back({s, true, 1, false});
  }
  return faces;
}();
constexpr TableBytes kBytes{1000, 300, 100};
constexpr double kPairs = 15 * 100.0 * 100 + 6 * 600;

TEST(MemoryEstimate, AddsWhatIsThereAtOneTime) {
  const MemoryEstimate all(kSixSides, {.solves = true}, kBytes, 0, {});
  ASSERT_EQ(all.stages().size(), 3u);
  EXPECT_EQ(all.stages()[0].count, 606 - 12.0);
  EXPECT_EQ(all.stages()[1].count, kPairs);
  EXPECT_EQ(all.of_factors(), 594 * 1000 + kPairs * 300);
  EXPECT_EQ(all.stages()[2].name, "radiosity");
  EXPECT_EQ(all.peak(), all.of_factors()) << "the matrix and the system take less";
  const MemoryEstimate lit(kSixSides, {.cells = 100'000'000}, kBytes, 0, {});
  EXPECT_EQ(lit.peak(), 594 * 1000 + kPairs * 100 + lit.stages()[2].bytes);
}

TEST(MemoryEstimate, DrawsPairsOnlyWhereAllMayBeTooMany) {
  int asked = 0;
  const PairSampling tenth = [&](std::span<const CountedFace>) {
    ++asked;
    return SampledPairs{kPairs / 10, true};
  };
  EXPECT_EQ(MemoryEstimate(kSixSides, {}, kBytes, 1e9, tenth).stages()[1].unit, "pairs at the most");
  EXPECT_EQ(asked, 0);
  const MemoryEstimate drawn(kSixSides, {}, kBytes, 1e6, tenth);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(drawn.stages()[1].count, kPairs / 10);
}

// Nothing is refused for what is not known.
TEST(MemoryEstimate, HoldsNothingAgainstPairsThatWereNotFound) {
  const PairSampling none = [](std::span<const CountedFace>) { return SampledPairs{kPairs / 2, false}; };
  const MemoryEstimate estimate(kSixSides, {}, kBytes, 1e6, none);
  EXPECT_EQ(estimate.of_factors(), 594 * 1000.0);
  EXPECT_EQ(memory_problem(estimate, {1'000'000, 1'000'000}), "");
  EXPECT_THAT(memory_problem(estimate, {500'000, 500'000}),
              EndsWith("need about 594 kB of memory; the limit is 500 kB (500000 bytes). Take fewer elements, or a "
                       "larger element size"));
}

TEST(MemoryEstimate, CountsWhatIsDividedFurther) {
  const MemoryEstimate deep(kSixSides, {.parts = 1e30}, kBytes, 1e10, [](std::span<const CountedFace> faces) {
    return SampledPairs{1e40 * static_cast<double>(faces.size()), true};
  });
  EXPECT_GT(deep.of_factors(), 1e20);
  EXPECT_THAT(memory_problem(deep, {1'000, 1'000'000}),
              HasSubstr("the limit is 1.0 kB (1000 bytes). Allow more (--memory), take fewer elements"));
}

template <class AnyScene>
std::string refusal_of(const AnyScene& scene, std::uint64_t memory) {
  try {
    require_memory(scene, {}, memory);
  } catch (const RequestError& error) {
    return error.what();
  }
  return "";
}

TEST(RequireMemory, RefusesByNameWhatNoMachineHolds) {
  Scene3 boxes = read_scene_3(shown("space/two_boxes.json"));
  EXPECT_EQ(refusal_of(boxes, 1000), "") << "undivided: that is the scene's own";
  divide_into(boxes, 1000);
  EXPECT_THAT(refusal_of(boxes, 0), StartsWith(boxes.file + ": about 1.8e+07 elements"));
  EXPECT_THROW(Simulation3(boxes, {.factors = {.granularity = Granularity::kElement}}).factors(), RequestError);
  EXPECT_NO_THROW(Simulation3(boxes, {.factors = {.granularity = Granularity::kFace, .tolerance = 1e-6}}).factors());
  Scene2 apartment = read_scene_2(shown("showcase/apartment.json"));
  divide_into(apartment, 1000);
  EXPECT_THAT(refusal_of(apartment, 0), HasSubstr("visible pairs need about"));
  EXPECT_THROW(Simulation2(apartment).factors(), RequestError);
  EXPECT_NO_THROW(Simulation2(apartment, {.granularity = Granularity::kFace}).factors());
}

// The resident set grows by no more than was said and, where pairs are known, not by far less: of scenes that take some
// ten megabytes and more. What the allocator keeps and stacks of threads take is beside it.
constexpr double kLess = 5, kMore = 1.3, kBeside = 3e7;

template <class AnySimulation, class AnyScene, class Request>
void expect_as_said(AnyScene scene, const Request& request) {
  if (kHasAddressSanitizer || kHasThreadSanitizer) GTEST_SKIP() << "memory is that of the sanitizer";
  const MemoryEstimate estimate = estimate_memory(scene, {.solves = true});
  const std::string about = scene.file + scene.about;
  const AnySimulation simulation(std::move(scene), request);
  const benchmarks::PeakMemory memory;
  simulation.radiosities();
  const double growth = memory.growth();
  EXPECT_LT(growth, kMore * estimate.peak() + kBeside) << about;
  const bool are_known = estimate.stages()[1].unit == "visible pairs";
  EXPECT_GT(growth + kBeside, are_known ? estimate.peak() / kLess : 0) << about;
  testing::Test::RecordProperty(about, fmt::format("{:.3g} of {:.3g}", growth, estimate.peak()));
}

Scene2 divided_2(Scene2 scene, std::uint32_t n) {
  divide_into(scene, n);
  return scene;
}
Scene3 divided_3(Scene3 scene, std::uint32_t n) {
  divide_into(scene, n);
  return scene;
}

TEST(MemoryEstimate, IsWhatTheResidentSetGrowsByInThePlane) {
  const SimulationRequest2 request;
  expect_as_said<Simulation2>(divided_2(read_scene_2(shown("showcase/apartment.json")), 16), request);
  expect_as_said<Simulation2>(divided_2(read_scene_2(shown("analytic/square_radiosity.json")), 300), request);
  expect_as_said<Simulation2>(generate_2({.kind = "clutter", .n = 8000, .seed = 2}), request);
}

TEST(MemoryEstimate, IsWhatTheResidentSetGrowsByInSpace) {
  const SimulationRequest3 request{.factors = {.granularity = Granularity::kElement, .tolerance = 1e-4}};
  expect_as_said<Simulation3>(divided_3(read_scene_3(shown("space/cube.json")), 10), request);
  expect_as_said<Simulation3>(divided_3(read_scene_3(shown("space/two_boxes.json")), 5), request);
}

// Two walls among triangles that pierce each other: thousands of pieces with dozens of arcs each, a hundred megabytes
// if they were all kept.
TEST(BytesPerThread, HoldWhereTrianglesPierceEachOther) {
  if (kHasAddressSanitizer || kHasThreadSanitizer) GTEST_SKIP() << "memory is that of the sanitizer";
  const PreparedScene3 prepared = prepare(generate_3({.kind = "triangle-soup", .n = 40, .seed = 1}));
  const ElementTable3& table = *prepared.elements(Granularity::kFace);
  const Patch3 &floor = table.parts()[6].patch, &wall = table.parts()[8].patch;
  const benchmarks::PeakMemory memory;
  EXPECT_GT(prepared.measurer().measure(floor, wall).pieces, 5000u);
  constexpr double kOfAllocator = 1e7;
  EXPECT_LT(memory.growth(), static_cast<double>(kBytesPerThread3) + kOfAllocator);
  RecordProperty("bytes", fmt::format("{:.3g}", memory.growth()));
}

}  // namespace
}  // namespace hottel::memory_estimate_test
