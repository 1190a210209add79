// How much memory there is, by the files in which a system says so.
#include "kernel/support/memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/temporary_folder.h"

namespace hottel::memory_test {
namespace {

constexpr std::uint64_t kMega = 1'000'000;

// A folder with the files of a system.
class SystemFiles {
 public:
  SystemFiles() { write("proc/meminfo", "MemTotal: 9000000 kB\nMemFree: 10 kB\nMemAvailable: 1000000 kB\n"); }

  void write(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  std::uint64_t free() const { return free_memory(root_.path()); }

 private:
  const TemporaryFolder root_;
};

TEST(FreeMemory, IsWhatTheSystemSaysIsAvailable) {
  const SystemFiles files;
  EXPECT_EQ(files.free(), 1'024'000'000u);
  files.write("proc/self/cgroup", "0::/user/shell\n");
  files.write("sys/fs/cgroup/user/memory.max", "max\n");
  files.write("sys/fs/cgroup/user/memory.current", "5000\n");
  EXPECT_EQ(files.free(), 1'024'000'000u) << "a group without a limit";
}

TEST(FreeMemory, IsWhatIsLeftInEveryGroupOfVersionTwo) {
  const SystemFiles files;
  files.write("proc/self/cgroup", "0::/user/shell\n");
  files.write("sys/fs/cgroup/user/shell/memory.max", "900000000\n");
  files.write("sys/fs/cgroup/user/shell/memory.current", "100000000\n");
  EXPECT_EQ(files.free(), 800 * kMega);
  files.write("sys/fs/cgroup/user/memory.max", "500000000\n");
  files.write("sys/fs/cgroup/user/memory.current", "200000000\n");
  EXPECT_EQ(files.free(), 300 * kMega) << "the group around it";
  files.write("sys/fs/cgroup/user/memory.stat", "anon 5\ninactive_file 150000000\n");
  EXPECT_EQ(files.free(), 450 * kMega) << "files may be dropped";
  files.write("sys/fs/cgroup/user/memory.current", "700000000\n");
  EXPECT_EQ(files.free(), 0u) << "beyond the limit";
}

TEST(FreeMemory, IsWhatIsLeftInEveryGroupOfVersionOne) {
  const SystemFiles files;
  files.write("proc/self/cgroup", "5:cpu,cpuacct:/jobs\n4:memory:/jobs/one\n0::/\n");
  files.write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  files.write("sys/fs/cgroup/memory/memory.usage_in_bytes", "300000000\n");
  EXPECT_EQ(files.free(), 1'024'000'000u);
  files.write("sys/fs/cgroup/memory/jobs/one/memory.limit_in_bytes", "200000000\n");
  files.write("sys/fs/cgroup/memory/jobs/one/memory.usage_in_bytes", "50000000\n");
  files.write("sys/fs/cgroup/memory/jobs/one/memory.stat", "cache 1\ntotal_inactive_file 10000000\n");
  EXPECT_EQ(files.free(), 160 * kMega);
}

// In a container the group has a name that is not there; its limit is at the root.
TEST(FreeMemory, IsThatOfAContainer) {
  const SystemFiles files;
  files.write("proc/self/cgroup", "0::/docker/0123456789\n");
  files.write("sys/fs/cgroup/memory.max", "400000000\n");
  files.write("sys/fs/cgroup/memory.current", "150000000\n");
  EXPECT_EQ(files.free(), 250 * kMega);
}

TEST(FreeMemory, IsWhatIsInstalledWhereNothingIsSaid) {
  const SystemFiles files;
  files.write("proc/meminfo", "");
  EXPECT_EQ(files.free(),
            static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)));
}

TEST(MemoryAllowed, IsWhatWasAskedForOrFourFifths) {
  EXPECT_EQ(memory_allowed(7), 7u);
  const std::uint64_t some = memory_allowed(), all = free_memory();
  EXPECT_NEAR(static_cast<double>(some), 0.8 * static_cast<double>(all), 0.3 * static_cast<double>(all));
}

}  // namespace
}  // namespace hottel::memory_test
