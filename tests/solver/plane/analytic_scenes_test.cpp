// Every expectation that a scene of scenes/analytic/ carries, and the promises of those in scenes/showcase/.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/visibility/visibility_polygon.h"
#include "io/scene/scene_json.h"
#include "kernel/rounding.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::analytic_scenes_test {
namespace {

namespace fs = std::filesystem;
using namespace testing_radiosity;

// Vertices rounded to 17 digits move a factor by less than this.
constexpr double kRounded = 1e-15;

// How far a measured order of convergence may be from the one that is known: a polygon's corners lie differently to
// the tangents for every number of them.
constexpr double kOrderSlack = 0.3;

struct Expected {
  std::string scene;  // file name without ending
  Expectation row;
};

std::string identifier(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? std::string(1, c) : c == '-' ? "minus" : "_";
  return result;
}

void PrintTo(const Expected& expected, std::ostream* out) {
  *out << expected.scene << ": " << expected.row.kind << " " << expected.row.quantity << " = " << expected.row.value;
}

std::vector<std::string> stems_in(const std::string& folder) {
  std::vector<std::string> stems;
  for (const auto& entry : fs::directory_iterator(fs::path(HOTTEL_SOURCE_DIR) / "scenes" / folder))
    if (entry.path().extension() == ".json") stems.push_back(entry.path().stem().string());
  std::sort(stems.begin(), stems.end());
  return stems;
}

Scene2 read(const std::string& folder, const std::string& stem) {
  return read_scene_2(fs::path(HOTTEL_SOURCE_DIR) / "scenes" / folder / (stem + ".json"));
}

// A scene of scenes/analytic/ and what is computed of it, each when it is first asked for.
class AnalyticScene {
 public:
  explicit AnalyticScene(const std::string& stem) : prepared_(prepare(read("analytic", stem))) {}

  const Scene2& scene() const { return prepared_.scene; }

  const ExchangeMatrix& matrix(Granularity granularity) {
    auto& matrix = matrices_[granularity];
    if (!matrix) matrix = std::make_unique<ExchangeMatrix>(exact_exchange(prepared_, {granularity}));
    return *matrix;
  }

  Rounded point_factor(const Expectation& row) const {
    const Edge2& from = scene().edges.at(scene().find(row.of.at(0)).value());
    const std::uint32_t to = scene().find(row.of.at(1)).value();
    const Arrangement2& arrangement = prepared_.arrangement;
    const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
    RootSum sum;
    for (const PointFactor2& part :
         point_factors(arrangement, location, from.from, from.to, false, parse_rational(row.at).value()))
      if (part.side != kSky && arrangement.owner(part.side) == Face{to, false}) sum += part.factor;
    return round_quotient(sum, RootSum(Rational(1))).number;
  }

  // Radiosities of all faces from the closed forms.
  const std::vector<mpf_class>& radiosities() {
    if (radiosities_.empty())
      radiosities_ = ExactScene(prepared_.scene).radiosity(scene().materials, scene().sky_emission, 0);
    return radiosities_;
  }

 private:
  PreparedScene2 prepared_;
  std::map<Granularity, std::unique_ptr<ExchangeMatrix>> matrices_;
  std::vector<mpf_class> radiosities_;
};

AnalyticScene& analytic(const std::string& stem) {
  static std::map<std::string, std::unique_ptr<AnalyticScene>> scenes;
  auto& scene = scenes[stem];
  if (!scene) scene = std::make_unique<AnalyticScene>(stem);
  return *scene;
}

Rational value_of(const Expectation& row) { return parse_rational(row.value).value(); }

Granularity per_of(const Expectation& row) {
  return row.quantity == "group_factor" ? Granularity::kGroup : Granularity::kFace;
}

// F(of[0], of[1]) + F(of[0], of[2]) + ...
double factor_sum(AnalyticScene& scene, const Expectation& row) {
  const ExchangeMatrix& matrix = scene.matrix(per_of(row));
  const std::uint32_t from = matrix.find(row.of.at(0)).value();
  double sum = 0;
  for (std::size_t k = 1; k < row.of.size(); ++k) sum += matrix.factor(from, matrix.find(row.of[k]).value()).value;
  return sum;
}

mpf_class radiosity(AnalyticScene& scene, const Expectation& row) {
  return scene.radiosities().at(scene.matrix(Granularity::kFace).find(row.of.at(0)).value());
}

double visibility(AnalyticScene& scene, const Expectation& row) {
  const ExchangeMatrix& matrix = scene.matrix(Granularity::kFace);
  const std::uint32_t to = matrix.find(row.of.at(1)).value();
  for (const FactorEntry& entry : matrix.row(matrix.find(row.of.at(0)).value()))
    if (entry.to == to) return entry.visibility;
  return 0;
}

bool is_factor(const Expectation& row) { return row.quantity == "factor" || row.quantity == "group_factor"; }

void expect_correctly_rounded(const Rounded& computed, const Expectation& row) {
  EXPECT_EQ(computed.value, to_double(value_of(row)));
  EXPECT_LE(Rational(computed.enclosure().lower), value_of(row));
  EXPECT_GE(Rational(computed.enclosure().upper), value_of(row));
}

class AnalyticScenes : public testing::TestWithParam<Expected> {};

TEST_P(AnalyticScenes, MeetTheirExpectation) {
  const Expectation& row = GetParam().row;
  AnalyticScene& scene = analytic(GetParam().scene);
  if (row.quantity == "radiosity") {
    ASSERT_EQ(row.kind, "exact");
    const mpf_class error = abs(radiosity(scene, row) - number(value_of(row)));
    EXPECT_LE(error, number(value_of(row)) * 1e-25);  // of the printed digits
  } else if (row.quantity == "point_factor") {
    ASSERT_EQ(row.kind, "point");
    expect_correctly_rounded(scene.point_factor(row), row);
  } else if (row.quantity == "visibility") {
    ASSERT_EQ(row.kind, "exact");
    EXPECT_EQ(visibility(scene, row), to_double(value_of(row)));
  } else if (row.kind == "rounded") {
    ASSERT_TRUE(is_factor(row)) << row.quantity;
    EXPECT_NEAR(factor_sum(scene, row), to_double(value_of(row)), kRounded);
  } else {
    ASSERT_EQ(row.kind, "exact");
    ASSERT_TRUE(is_factor(row)) << row.quantity;
    ASSERT_EQ(row.of.size(), 2u);
    const ExchangeMatrix& matrix = scene.matrix(per_of(row));
    expect_correctly_rounded(matrix.factor(matrix.find(row.of[0]).value(), matrix.find(row.of[1]).value()), row);
  }
}

// Scenes called NAME_8, NAME_16, ... with one limit, in order of the number.
struct Series {
  std::string limit;
  std::vector<std::pair<int, Expected>> members;
};

void PrintTo(const Series& series, std::ostream* out) { *out << series.limit << ", " << series.members.size(); }

int number_at_end(const std::string& stem) { return std::stoi(stem.substr(stem.find_last_not_of("0123456789") + 1)); }

// Polygons come near circles as 1/n², plates near infinite ones as 1/w; the derivations in the files say so.
double order_of(const std::string& limit) { return limit.starts_with("parallel_plates") ? 1 : 2; }

class AnalyticSeries : public testing::TestWithParam<Series> {};

TEST_P(AnalyticSeries, ConvergesToItsLimitWithTheKnownOrder) {
  const Series& series = GetParam();
  ASSERT_GE(series.members.size(), 3u);
  double previous = 0;
  for (std::size_t k = 0; k < series.members.size(); ++k) {
    const auto& [n, expected] = series.members[k];
    AnalyticScene& scene = analytic(expected.scene);
    ASSERT_TRUE(is_factor(expected.row) || expected.row.quantity == "radiosity");
    const double computed =
        is_factor(expected.row) ? factor_sum(scene, expected.row) : radiosity(scene, expected.row).get_d();
    const double error = std::abs(computed - to_double(value_of(expected.row)));
    ASSERT_GT(error, 0);
    if (k > 0) {
      const double order = std::log(previous / error) / std::log(double(n) / series.members[k - 1].first);
      EXPECT_NEAR(order, order_of(series.limit), kOrderSlack) << expected.scene;
    }
    previous = error;
  }
  EXPECT_LT(previous, 0.01 * to_double(value_of(series.members.back().second.row)));
}

struct Rows {
  std::vector<Expected> own;
  std::vector<Series> series;
};

const Rows& all_rows() {
  static const Rows rows = [] {
    Rows result;
    std::map<std::string, Series> series;
    for (const std::string& stem : stems_in("analytic"))
      for (const Expectation& row : read("analytic", stem).expect) {
        if (row.kind == "limit") {
          series[row.name].limit = row.name;
          series[row.name].members.emplace_back(number_at_end(stem), Expected{stem, row});
        } else {
          result.own.push_back({stem, row});
        }
      }
    for (auto& [name, one] : series) {
      std::sort(one.members.begin(), one.members.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      result.series.push_back(std::move(one));
    }
    return result;
  }();
  return rows;
}

INSTANTIATE_TEST_SUITE_P(, AnalyticScenes, testing::ValuesIn(all_rows().own), [](const auto& test) {
  std::string name = test.param.scene + "__" + test.param.row.name;
  if (test.param.row.quantity == "radiosity") name += "__" + test.param.row.of.at(0);
  return identifier(name);
});

INSTANTIATE_TEST_SUITE_P(, AnalyticSeries, testing::ValuesIn(all_rows().series),
                         [](const auto& test) { return identifier(test.param.limit); });

// A whole scene: folder and name.
class WholeScenes : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(WholeScenes, CloseExactlyAndKeepTheirPromise) {
  const PreparedScene2 prepared = prepare(read(GetParam().first, GetParam().second));
  ExchangeReport report;
  const ExchangeMatrix matrix = exact_exchange(prepared, {}, &report);
  EXPECT_TRUE(report.closure_is_exact);
  EXPECT_GT(report.pairs, 0u);
  std::size_t that_see_the_sky = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    double sum = 0;
    for (const FactorEntry& entry : matrix.row(i)) sum += entry.factor.value;
    EXPECT_NEAR(sum, 1, 1e-13) << matrix.elements()[i].name;
    if (!matrix.elements()[i].is_back && matrix.factor(i, matrix.sky()).value > 0) ++that_see_the_sky;
  }
  EXPECT_EQ(that_see_the_sky == 0, prepared.scene.closed);
}

std::vector<std::pair<std::string, std::string>> whole_scenes() {
  std::vector<std::pair<std::string, std::string>> result;
  for (const char* folder : {"analytic", "showcase"})
    for (const std::string& stem : stems_in(folder)) result.emplace_back(folder, stem);
  return result;
}

INSTANTIATE_TEST_SUITE_P(, WholeScenes, testing::ValuesIn(whole_scenes()),
                         [](const auto& test) { return identifier(test.param.first + "__" + test.param.second); });

}  // namespace
}  // namespace hottel::analytic_scenes_test
