// Jobs and what was found, through bytes.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/scene/division.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/space/scene/division.h"
#include "geometry/unmeasured_pairs.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "parallel/cell_crew.h"
#include "parallel/message.h"
#include "parallel/plane/cell_messages.h"
#include "parallel/plane/sweep_messages.h"
#include "parallel/scene_message.h"
#include "parallel/space/cell_messages.h"
#include "parallel/space/pair_messages.h"
#include "solver/plane/light/illumination_grid.h"
#include "solver/space/light/illumination_grid.h"
#include "tests/lit_grids.h"
#include "tests/same_matrix.h"
#include "tests/shuffled_cells.h"
#include "tests/shuffled_work.h"

namespace hottel::messages_test {
namespace {

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";

// Others get the job in bytes, prepare the scene by themselves, and answer in bytes.
class CrewThroughBytes3 : public ShuffledCrew3 {
 public:
  using ShuffledCrew3::ShuffledCrew3;
  const void* prepared() const { return kept_.last().get(); }

 protected:
  std::function<DoneTasks3(const WorkRange&)> elsewhere(const PairJob3& job) override {
    struct Other {
      ReceivedPairJob3 job;
      PairHelper3 helper;
      Other(std::string_view bytes, KeptScene3& kept)
          : job(bytes, kept), helper(*job.prepared, *job.table, job.request) {}
    };
    const auto other = std::make_shared<Other>(pair_job_message_3(job), kept_);
    return [other, &table = job.table](const WorkRange& tasks) {
      return read_done_3(done_message_3(other->helper.measure(tasks), *other->job.table), table);
    };
  }

 private:
  KeptScene3 kept_;
};

class CrewThroughBytes2 : public ShuffledCrew2 {
 public:
  using ShuffledCrew2::ShuffledCrew2;

 protected:
  std::function<SweptPart2(const WorkRange&)> elsewhere(const SweepJob2& job) override {
    const auto other = std::make_shared<ReceivedSweepJob2>(sweep_job_message_2(job), kept_);
    return [other, order = job.order](const WorkRange& places) {
      const auto vertices = read_vertices_2(vertices_message_2(order.subspan(places.begin, places.size())));
      return read_part_2(part_message_2(swept_part(places, vertices, other->prepared->arrangement, *other->table)));
    };
  }

 private:
  KeptScene2 kept_;
};

template <class Shuffled, class CellJob, class Received, class Kept, std::string (*message)(const CellJob&)>
class CellsThroughBytes : public Shuffled {
 public:
  using Shuffled::Shuffled;

 protected:
  std::function<LitCells(const WorkRange&)> elsewhere(const CellJob& job) override {
    const auto other = std::make_shared<Received>(message(job), kept_);
    return [other](const WorkRange& tasks) { return read_lit(lit_message(other->light->lit(tasks))); };
  }

 private:
  Kept kept_;
};
using CellsThroughBytes2 =
    CellsThroughBytes<ShuffledCells2, CellJob2, ReceivedCellJob2, KeptScene2, cell_job_message_2>;
using CellsThroughBytes3 =
    CellsThroughBytes<ShuffledCells3, CellJob3, ReceivedCellJob3, KeptScene3, cell_job_message_3>;

PreparedScene3 in_space(const std::string& name, std::uint32_t parts) {
  Scene3 scene = read_scene_3(kScenes + name);
  divide_into(scene, parts);
  return prepare(std::move(scene));
}

TEST(Messages, CarryPairsInSpaceBitForBit) {
  for (const std::string name : {"space/two_boxes.json", "degenerate/space/boxes_stacked.json", "space/cube.json",
                                 "degenerate/space/interpenetrating.json", "space/hat_in_a_box.json"}) {
    const PreparedScene3 prepared = in_space(name, 2);
    for (const Granularity granularity : {Granularity::kElement, Granularity::kGroup}) {
      const ExchangeRequest request{.granularity = granularity, .sky = SkyBy::kIntegral};
      const ExchangeMatrix expected = exact_exchange(prepared, request);
      CrewThroughBytes3 crew(5);
      const CrewScope<PairCrew3> scope(crew);
      expect_same(exact_exchange(prepared, request), expected);
      EXPECT_EQ(crew.sums(), 1);
    }
  }
}

TEST(Messages, CarryTurnsOfSomeRowsAndTheSkyByClosure) {
  const PreparedScene3 prepared = in_space("space/two_boxes.json", 2);
  const ExchangeRequest request{.granularity = Granularity::kElement, .sky = SkyBy::kClosure};
  const ExchangeMatrix expected = exact_exchange(prepared, request);
  CrewThroughBytes3 crew(6);
  const CrewScope<PairCrew3> scope(crew);
  ExchangeRows3 rows(prepared, request);
  const std::vector<std::uint32_t> some{3, 5};
  rows.add(some);
  const void* const before = crew.prepared();
  rows.add_all();
  expect_same(rows.matrix(), expected);
  EXPECT_GE(crew.sums(), 2);
  EXPECT_EQ(crew.prepared(), before) << "a scene is prepared once";
}

TEST(Messages, CarryPairsThatAreOpenAndThoseThatAreKnown) {
  const PreparedScene3 prepared = in_space("space/two_boxes.json", 1);
  const auto refusal = [&] {
    try {
      exact_exchange(prepared, {.tolerance = 1e-17});
    } catch (const UnmeasuredPairs& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string expected = refusal();
  ASSERT_NE(expected, "");
  const ExchangeMatrix matrix = exact_exchange(prepared);
  ExchangeRows3 first(prepared, {});
  PairRanges known(first.table().count());
  known.add(0, {1, 7});
  std::vector<PairSum3> pairs;
  first.add_all();
  for (const PairSum3& pair : first.pairs())
    if (pair.i < known.elements() && known.has(pair.i, pair.j)) pairs.push_back(pair);
  CrewThroughBytes3 crew(7);
  const CrewScope<PairCrew3> scope(crew);
  EXPECT_EQ(refusal(), expected);
  ExchangeRows3 rest(prepared, {});
  rest.take(pairs, known);
  rest.add_all();
  expect_same(rest.matrix(), matrix);
}

TEST(Messages, CarrySweepsInThePlaneBitForBit) {
  for (const std::string name :
       {"showcase/apartment.json", "degenerate/crossing_walls.json", "degenerate/tips_touch.json",
        "degenerate/overlap_on_a_line.json", "degenerate/needle_wedge.json"}) {
    Scene2 scene = read_scene_2(kScenes + name);
    for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup})
      for (const bool has_few_rows : {false, true}) {
        if (granularity == Granularity::kElement)
          for (Surface& surface : scene.surfaces) surface.elements = 3;
        const PreparedScene2 prepared =
            prepare(scene, granularity == Granularity::kElement ? Divided2::kYes : Divided2::kNo);
        ExchangeRequest request{.granularity = granularity, .always_sweeps = true};
        if (has_few_rows) request.rows = RowChoice::of(scene, scene.surfaces.front().name, granularity);
        const ExchangeMatrix expected = exact_exchange(prepared, request);
        CrewThroughBytes2 crew(8);
        const CrewScope<SweepCrew2> scope(crew);
        expect_same(exact_exchange(prepared, request), expected);
        EXPECT_EQ(crew.sweeps(), 1);
      }
  }
}

template <class Crew, class Scope, class Lit>
void expect_same_light_through_bytes(const Lit& lit) {
  const auto simulation = simulation_of(lit, kScenes);
  const auto light = [&] {
    return illuminate_points(*simulation.prepared(), lit.granularity, *simulation.radiosities(), lit.grid).values;
  };
  const std::vector<double> expected = light();
  Crew crew(9);
  const CrewScope<Scope> scope(crew);
  EXPECT_EQ(bits_of(light()), bits_of(expected)) << lit.scene;
  EXPECT_EQ(crew.grids(), 1);
}

TEST(Messages, CarryTheLightOfGridsBitForBit) {
  for (const LitGrid2& lit : lit_grids_2()) expect_same_light_through_bytes<CellsThroughBytes2, CellCrew2>(lit);
  for (const LitGrid3& lit : lit_grids_3()) expect_same_light_through_bytes<CellsThroughBytes3, CellCrew3>(lit);
}

TEST(Messages, CarryScenesWithTheTreesBelowTheirElements) {
  Scene3 scene = read_scene_3(kScenes + "space/two_boxes.json");
  scene.surfaces[1].trees.front = uniform_leaves(1, 4, 2);
  scene.surfaces[3].trees.back = uniform_leaves(1, 4, 1);
  MessageWriter writer;
  put_scene(scene, writer);
  MessageReader reader(writer.bytes());
  const Scene read = take_scene(reader);
  EXPECT_TRUE(reader.is_at_end());
  EXPECT_EQ(std::get<Scene3>(read).surfaces, scene.surfaces);
  EXPECT_EQ(std::get<Scene3>(read).polygons, scene.polygons);
}

TEST(Messages, OfOtherElementsAreRefused) {
  const PreparedScene3 two = in_space("space/two_boxes.json", 2), three = in_space("space/two_boxes.json", 3);
  const auto table = three.elements(Granularity::kElement);
  // The scene of one with the elements of the other: as of two programs that disagree.
  const std::string bytes = pair_job_message_3({two, Granularity::kElement, *table, {}, {}});
  KeptScene3 kept;
  EXPECT_THROW(ReceivedPairJob3(bytes, kept), RequestError);
}

TEST(Messages, OfLightThatBreakOffAreRefused) {
  const std::string bytes = lit_message({{2, 4}, {1, 2, 3, 4, 5, 6}});
  EXPECT_EQ(read_lit(bytes).values.size(), 6u);
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}, bytes.size() / 2, bytes.size() - 1})
    EXPECT_THROW(read_lit(std::string_view(bytes).substr(0, size)), ContractViolation);
  EXPECT_THROW(read_lit(bytes + "x"), ContractViolation);
}

TEST(Messages, ThatBreakOffAreRefused) {
  const PreparedScene3 prepared = in_space("space/cube.json", 1);
  const auto table = prepared.elements(Granularity::kFace);
  const PairSumRequest3 request;
  const PairHelper3 helper(prepared, *table, request);
  const std::string bytes = done_message_3(helper.measure({0, helper.tasks()}), *table);
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}, bytes.size() / 2, bytes.size() - 1})
    EXPECT_THROW(read_done_3(std::string_view(bytes).substr(0, size), *table), ContractViolation);
  EXPECT_THROW(read_done_3(bytes + "x", *table), ContractViolation);
}

}  // namespace
}  // namespace hottel::messages_test
