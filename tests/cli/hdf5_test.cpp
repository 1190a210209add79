// View factors as HDF5 files, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/cli/program.h"

namespace hottel::testing_cli::hdf5_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";
const std::string kApartment = "'" + kScenes + "showcase/apartment.json' ";
const std::string kBoxes = "'" + kScenes + "space/two_boxes.json' --tolerance 1e-4 ";

#ifdef HOTTEL_HDF5

TEST(Hdf5, HasTheSameBytesForAnyNumberOfThreads) {
  for (const std::string& scene : {kApartment, kBoxes}) {
    const Workplace place;
    for (const char* threads : {"1", "2", "3"})
      ASSERT_EQ(place.run("hottel factors " + scene + "-o " + threads + ".h5 --quiet --threads " + threads).code, 0);
    EXPECT_TRUE(place.read("1.h5") == place.read("2.h5") && place.read("1.h5") == place.read("3.h5"));
  }
}

TEST(Hdf5, IsComparedAndSolvedAsAnyOtherFile) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel factors " + kApartment + "-o f.h5 --quiet").code, 0);
  ASSERT_EQ(place.run("hottel compare " + kApartment + "--methods exact,file:f.h5 --repeat 1 -o c").code, 0);
  const auto csv = lines_of(place.read("c/compare.csv"));
  ASSERT_EQ(csv.size(), 3u);
  EXPECT_THAT(csv[2], StartsWith("file:f.h5,estimated,"));
  EXPECT_THAT(csv[2], HasSubstr(",0,0,")) << "no error at all";
  ASSERT_EQ(place.run("hottel solve " + kApartment + "--no-illumination -o a --quiet").code, 0);
  ASSERT_EQ(place.run("hottel solve " + kApartment + "--method file:f.h5 --no-illumination -o b --quiet").code, 0);
  EXPECT_EQ(lines_of(place.read("a/radiosity.csv")).size(), lines_of(place.read("b/radiosity.csv")).size());
}

TEST(Hdf5, OfSomeRowsIsSmallerAndComparedInThem) {
  const Workplace place;
  ASSERT_EQ(place
                .run("hottel factors " + kApartment + "-o all.h5 --quiet && hottel factors " + kApartment +
                     "--rows 'window*' -o some.h5 --quiet")
                .code,
            0);
  EXPECT_LT(place.read("some.h5").size(), place.read("all.h5").size());
  const Outcome outcome =
      place.run("hottel compare " + kApartment + "--methods exact,file:some.h5 --repeat 1 -o c --quiet");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(lines_of(place.read("c/compare.csv"))[2], HasSubstr(",0,0,"));
}

TEST(Hdf5, WithoutItsLibraryIsRefusedAndAllOtherFilesAreWritten) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel factors " + kApartment + "-o there.h5 --quiet").code, 0);
  place.write(HOTTEL_HDF5, "");  // no library, and found first
  const std::string without = "env LD_LIBRARY_PATH=. hottel ";
  for (const char* line : {"factors -o f.h5 ", "solve --method file:there.h5 "}) {
    const Outcome outcome = place.run(without + line + kApartment);
    EXPECT_EQ(outcome.code, 1) << line;
    for (const char* part : {HOTTEL_HDF5, ".h5"}) EXPECT_THAT(outcome.err, HasSubstr(part)) << line;
  }
  EXPECT_FALSE(std::filesystem::exists(place.path("f.h5")));
  EXPECT_EQ(place.run(without + "factors -o f.mtx " + kApartment).code, 0);
}

TEST(Hdf5, ThatCannotBeWrittenLeavesTheEarlierOne) {
  const Workplace place;
  place.write("f.h5", "earlier");
  const Outcome full = place.run("ulimit -f 20; trap '' XFSZ; hottel factors " + kApartment + "-o f.h5 --quiet");
  EXPECT_EQ(full.code, 3);
  EXPECT_EQ(full.err, "f.h5: cannot be written: File too large\n");
  EXPECT_EQ(place.read("f.h5"), "earlier");
  EXPECT_EQ(place.files(), std::vector<std::string>{"f.h5"});
  const Outcome device = place.run("ln -s /dev/null n.h5; hottel factors " + kApartment + "-o n.h5 --quiet");
  EXPECT_EQ(device.code, 3);
  EXPECT_EQ(device.err, "n.h5: is no regular file, and this format needs one\n");
}

TEST(Hdf5, OfAnythingElseIsRefused) {
  const Workplace place;
  ASSERT_EQ(place
                .run("hottel factors " + kApartment +
                     "-o f.h5 --quiet; head -c 9000 f.h5 > cut.h5; "
                     "echo text > text.h5")
                .code,
            0);
  for (const std::string name : {"cut.h5", "text.h5"}) {
    const Outcome outcome = place.run("hottel compare " + kApartment + "--methods exact,file:" + name + " -o c");
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, StartsWith(name + ": "));
  }
  EXPECT_EQ(place.run("hottel factors " + kApartment + "--matrix factor -o m.h5").code, 2);
}

#else

TEST(Hdf5, IsRefusedWithoutHdf5) {
  const Workplace place;
  const Outcome outcome = place.run("hottel factors " + kApartment + "-o f.h5");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("-DHOTTEL_HDF5=OFF"));
}

#endif

}  // namespace
}  // namespace hottel::testing_cli::hdf5_test
