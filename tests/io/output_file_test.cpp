#include "io/files/output_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "io/files/text_file.h"
#include "kernel/support/interrupt.h"
#include "tests/temporary_folder.h"

namespace hottel::output_file_test {
namespace {

namespace fs = std::filesystem;

// A directory of its own for each test.
class OutputFileTest : public ::testing::Test {
 protected:
  fs::path file(const std::string& name) const { return directory_ / name; }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory_.path()), fs::directory_iterator()));
  }
  static std::string why(const fs::path& path, std::string_view bytes = "new") {
    try {
      write_output_file(path, bytes);
    } catch (const OutputError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder directory_;
};

TEST_F(OutputFileTest, LeavesTheEarlierFileUntilItIsCommitted) {
  write_output_file(file("a.csv"), "old");
  OutputFile output(file("a.csv"));
  output.write("new");
  output.finish();
  EXPECT_EQ(read_text_file(file("a.csv")), "old");
  output.commit();
  EXPECT_EQ(read_text_file(file("a.csv")), "new");
  EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFileTest, LeavesNothingBehindWithoutCommit) {
  {
    OutputFile output(file("a.csv"));
    output.write("new");
    EXPECT_EQ(files(), 1u);
  }
  EXPECT_EQ(files(), 0u);
}

TEST_F(OutputFileTest, LeavesNothingBehindWhenASignalEndsTheProgram) {
  OutputFile output(file("a.csv"));
  output.write("new");
  remove_pending();
  EXPECT_EQ(files(), 0u);
}

TEST_F(OutputFileTest, WritesMoreThanItsBuffer) {
  const std::string text(1'000'003, 'x');
  OutputFile output(file("a.csv"));
  output.write(text);
  output.write("y");
  output.commit();
  EXPECT_EQ(read_text_file(file("a.csv")), text + "y");
}

TEST_F(OutputFileTest, KeepsTheOrderOfPiecesOfAnySize) {
  // More than the disk is told of at once (8 MiB), in pieces smaller and larger than the buffer (64 KiB).
  std::string text;
  OutputFile output(file("a.csv"));
  for (std::size_t k = 0, size = 1; text.size() < 30'000'000; ++k, size = size * 5 % 300'007) {
    const std::string piece(size, static_cast<char>('a' + k % 26));
    text += piece;
    output.write(piece);
  }
  OutputFile moved(std::move(output));
  moved.write("end");
  moved.commit();
  EXPECT_TRUE(read_text_file(file("a.csv")) == text + "end");
}

TEST_F(OutputFileTest, ReplacesNothingAfterAnInterrupt) {
  write_output_file(file("a.csv"), "old");
  OutputFile output(file("a.csv"));
  output.write("new");
  request_interrupt();
  EXPECT_THROW(output.commit(), Interrupted);
  interrupt_flag = false;
  EXPECT_EQ(read_text_file(file("a.csv")), "old");
}

TEST_F(OutputFileTest, KeepsPermissionsAndSymbolicLinks) {
  write_output_file(file("a.csv"), "old");
  ::chmod(file("a.csv").c_str(), 0640);
  fs::create_symlink("a.csv", file("link.csv"));
  write_output_file(file("link.csv"), "new");
  EXPECT_TRUE(fs::is_symlink(file("link.csv")));
  EXPECT_EQ(read_text_file(file("a.csv")), "new");
  EXPECT_EQ(fs::status(file("a.csv")).permissions(), fs::perms(0640));
}

TEST_F(OutputFileTest, RefusesPathsThatCannotBeWritten) {
  write_output_file(file("a.csv"), "old");
  EXPECT_EQ(why(directory_.path()), directory_.path().string() + ": is a directory, not a file");
  EXPECT_EQ(why(file("a.csv") / "b.csv"), (file("a.csv") / "b.csv").string() + ": cannot be written: Not a directory");
  EXPECT_EQ(why(file("no") / "b.csv"), (file("no") / "b.csv").string() +
                                           ": cannot be written: there is no directory '" + file("no").string() + "'");
  EXPECT_EQ(why(file(std::string(300, 'n'))),
            file(std::string(300, 'n')).string() + ": cannot be written: File name too long");
  EXPECT_EQ(why("/proc/a.csv"), "/proc/a.csv: cannot be written: '/proc' takes no new files");
  EXPECT_EQ(why(""), "'': is no name of a file");
  EXPECT_EQ(why(file("a.csv/")), file("a.csv/").string() + ": cannot be written: Not a directory");
  EXPECT_EQ(why(file("new/")), file("new/").string() + ": is a directory, not a file");
  EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFileTest, RefusesAFileWithoutWritePermission) {
  if (::geteuid() == 0) {
    // Nothing is read-only for root; what is left to check is that the permissions survive.
    write_output_file(file("a.csv"), "old");
    ::chmod(file("a.csv").c_str(), 0444);
    write_output_file(file("a.csv"), "new");
    EXPECT_EQ(fs::status(file("a.csv")).permissions(), fs::perms(0444));
    return;
  }
  write_output_file(file("a.csv"), "old");
  ::chmod(file("a.csv").c_str(), 0444);
  EXPECT_EQ(why(file("a.csv")), file("a.csv").string() + ": cannot be written: Permission denied");
}

TEST_F(OutputFileTest, ReportsADeviceThatIsFull) {
  fs::create_symlink("/dev/full", file("full.csv"));
  EXPECT_EQ(why(file("full.csv")), file("full.csv").string() + ": cannot be written: No space left on device");
  EXPECT_EQ(why("/dev/full"), "/dev/full: cannot be written: No space left on device");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(OutputFileTest, WritesDevicesDirectly) {
  EXPECT_EQ(why("/dev/null"), "");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(OutputFileTest, KeepsTheEarlierFileWhenTheDiskIsFull) {
  write_output_file(file("a.csv"), "old");
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{100'000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = why(file("a.csv"), std::string(200'000, 'x'));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_DFL);
  EXPECT_EQ(message, file("a.csv").string() + ": cannot be written: File too large");
  EXPECT_EQ(read_text_file(file("a.csv")), "old");
  EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace hottel::output_file_test
