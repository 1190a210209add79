// What view factors in space cost: rooms of boxes with up to 1,900 elements, and rows of towns of 2,400 and 10,400.
//
// The rooms are scenes/space/room_axis.json and room_turned.json, also with every element divided by 2 or 4 along each
// side, and a unit cube with a box in its middle (space_scenes.h).
//
//   factors  preparation and exact_exchange, everything `hottel factors` does but reading and writing: black backs and
//            the sky are among the columns, visibilities are computed
//   pairs    every pair by itself through PairIntegrator3, on one thread, with a stopwatch: fronts alone, as published
//            studies do it; with black backs; with these and the sky
//   stages   the mixed pairs of the fronts once more, their stages one after the other, each timed alone: what is left
//            of the whole is summing and refining the integrals
//   town     20 elements drawn by seed from a town under the sky: their whole rows, on one thread; 100 buildings (2,400
//            elements) with backs and sky, 500 (10,400) with backs, and 4 elements of these with the sky too
//
// Kinds of pairs are those of PairVisibility3. `closure` is |row sum - 1|: of rows that see anything at all, for where
// backs are left out elements beneath boxes see nothing.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "benchmarks/clutter.h"
#include "benchmarks/space_scenes.h"
#include "geometry/space/between/pair_occluders.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/facing.h"
#include "geometry/space/pairs/pair_stretches.h"
#include "geometry/space/pieces/stretch_map.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/unobstructed/unobstructed.h"
#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"

namespace hottel::benchmarks {
namespace {

using Part = ElementTable3::Part;

// How a room is divided: elements along a side of a wall, and of a face of a box.
struct Division {
  std::uint32_t walls, boxes;
};

// The elements with a row: all fronts.
std::size_t rows_of(Room3 room, const Division& division) {
  const std::size_t faces = room == Room3::kAxis ? 21 : room == Room3::kTurned ? 24 : 6;
  return std::size_t{6} * division.walls * division.walls + faces * division.boxes * division.boxes;
}

void set_closure(benchmark::State& state, const std::vector<double>& defects) {
  state.counters["closure_median"] = quantile(defects, 0.5);
  state.counters["closure_p95"] = quantile(defects, 0.95);
  state.counters["closure_max"] = quantile(defects, 1);
}

void factors(benchmark::State& state, Room3 room, const Division& division, double tolerance, int threads) {
  const ThreadLimit limit(threads);
  const Scene3 scene = room_3(room, division.walls, division.boxes);
  std::map<std::string, double> stages;
  ExchangeReport3 report;
  double seconds = 0;
  for (auto _ : state) {
    Scene3 copy = scene;
    const PreparedScene3 prepared = prepare(std::move(copy));
    ExchangeRequest request;
    request.granularity = Granularity::kElement;
    request.tolerance = tolerance;
    const ExchangeMatrix matrix = exact_exchange(prepared, request, &report);
    double iteration = 0;
    for (const auto& [stage, time] : report.seconds) {
      stages[stage] += time;
      iteration += time;
    }
    seconds += iteration;
    state.SetIterationTime(iteration);
    std::vector<double> defects;
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      double sum = -1;
      for (const FactorEntry& entry : matrix.row(i)) sum += entry.factor.value;
      defects.push_back(std::fabs(sum));
    }
    set_closure(state, defects);
  }
  const auto iterations = static_cast<double>(state.iterations()), pairs = static_cast<double>(report.pairs);
  state.counters["pairs"] = pairs;
  state.counters["us_per_pair_core"] = 1e6 * seconds / iterations * threads / pairs;
  for (const auto& [stage, time] : stages) state.counters["ms_" + stage] = 1e3 * time / iterations;
  state.counters["enclosed"] = static_cast<double>(report.enclosed) / pairs;
}

// What is known of pairs of one kind.
struct Kind {
  std::vector<double> seconds;
  double sum() const { return std::accumulate(seconds.begin(), seconds.end(), 0.0); }
  double count() const { return static_cast<double>(seconds.size()); }
  double mean() const { return seconds.empty() ? 0 : sum() / count(); }
};

// What measuring pairs one by one tells.
struct Tally {
  std::array<Kind, 3> kinds;  // by PairVisibility3
  double maps = 0, pieces = 0, nodes = 0, failed = 0;

  const Kind& of(PairVisibility3 sight) const { return kinds[static_cast<std::size_t>(sight)]; }

  // Measures a pair of `a`, whose row it is. Returns S.
  double measure(const PreparedScene3& prepared, PairRow3& row, const Part& a, const Part& b, double tolerance) {
    Stopwatch watch;
    PairResult3 pair;
    if (b.patch.is_sky() || surfaces_face_each_other(prepared.occluders(), a, b))
      pair = row.measure(b.patch, {.tolerance = tolerance});
    kinds[static_cast<std::size_t>(pair.sight)].seconds.push_back(watch.lap());
    maps += pair.maps;
    pieces += pair.pieces;
    nodes += pair.nodes;
    failed += !pair.problem.empty();
    return pair.measure;
  }

  void tell(benchmark::State& state, double per) const {
    const Kind &hidden = of(PairVisibility3::kHidden), &clear = of(PairVisibility3::kClear),
               &mixed = of(PairVisibility3::kMixed);
    state.counters["hidden"] = hidden.count() / per;
    state.counters["clear"] = clear.count() / per;
    state.counters["mixed"] = mixed.count() / per;
    state.counters["s_hidden"] = hidden.sum() / per;
    state.counters["s_clear"] = clear.sum() / per;
    state.counters["s_mixed"] = mixed.sum() / per;
    state.counters["us_hidden"] = 1e6 * hidden.mean();
    state.counters["us_clear"] = 1e6 * clear.mean();
    state.counters["ms_mixed"] = 1e3 * mixed.mean();
    state.counters["ms_mixed_median"] = 1e3 * quantile(mixed.seconds, 0.5);
    state.counters["ms_mixed_p95"] = 1e3 * quantile(mixed.seconds, 0.95);
    state.counters["ms_mixed_max"] = 1e3 * quantile(mixed.seconds, 1);
    state.counters["maps"] = maps / mixed.count();
    state.counters["pieces"] = pieces / mixed.count();
    state.counters["nodes"] = nodes / mixed.count();
    state.counters["failed"] = failed;
  }
};

// Which patches take part.
enum class Who { kFronts, kBacks, kSky };
constexpr const char* kWhoNames[] = {"fronts", "backs", "backs-sky"};

std::vector<const Part*> chosen(const ElementTable3& table, Who who) {
  std::vector<const Part*> result;
  for (const Part& part : table.parts())
    if (part.patch.is_sky() ? who == Who::kSky : who != Who::kFronts || !part.is_back) result.push_back(&part);
  return result;
}

// |row sum - 1| of rows that see anything.
std::vector<double> closure_defects(const ElementTable3& table, const std::vector<double>& sums) {
  std::vector<double> defects;
  for (std::uint32_t i = 0; i < table.count(); ++i)
    if (table.has_row(i) && sums[i] > 0) defects.push_back(std::fabs(sums[i] / table.extent(i).value - 1));
  return defects;
}

void pairs(benchmark::State& state, Room3 room, const Division& division, double tolerance, Who who) {
  const ThreadLimit limit(1);
  const DefaultFloatingPoint arithmetic;
  const PreparedScene3 prepared = prepare(room_3(room, division.walls, division.boxes));
  const ElementTable3& table = *prepared.elements(Granularity::kElement);
  const std::vector<const Part*> parts = chosen(table, who);
  for (auto _ : state) {
    Tally tally;
    std::vector<double> sums(table.count() + std::size_t{1}, 0);
    Stopwatch watch;
    for (std::size_t a = 0; a < parts.size(); ++a) {
      PairRow3 row(prepared.measurer(), parts[a]->patch);
      for (std::size_t b = a + 1; b < parts.size(); ++b) {
        const Part &first = *parts[a], &second = *parts[b];
        const bool is_asked = table.has_row(first.label) || table.has_row(second.label);
        if (!is_asked || first.patch.surface == second.patch.surface) continue;
        const double measure = tally.measure(prepared, row, first, second, tolerance);
        sums[first.label] += measure;
        sums[second.label] += measure;
      }
    }
    state.SetIterationTime(watch.lap());
    tally.tell(state, 1);
    set_closure(state, closure_defects(table, sums));
  }
}

// The stages of one mixed pair. Other pairs add nothing.
class StagesOfPairs {
 public:
  StagesOfPairs(const PreparedScene3& prepared, double tolerance)
      : prepared_(prepared),
        tolerance_(tolerance),
        boxes_(prepared.occluders()),
        stretches_(prepared.occluders(), boxes_) {}

  void add(const Patch3& i, const Patch3& j) {
    const Occluders3& occluders = prepared_.occluders();
    Stopwatch watch;
    const PairOccluders3 setting(occluders, boxes_, i, j);
    const double classification = watch.lap();
    if (setting.sight != PairVisibility3::kMixed) return;
    benchmark::DoNotOptimize(unobstructed_measure(occluders.vertices(), i, j, tolerance_ / 4));
    const double alone = watch.lap();
    const std::vector<PairStretch3> stretches = pair_stretches(setting, stretches_, i, j);
    const double edges = watch.lap();
    StretchMapper3 mapper(setting.bodies);
    std::vector<StretchPiece3> pieces;
    for (const PairStretch3& stretch : stretches) {
      const std::size_t first = pieces.size();
      mapper.divide(stretch, pieces);
      for (std::size_t k = first; k < pieces.size(); ++k) mapper.make_arcs(stretch, pieces[k]);
    }
    const double maps = watch.lap();
    benchmark::DoNotOptimize(prepared_.measurer().measure(i, j, {.tolerance = tolerance_}));
    const double whole = watch.lap();
    const double parts[] = {classification, alone, edges, maps, whole - classification - alone - edges - maps};
    for (std::size_t k = 0; k < seconds_.size(); ++k) seconds_[k] += parts[k];
    whole_ += whole;
    ++mixed_;
    occluders_ += static_cast<double>(setting.bodies.bodies.size() - 2);
    edges_ += static_cast<double>(stretches.size());
  }

  double whole() const { return whole_; }

  void tell(benchmark::State& state) const {
    const char* const kNames[] = {"classification", "alone", "edges", "maps", "integration"};
    for (std::size_t k = 0; k < seconds_.size(); ++k)
      state.counters[std::string("share_") + kNames[k]] = 100 * seconds_[k] / whole_;
    state.counters["mixed"] = mixed_;
    state.counters["ms_mixed"] = 1e3 * whole_ / mixed_;
    state.counters["occluders"] = occluders_ / mixed_;
    state.counters["stretches"] = edges_ / mixed_;
  }

 private:
  const PreparedScene3& prepared_;
  double tolerance_;
  SurfaceBoxes3 boxes_;
  SurfaceStretches3 stretches_;
  std::array<double, 5> seconds_{};
  double whole_ = 0, mixed_ = 0, occluders_ = 0, edges_ = 0;
};

void stages(benchmark::State& state, Room3 room, const Division& division, double tolerance) {
  const ThreadLimit limit(1);
  const DefaultFloatingPoint arithmetic;
  const PreparedScene3 prepared = prepare(room_3(room, division.walls, division.boxes));
  const ElementTable3& table = *prepared.elements(Granularity::kElement);
  const std::vector<const Part*> parts = chosen(table, Who::kFronts);
  for (auto _ : state) {
    StagesOfPairs all(prepared, tolerance);
    for (std::size_t a = 0; a < parts.size(); ++a)
      for (std::size_t b = a + 1; b < parts.size(); ++b)
        if (surfaces_face_each_other(prepared.occluders(), *parts[a], *parts[b]))
          all.add(parts[a]->patch, parts[b]->patch);
    state.SetIterationTime(all.whole());
    all.tell(state);
  }
}

void town(benchmark::State& state, std::uint64_t buildings, int rows, double tolerance, Who who) {
  const ThreadLimit limit(1);
  const DefaultFloatingPoint arithmetic;
  const PreparedScene3 prepared = prepare(town_3(buildings));
  const ElementTable3& table = *prepared.elements(Granularity::kElement);
  const std::vector<const Part*> parts = chosen(table, who);
  std::vector<std::uint32_t> with_row;
  for (std::uint32_t i = 0; i < table.count(); ++i)
    if (table.has_row(i)) with_row.push_back(i);
  for (auto _ : state) {
    Dice3 dice(3);
    Tally tally;
    std::vector<double> seconds, of_sky, sums(table.count(), 0);
    for (int row = 0; row < rows; ++row) {
      const std::uint32_t i = with_row[static_cast<std::size_t>(dice.roll(0, static_cast<int>(with_row.size()) - 1))];
      const Part& first = table.parts(i).front();
      PairRow3 row_of_first(prepared.measurer(), first.patch);
      double sum = 0, sky = 0, others = 0;
      for (const Part* second : parts) {
        if (second->patch.surface == first.patch.surface) continue;
        Stopwatch watch;
        sum += tally.measure(prepared, row_of_first, first, *second, tolerance);
        (second->patch.is_sky() ? sky : others) += watch.lap();
      }
      seconds.push_back(others + sky);
      of_sky.push_back(sky);
      sums[i] = sum;
    }
    const double all = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    state.SetIterationTime(all);
    state.counters["s_row"] = all / rows;
    state.counters["s_row_median"] = quantile(seconds, 0.5);
    state.counters["s_row_max"] = quantile(seconds, 1);
    tally.tell(state, rows);
    if (who != Who::kSky) continue;
    state.counters["s_sky"] = std::accumulate(of_sky.begin(), of_sky.end(), 0.0) / rows;
    set_closure(state, closure_defects(table, sums));
  }
}

std::string to_string(Room3 room, const Division& division, double tolerance) {
  return fmt::format("/{}/elements:{}/tolerance:{}", benchmarks::to_string(room), rows_of(room, division), tolerance);
}

// Rooms that published figures exist for.
void add_centred_rooms() {
  for (const Division division : {Division{1, 1}, Division{4, 1}, Division{7, 2}, Division{10, 3}, Division{16, 6}})
    add_case("factors" + to_string(Room3::kCentred, division, 1e-6) + "/threads:1",
             [=](benchmark::State& state) { factors(state, Room3::kCentred, division, 1e-6, 1); });
}

void add_town(std::uint64_t buildings, int rows, double tolerance, Who who) {
  add_case(fmt::format("town/buildings:{}/tolerance:{}/{}", buildings, tolerance, kWhoNames[static_cast<int>(who)]),
           [=](benchmark::State& state) { town(state, buildings, rows, tolerance, who); });
}

void add_room(Room3 room) {
  const std::uint32_t boxes = room == Room3::kAxis ? 2 : 1;
  const Division as_in_the_file{8, boxes}, fine{16, room == Room3::kAxis ? 2 * boxes : 4 * boxes};
  for (const double tolerance : {1e-6, 1e-12})
    for (const int threads : {1, 2})
      add_case("factors" + to_string(room, as_in_the_file, tolerance) + "/threads:" + std::to_string(threads),
               [=](benchmark::State& state) { factors(state, room, as_in_the_file, tolerance, threads); });
  add_case("factors" + to_string(room, fine, 1e-12) + "/threads:2",
           [=](benchmark::State& state) { factors(state, room, fine, 1e-12, 2); });
  for (const double tolerance : {1e-6, 1e-12})
    for (const Who who : {Who::kFronts, Who::kBacks, Who::kSky})
      add_case("pairs" + to_string(room, as_in_the_file, tolerance) + "/" + kWhoNames[static_cast<int>(who)],
               [=](benchmark::State& state) { pairs(state, room, as_in_the_file, tolerance, who); });
  add_case("pairs" + to_string(room, fine, 1e-12) + "/fronts",
           [=](benchmark::State& state) { pairs(state, room, fine, 1e-12, Who::kFronts); });
  for (const double tolerance : {1e-6, 1e-12})
    add_case("stages" + to_string(room, as_in_the_file, tolerance),
             [=](benchmark::State& state) { stages(state, room, as_in_the_file, tolerance); });
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  for (const Room3 room : {Room3::kAxis, Room3::kTurned}) add_room(room);
  add_centred_rooms();
  for (const double tolerance : {1e-6, 1e-12}) {
    add_town(100, 20, tolerance, Who::kSky);
    add_town(500, 20, tolerance, Who::kBacks);
  }
  add_town(500, 4, 1e-6, Who::kSky);
  return run(argc, argv);
}
