// Light in volumes as files of VTK: what they say of places, and where their numbers are.
#include "io/results/space/volume_file.h"

#include <gmock/gmock.h>

#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace hottel::volume_file_test {
namespace {

using testing::HasSubstr;
using testing::Not;

const Grid3 kAlong{{1, 2, 3}, {2, 0, 0}, {0, 3, 0}, 2, 1, "", Vector3{0, 0, 1}, 4};

std::string written(const Grid3& grid, const std::vector<double>& values) {
  std::string bytes;
  const std::vector<VolumeValues> all{{"mean_irradiance", {"all"}, values}};
  write_volume(grid, all, [&](std::string_view part) { bytes += part; });
  return bytes;
}

// The numbers of the array that begins so far after the underscore.
std::vector<double> numbers_at(const std::string& bytes, std::size_t offset) {
  const std::size_t at = bytes.find("   _") + 4 + offset;
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data() + at, sizeof size);
  std::vector<double> numbers(size / sizeof(double));
  std::memcpy(numbers.data(), bytes.data() + at + sizeof size, size);
  return numbers;
}

TEST(VolumeFile, IsAnImageWhereItsSidesRunAlongTheAxes) {
  const std::vector<double> values{0, 1, 2, 3, 4, std::numeric_limits<double>::quiet_NaN(), 6, 7};
  const std::string bytes = written(kAlong, values);
  EXPECT_EQ(volume_ending(kAlong), ".vti");
  EXPECT_THAT(bytes, HasSubstr("WholeExtent=\"0 2 0 1 0 4\" Origin=\"1 2 3\" Spacing=\"1 3 0.25\""));
  EXPECT_THAT(bytes, HasSubstr("NumberOfComponents=\"1\" ComponentName0=\"all\" format=\"appended\" offset=\"0\""));
  const std::vector<double> found = numbers_at(bytes, 0);
  ASSERT_EQ(found.size(), values.size());
  EXPECT_EQ(std::memcmp(found.data(), values.data(), sizeof(double) * values.size()), 0);
}

TEST(VolumeFile, HasItsCornersWhereTheyDoNot) {
  Grid3 grid = kAlong;
  grid.v = {0, 3, 1};
  const std::string bytes = written(grid, std::vector<double>(8));
  EXPECT_EQ(volume_ending(grid), ".vts");
  EXPECT_THAT(bytes, HasSubstr("<StructuredGrid WholeExtent=\"0 2 0 1 0 4\">"));
  const std::vector<double> corners = numbers_at(bytes, 0);
  ASSERT_EQ(corners.size(), 3U * 3 * 2 * 5);
  EXPECT_THAT(std::vector(corners.begin(), corners.begin() + 6), testing::ElementsAre(1, 2, 3, 2, 2, 3));
  EXPECT_THAT(std::vector(corners.end() - 3, corners.end()), testing::ElementsAre(3, 5, 5));
  EXPECT_EQ(numbers_at(bytes, 8 + 8 * corners.size()).size(), 8U);
}

TEST(VolumeFile, IsNoImageWhereASideRunsDownwards) {
  Grid3 grid = kAlong;
  grid.w = Vector3{0, 0, -1};
  EXPECT_EQ(volume_ending(grid), ".vts");
  EXPECT_THAT(written(grid, std::vector<double>(8)), Not(HasSubstr("ImageData")));
}

}  // namespace
}  // namespace hottel::volume_file_test
