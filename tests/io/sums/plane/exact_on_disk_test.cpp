// A matrix that stands in files: the same as in memory.
#include "io/sums/plane/exact_on_disk.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/generate/generators.h"
#include "solver/plane/simulation/simulation.h"
#include "tests/geometry/plane/exchange_scenes.h"
#include "tests/same_matrix.h"
#include "tests/temporary_folder.h"

namespace hottel::exact_on_disk_test {
namespace {

using testing_scenes::generated;

ExchangeMatrix on_disk(const PreparedScene2& prepared, const std::filesystem::path& folder, ExchangeReport& counts) {
  MethodReport report;
  ExchangeMatrix matrix = ExactOnDisk2({.folder = folder}).compute(prepared, {.memory = 50'000}, report);
  counts = report.counts;
  return matrix;
}

// Property (1).
TEST(ExactOnDisk2, HasTheMatrixOfTheExactMethod) {
  const TemporaryFolder folder;
  const auto expect_same_on_disk = [&](const Scene2& scene) {
    const PreparedScene2 prepared = prepare(scene);
    ExchangeReport whole, counts;
    const ExchangeMatrix expected = exact_exchange(prepared, {}, &whole);
    const ExchangeMatrix matrix = on_disk(prepared, folder / "d", counts);
    ASSERT_NO_FATAL_FAILURE(expect_same(expected, matrix));
    EXPECT_NE(matrix.memory(), nullptr);
    EXPECT_EQ(counts.pairs, whole.pairs);
    EXPECT_TRUE(counts.closure_is_exact);
  };
  for (const GeneratorKind2& kind : generator_kinds_2())
    expect_same_on_disk(generated(kind.name, std::max<std::uint64_t>(kind.min_edges, 200), 5));
  for (std::uint64_t seed = 1; seed <= 40; ++seed) expect_same_on_disk(generated("lattice", 8 + seed % 40, seed));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

// What is solved from it is the same too, also where the solver iterates over entries in files.
TEST(ExactOnDisk2, LeadsToTheSameRadiosities) {
  const TemporaryFolder folder;
  const Scene2 scene = generated("clutter", 1500, 3);
  const auto method = std::make_shared<const ExactOnDisk2>(SumFolderRequest{.folder = folder.path(), .stays = true});
  const auto usual = Simulation2(scene, {.system = {.solver = Solver::kCg}}).radiosities();
  const auto solved = Simulation2(scene, {.method = method, .system = {.solver = Solver::kCg}}).radiosities();
  ASSERT_EQ(solved->channels.size(), usual->channels.size());
  for (std::size_t c = 0; c < usual->channels.size(); ++c)
    for (std::size_t i = 0; i < usual->channels[c].elements.size(); ++i) {
      const ElementRadiosity &a = usual->channels[c].elements[i], &b = solved->channels[c].elements[i];
      ASSERT_TRUE(is_same(a.radiosity, b.radiosity) && is_same(a.lower, b.lower) && is_same(a.upper, b.upper)) << i;
    }
  EXPECT_FALSE(std::filesystem::is_empty(folder.path())) << "sums for a run that goes on";
  EXPECT_GT(method->bytes_of_sums(), 0U);
  method->forget();
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace hottel::exact_on_disk_test
