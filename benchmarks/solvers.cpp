// What solving for radiosities costs: every solver, on clutter with short views of 100 to 10,000 edges whose faces all
// have one reflectivity of 0.1 to 0.999.
//
// Timed: the solver as it is, from the factors to its approximation. Counters: steps (iterations; for cholesky and cg,
// which are refined, corrections); milliseconds of the certificate that turns the approximation into proven bounds, the
// elimination or conjugate gradients that it needs included where the solver has none to share; the largest error of
// the approximation over the largest radiosity, against the certified solution; the widest relative bounds. The dense
// solvers stop at 2,000 unknowns; a solver that does not get to 1e-12 in 10,000 iterations (100,000 shots) is stopped
// there, which `true_error` shows.
#include <algorithm>
#include <cmath>

#include "benchmarks/clutter.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/radiosity/radiosity.h"

namespace hottel::benchmarks {
namespace {

constexpr std::size_t kMostDense = 2000;

bool is_dense(Solver solver) { return solver == Solver::kCholesky || solver == Solver::kLu; }

// A clutter whose faces reflect alike, and its factors.
struct Problem {
  std::vector<Material> materials;
  Spectrum sky;
  ExchangeMatrix matrix;

  Problem(std::uint64_t edges, const Rational& reflectivity) {
    const PreparedScene2 prepared = prepare(clutter(View::kShort, edges));
    materials = prepared.scene.materials;
    for (Material& material : materials) {
      material.reflectivity = Spectrum::scalar(reflectivity);
      material.emission = Spectrum::scalar(material.emission.value[0]);
    }
    matrix = exact_exchange(prepared, {.wants_visibility = false});
  }

  RadiositySolution solve(Solver solver) const {
    RadiosityOptions options;
    options.solver = solver;
    return solve_radiosity(matrix, materials, sky, options);
  }
};

double error_of(const RadiositySolution& solution, const RadiositySolution& certified) {
  double error = 0, largest = 0;
  for (std::size_t i = 0; i < certified.channels[0].elements.size(); ++i) {
    const double exact = certified.channels[0].elements[i].radiosity;
    error = std::max(error, std::abs(solution.channels[0].elements[i].radiosity - exact));
    largest = std::max(largest, exact);
  }
  return error / largest;
}

void solvers(benchmark::State& state, Solver solver, std::uint64_t edges, const std::string& reflectivity) {
  const Problem problem(edges, *parse_rational(reflectivity));
  const RadiositySolution certified = problem.solve(Solver::kAuto);
  if (is_dense(solver) && certified.unknowns > kMostDense) {
    state.SkipWithError("too many unknowns for a dense solver");
    return;
  }
  double certificate = 0;
  RadiositySolution solution;
  for (auto _ : state) {
    solution = problem.solve(solver);
    state.SetIterationTime(solution.seconds.at("radiosity"));
    certificate += solution.seconds.at("certificate");
  }
  state.counters["unknowns"] = solution.unknowns;
  state.counters["steps"] = static_cast<double>(solution.channels[0].residual_history.size()) - 1;
  state.counters["ms_certificate"] = 1e3 * certificate / static_cast<double>(state.iterations());
  state.counters["true_error"] = error_of(solution, certified);
  state.counters["bounds"] = solution.max_relative_width;
}

void add(Solver solver, std::uint64_t edges, const std::string& reflectivity) {
  add_case(
      std::string("solvers/") + to_string(solver) + "/edges:" + std::to_string(edges) + "/reflectivity:" + reflectivity,
      [=](benchmark::State& state) { solvers(state, solver, edges, reflectivity); });
}

}  // namespace
}  // namespace hottel::benchmarks

int main(int argc, char** argv) {
  using namespace hottel::benchmarks;
  using hottel::Solver;
  for (const std::uint64_t edges : {100, 1'000, 10'000})
    for (const char* reflectivity : {"0.1", "0.5", "0.9", "0.99", "0.999"})
      for (const Solver solver : {Solver::kCholesky, Solver::kCg, Solver::kLu, Solver::kBicgstab, Solver::kJacobi,
                                  Solver::kGaussSeidel, Solver::kShooting})
        add(solver, edges, reflectivity);
  return run(argc, argv);
}
