// What csv files of factors say of each number.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/results/factor_files.h"

namespace hottel::factors_csv_test {
namespace {

TEST(FactorsCsv, SaysOfEachFactorWhatIsGuaranteed) {
  SceneTable scene;
  std::vector<Element> elements(2);
  elements[0].name = "floor";
  elements[1].name = "wall";
  ExchangeMatrix matrix(elements, Guarantee::kExact);
  matrix.assign({0, 2, 3}, {{1, {0.5, 0}, 1}, {2, {0.25, 0}, 0.5}, {0, {0.75, 0}, 1}}, {},
                {{0, 0}, {0.125, 0.5}, {0, 1}}, {Guarantee::kExact, Guarantee::kEnclosed, Guarantee::kEstimated});
  std::string text;
  write_factors_csv({scene, matrix, Granularity::kFace, {{1, 2}}, {}}, [&](std::string_view part) { text += part; });
  EXPECT_EQ(text,
            "from,to,factor,lower,upper,visibility,guarantee\n"
            "floor,wall,0.5,0.5,0.5,1,exact\n"
            "floor,sky,0.25,0.125,0.5,0.5,enclosed\n"
            "wall,floor,0.75,0,1,1,estimated\n"
            "wall,sky,0,0,0,0,exact\n");
}

}  // namespace
}  // namespace hottel::factors_csv_test
