// Radiosities of more unknowns than are factored in doubles, whose rows do not sum to 1.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "kernel/support/parallel.h"
#include "solver/radiosity/approximate_inverse.h"
#include "solver/radiosity/radiosity_solver.h"
#include "solver/radiosity/single_precision_lu.h"
#include "solver/space/methods/method_catalogue.h"

namespace hottel::many_unknowns_test {
namespace {

// The Cornell box in elements, by item buffers: estimates.
struct Box {
  std::vector<Material> materials;
  std::shared_ptr<const ExchangeMatrix> matrix;

  explicit Box(std::uint32_t n = 5) {
    Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/cornell_box.json");
    divide_into(scene, n);
    MethodReport report;
    const PreparedScene3 prepared = prepare(scene);
    // A hemicube sees everything once: rows sum to 1, but for roundings.
    matrix = std::make_shared<const ExchangeMatrix>(
        methods_3().make("hemicube:64")->compute(prepared, {.granularity = Granularity::kElement}, report));
    materials = scene.materials;
  }
  RadiositySolver solver(Solver which = Solver::kAuto, bool serves_many = false) const {
    return {matrix, reflectivities_of(materials), {.solver = which, .serves_many = serves_many}};
  }
  RadiositySources sources(const Rational& lamp) const {
    std::vector<Material> lit = materials;
    for (Material& material : lit)
      if (material.name == "lamp") material.emission = Spectrum::scalar(lamp);
    return sources_of(*matrix, lit, Spectrum());
  }
};

const Box& box() {
  static const Box made;
  return made;
}

void expect_the_same(const RadiositySolution& a, const RadiositySolution& b) {
  ASSERT_EQ(a.channels.size(), b.channels.size());
  for (std::size_t c = 0; c < a.channels.size(); ++c)
    for (std::size_t i = 0; i < a.channels[c].elements.size(); ++i) {
      EXPECT_EQ(a.channels[c].elements[i].radiosity, b.channels[c].elements[i].radiosity);
      EXPECT_EQ(a.channels[c].elements[i].lower, b.channels[c].elements[i].lower);
      EXPECT_EQ(a.channels[c].elements[i].upper, b.channels[c].elements[i].upper);
    }
}

TEST(ManyUnknowns, AreFactoredAndBoundsAreThoseOfTheIterations) {
  const RadiositySolution factored = box().solver().solve(box().sources(7));
  const RadiositySolution iterated = box().solver(Solver::kBicgstab).solve(box().sources(7));
  ASSERT_GT(factored.unknowns, kMostDenseUnknowns);
  EXPECT_EQ(factored.used, Solver::kLu);
  EXPECT_EQ(iterated.used, Solver::kBicgstab);
  EXPECT_LT(factored.max_relative_width, 1e-14);
  for (std::size_t c = 0; c < factored.channels.size(); ++c)
    for (std::size_t i = 0; i < factored.channels[c].elements.size(); ++i) {
      const ElementRadiosity &a = factored.channels[c].elements[i], &b = iterated.channels[c].elements[i];
      EXPECT_LE(a.lower, b.upper) << i;
      EXPECT_LE(b.lower, a.upper) << i;
    }
}

// Where one light alone does not pay for it.
TEST(ManyUnknowns, AreFactoredForManyLights) {
  const Box larger(7);
  const RadiositySolution for_one = larger.solver().solve(larger.sources(7));
  const RadiositySolution for_many = larger.solver(Solver::kAuto, true).solve(larger.sources(7));
  ASSERT_GT(for_one.unknowns, kMostUnknownsFactoredForOne);
  ASSERT_LT(for_one.unknowns, kMostUnknownsFactoredForMany);
  EXPECT_EQ(for_one.used, Solver::kBicgstab);
  EXPECT_EQ(for_many.used, Solver::kLu);
  for (std::size_t c = 0; c < for_one.channels.size(); ++c)
    for (std::size_t i = 0; i < for_one.channels[c].elements.size(); ++i) {
      const ElementRadiosity &a = for_one.channels[c].elements[i], &b = for_many.channels[c].elements[i];
      EXPECT_LE(a.lower, b.upper) << i;
      EXPECT_LE(b.lower, a.upper) << i;
    }
}

// RadiositySolver (8)
TEST(ManyUnknowns, AreAFunctionOfTheSceneAlone) {
  const RadiositySolver solver = box().solver();
  solver.solve(box().sources(3));
  const RadiositySolution second = solver.solve(box().sources(11));
  expect_the_same(second, box().solver().solve(box().sources(11)));
  const ThreadLimit one(1);
  expect_the_same(second, box().solver().solve(box().sources(11)));
}

// single_precision_lu.h
TEST(SinglePrecisionLu, SolvesToTenDigitsOrSaysThatItDoesNot) {
  for (const char* reflectivity : {"0.5", "0.9", "0.999"}) {
    std::vector<Rational> rho(box().materials.size(), *parse_rational(reflectivity));
    const RadiositySystem system(*box().matrix, rho);
    const PlainSystem plain(system, std::vector<char>(system.components().size(), 1));
    const auto inverse = make_single_precision_lu(plain, system.components().size());
    ASSERT_EQ(inverse == nullptr, rho[0] > Rational(99, 100)) << reflectivity;
    if (!inverse) continue;
    const auto exact = make_lu(plain, system.components().size());
    std::vector<double> right_side(system.size());
    for (std::size_t i = 0; i < right_side.size(); ++i) right_side[i] = static_cast<double>(1 + i * i % 17);
    const Correction found = inverse->solve(right_side), expected = exact->solve(right_side);
    for (std::size_t i = 0; i < right_side.size(); ++i)
      EXPECT_NEAR(found.rest[i], expected.rest[i], 1e-9 * expected.rest[i]);
  }
}

TEST(SinglePrecisionLu, IsNotTakenWhereLightStaysLong) {
  std::vector<Material> materials = box().materials;
  for (Material& material : materials) material.reflectivity = Spectrum::scalar(Rational(999, 1000));
  const RadiositySolver solver(box().matrix, reflectivities_of(materials));
  EXPECT_EQ(solver.solve(box().sources(1)).used, Solver::kBicgstab);
}

}  // namespace
}  // namespace hottel::many_unknowns_test
