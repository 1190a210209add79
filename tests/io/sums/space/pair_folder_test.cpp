// Pairs on disk: the rows of pairs in memory, bit for bit.
#include "io/sums/space/pair_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/space/generate/generators.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "tests/geometry/same_rows.h"
#include "tests/temporary_folder.h"

namespace hottel::pair_folder_test {
namespace {

namespace fs = std::filesystem;

std::size_t files_in(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) count += entry.is_regular_file() ? 1 : 0;
  return count;
}

void expect_rows_of_the_matrix(const Scene3& scene, const ExchangeRequest& request) {
  const TemporaryFolder folder;
  const PreparedScene3 prepared = prepare(scene);
  const ExchangeMatrix whole = exact_exchange(prepared, request);
  {
    PairFolder3 pairs(folder.path(), prepared, *prepared.elements(request.granularity), request);
    ExchangeRows3 measured(prepared, request, &pairs);
    // As they come, not all at the end.
    measured.hand_on([&pairs](std::span<const PairSum3> some, const PairRanges&) { pairs.keep(some); },
                     std::chrono::seconds(0));
    measured.add_all();
    EXPECT_GT(pairs.bytes(), 0U);
    EXPECT_GT(files_in(folder.path()), 0U);
    testing_scenes::expect_same_rows(whole, *measured.rows());
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

// (1) and (2)
TEST(PairFolder3, HasTheRowsOfTheMatrixAndLeavesNothing) {
  Scene3 boxes = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/two_boxes.json");
  divide_into(boxes, 2);
  for (const Granularity granularity : {Granularity::kElement, Granularity::kGroup})
    expect_rows_of_the_matrix(boxes, {.granularity = granularity});
  expect_rows_of_the_matrix(generate_3({.kind = "room-touching", .n = 2, .seed = 1}), {.proves = true});
  const Scene3 town = generate_3({.kind = "town", .n = 8, .seed = 1});
  expect_rows_of_the_matrix(town, {.wants_visibility = false, .sky = SkyBy::kClosure});
  expect_rows_of_the_matrix(town, {.rows = RowChoice::of(town, "fronts", Granularity::kFace)});
}

TEST(PairFolder3, NoticesWhatChangedOnItsWay) {
  const TemporaryFolder folder;
  const PreparedScene3 prepared = prepare(generate_3({.kind = "town", .n = 2, .seed = 1}));
  PairFolder3 pairs(folder.path(), prepared, *prepared.elements(Granularity::kFace), {});
  pairs.keep(std::vector<PairSum3>{{.i = 0, .j = 1, .measure = 0.5}, {.i = 0, .j = 2, .measure = 0.25}});
  ASSERT_EQ(pairs.pairs(0).size(), 2U);
  EXPECT_EQ(pairs.pairs(0)[1].measure, 0.25);
  const auto file = fs::recursive_directory_iterator(folder.path());
  fs::path first;
  for (const auto& entry : file)
    if (entry.is_regular_file() && entry.path().filename() == "000.pairs") first = entry.path();
  ASSERT_FALSE(first.empty());
  std::fstream bytes(first, std::ios::in | std::ios::out | std::ios::binary);
  bytes.seekp(20);
  bytes.put('\x55');
  bytes.close();
  EXPECT_THROW(pairs.pairs(0), InputError);
  EXPECT_NO_THROW(pairs.pairs(1));
  fs::resize_file(first, 56);
  EXPECT_THROW(pairs.pairs(0), InputError);
  fs::remove(first);
  EXPECT_THROW(pairs.pairs(0), InputError);
}

}  // namespace
}  // namespace hottel::pair_folder_test
