// Rows of the scenes of this repository, the sky integrated, sum to 1 within the errors that their entries state. All
// of them, with the slow ones: report_row_closure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/exchange_rows.h"
#include "io/scene/scene_json.h"

namespace hottel::row_sums_test {
namespace {

// Scenes in space, in some folders of scenes/, that take less than a second or two.
std::vector<std::filesystem::path> scenes() {
  const std::filesystem::path root(HOTTEL_SOURCE_DIR "/scenes");
  const std::set<std::string> are_slow{"cornell_box.json", "room_axis.json", "room_turned.json",
                                       "room_six_digits.json"};
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"analytic/space", "degenerate/space", "space", "lights"})
    for (const auto& entry : std::filesystem::directory_iterator(root / folder))
      if (entry.path().extension() == ".json" && !are_slow.contains(entry.path().filename().string()))
        files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

TEST(RowSums, AreOneWithinTheErrorsThatEntriesState) {
  std::size_t open_rows = 0, all = 0;
  for (const std::filesystem::path& file : scenes()) {
    const ValidScene scene = read_scene(file);
    if (!std::holds_alternative<ValidScene3>(scene)) continue;
    ++all;
    const PreparedScene3 prepared = prepare(std::get<ValidScene3>(scene));
    ExchangeRows3 rows(prepared, {.wants_visibility = false});
    rows.add_all();
    const ElementTable3& table = rows.table();
    std::vector<long double> sums(table.count(), 0), errors(table.count(), 0);
    for (const PairSum3& pair : rows.pairs()) {
      sums[pair.i] += pair.measure;
      errors[pair.i] += pair.error;
      open_rows += pair.j == table.sky() && !pair.is_zero() ? 1 : 0;
      if (pair.j == table.sky() || pair.j == pair.i) continue;
      sums[pair.j] += pair.measure;
      errors[pair.j] += pair.error;
    }
    for (std::uint32_t i = 0; i < table.count(); ++i) {
      if (!table.has_row(i)) continue;
      const long double area = table.extent(i).value;
      EXPECT_LE(std::fabs(sums[i] - area), errors[i] + 0x1p-52L * area) << file << ' ' << table.elements()[i].name;
    }
  }
  EXPECT_GT(all, 45u);
  EXPECT_GT(open_rows, 100u);
}

// The sides of a hat that are seen from within from one end of an edge are seen from outside from the other one, while
// its rim stays convex.
TEST(RowSums, OfAHatThatIsSeenFromWithinAndFromOutside) {
  const ValidScene scene = read_scene(HOTTEL_SOURCE_DIR "/scenes/space/hat_in_a_box.json");
  const ExchangeMatrix matrix = exact_exchange(prepare(std::get<ValidScene3>(scene)));  // every pair can be measured
  for (const char* name : {"floor", "top", "mat"}) {
    double sum = 0;
    for (const FactorEntry& entry : matrix.row(*matrix.find(name))) sum += entry.factor.value;
    EXPECT_NEAR(sum, 1, 1e-12) << name;
  }
}

// Where faces meet, their pieces have corners that are ratios of integers of hundreds of digits. In doubles of a common
// size all other points would be zero.
TEST(RowSums, OfBoxesThatAreNearlyOneAddUpToOne) {
  const ValidScene scene = read_scene(HOTTEL_SOURCE_DIR "/tests/geometry/space/boxes_nearly_one.json");
  const ExchangeMatrix matrix = exact_exchange(prepare(std::get<ValidScene3>(scene)));  // every pair can be measured
  for (std::uint32_t row = 0; row < matrix.size(); ++row) {
    double sum = 0;
    for (const FactorEntry& entry : matrix.row(row)) sum += entry.factor.value;
    if (matrix.row(row).empty()) continue;  // backs without a material
    EXPECT_NEAR(sum, 1, 1e-10) << matrix.name(row);
  }
}

}  // namespace
}  // namespace hottel::row_sums_test
