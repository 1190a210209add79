// What dividing the faces costs and brings: radiosities of 1 to 256 elements an edge against the finest division.
//
// Each case prepares the scene, computes exact factors of its elements and solves for radiosities with proven bounds.
// The reference is the same with two to four times as many elements as the finest case. Errors are fractions of the
// largest radiosity of the reference: of the mean over each face, of the radiosity at each place (the largest, and the
// root of the mean square over the length of all faces). An order p says that the error falls like (elements an
// edge)^-p, from the case with half as many elements to this one.
#include <algorithm>
#include <cmath>
#include <map>

#include "benchmarks/clutter.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/stopwatch.h"
#include "solver/radiosity/radiosity.h"

namespace hottel::benchmarks {
namespace {

// A scene by the radiosities of its elements, each edge in `elements` equal ones. Channels are averaged.
struct DividedRoom {
  std::uint32_t elements = 1;
  std::vector<Element> labels;
  std::vector<double> radiosity, area;
  double bounds = 0;  // widest relative bounds, proven
  std::uint64_t pairs = 0;
};

DividedRoom solve_divided(Scene2 scene, std::uint32_t elements) {
  for (Surface& surface : scene.surfaces) surface.elements = elements;
  const PreparedScene2 prepared = prepare(std::move(scene), Divided2::kYes);
  const ExchangeMatrix matrix =
      exact_exchange(prepared, {.granularity = Granularity::kElement, .wants_visibility = false});
  const RadiositySolution solution = solve_radiosity(matrix, prepared.scene.materials, prepared.scene.sky_emission);
  DividedRoom result{elements, matrix.elements(), {}, {}, solution.max_relative_width, matrix.entry_count() / 2};
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    double sum = 0;
    for (const ChannelSolution& channel : solution.channels) sum += channel.elements[i].radiosity;
    result.radiosity.push_back(sum / static_cast<double>(solution.channels.size()));
    result.area.push_back(matrix.has_row(i) ? matrix.elements()[i].area.value : 0);
  }
  return result;
}

struct Errors {
  double of_means = 0, largest = 0, root_mean_square = 0;
};

// REQUIRES that the reference divides each element of `coarse` into equally many. Elements of one face follow each
// other in both.
Errors errors_against(const DividedRoom& reference, const DividedRoom& coarse) {
  const double brightest = *std::max_element(reference.radiosity.begin(), reference.radiosity.end());
  Errors errors;
  double squares = 0, length = 0;
  std::size_t fine = 0;
  for (std::size_t first = 0; first < coarse.labels.size(); first += coarse.labels[first].parts) {
    const std::uint32_t parts = coarse.labels[first].parts, ratio = reference.labels[fine].parts / parts;
    double area = 0, coarse_power = 0, fine_power = 0;
    for (std::uint32_t part = 0; part < parts; ++part)
      for (std::uint32_t k = 0; k < ratio; ++k, ++fine) {
        const double difference = std::abs(coarse.radiosity[first + part] - reference.radiosity[fine]) / brightest;
        if (reference.area[fine] > 0) errors.largest = std::max(errors.largest, difference);
        squares += reference.area[fine] * difference * difference;
        area += reference.area[fine];
        coarse_power += reference.area[fine] * coarse.radiosity[first + part];
        fine_power += reference.area[fine] * reference.radiosity[fine];
      }
    length += area;
    if (area > 0) errors.of_means = std::max(errors.of_means, std::abs(coarse_power - fine_power) / area / brightest);
  }
  errors.root_mean_square = std::sqrt(squares / length);
  return errors;
}

struct Case {
  std::string name, file;
  std::uint32_t finest = 1, reference = 1;  // elements an edge, of the finest case and of what it is held against

  const Scene2& scene() const {
    static std::map<std::string, Scene2> scenes;
    if (!scenes.contains(name)) scenes[name] = read_scene_2(file);
    return scenes.at(name);
  }
  const DividedRoom& solved_finely() const {
    static std::map<std::string, DividedRoom> references;
    if (!references.contains(name)) references[name] = solve_divided(scene(), reference);
    return references.at(name);
  }
};

double order(double before, double now) { return now > 0 ? std::log2(before / now) : 0; }

void discretisation(benchmark::State& state, const Case& of, std::uint32_t elements) {
  const DividedRoom& reference = of.solved_finely();
  DividedRoom solved;
  for (auto _ : state) {
    Stopwatch watch;
    solved = solve_divided(of.scene(), elements);
    state.SetIterationTime(watch.lap());
  }
  const Errors now = errors_against(reference, solved);
  const auto add = [&](const char* name, double value) { state.counters[name] = value; };
  add("pairs", static_cast<double>(solved.pairs));
  add("error_of_means", now.of_means);
  add("largest_error", now.largest);
  add("rms_error", now.root_mean_square);
  const bool has_before = elements > 1;
  const Errors before = has_before ? errors_against(reference, solve_divided(of.scene(), elements / 2)) : Errors{};
  add("order_of_means", has_before ? order(before.of_means, now.of_means) : 0);
  add("order_largest", has_before ? order(before.largest, now.largest) : 0);
  add("order_rms", has_before ? order(before.root_mean_square, now.root_mean_square) : 0);
  add("bounds", solved.bounds);
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  for (const Case& of : {Case{"square", "scenes/analytic/square_radiosity.json", 256, 1024},
                         Case{"apartment", "scenes/showcase/apartment.json", 16, 32}})
    for (std::uint32_t elements = 1; elements <= of.finest; elements *= 2)
      add_case("discretisation/" + of.name + "/elements:" + std::to_string(elements),
               [=](benchmark::State& state) { discretisation(state, of, elements); });
  return run(argc, argv);
}
