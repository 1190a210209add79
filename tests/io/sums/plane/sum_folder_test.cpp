// Sums on disk: the rows of sums in memory, bit for bit, and nobody else's sums.
#include "io/sums/plane/sum_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

#include "geometry/plane/exchange/exact_rows.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/generate/generators.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "tests/geometry/plane/exchange_scenes.h"
#include "tests/geometry/same_rows.h"
#include "tests/temporary_folder.h"

namespace hottel::sum_folder_test {
namespace {

namespace fs = std::filesystem;

using testing_scenes::generated;

// A scene with its rows by way of a folder.
class OnDisk {
 public:
  OnDisk(const Scene2& scene, std::uint64_t memory)
      : prepared_(prepare(scene)), table_(prepared_.elements(Granularity::kFace)) {
    request_.memory = memory;
  }

  const PreparedScene2& prepared() const { return prepared_; }
  ExchangeRequest& request() { return request_; }
  SumFolder2 folder(const fs::path& folder, bool stays) {
    report_ = {};
    return SumFolder2({.folder = folder, .stays = stays, .between = std::chrono::milliseconds(1)}, prepared_, *table_,
                      request_, report_);
  }
  void expect_rows_of_the_matrix(const SumFolder2& sums) {
    ExchangeReport of_whole;
    const ExchangeMatrix whole = exact_exchange(prepared_, {}, &of_whole);
    ExactRows2 rows(prepared_, *table_, request_, sums, report_);
    testing_scenes::expect_same_rows(whole, rows);
    EXPECT_EQ(report_.pairs, of_whole.pairs);
    if (of_whole.gaps == 0) return;  // a convex room: no sweep, and other errors on the way to the same numbers
    EXPECT_EQ(report_.tiers, of_whole.tiers);
    EXPECT_EQ(report_.gaps, of_whole.gaps);
    EXPECT_EQ(report_.terms, of_whole.terms);
  }
  void read_all(const SumFolder2& sums) { ExactRows2(prepared_, *table_, request_, sums, report_); }

 private:
  PreparedScene2 prepared_;
  std::shared_ptr<const ElementTable2> table_;
  ExchangeRequest request_;
  ExchangeReport report_;
};

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

TEST(SumFolder2, HasTheRowsOfSumsInMemory) {
  const TemporaryFolder place;
  for (const GeneratorKind2& kind : generator_kinds_2()) {
    OnDisk scene(generated(kind.name, std::max<std::uint64_t>(kind.min_edges, 300), 3), 50'000);
    const SumFolder2 sums = scene.folder(place / "d", false);
    EXPECT_GT(sums.cuts().count(), 1U) << kind.name;
    scene.expect_rows_of_the_matrix(sums);
  }
  EXPECT_TRUE(files_in(place.path()).empty()) << "folder and files are gone";
}

TEST(SumFolder2, HasTheRowsOfSumsInMemoryOnLattices) {
  const TemporaryFolder place;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    OnDisk scene(generated("lattice", 8 + seed % 40, seed), 20'000);
    scene.expect_rows_of_the_matrix(scene.folder(place / std::to_string(seed), seed % 2 == 0));
  }
}

TEST(SumFolder2, HasTheRowsOfSumsInMemoryOfEveryDegenerateScene) {
  const TemporaryFolder place;
  int scenes = 0;
  for (const fs::path& file : files_in(fs::path(HOTTEL_SOURCE_DIR) / "scenes" / "degenerate")) {
    if (file.extension() != ".json") continue;
    try {
      OnDisk scene(read_scene_2(file.string()), 10'000);
      scene.expect_rows_of_the_matrix(scene.folder(place / "d", false));
      ++scenes;
    } catch (const InputError&) {  // refused whoever reads it
    }
  }
  EXPECT_GT(scenes, 40);
}

// A run that is ended again and again, each time somewhere else.
TEST(SumFolder2, GoesOnWhereARunWasEnded) {
  const TemporaryFolder place;
  OnDisk scene(generated("clutter", 3000, 2), 400'000);
  std::mt19937_64 random(1);
  int ended = 0;
  for (bool is_done = false; !is_done;) {
    int left = static_cast<int>(random() % 6) + 1;
    scene.request().progress = [&left](double) {
      if (left-- == 0) throw std::runtime_error("ended");
    };
    try {
      const SumFolder2 sums = scene.folder(place / "d", true);
      is_done = true;
      scene.expect_rows_of_the_matrix(sums);
    } catch (const std::runtime_error&) {
      ++ended;
      ASSERT_LT(ended, 1000);
    }
  }
  EXPECT_GT(ended, 3);
  EXPECT_FALSE(files_in(place / "d").empty()) << "nobody said that they are of no more use";
  scene.request().progress = {};
  fs::remove(files_in(place / "d").front());  // a hole
  SumFolder2 again = scene.folder(place / "d", true);
  scene.expect_rows_of_the_matrix(again);
  again.forget();
}

TEST(SumFolder2, LeavesNothingWhereAnEndedRunIsNotToGoOn) {
  const TemporaryFolder place;
  OnDisk scene(generated("clutter", 1000, 2), 100'000);
  scene.request().progress = [](double done) {
    if (done > 0.5) throw std::runtime_error("ended");
  };
  EXPECT_THROW(scene.folder(place / "d", false), std::runtime_error);
  EXPECT_TRUE(files_in(place.path()).empty());
}

// To machines that share the disk but no locks it looks used for as long as it is read.
TEST(SumFolder2, SaysThatItsFolderIsInUse) {
  const TemporaryFolder place;
  OnDisk scene(generated("clutter", 200, 2), 100'000);
  const SumFolder2 sums = scene.folder(place / "d", false);
  const fs::path own = files_in(place / "d").front();
  ASSERT_TRUE(fs::is_directory(own));
  const auto now = fs::last_write_time(own);
  fs::last_write_time(own, now - std::chrono::hours(30));
  scene.read_all(sums);
  EXPECT_GE(fs::last_write_time(own), now);
}

std::string refusal(const std::function<void()>& work) {
  try {
    work();
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(SumFolder2, RefusesSumsOfOthersByName) {
  const TemporaryFolder place;
  Scene2 first = generated("clutter", 100, 1), second = generated("clutter", 100, 2);
  first.file = "first.json";
  OnDisk(first, 100'000).folder(place / "d", true);
  const std::vector<fs::path> before = files_in(place / "d");
  ASSERT_FALSE(before.empty());
  const std::string text = refusal([&] { OnDisk(second, 100'000).folder(place / "d", true); });
  EXPECT_NE(text.find("holds sums of first.json by hottel "), std::string::npos) << text;
  EXPECT_NE(text.find("remove " + (place / "d").string()), std::string::npos) << text;
  EXPECT_EQ(files_in(place / "d"), before);
}

// Of two runs at once the second would read chunks that the first removes or writes anew.
TEST(SumFolder2, SumsThatStayAreOfOneRunAtATime) {
  const TemporaryFolder place;
  OnDisk scene(generated("clutter", 200, 1), 100'000), other(generated("clutter", 200, 1), 100'000);
  {
    SumFolder2 first = scene.folder(place / "d", true);
    const std::string text = refusal([&] { other.folder(place / "d", true); });
    EXPECT_EQ(text, (place / "d").string() + ": another run keeps its sums there until it ends");
    scene.expect_rows_of_the_matrix(first);
    other.expect_rows_of_the_matrix(other.folder(place / "d", false));  // beside them, in a folder of its own
  }
  EXPECT_EQ(refusal([&] { other.folder(place / "d", true).forget(); }), "");
  EXPECT_TRUE(files_in(place.path()).empty() || files_in(place / "d").empty());
}

TEST(SumFolder2, RefusesDamagedChunks) {
  const TemporaryFolder place;
  OnDisk scene(generated("clutter", 200, 1), 100'000);
  scene.folder(place / "d", true);
  const fs::path file = files_in(place / "d").front();
  const auto size = fs::file_size(file);
  const auto flip = [&](std::uintmax_t at) {
    std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekg(static_cast<std::streamoff>(at));
    const int byte = bytes.get();
    bytes.seekp(static_cast<std::streamoff>(at));
    bytes.put(static_cast<char>(byte ^ 1));
  };
  const auto read = [&] { return refusal([&] { scene.read_all(scene.folder(place / "d", true)); }); };
  EXPECT_EQ(read(), "");
  for (const std::uintmax_t at : {std::uintmax_t{0}, std::uintmax_t{14}, std::uintmax_t{40}, size - 1, size - 40}) {
    flip(at);
    EXPECT_NE(read().find("chunk of sums"), std::string::npos) << at;
    flip(at);
  }
  fs::resize_file(file, size - 1);
  EXPECT_NE(read().find("breaks off"), std::string::npos);
}

TEST(SumFolder2, AsksWhetherTheDiskHasRoom) {
  EXPECT_GE(disk_for_sums_2(1000), 64'000U);
  EXPECT_EQ(ranges_for_sums_2(1000, 1'000'000'000), 1U);
  EXPECT_EQ(ranges_for_sums_2(1'000'000'000, 1), 256U);
}

}  // namespace
}  // namespace hottel::sum_folder_test
