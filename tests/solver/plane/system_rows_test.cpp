// The systems of radiosity as threads make them: row by row what a loop over all entries makes.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/radiosity/radiosity_system.h"
#include "solver/radiosity/symmetric_rows.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::system_rows_test {
namespace {

using testing_scenes::generated;

ExchangeMatrix matrix_of(const Scene2& scene, const std::string& method) {
  MethodReport report;
  return methods_2().make(method)->compute(prepare(scene), {}, report);
}

// By component its first element, how many unknowns it has, whether it loses light; and the component of each unknown.
struct Components {
  std::vector<SystemComponent> all;
  std::vector<std::uint32_t> of_unknown;
};

// By walks from one unknown to the next, over entries of either direction.
Components walked(const RadiositySystem& system) {
  const ExchangeMatrix& matrix = system.matrix();
  std::vector<std::vector<std::uint32_t>> neighbours(system.size());
  std::vector<char> loses(system.size());
  for (std::uint32_t i = 0; i < system.size(); ++i) {
    loses[i] = system.absorptivity(system.rows()[i]) != 0;
    for (const FactorEntry& entry : matrix.row(system.rows()[i].element)) {
      const std::int32_t j = system.unknown(entry.to);
      if (j < 0) loses[i] = 1;
      if (j < 0 || !is_positive(entry.factor)) continue;
      neighbours[i].push_back(static_cast<std::uint32_t>(j));
      neighbours[static_cast<std::size_t>(j)].push_back(i);
    }
  }
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  Components result{{}, std::vector<std::uint32_t>(system.size(), kNone)};
  for (std::uint32_t first = 0; first < system.size(); ++first) {
    if (result.of_unknown[first] != kNone) continue;
    const auto component = static_cast<std::uint32_t>(result.all.size());
    result.all.push_back({system.rows()[first].element, 0, false});
    std::vector<std::uint32_t> open{first};
    result.of_unknown[first] = component;
    while (!open.empty()) {
      const std::uint32_t i = open.back();
      open.pop_back();
      ++result.all.back().size;
      result.all.back().loses |= loses[i] != 0;
      for (const std::uint32_t j : neighbours[i])
        if (result.of_unknown[j] == kNone) {
          result.of_unknown[j] = component;
          open.push_back(j);
        }
    }
  }
  return result;
}

void expect_walked_components(const RadiositySystem& system) {
  const Components expected = walked(system);
  ASSERT_EQ(system.components().size(), expected.all.size());
  for (std::size_t c = 0; c < expected.all.size(); ++c) {
    EXPECT_EQ(system.components()[c].first_element, expected.all[c].first_element);
    EXPECT_EQ(system.components()[c].size, expected.all[c].size);
    EXPECT_EQ(system.components()[c].loses, expected.all[c].loses);
  }
  for (std::size_t i = 0; i < system.size(); ++i) EXPECT_EQ(system.rows()[i].component, expected.of_unknown[i]);
}

// Entry by entry, as the header says.
void expect_rows_of_a_loop(const RadiositySystem& system, const SymmetricRows& rows) {
  const ExchangeMatrix& matrix = system.matrix();
  std::vector<double> largest(system.components().size(), 0);
  for (const SystemRow& row : system.rows())
    largest[row.component] = std::max(largest[row.component], matrix.elements()[row.element].area.value);
  std::size_t k = 0;
  ASSERT_EQ(rows.begin.size(), system.size() + 1);
  for (std::size_t i = 0; i < system.size(); ++i) {
    const SystemRow& row = system.rows()[i];
    const double area = matrix.elements()[row.element].area.value / largest[row.component];
    double coupling = 0, to_known = 0;
    EXPECT_EQ(rows.begin[i], k);
    for (const FactorEntry& entry : matrix.row(row.element)) {
      const std::int32_t j = system.unknown(entry.to);
      if (j < 0) to_known += entry.factor.value;
      if (j < 0 || static_cast<std::size_t>(j) == i) continue;
      ASSERT_LT(k, rows.to.size());
      EXPECT_EQ(rows.to[k], static_cast<std::uint32_t>(j));
      EXPECT_EQ(rows.coupling_of[k], area * entry.factor.value);
      coupling += rows.coupling_of[k++];
    }
    EXPECT_EQ(rows.component[i], row.component);
    EXPECT_EQ(rows.coupling[i], coupling);
    EXPECT_EQ(rows.weight[i], area / row.reflectivity.hi);
    EXPECT_EQ(rows.defect[i], rows.weight[i] * row.loss.hi + area * to_known);
  }
  EXPECT_EQ(rows.begin.back(), k);
  EXPECT_EQ(rows.to.size(), k);
}

TEST(SystemRows, AreThoseOfALoop) {
  for (const int threads : {1, 4}) {
    const ThreadLimit limit(threads);
    for (const GeneratorKind2& kind : generator_kinds_2()) {
      const Scene2 scene = generated(kind.name, std::max<std::uint64_t>(kind.min_edges, 300), 3);
      const ExchangeMatrix matrix = matrix_of(scene, "exact");
      const RadiositySystem system(matrix, scene.materials, 0);
      expect_walked_components(system);
      expect_rows_of_a_loop(system, SymmetricRows(system));
    }
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Scene2 scene = generated("lattice", 8 + seed, seed);  // often of several components
      const ExchangeMatrix matrix = matrix_of(scene, "exact");
      expect_walked_components(RadiositySystem(matrix, scene.materials, 0));
    }
  }
}

// Rows of estimates do not sum to 1: their loss is what they leave.
TEST(SystemRows, OfEstimatesLoseWhatTheyLeave) {
  const Scene2 scene = generated("clutter", 300, 3);
  const ExchangeMatrix matrix = matrix_of(scene, "center");
  const ThreadLimit limit(4);
  const RadiositySystem system(matrix, scene.materials, 0);
  ASSERT_FALSE(system.rows_are_closed());
  EXPECT_FALSE(system.has_negative_factors());
  expect_walked_components(system);
  for (const SystemRow& row : system.rows()) {
    double sum = 0;
    for (const double factor : matrix.row(row.element).factors()) sum += factor;
    EXPECT_NEAR(row.loss.value(), 1 - row.reflectivity.value() * sum, 1e-13);
  }
}

// Of many rows that are wrong the first one is named, whoever finds another one before.
TEST(SystemRows, NameTheFirstFactorThatIsNoNumber) {
  const Scene2 scene = generated("clutter", 300, 3);
  const ExchangeMatrix whole = matrix_of(scene, "center");
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), -1e-3}) {
    std::vector<std::size_t> begin(whole.begins().begin(), whole.begins().end());
    FactorEntries entries;
    std::string first;
    for (std::uint32_t i = 0; i < whole.size(); ++i)
      for (const FactorEntry& entry : whole.row(i)) {
        const bool is_wrong = i % 50 == 49;
        if (is_wrong && first.empty()) first = whole.name(i);
        entries.push_back(is_wrong ? FactorEntry{entry.to, {wrong, 0}, 1} : entry);
      }
    ExchangeMatrix matrix(whole.elements(), Guarantee::kEstimated);
    matrix.assign(std::move(begin), std::move(entries));
    const ThreadLimit limit(4);
    if (wrong < 0) {
      EXPECT_TRUE(RadiositySystem(matrix, scene.materials, 0).has_negative_factors());
      continue;
    }
    try {
      RadiositySystem(matrix, scene.materials, 0);
      ADD_FAILURE();
    } catch (const RequestError& error) {
      EXPECT_EQ(error.what(), "a factor of '" + first + "' is nan: nothing can be solved");
    }
  }
}

}  // namespace
}  // namespace hottel::system_rows_test
