// Queries to a simulation by names of faces, in both dimensions.
#include "solver/plane/simulation/queries.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/near_names.h"
#include "kernel/support/failure.h"
#include "solver/space/simulation/queries.h"
#include "tests/solver/dimensions.h"

namespace hottel::queries_test {
namespace {

template <class D>
class QueriesTest : public testing::Test {
 protected:
  // A furnace by the elements that its first surface is divided into.
  static typename D::Simulation furnace(std::uint32_t elements) {
    auto scene = D::furnace("0.5");
    scene.surfaces[0].elements = elements;
    typename D::Request request;
    D::set_granularity(request, Granularity::kElement);
    return typename D::Simulation(std::move(scene), request);
  }
};
TYPED_TEST_SUITE(QueriesTest, BothDimensions, DimensionNames);

TYPED_TEST(QueriesTest, AreAnsweredByName) {
  for (const std::uint32_t elements : {1u, 2u}) {
    const auto simulation = this->furnace(elements);
    const std::string first = simulation.scene().surfaces[0].name + (elements == 1 ? "" : "#1");
    const std::string other = simulation.scene().surfaces[1].name;
    const ExchangeMatrix& matrix = simulation.factors()->matrix;
    const std::uint32_t i = *matrix.find(first), j = *matrix.find(other);
    EXPECT_EQ(view_factor(simulation, first, other).value, matrix.factor(i, j).value);
    EXPECT_GT(view_factor(simulation, first, other).value, 0);
    EXPECT_EQ(view_factor(simulation, first, "sky").value, 0);
    const ElementRadiosity radiosity = radiosity_of(simulation, first);
    EXPECT_EQ(radiosity.radiosity, simulation.radiosities()->channels[0].elements[i].radiosity);
    EXPECT_LE(radiosity.lower, 2);
    EXPECT_GE(radiosity.upper, 2);
  }
}

TYPED_TEST(QueriesTest, RefuseNamesThatThereAreNot) {
  const auto simulation = this->furnace(1);
  const std::string first = simulation.scene().surfaces[0].name, back = first + ":back";
  EXPECT_THROW(view_factor(simulation, first + "x", "sky"), UnknownName);
  EXPECT_THROW(view_factor(simulation, first, "skies"), UnknownName);
  EXPECT_THROW(view_factor(simulation, "sky", first), UsageError);
  EXPECT_THROW(view_factor(simulation, back, first), UsageError);
  EXPECT_THROW(radiosity_of(simulation, "sky"), UsageError);
  EXPECT_THROW(radiosity_of(simulation, back), UsageError);
  EXPECT_THROW(radiosity_of(simulation, first + "#7"), UnknownName);
  EXPECT_THROW(radiosity_of(simulation, first, 1), ContractViolation);
}

}  // namespace
}  // namespace hottel::queries_test
