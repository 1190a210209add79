// Rows of what is near first, and light among those that have come.
#include "viewer/window/space/nearest_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/window/space/first_light.h"
#include "viewer/window/space/live_version.h"

namespace hottel::nearest_rows_test {
namespace {

Scene3 boxes() {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/two_boxes.json");
  divide_into(scene, 2);
  Light bulb;
  bulb.name = "bulb";
  bulb.power = {{30, 20, 10}, false};
  LightPlace3 place;
  place.position = {Rational(1, 2), Rational(1, 2), 5};
  scene.add_light(std::move(bulb), std::move(place));
  return scene;
}

// Remembers what has come.
class Remembering : public RowWatch3 {
 public:
  explicit Remembering(std::shared_ptr<NearestRows3> nearest) : nearest_(std::move(nearest)) {}
  std::vector<std::uint32_t> next(const ExchangeRows3& rows) override {
    parts.push_back(nearest_->next(rows));
    return parts.back();
  }
  void have_come(const ExchangeRows3& rows, std::span<const PairSum3> pairs) override {
    nearest_->have_come(rows, pairs);
    so_far.push_back(nearest_->take());
    EXPECT_FALSE(nearest_->take());
  }
  std::vector<std::vector<std::uint32_t>> parts;
  std::vector<std::shared_ptr<const RowsSoFar3>> so_far;

 private:
  std::shared_ptr<NearestRows3> nearest_;
};

class Arriving : public testing::Test {
 protected:
  Arriving() : nearest(std::make_shared<NearestRows3>(nullptr)), watch(std::make_shared<Remembering>(nearest)) {
    nearest->look_from({2.75, 0.1, 2.75});
  }
  Simulation3 simulation() const {
    return Simulation3(boxes(), {.factors = {.granularity = Granularity::kElement, .watch = watch}});
  }
  std::shared_ptr<NearestRows3> nearest;
  std::shared_ptr<Remembering> watch;
};

TEST_F(Arriving, NearRowsComeFirstAndAllCome) {
  const Simulation3 watched = simulation();
  const ExchangeMatrix& matrix = watched.factors()->matrix;
  const LiveModel3 model(*watched.prepared());
  const auto corners = element_corners(model.table(), model.prepared.occluders().vertices());
  double before = 0;
  std::size_t all = 0;
  for (const auto& part : watch->parts) {
    double nearest_of_part = 1e9, farthest = 0;
    for (const std::uint32_t i : part) {
      Direction3 sum;
      for (const auto& p : corners[i]) sum = sum + Direction3{p[0], p[1], p[2]};
      const double distance = length((1 / static_cast<double>(corners[i].size())) * sum - Direction3{2.75, 0.1, 2.75});
      nearest_of_part = std::min(nearest_of_part, distance);
      farthest = std::max(farthest, distance);
    }
    EXPECT_GE(nearest_of_part, before - 1e-9);
    before = farthest;
    all += part.size();
  }
  EXPECT_GE(watch->parts.size(), 10u);
  EXPECT_EQ(watch->so_far.back()->count, all);
  EXPECT_EQ(watch->so_far.back()->all, all);
  // Nothing that is computed depends on the order.
  const Simulation3 plain(boxes(), {.factors = {.granularity = Granularity::kElement}});
  EXPECT_EQ(watched.request(), plain.request());
  ASSERT_EQ(matrix.entry_count(), plain.factors()->matrix.entry_count());
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k)
      EXPECT_EQ(matrix.row(i)[k].factor, plain.factors()->matrix.row(i)[k].factor);
}

// (2): one that was told to stop, and has not yet, while another one of the same shape has begun.
TEST_F(Arriving, AMeasurementThatHasNotStoppedIsNotMixedWithTheNext) {
  const PreparedScene3 prepared = prepare(boxes());
  const ExchangeRequest request{.granularity = Granularity::kElement};
  ExchangeRows3 before(prepared, request), after(prepared, request);
  const std::vector<std::uint32_t> first = nearest->next(before);
  EXPECT_EQ(nearest->next(after), first);
  nearest->have_come(before, before.add(first));
  EXPECT_FALSE(nearest->take());
  EXPECT_FALSE(nearest->next(before).empty());  // it goes on until it stops
  nearest->have_come(after, after.add(first));
  const auto so_far = nearest->take();
  ASSERT_TRUE(so_far);
  EXPECT_EQ(so_far->count, first.size());
  EXPECT_EQ(so_far->pairs.size(), 1u);
}

// (1) of RowSweeps3.
TEST_F(Arriving, SweepsTendToTheLight) {
  const Simulation3 watched = simulation();
  const auto light = watched.radiosities();
  const LiveModel3 model(*watched.prepared());
  RowSweeps3 sweeps(watched.scene(), model.table(), *watch->so_far.back(), *watched.light_shares(),
                    light_before_factors_3(watched.scene(), model.table()));
  double before = 2;
  for (int k = 0; k < 60; ++k) {
    const double change = sweeps.sweep();
    EXPECT_LE(change, before);
    before = std::max(change, 1e-14);
  }
  for (std::size_t c = 0; c < 3; ++c)
    for (std::uint32_t i = 0; i < model.table().count(); ++i)
      EXPECT_NEAR(sweeps.light().value(i)[c], light->channels[c].elements[i].radiosity, 1e-9);
}

TEST_F(Arriving, RowsThatAreMissingKeepTheirLight) {
  const Simulation3 watched = simulation();
  watched.factors();
  const LiveModel3 model(*watched.prepared());
  const ElementPaint3 before = light_before_factors_3(watched.scene(), model.table());
  const RowsSoFar3& some = *watch->so_far[3];
  RowSweeps3 sweeps(watched.scene(), model.table(), some, *watched.light_shares(), before);
  sweeps.sweep();
  std::size_t changed = 0;
  for (std::uint32_t i = 0; i < model.table().count(); ++i) {
    const bool is_same = std::ranges::equal(sweeps.light().value(i), before.value(i));
    if (some.has_come[i] == 0) {
      EXPECT_TRUE(is_same) << i;
    }
    changed += is_same ? 0 : 1;
  }
  EXPECT_GT(changed, some.count / 2);
}

}  // namespace
}  // namespace hottel::nearest_rows_test
