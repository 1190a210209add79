// Rows of radiosity systems through bytes: solutions with others against those of one process, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/generate/generators.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "parallel/row_messages.h"
#include "solver/radiosity/radiosity.h"

namespace hottel::rows_test {
namespace {

// What others do wrong.
enum class Wrong : unsigned char {
  kNothing,
  kOwnColumnsFirst,  // products as matrices are stored that part each row in the columns of a rank and all others
};

// So many others get their rows in bytes and answer in bytes.
class RowsThroughBytes : public SharedRows {
 public:
  RowsThroughBytes(const RadiositySystem& system, const std::vector<char>& is_wanted, std::size_t others, Wrong wrong,
                   std::atomic<int>& asked)
      : symmetric_(system), wrong_(wrong), asked_(asked) {
    elements_ = even_shares(system.matrix(), others + 1);
    for (const WorkRange& range : elements_) {
      unknowns_.push_back(unknowns_among(system, range));
      others_.push_back(std::make_unique<ReceivedRows>(rows_message(system, is_wanted, range)));
    }
  }

  void multiply(RowProduct product, const std::vector<double>& x, const Here& here,
                std::vector<double>& result) override {
    form(product_question(product, x), unknowns_, here, result);
    if (wrong_ == Wrong::kOwnColumnsFirst && product == RowProduct::kSymmetric)
      for (std::size_t k = 1; k < unknowns_.size(); ++k) sum_own_columns_first(unknowns_[k], x, result);
  }
  void residual(const ResidualQuestion& question, const Here& here, std::vector<DoubleDoubleBall>& result) override {
    form(residual_question(question), unknowns_, here, result);
  }
  void irradiance(const std::vector<ScaledBall>& radiosity, FactorsMeant meant, const Here& here,
                  std::vector<ScaledBall>& result) override {
    form(irradiance_question(radiosity, meant), elements_, here, result);
  }

 private:
  template <class T>
  void form(const std::string& question, const std::vector<WorkRange>& ranges, const Here& here,
            std::vector<T>& result) {
    ++asked_;
    here(ranges.front());
    for (std::size_t k = 1; k < ranges.size(); ++k) take_answer(others_[k]->answer(question), ranges[k], result);
  }

  void sum_own_columns_first(const WorkRange& own, const std::vector<double>& x, std::vector<double>& result) const {
    for (std::size_t i = own.begin; i < own.end; ++i) {
      double sums[2] = {0, 0};
      for (std::size_t e = symmetric_.begin[i]; e < symmetric_.begin[i + 1]; ++e) {
        const std::size_t j = symmetric_.to[e];
        sums[own.begin <= j && j < own.end ? 0 : 1] += symmetric_.coupling_of[e] * (x[i] - x[j]);
      }
      result[i] = sums[0] + sums[1] + symmetric_.defect[i] * x[i];
    }
  }

  const SymmetricRows symmetric_;
  const Wrong wrong_;
  std::atomic<int>& asked_;
  std::vector<WorkRange> elements_, unknowns_;
  std::vector<std::unique_ptr<ReceivedRows>> others_;
};

class CrewThroughBytes : public RowCrew {
 public:
  explicit CrewThroughBytes(std::size_t others, Wrong wrong = Wrong::kNothing) : others_(others), wrong_(wrong) {}

  std::unique_ptr<SharedRows> begin(const RadiositySystem& system, const std::vector<char>& is_wanted) override {
    ++systems_;
    return std::make_unique<RowsThroughBytes>(system, is_wanted, others_, wrong_, asked_);
  }
  int systems() const { return systems_; }
  int asked() const { return asked_; }

 private:
  const std::size_t others_;
  const Wrong wrong_;
  std::atomic<int> systems_{0}, asked_{0};
};

// All numbers of a solution but seconds, by their bits.
std::vector<std::uint64_t> bits(const RadiositySolution& solution) {
  std::vector<std::uint64_t> all;
  const auto add = [&](std::initializer_list<double> numbers) {
    for (const double number : numbers) all.push_back(std::bit_cast<std::uint64_t>(number));
  };
  for (const ChannelSolution& channel : solution.channels) {
    for (const ElementRadiosity& e : channel.elements)
      add({e.emission, e.reflectivity, e.radiosity, e.lower, e.upper, e.irradiance, e.net_lower, e.net_upper,
           e.net_value});
    for (const double residual : channel.residual_history) add({residual});
    add({channel.energy.emitted, channel.energy.absorbed, channel.energy.to_sky, channel.energy.defect,
         channel.max_relative_width});
  }
  return all;
}

struct Room {
  ExchangeMatrix matrix;
  std::vector<Material> materials;
  Spectrum sky;

  RadiositySolution solve(const RadiosityOptions& options = {}) const {
    return solve_radiosity(matrix, materials, sky, options);
  }
};

Room clutter(std::uint32_t n) {
  const Scene2 scene = generate_2({"clutter", n, 5});
  return {exact_exchange(prepare(scene), {.wants_visibility = false}), scene.materials, scene.sky_emission};
}

// The same factors, each known within a share of itself, in closed rows or not; or as estimates.
Room weakened(const Room& room, Guarantee guarantee, bool is_closed, double share) {
  std::vector<Enclosure> bounds;
  FactorEntries entries;
  for (std::uint32_t i = 0; i < room.matrix.size(); ++i)
    for (FactorEntry entry : room.matrix.row(i)) {
      entry.factor.side = 0;
      entries.push_back(entry);
      bounds.push_back({entry.factor.value * (1 - share), entry.factor.value * (1 + share)});
    }
  const auto begins = room.matrix.begins();
  Room result{ExchangeMatrix(room.matrix.elements(), guarantee), room.materials, room.sky};
  if (guarantee == Guarantee::kEstimated) bounds.clear();
  result.matrix.assign({begins.begin(), begins.end()}, std::move(entries), {}, std::move(bounds));
  if (is_closed) result.matrix.promise_closed_rows();
  return result;
}

// Returns how often others were asked.
int expect_same_with_others(const Room& room, const RadiosityOptions& options, const std::string& what) {
  const RadiositySolution expected = room.solve(options);
  int asked = 0;
  for (const std::size_t others : {1, 2, 4}) {
    CrewThroughBytes crew(others);
    const CrewScope<RowCrew> scope(crew);
    const RadiositySolution solution = room.solve(options);
    EXPECT_TRUE(bits(solution) == bits(expected)) << what << ", " << others << " others";
    EXPECT_EQ(solution.notes, expected.notes) << what;
    asked += crew.asked();
  }
  return asked;
}

TEST(SharedRows, GiveTheBitsOfOneProcessInThePlane) {
  const Room room = clutter(900);
  EXPECT_GT(expect_same_with_others(room, {}, "auto"), 100);
  EXPECT_GT(expect_same_with_others(room, {.solver = Solver::kCg, .iterations = 4}, "cg"), 3 * 6);
  EXPECT_GT(expect_same_with_others(room, {.solver = Solver::kBicgstab}, "bicgstab"), 100);
  EXPECT_GT(expect_same_with_others(room, {.solver = Solver::kJacobi, .iterations = 3}, "jacobi"), 3);
}

TEST(SharedRows, GiveTheBitsOfOneProcessForEnclosedAndEstimatedFactors) {
  const Room room = clutter(900);
  const Room closed = weakened(room, Guarantee::kEnclosed, true, 1e-12);
  EXPECT_GT(expect_same_with_others(closed, {}, "closed rows"), 100);
  const Room enclosed = weakened(room, Guarantee::kEnclosed, false, 1e-3);
  EXPECT_GT(expect_same_with_others(enclosed, {}, "enclosed"), 100);
  const Room estimated = weakened(room, Guarantee::kEstimated, false, 0);
  EXPECT_GT(expect_same_with_others(estimated, {}, "estimated"), 100);
}

TEST(SharedRows, GiveTheBitsOfOneProcessInSpace) {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/cube.json");
  divide_into(scene, 10);
  const Room room{exact_exchange(prepare(scene), {.granularity = Granularity::kElement}), scene.materials,
                  scene.sky_emission};
  EXPECT_GT(expect_same_with_others(room, {}, "auto"), 100);
}

TEST(SharedRows, AreNotAskedForWhereSystemsAreEliminated) {
  const Room room = clutter(60);
  CrewThroughBytes crew(2);
  const CrewScope<RowCrew> scope(crew);
  room.solve();
  EXPECT_EQ(crew.systems(), 0);
}

// What the comparison above would notice.
TEST(SharedRows, ThatSumTheirOwnColumnsFirstGiveOtherBits) {
  const Room room = clutter(900);
  const RadiosityOptions options{.solver = Solver::kCg, .iterations = 20};
  const auto expected = bits(room.solve(options));
  CrewThroughBytes crew(2, Wrong::kOwnColumnsFirst);
  const CrewScope<RowCrew> scope(crew);
  EXPECT_FALSE(bits(room.solve(options)) == expected);
}

TEST(SharedRows, AreCutIntoEvenRangesThatCoverAllElements) {
  const Room room = clutter(300);
  const ExchangeMatrix& matrix = room.matrix;
  const RadiositySystem system(matrix, room.materials, 0);
  for (const std::size_t parts : {1, 2, 3, 7, 5000}) {
    const std::vector<WorkRange> shares = even_shares(matrix, parts);
    ASSERT_EQ(shares.size(), parts);
    std::size_t end = 0, unknown = 0, most = 0;
    for (const WorkRange& share : shares) {
      EXPECT_EQ(share.begin, end);
      end = share.end;
      const WorkRange unknowns = unknowns_among(system, share);
      EXPECT_EQ(unknowns.begin, unknown);
      unknown = unknowns.end;
      most = std::max(most, matrix.begins()[share.end] - matrix.begins()[share.begin]);
    }
    EXPECT_EQ(end, matrix.size());
    EXPECT_EQ(unknown, system.size());
    if (parts <= 7) {
      EXPECT_LT(most, matrix.entry_count() / parts + 2 * matrix.size());
    }
  }
}

TEST(SharedRows, ThatBreakOffAreRefused) {
  const Room room = clutter(60);
  const RadiositySystem system(room.matrix, room.materials, 0);
  const std::vector<char> is_wanted(system.components().size(), 1);
  const std::string bytes = rows_message(system, is_wanted, {0, room.matrix.size()});
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}, bytes.size() / 2, bytes.size() - 1})
    EXPECT_THROW(ReceivedRows(std::string_view(bytes).substr(0, size)), ContractViolation);
  ReceivedRows rows(bytes);
  EXPECT_THROW(rows.answer(""), ContractViolation);
  EXPECT_THROW(rows.answer(product_question(RowProduct::kSymmetric, {1, 2})), ContractViolation);
  std::vector<double> result(2);
  EXPECT_THROW(take_answer("", {0, 2}, result), ContractViolation);
  const std::string three = rows.answer(product_question(RowProduct::kPlain, std::vector<double>(system.size(), 1)));
  EXPECT_THROW(take_answer(three, {0, 2}, result), ContractViolation);
}

}  // namespace
}  // namespace hottel::rows_test
