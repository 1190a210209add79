
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include "io/files/output_file.h"
#include "tests/temporary_folder.h"

namespace hottel::output_folder_test {
namespace {

namespace fs = std::filesystem;

class OutputFolderTest : public ::testing::Test {
 protected:
  TemporaryFolder root_;
};

TEST_F(OutputFolderTest, IsThereWhileItLivesAndAfterwardsOnlyWithSomethingInIt) {
  for (const std::string name : {"a", "a/b/c", "a/b/c/"}) {
    {
      const OutputFolder folder(root_ / name);
      EXPECT_TRUE(fs::is_directory(root_ / name));
    }
    EXPECT_TRUE(fs::is_empty(root_.path())) << name;
  }
  {
    const OutputFolder folder(root_ / "a/b/c");
    write_output_file(root_ / "a/b/file", "new");
  }
  EXPECT_TRUE(fs::exists(root_ / "a/b/file"));
  EXPECT_FALSE(fs::exists(root_ / "a/b/c"));
}

TEST_F(OutputFolderTest, AFolderThatWasThereStays) {
  fs::create_directory(root_ / "a");
  { const OutputFolder folder(root_ / "a"); }
  EXPECT_TRUE(fs::exists(root_ / "a"));
  { const OutputFolder folder(root_ / "a/b"); }
  EXPECT_TRUE(fs::exists(root_ / "a"));
  EXPECT_FALSE(fs::exists(root_ / "a/b"));
}

TEST_F(OutputFolderTest, AFileInTheWayIsAnError) {
  write_output_file(root_ / "a", "a file");
  EXPECT_THROW(OutputFolder(root_ / "a"), OutputError);
  EXPECT_THROW(OutputFolder(root_ / "a/b/c"), OutputError);
  EXPECT_THROW(OutputFolder(""), OutputError);
  EXPECT_TRUE(fs::is_regular_file(root_ / "a"));
}

TEST_F(OutputFolderTest, WhatCannotBeMadeIsTold) {
  const auto why = [](const fs::path& folder) -> std::string {
    try {
      const OutputFolder made(folder);
    } catch (const OutputError& error) {
      return error.what();
    }
    return "made";
  };
  EXPECT_EQ(why("/proc/x/y"), "/proc/x: this folder cannot be made: '/proc' takes no new folders");
  write_output_file(root_ / "a", "a file");
  EXPECT_EQ(why(root_ / "a/b"), (root_ / "a/b").string() + ": this folder cannot be made: '" + (root_ / "a").string() +
                                    "' is a file, not a folder");
  const std::string name(300, 'n');
  EXPECT_EQ(why(root_ / name), (root_ / name).string() + ": this folder cannot be made: File name too long");
}

TEST_F(OutputFolderTest, IsRemovedWhereASignalEndsTheProgram) {
  fs::create_directory(root_ / "before");
  const OutputFolder folder(root_ / "a/b/c"), other(root_ / "before");
  OutputFile file(root_ / "a/b/c/file");
  file.write("half");
  remove_pending();
  EXPECT_FALSE(fs::exists(root_ / "a"));
  EXPECT_TRUE(fs::exists(root_ / "before"));
}

TEST_F(OutputFolderTest, APendingFolderGoesWithAllThatIsInIt) {
  fs::create_directories(root_ / "scratch/deep/deeper");
  fs::create_directories(root_ / "kept");
  for (int k = 0; k < 1000; ++k)
    std::ofstream(root_ / "scratch" / ("a_file_of_an_external_program_" + std::to_string(k)));
  std::ofstream(root_ / "scratch/deep/deeper/file") << "x";
  std::ofstream(root_ / "kept/file") << "x";
  fs::create_directory_symlink(root_ / "kept", root_ / "scratch/link");
  std::optional<PendingRemoval> pending(std::in_place, (root_ / "scratch").string(), Removal::kFolder);
  PendingRemoval moved = std::move(*pending);
  pending.reset();
  { const PendingRemoval over((root_ / "kept").string(), Removal::kFolder); }
  remove_pending();
  EXPECT_FALSE(fs::exists(root_ / "scratch"));
  EXPECT_TRUE(fs::exists(root_ / "kept/file"));
}

}  // namespace
}  // namespace hottel::output_folder_test
