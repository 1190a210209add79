// What becomes of a file while a window looks at it.
#include "viewer/window/watched_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/temporary_folder.h"

namespace hottel::watched_file_test {
namespace {

namespace fs = std::filesystem;

class WatchedFileTest : public testing::Test {
 protected:
  WatchedFileTest() : file(folder / "scene.json") {
    write("one");
    file.note();
  }
  void write(const std::string& text) const { std::ofstream(folder / "scene.json") << text; }

  TemporaryFolder folder;
  WatchedFile file;
};

TEST_F(WatchedFileTest, TellsThatItIsGoneAndBackOnceEach) {
  fs::rename(file.path(), folder / "other.json");
  EXPECT_EQ(file.news(), FileNews::kGone);
  EXPECT_TRUE(file.is_gone());
  EXPECT_EQ(file.news(), FileNews::kNone);
  EXPECT_TRUE(file.is_gone());
  fs::rename(folder / "other.json", file.path());  // the very same
  EXPECT_EQ(file.news(), FileNews::kBack);
  EXPECT_FALSE(file.is_gone());
  EXPECT_EQ(file.news(), FileNews::kNone);
}

TEST_F(WatchedFileTest, AFolderInItsPlaceCannotBeRead) {
  fs::remove(file.path());
  fs::create_directory(file.path());
  EXPECT_EQ(file.news(), FileNews::kGone);
  fs::remove(file.path());
  EXPECT_EQ(file.news(), FileNews::kNone);
  write("another one");
  EXPECT_EQ(file.news(), FileNews::kBack);
}

TEST_F(WatchedFileTest, WhatOneWritesOneselfIsNoNews) {
  fs::remove(file.path());
  EXPECT_EQ(file.news(), FileNews::kGone);
  write("written again");
  file.note();
  EXPECT_FALSE(file.is_gone());
  EXPECT_EQ(file.news(), FileNews::kNone);
  write("by someone else");
  EXPECT_EQ(file.news(), FileNews::kChanged);
}

}  // namespace
}  // namespace hottel::watched_file_test
