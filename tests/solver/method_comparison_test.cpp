// Methods held against the exact one, in both dimensions.
#include "solver/compare/method_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "solver/plane/compare/method_comparison.h"
#include "solver/space/compare/method_comparison.h"
#include "tests/solver/dimensions.h"

namespace hottel::method_comparison_test {
namespace {

template <class D>
using ComparisonOf = std::conditional_t<std::is_same_v<D, PlaneTests>, MethodComparison2, MethodComparison3>;

// A method that gives the matrix it is given.
template <class D>
class Given final : public D::ElementMethod {
 public:
  explicit Given(ExchangeMatrix matrix) : matrix_(std::move(matrix)) {}
  const MethodInfo& info() const override { return info_; }
  ExchangeMatrix compute_elements(const typename D::Prepared&, const std::function<void(double)>&,
                                  MethodReport& report) const override {
    report.seconds = 0.25;
    return matrix_;
  }
  std::optional<double> declared_error(const typename D::Prepared&) const override { return std::nullopt; }

 private:
  ExchangeMatrix matrix_;
  MethodInfo info_{"given", "given", 0, Guarantee::kEstimated, ""};
};

// The exact factors of a scene, each times a number.
ExchangeMatrix times(const ExchangeMatrix& exact, double factor) {
  std::vector<std::size_t> begin{0};
  std::vector<FactorEntry> entries;
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    for (FactorEntry entry : exact.row(i)) {
      entry.factor = {entry.factor.value * factor, 0};
      entries.push_back(entry);
    }
    begin.push_back(entries.size());
  }
  ExchangeMatrix matrix(exact.elements(), Guarantee::kEstimated);
  matrix.assign(begin, entries);
  return matrix;
}

template <class D>
class MethodComparisonTest : public testing::Test {
 protected:
  static ComparisonOf<D> comparison(const char* reflectivity = "0.5") {
    return ComparisonOf<D>(typename D::Simulation(D::furnace(reflectivity)));
  }
};
TYPED_TEST_SUITE(MethodComparisonTest, BothDimensions, DimensionNames);

// Every factor halved: the walls send out 1 / (1 - 1/4) instead of 1 / (1 - 1/2).
TYPED_TEST(MethodComparisonTest, SolvesTheMatrixAsItIs) {
  const auto comparison = this->comparison();
  const MethodResult result = comparison.run(Given<TypeParam>(times(comparison.exact(), 0.5)));
  EXPECT_NEAR(*result.max_radiosity_error, (2 - 4.0 / 3) / 2, 1e-14);
  EXPECT_NEAR(result.errors.closure, 0.5, 1e-15);
  EXPECT_EQ(result.timing.median, 0.25) << "the time that the method itself knows";
}

TYPED_TEST(MethodComparisonTest, SaysThatAMatrixWithoutRadiositiesHasNone) {
  const auto comparison = this->comparison();
  const MethodResult result = comparison.run(Given<TypeParam>(times(comparison.exact(), 1e3)), 1);
  EXPECT_EQ(result.max_radiosity_error, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(result.solution);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_THAT(result.notes[0], testing::StartsWith("no radiosity"));
}

TYPED_TEST(MethodComparisonTest, ComparesFactorsOfASceneThatHasNoRadiosities) {
  const auto comparison = this->comparison("1");
  EXPECT_FALSE(comparison.exact_solution());
  EXPECT_FALSE(comparison.why_no_solution().empty());
  const MethodResult result = comparison.run(*TypeParam::methods().make("exact"), 1);
  EXPECT_EQ(result.max_radiosity_error, std::nullopt);
  EXPECT_LE(result.errors.max, 1e-9);
  EXPECT_THROW(comparison.required_solution(), RequestError);
}

// The reference as a method is what running it gives, but for the time.
TYPED_TEST(MethodComparisonTest, TheReferenceIsWhatTheExactMethodGives) {
  const auto comparison = this->comparison();
  const auto exact = TypeParam::methods().make("exact");
  const MethodResult run = comparison.run(*exact, 1), reference = comparison.reference_as_method(*exact);
  EXPECT_EQ(run.errors.max, reference.errors.max);
  EXPECT_EQ(run.errors.rms, reference.errors.rms);
  EXPECT_EQ(run.errors.closure, reference.errors.closure);
  EXPECT_EQ(run.max_radiosity_error, reference.max_radiosity_error);
  EXPECT_EQ(run.declared_error, reference.declared_error);
  EXPECT_EQ(run.elements, reference.elements);
  EXPECT_GT(reference.timing.median, 0);
}

}  // namespace
}  // namespace hottel::method_comparison_test
