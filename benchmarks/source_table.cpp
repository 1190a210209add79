// What an old 3D system told of its view factors, done again: a cube with 1, 4, 16 and 64 faces a side, for which it
// took 0.00276 s to 240 s, saved 3 to 4 % by keeping centroids, and 47 to 50 % by symmetry. Beside it what it could not
// tell: how far off its factors were, and what it costs to do it otherwise. Everything on one thread.
//
//   cube         6, 24, 96 and 384 faces, of which none hides another
//   boxes        the same with two boxes in it, one of them turned, divided alike: 18, 72, 288 and 1152 faces
//
//   old          its way, in doubles: F_ij = A_j cos cos / (pi r^2) between centroids, for every ordered pair, where no
//                other face, tried one after the other, meets the segment between them. A pair that does not face each
//                other tries none. Centroids are the means of the corners, formed when they are needed
//   old_kept     the same with centroids formed once
//   old_half     the same as old for one of both orders, the other by A_i F_ij = A_j F_ji
//   old_both     the two together
//   tree         old_both, but the faces that may meet the segment are found in a tree of boxes
//   center       the method `center` of the library: the same numbers, what hides decided without rounding
//   exact        exact factors of the elements (a tolerance of 1e-9), with the backs and the sky among the columns
//   store        the same, read from a store that an earlier run wrote
//
// Times are those of the processor, which other work on the machine does not lengthen much, from what describes the
// faces (old, tree) or the prepared scene (the others) to all factors. `of_old` is a time over the median of those of
// `old` in the same run.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/clutter.h"
#include "benchmarks/folder.h"
#include "benchmarks/space_scenes.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/store/factor_store.h"
#include "kernel/support/parallel.h"
#include "solver/space/methods/method_catalogue.h"
#include "solver/space/simulation/simulation.h"

namespace hottel::benchmarks {
namespace {

constexpr double kTolerance = 1e-9;

Scene3 scene_of(bool has_boxes, std::uint32_t n) {
  SceneMaker3 maker;
  maker.add_room({1, 1, 1}, n);
  if (has_boxes) {
    maker.add_box({{ratio(3, 10), ratio(3, 10), ratio(3, 10)}, {ratio(3, 10), ratio(2, 5), ratio(1, 4)}}, n);
    maker.add_box(
        {{ratio(13, 20), ratio(13, 20), ratio(11, 20)}, {ratio(1, 4), ratio(3, 10), ratio(2, 5)}, {4, 1, 0, 2}}, n);
  }
  return maker.take();
}

// The processor time of all threads since it was asked last.
class ProcessorWatch {
 public:
  ProcessorWatch() { lap(); }
  double lap() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    const double seconds = static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    return seconds - std::exchange(last_, seconds);
  }

 private:
  double last_ = 0;
};

// --- the old way ---------------------------------------------------------------------------------------------------

struct Vector {
  double x = 0, y = 0, z = 0;
};
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Quad {
  std::array<Vector, 4> corners;
  Vector normal;  // of length 1
  double area = 0;
};

Vector centroid_of(const Quad& quad) {
  Vector sum;
  for (const Vector& corner : quad.corners) sum = {sum.x + corner.x, sum.y + corner.y, sum.z + corner.z};
  return {sum.x / 4, sum.y / 4, sum.z / 4};
}

// Whether a quad meets the open segment from p to q.
bool meets(const Quad& quad, const Vector& p, const Vector& q) {
  const double before = dot(quad.normal, p - quad.corners[0]), after = dot(quad.normal, q - quad.corners[0]);
  if (before * after >= 0) return false;
  const double t = before / (before - after);
  const Vector at{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)};
  for (std::size_t k = 0; k < 4; ++k)
    if (dot(quad.normal, cross(quad.corners[(k + 1) % 4] - quad.corners[k], at - quad.corners[k])) < 0) return false;
  return true;
}

// All faces, tried one after the other.
class EveryFace {
 public:
  explicit EveryFace(const std::vector<Quad>& quads) : quads_(quads) {}
  bool is_free(std::size_t i, std::size_t j, const Vector& p, const Vector& q) const {
    for (std::size_t k = 0; k < quads_.size(); ++k)
      if (k != i && k != j && meets(quads_[k], p, q)) return false;
    return true;
  }

 private:
  const std::vector<Quad>& quads_;
};

// The same through a tree of boxes, cut at the median along the longest side.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Quad>& quads) : quads_(quads), order_(quads.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    build(0, quads.size());
  }
  bool is_free(std::size_t i, std::size_t j, const Vector& p, const Vector& q) const {
    std::array<std::size_t, 64> open;
    std::size_t count = 1;
    open[0] = 0;
    while (count > 0) {
      const Node& node = nodes_[open[--count]];
      if (!crosses(node, p, q)) continue;
      if (node.second == 0) {
        for (std::size_t k = node.begin; k < node.end; ++k)
          if (order_[k] != i && order_[k] != j && meets(quads_[order_[k]], p, q)) return false;
      } else {
        open[count++] = node.first;
        open[count++] = node.second;
      }
    }
    return true;
  }

 private:
  struct Node {
    std::array<double, 3> low{}, high{};
    std::size_t begin = 0, end = 0, first = 0, second = 0;  // second 0: a leaf
  };
  static std::array<double, 3> numbers(const Vector& v) { return {v.x, v.y, v.z}; }

  std::size_t build(std::size_t begin, std::size_t end) {
    constexpr std::size_t kLeaf = 4;
    const std::size_t place = nodes_.size();
    nodes_.emplace_back();
    Node node{.begin = begin, .end = end};
    node.low.fill(1e300);
    node.high.fill(-1e300);
    for (std::size_t k = begin; k < end; ++k)
      for (const Vector& corner : quads_[order_[k]].corners)
        for (std::size_t axis = 0; axis < 3; ++axis) {
          node.low[axis] = std::min(node.low[axis], numbers(corner)[axis]);
          node.high[axis] = std::max(node.high[axis], numbers(corner)[axis]);
        }
    if (end - begin > kLeaf) {
      std::size_t longest = 0;
      for (std::size_t axis = 1; axis < 3; ++axis)
        if (node.high[axis] - node.low[axis] > node.high[longest] - node.low[longest]) longest = axis;
      const auto first = order_.begin() + static_cast<std::ptrdiff_t>(begin);
      const std::size_t middle = (begin + end) / 2;
      std::nth_element(first, order_.begin() + static_cast<std::ptrdiff_t>(middle),
                       order_.begin() + static_cast<std::ptrdiff_t>(end), [&](std::size_t a, std::size_t b) {
                         return std::pair(numbers(centroid_of(quads_[a]))[longest], a) <
                                std::pair(numbers(centroid_of(quads_[b]))[longest], b);
                       });
      node.first = build(begin, middle);
      node.second = build(middle, end);
    }
    nodes_[place] = node;
    return place;
  }

  static bool crosses(const Node& node, const Vector& p, const Vector& q) {
    const std::array<double, 3> from = numbers(p), way = numbers(q - p);
    double enter = 0, leave = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (way[axis] == 0) {
        if (from[axis] < node.low[axis] || from[axis] > node.high[axis]) return false;
        continue;
      }
      const double a = (node.low[axis] - from[axis]) / way[axis], b = (node.high[axis] - from[axis]) / way[axis];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave * (1 + 1e-12) + 1e-12;
  }

  const std::vector<Quad>& quads_;
  std::vector<std::size_t> order_;
  std::vector<Node> nodes_;
};

// Factors row by row.
using Table = std::vector<double>;

template <class Hiding>
double factor(const std::vector<Quad>& quads, const Hiding& hiding, std::size_t i, std::size_t j, const Vector& p,
              const Vector& q) {
  const Vector way = q - p;
  const double square = dot(way, way), here = dot(quads[i].normal, way), there = -dot(quads[j].normal, way);
  if (here <= 0 || there <= 0 || !hiding.is_free(i, j, p, q)) return 0;
  return quads[j].area * here * there / (std::numbers::pi * square * square);
}

template <class Hiding>
Table factors_by(const std::vector<Quad>& quads, const Hiding& hiding, bool keeps_centroids, bool uses_symmetry) {
  const std::size_t n = quads.size();
  std::vector<Vector> kept;
  if (keeps_centroids) std::transform(quads.begin(), quads.end(), std::back_inserter(kept), centroid_of);
  const auto centroid = [&](std::size_t k) { return keeps_centroids ? kept[k] : centroid_of(quads[k]); };
  Table table(n * n, 0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = uses_symmetry ? i + 1 : 0; j < n; ++j) {
      if (i == j) continue;
      const double value = factor(quads, hiding, i, j, centroid(i), centroid(j));
      table[i * n + j] = value;
      if (uses_symmetry) table[j * n + i] = value * quads[i].area / quads[j].area;
    }
  return table;
}

// --- a scene, divided ----------------------------------------------------------------------------------------------

struct Divided {
  std::shared_ptr<const PreparedScene3> prepared;
  Scene3 scene;
  std::vector<std::uint32_t> rows;  // labels of the faces
  std::vector<Quad> quads;
  Table exact;
  std::vector<double> to_others;  // what of the exact row goes elsewhere: to backs and the sky

  Divided(bool has_boxes, std::uint32_t n) : scene(scene_of(has_boxes, n)) {
    prepared = std::make_shared<const PreparedScene3>(prepare(scene));
    const ElementTable3 table(scene, prepared->arrangement(), prepared->occluders(), Granularity::kElement);
    const auto corners = element_corners(table, prepared->occluders().vertices());
    for (std::uint32_t label = 0; label < table.count(); ++label) {
      if (!table.has_row(label)) continue;
      rows.push_back(label);
      Quad quad;
      for (std::size_t k = 0; k < 4; ++k)
        quad.corners[k] = {corners[label][k][0], corners[label][k][1], corners[label][k][2]};
      const Vector area = cross(quad.corners[1] - quad.corners[0], quad.corners[3] - quad.corners[0]);
      quad.area = std::sqrt(dot(area, area));
      quad.normal = {area.x / quad.area, area.y / quad.area, area.z / quad.area};
      quads.push_back(quad);
    }
    exact = table_of(exact_matrix(), &to_others);
  }

  ExchangeMatrix exact_matrix() const {
    ExchangeRequest request;
    request.granularity = Granularity::kElement;
    request.tolerance = kTolerance;
    return exact_exchange(*prepared, request, nullptr);
  }

  Table table_of(const ExchangeMatrix& matrix, std::vector<double>* others = nullptr) const {
    std::vector<std::size_t> place(matrix.size() + 1, rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) place[rows[k]] = k;
    Table table(rows.size() * rows.size(), 0);
    if (others != nullptr) others->assign(rows.size(), 0);
    for (std::size_t k = 0; k < rows.size(); ++k)
      for (const FactorEntry& entry : matrix.row(rows[k])) {
        const std::size_t to = place[entry.to];
        if (to < rows.size())
          table[k * rows.size() + to] = entry.factor.value;
        else if (others != nullptr)
          (*others)[k] += entry.factor.value;
      }
    return table;
  }
};

const Divided& divided(bool has_boxes, std::uint32_t n) {
  static std::map<std::pair<bool, std::uint32_t>, std::unique_ptr<const Divided>> made;
  std::unique_ptr<const Divided>& result = made[{has_boxes, n}];
  if (!result) result = std::make_unique<const Divided>(has_boxes, n);
  return *result;
}

// Errors over the ordered pairs that exchange light by either, and rows.
void tell(benchmark::State& state, const Divided& scene, const Table& table, double seconds, double seconds_old) {
  const std::size_t n = scene.rows.size();
  double largest = 0, squares = 0, count = 0, row_defect = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double sum = scene.to_others[i];
    for (std::size_t j = 0; j < n; ++j) {
      const double value = table[i * n + j], error = std::fabs(value - scene.exact[i * n + j]);
      sum += value;
      if (value == 0 && scene.exact[i * n + j] == 0) continue;
      largest = std::max(largest, error);
      squares += error * error;
      ++count;
    }
    row_defect = std::max(row_defect, std::fabs(sum - 1));
  }
  state.counters["faces"] = static_cast<double>(n);
  state.counters["factors"] = count;
  state.counters["of_old"] = seconds / seconds_old;
  state.counters["max_error"] = largest;
  state.counters["rms_error"] = count > 0 ? std::sqrt(squares / count) : 0;
  state.counters["worst_row"] = row_defect;
}

using Way = std::function<Table(const Divided&, double& seconds)>;

template <class Make>
Way in_doubles(bool keeps_centroids, bool uses_symmetry, Make make) {
  return [=](const Divided& scene, double& seconds) {
    ProcessorWatch watch;
    const auto hiding = make(scene.quads);
    Table table = factors_by(scene.quads, hiding, keeps_centroids, uses_symmetry);
    seconds = watch.lap();
    return table;
  };
}

Table by_center(const Divided& scene, double& seconds) {
  const auto method = methods_3().make("center");
  MethodReport report;
  ProcessorWatch watch;
  const ExchangeMatrix matrix = method->compute(*scene.prepared, {.granularity = Granularity::kElement}, report);
  seconds = watch.lap();
  return scene.table_of(matrix);
}

Table by_exact(const Divided& scene, double& seconds) {
  ProcessorWatch watch;
  const ExchangeMatrix matrix = scene.exact_matrix();
  seconds = watch.lap();
  return scene.table_of(matrix);
}

Table by_store(const Divided& scene, double& seconds) {
  static const Folder folder("source_table");
  static std::map<const Divided*, std::string> written;
  const auto simulate = [&](const std::string& file) {
    const Simulation3 simulation(
        scene.scene,
        {.factors = {.granularity = Granularity::kElement, .tolerance = kTolerance, .store = open_factor_store(file)}});
    simulation.prepared();
    ProcessorWatch watch;
    const auto factors = simulation.factors();
    seconds = watch.lap();
    return factors;
  };
  std::string& file = written[&scene];
  if (file.empty()) {
    file = folder.file(fmt::format("{}.store", written.size()));
    simulate(file);
  }
  return scene.table_of(simulate(file)->matrix);
}

Way old_way() {
  return in_doubles(false, false, [](const std::vector<Quad>& quads) { return EveryFace(quads); });
}

double seconds_of(const Divided& scene, const Way& way) {
  double seconds = 0;
  way(scene, seconds);
  return seconds;
}

// What the old way took each time. Times of fewer iterations than the most were for finding how many it takes.
class OldTimes {
 public:
  void add(benchmark::IterationCount iterations, double seconds) {
    if (iterations > iterations_) seconds_.clear();
    iterations_ = std::max(iterations_, iterations);
    if (iterations == iterations_) seconds_.push_back(seconds);
  }
  double median() const { return quantile(seconds_, 0.5); }

 private:
  benchmark::IterationCount iterations_ = 0;
  std::vector<double> seconds_;
};

void measure(benchmark::State& state, bool has_boxes, std::uint32_t n, bool is_old, const Way& way) {
  const ThreadLimit limit(1);
  const Divided& scene = divided(has_boxes, n);
  double sum = 0;
  Table table;
  for (auto _ : state) {
    double seconds = 0;
    table = way(scene, seconds);
    state.SetIterationTime(seconds);
    sum += seconds;
  }
  const double seconds = sum / static_cast<double>(state.iterations());
  static std::map<const Divided*, OldTimes> of_old;
  if (is_old) of_old[&scene].add(state.iterations(), seconds);
  tell(state, scene, table, seconds, of_old.contains(&scene) ? of_old[&scene].median() : seconds_of(scene, old_way()));
}

void add_cases(bool has_boxes, std::uint32_t n) {
  const auto every = [](const std::vector<Quad>& quads) { return EveryFace(quads); };
  const auto tree = [](const std::vector<Quad>& quads) { return BoxTree(quads); };
  const std::pair<const char*, Way> ways[] = {{"old", old_way()},
                                              {"old_kept", in_doubles(true, false, every)},
                                              {"old_half", in_doubles(false, true, every)},
                                              {"old_both", in_doubles(true, true, every)},
                                              {"tree", in_doubles(true, true, tree)},
                                              {"center", by_center},
                                              {"exact", by_exact},
                                              {"store", by_store}};
  const std::uint32_t faces = (has_boxes ? 18 : 6) * n * n;
  for (const auto& [name, way] : ways)
    add_case(fmt::format("{}/faces:{}/{}", has_boxes ? "boxes" : "cube", faces, name),
             [=](benchmark::State& state) { measure(state, has_boxes, n, name == std::string("old"), way); });
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  for (const bool has_boxes : {false, true})
    for (const std::uint32_t n : {1, 2, 4, 8}) add_cases(has_boxes, n);
  return run(argc, argv);
}
