// What it costs to test a few points of each element instead of seeing what a light shines on: errors of both tests
// against the exact lights of the same elements, as a table of docs/accuracy.md.
//
//   report_light_tests SCENE MOST      1, 2, 4, ... MOST elements an edge, or along each side of a face
//
// Errors of D are fractions of the largest exact D of the same elements in any channel, their mean square is over the
// area; those of radiosities fractions of the largest exact one. Both use the same factors: exact ones in the plane,
// those of points:1 in space. `power` is what the shares have too much (+) or lack (-), of all lights together.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include "io/scene/scene_json.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/radiosity/direct_light.h"
#include "solver/space/methods/method_catalogue.h"
#include "solver/space/simulation/simulation.h"

namespace hottel {
namespace {

// What the lights make of a scene by one test.
struct Lit {
  std::vector<std::vector<double>> direct;  // D by element with a row, by channel
  std::vector<double> area;
  std::shared_ptr<const RadiositySolution> solution;
  double power = 0;  // the shares of all lights, weighed by their power
};

template <class Simulation>
Lit lit_by(const Simulation& simulation, LightTest test) {
  auto request = simulation.request();
  request.lights = test;
  const Simulation tested = simulation.with_request(request);
  const auto factors = tested.factors();
  const auto shares = tested.light_shares();
  Lit result;
  result.solution = tested.radiosities();
  const auto& lights = tested.scene().lights;
  const auto middle = [](const Enclosure& share) { return share.lower + share.width() / 2; };
  for (std::uint32_t i = 0; i < factors->matrix.size(); ++i) {
    if (!factors->matrix.has_row(i)) continue;
    result.area.push_back(factors->matrix.elements()[i].area.value);
    std::vector<double>& direct = result.direct.emplace_back(3, 0.0);
    for (std::size_t k = 0; k < lights.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c)
        direct[c] += middle((*shares)[k].of_element[i]) * to_double(lights[k].power.value[c]) / result.area.back();
  }
  double all = 0;
  for (std::size_t k = 0; k < lights.size(); ++k) {
    double power = 0, sum = middle((*shares)[k].sky);
    for (const Rational& value : lights[k].power.value) power += to_double(value);
    for (const Enclosure& share : (*shares)[k].of_element) sum += middle(share);
    all += power;
    result.power += power * sum;
  }
  result.power /= all;
  return result;
}

struct Errors {
  double largest = 0, mean_square = 0, of_radiosity = 0, power = 0;
};

Errors errors_of(const Lit& tested, const Lit& exact) {
  Errors errors;
  double bright = 0, area = 0;
  for (std::size_t i = 0; i < exact.direct.size(); ++i) {
    area += exact.area[i];
    for (std::size_t c = 0; c < 3; ++c) {
      const double error = std::fabs(tested.direct[i][c] - exact.direct[i][c]);
      bright = std::max(bright, exact.direct[i][c]);
      errors.largest = std::max(errors.largest, error);
      errors.mean_square += exact.area[i] * error * error / 3;
    }
  }
  errors.largest /= bright;
  errors.mean_square = std::sqrt(errors.mean_square / area) / bright;
  for (std::size_t c = 0; c < exact.solution->channels.size(); ++c)
    for (std::size_t i = 0; i < exact.solution->channels[c].elements.size(); ++i)
      errors.of_radiosity = std::max(errors.of_radiosity, std::fabs(tested.solution->channels[c].elements[i].radiosity -
                                                                    exact.solution->channels[c].elements[i].radiosity));
  errors.of_radiosity /= largest_radiosity(*exact.solution);
  errors.power = tested.power - exact.power;
  return errors;
}

template <class Simulation>
void print_row(std::uint32_t n, const Simulation& simulation) {
  const Lit exact = lit_by(simulation, LightTest::kExact);
  std::string line = fmt::format("| {} | {} |", n, exact.direct.size());
  for (const LightTest test : {LightTest::kCentroid, LightTest::kVertices}) {
    const Errors errors = errors_of(lit_by(simulation, test), exact);
    line += fmt::format(" {:.2g} | {:.2g} | {:.2g} | {:+.2g} % |", errors.largest, errors.mean_square,
                        errors.of_radiosity, 100 * errors.power);
  }
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

template <class Scene>
Scene divided(Scene scene, std::uint32_t n) {
  for (Surface& surface : scene.surfaces) surface.elements = n;
  return scene;
}

void print_table(const Scene& scene, std::uint32_t most) {
  std::puts(
      "| n | elements | centroid: largest error of D | rms | radiosity | power | vertices: largest error of D | rms | "
      "radiosity | power |\n|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
  for (std::uint32_t n = 1; n <= most; n *= 2) {
    if (const auto* plane = std::get_if<Scene2>(&scene)) {
      print_row(n, Simulation2(divided(*plane, n), {.granularity = Granularity::kElement}));
    } else {
      const std::shared_ptr<const ExchangeMethod3> method = methods_3().make("points:1");
      print_row(n, Simulation3(divided(std::get<Scene3>(scene), n),
                               {.factors = {.method = method, .granularity = Granularity::kElement}}));
    }
  }
}

}  // namespace
}  // namespace hottel

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "report_light_tests SCENE MOST\n");
    return 2;
  }
  try {
    hottel::print_table(hottel::changeable(hottel::read_scene(argv[1])),
                        static_cast<std::uint32_t>(std::atoi(argv[2])));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
