#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "geometry/plane/exchange/exchange.h"
#include "io/results/factor_files.h"
#include "io/results/npy.h"
#include "tests/solver/plane/lit_scenes.h"

namespace hottel::npy_sidecar_test {
namespace {

using Json = nlohmann::json;

TEST(NpySidecar, TellsWhatTheCellsAndChannelsAre) {
  const GridRegion region{{-1.0 / 3, 0}, {2, 2.5}, 4, 3};
  const Json json = Json::parse(illumination_sidecar(region, {"r", "g", "b"}, "average"));
  EXPECT_EQ(json["shape"], Json({3, 4, 3}));
  EXPECT_EQ(json["order"], "C");
  EXPECT_EQ(json["axes"], Json({"y", "x", "channel"}));
  EXPECT_EQ(json["region"]["min"], Json({-1.0 / 3, 0.0}));
  EXPECT_EQ(json["region"]["max"], Json({2.0, 2.5}));
  EXPECT_EQ(json["channels"], Json({"r", "g", "b"}));
  EXPECT_EQ(json["quantity"], "mean irradiance");
  EXPECT_EQ(json["illumination"], "average");
}

TEST(NpySidecar, NamesRowsAndGivesTheirAreas) {
  const PreparedScene2 prepared = prepare(square_room());
  const ExchangeMatrix matrix = exact_exchange(prepared);
  const Json json = Json::parse(factors_sidecar({prepared.scene, matrix}));
  EXPECT_EQ(json["shape"], Json({9, 9}));
  ASSERT_EQ(json["names"].size(), 9u);
  ASSERT_EQ(json["areas"].size(), 9u);
  for (std::uint32_t i = 0; i < 8; ++i) {
    EXPECT_EQ(json["names"][i], matrix.elements()[i].name);
    EXPECT_EQ(json["areas"][i], 1.0);
  }
  EXPECT_EQ(json["names"][8], "sky");
  EXPECT_TRUE(json["areas"][8].is_null());
}

}  // namespace
}  // namespace hottel::npy_sidecar_test
