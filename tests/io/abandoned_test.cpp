// What killed runs leave behind, and what a later one removes of it.
#include "io/files/abandoned.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "io/external/external_command.h"
#include "io/files/output_file.h"
#include "tests/temporary_folder.h"

namespace hottel::abandoned::abandoned_test {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

class AbandonedFiles : public testing::Test {
 protected:
  std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& entry : fs::directory_iterator(folder_.path())) result.insert(entry.path().filename().string());
    return result;
  }
  void make(const std::string& name, std::time_t seconds_ago = 0) const {
    std::ofstream(folder_ / name) << "half";
    if (seconds_ago == 0) return;
    const timespec then{::time(nullptr) - seconds_ago, 0};
    const timespec times[2] = {then, then};
    ASSERT_EQ(::utimensat(AT_FDCWD, (folder_ / name).c_str(), times, 0), 0);
  }
  // Runs something in a process of its own, and kills it once it says that it is ready.
  template <class Work>
  static pid_t start(const Work& work) {
    int ready[2];
    EXPECT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      work();
      EXPECT_EQ(::write(ready[1], "x", 1), 1);
      for (;;) ::pause();
    }
    char byte = 0;
    EXPECT_EQ(::read(ready[0], &byte, 1), 1);
    ::close(ready[0]);
    ::close(ready[1]);
    return child;
  }
  static void kill(pid_t child) {
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }

  TemporaryFolder folder_;
};

constexpr std::time_t kDay = 86'400;

TEST_F(AbandonedFiles, OfAKilledRunAreRemovedByTheNextOneAndThoseOfALivingOneAreNot) {
  const auto begin_two = [this] {
    static OutputFile written(folder_ / "a.csv"), finished(folder_ / "b.csv");
    written.write("half");
    finished.write("all");
    finished.finish();  // it has not taken its name
  };
  const pid_t living = start(begin_two);
  const pid_t killed = start(begin_two);
  ASSERT_EQ(names().size(), 4U);
  const pid_t next = start([this] { write_output_file(folder_ / "c.csv", "whole"); });
  kill(next);
  EXPECT_EQ(names().size(), 5U) << "all run";
  kill(killed);
  write_output_file(folder_ / "c.csv", "whole");  // the first of this process in the folder
  std::set<std::string> left = names();
  EXPECT_EQ(left.erase("c.csv"), 1U);
  EXPECT_EQ(left.size(), 2U);
  for (const std::string& name : left) EXPECT_TRUE(name.starts_with(".hottel-" + std::to_string(living) + "-")) << name;
  kill(living);
}

TEST_F(AbandonedFiles, OfAnotherMachineAreLeftForADay) {
  const std::string here = running_kernel(), elsewhere = here == "0123abcd" ? "0123abce" : "0123abcd";
  ASSERT_EQ(here.size(), 8U);
  const std::string own_number = std::to_string(::getpid());  // another process had it
  make(".hottel-" + own_number + "-0-" + here + ".tmp");
  make(".hottel-1-7-" + here + ".tmp");
  make(".hottel-12-0-" + elsewhere + ".tmp");
  make(".hottel-13-0-" + elsewhere + ".tmp", 2 * kDay);
  make(".hottel-14-0.tmp");  // of an earlier version
  make(".hottel-15-0.tmp", 2 * kDay);
  const std::set<std::string> others = {".hottel-x-0-" + here + ".tmp",
                                        ".hottel-12-0-" + here + "-1.tmp",
                                        ".hottel-12-0-" + here + ".csv",
                                        "hottel-12-0-" + here + ".tmp",
                                        ".hottel-12.tmp",
                                        "hottel-run-12-" + here + "-abcdef"};
  for (const std::string& name : others) make(name, 2 * kDay);
  remove_abandoned(folder_.path(), Abandoned::kFiles);
  std::set<std::string> expected = others;
  expected.insert({".hottel-12-0-" + elsewhere + ".tmp", ".hottel-14-0.tmp"});
  EXPECT_EQ(names(), expected);
}

TEST_F(AbandonedFiles, AreFilesAndNothingElse) {
  const std::string name = ".hottel-12-0-" + running_kernel() + ".tmp";
  make("kept");
  fs::create_symlink(folder_ / "kept", folder_ / name);
  fs::create_directory(folder_ / (".hottel-12-1-" + running_kernel() + ".tmp"));
  ASSERT_EQ(::mkfifo((folder_ / (".hottel-12-2-" + running_kernel() + ".tmp")).c_str(), 0600), 0);
  remove_abandoned(folder_.path(), Abandoned::kFiles);
  EXPECT_EQ(names().size(), 4U);
}

// A name that is taken by then is not one that was left behind: it is held before it is used.
TEST_F(AbandonedFiles, AreHeldByOneAlone) {
  const std::string path = (folder_ / "f").string();
  const int one = ::open(path.c_str(), O_RDWR | O_CREAT, 0600), other = ::open(path.c_str(), O_RDWR);
  EXPECT_TRUE(hold_temporary(one, path));
  EXPECT_FALSE(hold_temporary(other, path)) << "somebody has it";
  ::close(one);
  fs::remove(path);
  EXPECT_FALSE(hold_temporary(other, path)) << "it is gone";
  make("f");
  EXPECT_FALSE(hold_temporary(other, path)) << "it is another one";
  ::close(other);
}

TEST_F(AbandonedFiles, AndScratchFoldersAreHeldByTheCommandsInThem) {
  ::setenv("TMPDIR", folder_.path().c_str(), 1);
  const pid_t killed = start([this] {
    static ScratchFolder scratch;
    std::ofstream(scratch.path() / "half") << "half";
    // A command that outlives the run.
    if (::fork() == 0)
      ::execl("/bin/sh", "sh", "-c", ("echo $$ > " + (folder_ / "pid").string() + "; exec sleep 600").c_str(), nullptr);
    while (!fs::exists(folder_ / "pid") || fs::file_size(folder_ / "pid") == 0) ::usleep(1000);
  });
  kill(killed);
  pid_t command = 0;
  std::ifstream(folder_ / "pid") >> command;
  const auto in_another_process = [this] {
    const pid_t child = ::fork();
    if (child == 0) {
      remove_abandoned(folder_.path(), Abandoned::kRunFolders);
      ::_exit(0);
    }
    ::waitpid(child, nullptr, 0);
  };
  in_another_process();
  EXPECT_EQ(names().size(), 2U) << "the command is there";
  ::kill(command, SIGKILL);
  for (int k = 0; k < 1000 && names().size() == 2; ++k) {
    ::usleep(1000);  // until it has ended
    in_another_process();
  }
  EXPECT_EQ(names(), std::set<std::string>{"pid"});
  ::unsetenv("TMPDIR");
}

}  // namespace
}  // namespace hottel::abandoned::abandoned_test
