// hottel compare --texels: lightmaps of others, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/results/npy.h"
#include "tests/cli/csv_table.h"
#include "tests/cli/program.h"

namespace hottel::compare_texels_test {
namespace {

using testing::HasSubstr;
using testing_cli::cells_of;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

const std::string kCube = "'" + std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/cube.json'";
constexpr std::size_t kSide = 3;

// The texels of the floor of the cube, by another program.
class OfTheFloor : public testing::Test {
 protected:
  OfTheFloor() {
    place_.run("hottel solve " + kCube + " --texels floor=3x3 -o solved --quiet --no-picture");
    const std::string bytes = place_.read("solved/texels.npy");
    channels_ = nlohmann::json::parse(place_.read("solved/texels.npy.json"))["channels"].size();
    values_.resize(kSide * kSide * channels_);
    std::memcpy(values_.data(), bytes.data() + bytes.size() - values_.size() * sizeof(double),
                values_.size() * sizeof(double));
  }

  void write(const std::string& file, std::span<const std::size_t> shape, std::span<const double> values) const {
    std::string bytes;
    write_npy(shape, values, [&bytes](std::string_view part) { bytes += part; });
    place_.write(file, bytes);
  }
  void write(const std::string& file, const std::vector<double>& values) const {
    write(file, std::array{kSide, kSide, channels_}, values);
  }
  Outcome compare(const std::string& texels) const {
    return place_.run("hottel compare " + kCube + " --repeat 1 --json -o out --texels " + texels);
  }

  Workplace place_;
  std::size_t channels_ = 0;
  std::vector<double> values_;
};

TEST_F(OfTheFloor, AreExactWhereSolveWroteThem) {
  const Outcome outcome = compare("solved/texels.npy");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto lines = lines_of(place_.read("out/texels.csv"));
  ASSERT_EQ(lines.size(), 1 + channels_);
  EXPECT_EQ(lines[0], "channel,texels,missing,extra,max_error,rms_error,mean_error,mean,ix,iy,s,t,x,y,z,value,exact");
  EXPECT_EQ(cells_of(lines[1])[1], "9");
  EXPECT_EQ(cells_of(lines[1])[4], "0");
  EXPECT_EQ(lines_of(place_.read("out/compare.csv")).size(), 2u) << "exact alone";
  EXPECT_THAT(place_.read("out/texel_errors.png"), testing::StartsWith("\x89PNG"));
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["texels"]["face"], "floor");
}

TEST_F(OfTheFloor, AreToldWithTheirErrorsAndTheWorstPlace) {
  std::vector<double> wrong = values_;
  const std::size_t worst = (kSide * 2 + 0) * channels_;  // texel 0, 2
  wrong[worst] += 9;
  write("wrong.npy", wrong);
  const Outcome outcome = compare("floor=wrong.npy");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto told = nlohmann::json::parse(outcome.out)["texels"]["channels"][0];
  EXPECT_NEAR(told["max_error"].get<double>(), 9, 1e-12);
  EXPECT_NEAR(told["rms_error"].get<double>(), 3, 1e-12);
  EXPECT_NEAR(told["mean_error"].get<double>(), 1, 1e-12);
  EXPECT_EQ(told["off"], 1);
  EXPECT_EQ(told["worst"]["texel"], (std::vector<int>{0, 2}));
  EXPECT_NEAR(told["worst"]["st"][1].get<double>(), 2.5 / 3, 1e-15);
  EXPECT_THAT(outcome.err, HasSubstr("the worst is texel 0, 2 at S,T = 0.166667,0.833333"));
}

// By channel, and the mean of all.
TEST_F(OfTheFloor, MayBeIrradiances) {
  ASSERT_EQ(place_.run("hottel solve " + kCube + " --texels floor=3x3 --show irradiance -o shown --quiet").code, 0);
  EXPECT_EQ(nlohmann::json::parse(place_.read("shown/texels.npy.json"))["face"], "floor");
  Outcome outcome = compare("shown/texels.npy");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(cells_of(lines_of(place_.read("out/texels.csv")).at(1))[4], "0");

  write("twice.npy", values_);
  place_.write("twice.npy.json", R"({"quantity": "irradiance", "face": "floor"})");
  outcome = compare("twice.npy");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("the light is times 0.")) << "the reflectivity";
}

TEST_F(OfTheFloor, AreRefusedWhereTheyDoNotFit) {
  const auto said = [&](const std::string& texels, int code) {
    const Outcome outcome = compare(texels);
    EXPECT_EQ(outcome.code, code) << texels << outcome.err;
    return outcome.err;
  };
  write("good.npy", values_);
  EXPECT_THAT(said("good.npy", 2), HasSubstr("no good.npy.json says of which face"));
  EXPECT_THAT(said("flor=good.npy", 2), HasSubstr("did you mean 'floor'?"));
  EXPECT_THAT(said("floor:back=good.npy", 2), HasSubstr("has no material"));
  EXPECT_THAT(said("floor=none.npy", 3), HasSubstr("none.npy: there is no such file"));
  place_.write("good.npy.json", R"({"face": "flor"})");
  EXPECT_THAT(said("good.npy", 3), HasSubstr("good.npy.json: is of a face that cannot be compared"));
  place_.write("good.npy.json", R"({"face": "floor", "shape": [4, 3, 3]})");
  EXPECT_THAT(said("good.npy", 3), HasSubstr("says that the shape is [4,3,3]"));
  place_.write("good.npy.json", R"({"face": "floor", "quantity": "temperature"})");
  EXPECT_THAT(said("good.npy", 3), HasSubstr("radiosity and irradiance can be compared"));
  place_.write("good.npy.json", R"({"region": {"origin": [7, 0, 0], "u": [1, 0, 0], "v": [0, 1, 0]}})");
  EXPECT_THAT(said("floor=good.npy", 3), HasSubstr("says that the texels lie elsewhere"));
  write("nan.npy", std::vector<double>(values_.size(), std::nan("")));
  EXPECT_THAT(said("floor=nan.npy", 3), HasSubstr("no finite value"));
  write("two.npy", std::array{kSide, std::size_t{1}, std::size_t{2}}, std::vector<double>(6, 1));
  EXPECT_THAT(said("floor=two.npy", 3), HasSubstr("has 2 values a texel, and the light of the scene "));
}

}  // namespace
}  // namespace hottel::compare_texels_test
