// Bytes that are put aside on disk.
#include "io/files/spool_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "io/files/output_file.h"
#include "tests/temporary_folder.h"

namespace hottel::spool_file_test {
namespace {

std::string all_of(SpoolFile& spool) {
  std::string bytes;
  spool.read([&](std::string_view part) { bytes += part; });
  return bytes;
}

TEST(SpoolFile, GivesBackWhatWasPutAsideAsOftenAsOneLikes) {
  const TemporaryFolder folder;
  SpoolFile spool(folder.path());
  std::string expected;
  for (int k = 0; k < 40'000; ++k) {
    const std::string number = std::to_string(k) + ",";
    spool.write(number);
    expected += number;
  }
  EXPECT_EQ(spool.size(), expected.size());
  EXPECT_EQ(all_of(spool), expected);
  spool.write("more");
  EXPECT_EQ(all_of(spool), expected + "more");
}

TEST(SpoolFile, HasNoNameInItsFolder) {
  const TemporaryFolder folder;
  SpoolFile spool(folder.path());
  spool.add(3.5);
  EXPECT_EQ(all_of(spool).size(), sizeof(double));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(SpoolFile, RefusesAFolderThatIsNotThere) {
  const TemporaryFolder folder;
  EXPECT_THROW(SpoolFile(folder.path() / "nowhere"), OutputError);
}

}  // namespace
}  // namespace hottel::spool_file_test
