// The exact method in other arithmetic.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>

#include "geometry/plane/generate/generators.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/view.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/plane/methods/arithmetic_naive.h"
#include "solver/plane/methods/method_catalogue.h"

namespace hottel::methods_arithmetic_test {
namespace {

PreparedScene2 clutter(std::uint64_t edges, int digits = 0) {
  GeneratorRequest2 request;
  request.kind = "clutter";
  request.n = edges;
  request.seed = 3;
  request.digits = digits;
  return prepare(generate_2(request), Divided2::kYes);
}

std::vector<std::filesystem::path> scenes_in(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(HOTTEL_SOURCE_DIR "/scenes/" + folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

double max_error(const ExchangeMatrix& matrix, const ExchangeMatrix& exact) {
  double error = 0;
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    for (const FactorEntry& entry : exact.row(i))
      error = std::max(error, std::fabs(matrix.factor(i, entry.to).value - entry.factor.value));
    for (const FactorEntry& entry : matrix.row(i))
      error = std::max(error, std::fabs(exact.factor(i, entry.to).value - entry.factor.value));
  }
  return error;
}

struct Outcome {
  ExchangeMatrix matrix;
  MethodReport report;
};
Outcome run(const std::string& name, const PreparedScene2& prepared) {
  Outcome result;
  result.matrix = methods_2().make(name)->compute(prepared, {.granularity = Granularity::kElement}, result.report);
  return result;
}

void expect_same(const ExchangeMatrix& a, const ExchangeMatrix& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a.row(i).size(), b.row(i).size());
    for (std::size_t k = 0; k < a.row(i).size(); ++k) {
      EXPECT_EQ(a.row(i)[k].to, b.row(i)[k].to);
      EXPECT_EQ(a.row(i)[k].factor, b.row(i)[k].factor);
    }
  }
}

TEST(Arithmetic2, RoundedIsTheExactMethod) {
  const PreparedScene2 prepared = clutter(100);
  expect_same(run("arithmetic:rounded", prepared).matrix, run("exact", prepared).matrix);
}

TEST(Arithmetic2, GivesTheSameForAnyNumberOfThreads) {
  const PreparedScene2 prepared = clutter(400);
  for (const char* name : {"arithmetic:naive", "arithmetic:doubles", "arithmetic:bounds", "arithmetic:cgal"}) {
    const ThreadLimit one(1);
    const ExchangeMatrix alone = run(name, prepared).matrix;
    const ThreadLimit four(4);
    expect_same(alone, run(name, prepared).matrix);
  }
}

TEST(Arithmetic2, StaysWithinItsDeclaredErrorOnEveryAnalyticAndDegenerateScene) {
  int declared = 0;
  for (const char* folder : {"analytic", "degenerate"})
    for (const auto& file : scenes_in(folder)) {
      const PreparedScene2 prepared = prepare(read_scene_2(file), Divided2::kYes);
      const ExchangeMatrix exact = run("exact", prepared).matrix;
      for (const char* name : {"arithmetic:doubles", "arithmetic:bounds", "arithmetic:rounded"}) {
        const auto error = methods_2().make(name)->declared_error(prepared);
        if (!error) continue;
        ++declared;
        EXPECT_LE(max_error(run(name, prepared).matrix, exact), *error) << file << ' ' << name;
      }
    }
  EXPECT_GT(declared, 180);
}

TEST(Arithmetic2, EnclosesEveryFactorByBounds) {
  for (const char* folder : {"analytic", "degenerate"})
    for (const auto& file : scenes_in(folder)) {
      const PreparedScene2 prepared = prepare(read_scene_2(file), Divided2::kYes);
      const ExchangeMatrix exact = run("exact", prepared).matrix, enclosed = run("arithmetic:bounds", prepared).matrix;
      EXPECT_EQ(enclosed.guarantee(), Guarantee::kEnclosed);
      for (std::uint32_t i = 0; i < enclosed.size(); ++i)
        for (std::size_t k = 0; k < enclosed.row(i).size(); ++k) {
          const Enclosure bounds = enclosed.bounds(i, k);
          const Enclosure real = exact.factor(i, enclosed.row(i)[k].to).enclosure();
          EXPECT_LE(bounds.lower, real.upper) << file;
          EXPECT_GE(bounds.upper, real.lower) << file;
        }
    }
  const PreparedScene2 prepared = clutter(100);
  const ExchangeMatrix enclosed = run("arithmetic:bounds", prepared).matrix;
  for (std::uint32_t i = 0; i < enclosed.size(); ++i)
    for (std::size_t k = 0; k < enclosed.row(i).size(); ++k) EXPECT_LT(enclosed.bounds(i, k).width(), 1e-13);
}

TEST(Arithmetic2, AgreesWhereNothingIsDegenerate) {
  const PreparedScene2 prepared = clutter(200);
  const ExchangeMatrix exact = run("exact", prepared).matrix;
  EXPECT_LT(max_error(run("arithmetic:bounds", prepared).matrix, exact), 0x1p-51);
  for (const char* name : {"arithmetic:naive", "arithmetic:doubles", "arithmetic:cgal"})
    EXPECT_LT(max_error(run(name, prepared).matrix, exact), 1e-12) << name;
}

TEST(Arithmetic2, NaiveSignsAreCountedAndMostlyRightInGeneralPosition) {
  const PreparedScene2 prepared = clutter(50);
  const WrongOrientations2 counts =
      count_wrong_orientations(prepared.arrangement, NaivePoints2(prepared.arrangement.vertices()));
  EXPECT_GT(counts.asked, 10'000u);
  EXPECT_LT(counts.wrong, counts.asked / 100);
}

// Points of a line with coordinates that are no doubles: naive signs see them turn left and right.
TEST(Arithmetic2, NaiveSignsAreWrongOnALineOfDecimals) {
  Scene2 scene;
  scene.file = "line";
  scene.materials.push_back({"white", Spectrum::scalar(Rational(1, 2)), {}});
  for (int k = 0; k < 8; ++k) {
    Surface surface;
    surface.name = fmt::format("piece {}", k);
    const auto at = [](int tenth) {
      Point2 p{Rational(tenth, 10), Rational(3 * tenth, 10)};
      p.x.canonicalize();
      p.y.canonicalize();
      return p;
    };
    surface.group = static_cast<std::uint32_t>(k);
    scene.groups.push_back(surface.name);
    scene.add(surface, {at(2 * k + 1), at(2 * k + 2)});
  }
  scene.add(scene.surfaces.front(), {{5, 0}, {0, -5}});
  scene.surfaces.back().name = "wall";
  scene.surfaces.back().group = 8;
  scene.groups.push_back("wall");
  const PreparedScene2 prepared = prepare(scene);
  const WrongOrientations2 counts =
      count_wrong_orientations(prepared.arrangement, NaivePoints2(prepared.arrangement.vertices()));
  EXPECT_GT(counts.wrong, 0u);
  EXPECT_THAT(
      run("arithmetic:naive", prepared).report.notes,
      ::testing::Contains(fmt::format("of {} orientations {} have the wrong sign", counts.asked, counts.wrong)));
}

// Whatever the signs say, every sweep ends and every factor is a number.
TEST(Arithmetic2, EndsOnEveryDegenerateScene) {
  std::uint64_t wrong = 0, wrong_scenes = 0, scenes = 0;
  for (const auto& file : scenes_in("degenerate")) {
    const PreparedScene2 prepared = prepare(read_scene_2(file), Divided2::kYes);
    for (const char* name : {"arithmetic:naive", "arithmetic:doubles", "arithmetic:bounds", "arithmetic:cgal"}) {
      const Outcome result = run(name, prepared);
      for (std::uint32_t i = 0; i < result.matrix.size(); ++i)
        for (const FactorEntry& entry : result.matrix.row(i))
          EXPECT_TRUE(std::isfinite(entry.factor.value)) << file << ' ' << name;
    }
    const WrongOrientations2 counts =
        count_wrong_orientations(prepared.arrangement, NaivePoints2(prepared.arrangement.vertices()));
    wrong += counts.wrong;
    wrong_scenes += counts.wrong > 0;
    ++scenes;
  }
  RecordProperty("wrong_orientations", static_cast<int>(wrong));
  EXPECT_GT(scenes, 30u);
  EXPECT_GT(wrong_scenes, 3u);
}

// Orientations that contradict each other as much as they can, always in the same way: some sweeps go in circles, and
// are stopped.
TEST(Arithmetic2, EndsWhenSignsAreArbitrary) {
  class ArbitrarySigns {
   public:
    explicit ArbitrarySigns(std::uint64_t seed) : seed_(seed) {}
    int orientation(VertexId i, VertexId j, VertexId k) const {
      std::uint64_t hash = seed_;
      for (const VertexId v : {i, j, k}) hash = (hash ^ v.index()) * 0x9e3779b97f4a7c15ull, hash ^= hash >> 29;
      return static_cast<int>(hash % 3) - 1;
    }

   private:
    std::uint64_t seed_;
  };
  const PreparedScene2 prepared = clutter(100);
  std::atomic<std::uint64_t> cut_off = 0;
  View2 view;
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    for (const VertexId v : prepared.arrangement.vertices().ids()) {
      const ArbitrarySigns signs(seed);
      const StepLimit2 limited(signs, 10'000, cut_off);
      look_around(limited, prepared.arrangement.triangulation(), v, view);
      EXPECT_GE(view.seen.size(), prepared.arrangement.triangulation().star(v).size());
    }
  EXPECT_GT(cut_off.load(), 0u);
}

TEST(Arithmetic2, RefusesAVariantThatIsNotThere) {
  EXPECT_THROW(methods_2().make("arithmetic"), UsageError);
  EXPECT_THROW(methods_2().make("arithmetic:quad"), UsageError);
}

}  // namespace
}  // namespace hottel::methods_arithmetic_test
