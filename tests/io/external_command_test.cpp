// Commands that compute view factors, run and timed.
#include "io/external/external_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "geometry/plane/prepared/prepared_scene.h"
#include "tests/io/external_room.h"

namespace hottel::external_command_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

// A run: in the scene's folder.
class ExternalCommandTest : public ExternalRoomTest {
 protected:
  std::string why_not(const std::string& command) {
    const PreparedScene2 prepared = room();
    MethodReport report;
    try {
      planar().make("run:" + command)->compute(prepared, {.granularity = Granularity::kElement}, report);
    } catch (const RequestError& error) {
      return error.what();
    }
    return "nothing is wrong";
  }
};

TEST_F(ExternalCommandTest, ReadsWhatACommandWritesAndTimesIt) {
  const PreparedScene2 prepared = room();
  const std::string list = write("list with blanks.csv", "from,to,factor\na,b,0.5\nc,d,0.25\n");
  for (const std::string& command : std::vector<std::string>{
           "sleep 0.05; cp '" + list + "' {out}", "sleep 0.05; cat '" + list + "'",
           "sleep 0.05; echo said; test -e {scene} && cat '" + list + "' > {out.csv}",
           "sleep 0.05; printf '%%%%MatrixMarket matrix coordinate real general\\n4 4 2\\n1 2 0.5\\n3 4 0.25\\n' > "
           "{out.mtx}"}) {
    MethodReport report;
    const ExchangeMatrix matrix =
        planar().make("run:" + command)->compute(prepared, {.granularity = Granularity::kElement}, report);
    EXPECT_EQ(matrix.factor(0, 2).value, 0.5) << command;
    EXPECT_EQ(matrix.factor(4, 6).value, 0.25) << command;
    EXPECT_GT(report.seconds.value_or(0), 0.05);
  }
}

TEST_F(ExternalCommandTest, PathsWithBlanksAreOneWord) {
  fs::create_directory(directory_ / "it's a folder");
  const PreparedScene2 prepared = prepare(read_scene_2(write("it's a folder/room.json", kRoom)));
  MethodReport report;
  planar()
      .make("run:test -s {scene} && echo from,to,factor && echo a,b,0.5")
      ->compute(prepared, {.granularity = Granularity::kElement}, report);
  EXPECT_EQ(report.written->digits.decimals, 1);
}

TEST_F(ExternalCommandTest, FailuresNameTheCommandAndItsStatus) {
  EXPECT_EQ(why_not("exit 7"), "the command 'exit 7' ended with status 7");
  EXPECT_EQ(why_not("kill -9 $$"), "the command 'kill -9 $$' was ended by signal 9 (Killed)");
  EXPECT_EQ(why_not("true {out}"), "the command 'true {out}' ended well but wrote nothing to {out}");
  EXPECT_THAT(why_not("no-such-program-xyz 2>&-"), HasSubstr("ended with status 127"));
  EXPECT_THAT(why_not("echo from,to,factor; echo a,x,1"),
              StartsWith("what the command 'echo from,to,factor; echo a,x,1' wrote cannot be used: "));
  EXPECT_THROW(why_not("echo {out.csv} {out.mtx}"), UsageError);
  EXPECT_THROW(planar().make("run:"), UsageError);
  EXPECT_THROW(planar().make("file"), UsageError);
}

TEST_F(ExternalCommandTest, LeavesNoFolderBehind) {
  const auto folders = [] {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(fs::temp_directory_path()))
      count += entry.path().filename().string().starts_with("hottel-run-");
    return count;
  };
  ::setenv("TMPDIR", directory_.path().c_str(), 1);
  EXPECT_THAT(why_not("echo half > {out}; exit 1"), HasSubstr("status 1"));
  EXPECT_EQ(folders(), 0u);
  ::unsetenv("TMPDIR");
}

}  // namespace
}  // namespace hottel::external_command_test
