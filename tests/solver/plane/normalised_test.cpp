// Methods with ":normalised" at the end of their names.
#include <gtest/gtest.h>

#include "geometry/plane/generate/generators.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/rational.h"
#include "solver/plane/methods/method_catalogue.h"

namespace hottel::normalised_test {
namespace {

TEST(Normalised, RowsSumToOneAndNeverToMore) {
  const PreparedScene2 prepared = prepare(generate_2({.kind = "clutter", .n = 90, .seed = 4}), Divided2::kYes);
  std::size_t rows = 0, below = 0;
  for (const char* name : {"exact", "strings", "center", "gauss:4", "rays:100", "hemicube:64"}) {
    MethodReport report;
    const ExchangeMatrix matrix = methods_2()
                                      .make(std::string(name) + ":normalised")
                                      ->compute(prepared, {.granularity = Granularity::kElement}, report);
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (matrix.row(i).empty()) continue;
      Rational sum = 0;
      for (const FactorEntry& entry : matrix.row(i)) sum += Rational(entry.factor.value);
      ++rows;
      below += sum < 1;
      EXPECT_LE(sum, 1) << name << " " << matrix.elements()[i].name;
      EXPECT_GE(to_double(sum), 1 - 0x1p-53) << name << " " << matrix.elements()[i].name;
    }
  }
  EXPECT_GT(rows, 400u);
  EXPECT_GT(below, 0u);
}

TEST(Normalised, StandsAtTheEndOfAName) {
  EXPECT_EQ(split_method_name("gauss:4:normalised").raw, "gauss:4");
  EXPECT_EQ(split_method_name("gauss:4:normalised").normalised, ":normalised");
  EXPECT_EQ(split_method_name("gauss:4").raw, "gauss:4");
  EXPECT_EQ(split_method_name("gauss:4").normalised, "");
}

}  // namespace
}  // namespace hottel::normalised_test
