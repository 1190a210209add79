// Drives hard cases into their degeneracy, over sixty orders of magnitude, and writes docs/hard_cases.md: the error of
// the exact method and of the methods that most codes use, against closed forms at 1024 bits.
//
//   report_hard_cases FOLDER      FOLDER/hard_cases.md, FOLDER/hard_cases.csv, FOLDER/images/hard_case_*.png
#include <fmt/format.h>
#include <gmpxx.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/files/output_file.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/radiosity/radiosity.h"
#include "viewer/picture/log_plot.h"

namespace hottel {
namespace {

using Real = mpf_class;
constexpr unsigned kBits = 1024;

Real real(double value) { return Real(value, kBits); }
Real root(const Real& value) { return Real(sqrt(value), kBits); }
Real power_of_ten(int exponent) {
  Real result(1, kBits);
  for (int k = 0; k < std::abs(exponent); ++k) result *= 10;
  return exponent < 0 ? Real(1 / result, kBits) : result;
}

// One hard case: a scene for each d = 10^exponent, one of its factors, and that factor in closed form.
struct HardCase {
  std::string name, title, story, closed_form;
  std::string from, to;
  std::function<std::string(const std::string& d)> edges;  // d as typed: "1e-7"
  std::function<Real(const Real& d)> factor;
  int direction = -1;  // exponents 0, -1, ..., -60; or +1: 0, 1, ..., 60
  std::string parameter;
};

std::string edge(const std::string& name, const std::string& a, const std::string& b) {
  return fmt::format(R"({{"name": "{}", "points": [[{}], [{}]], "material": "m"}})", name, a, b);
}

// An exact decimal: base - d, for d = 10^-k.
std::string less(int base, const std::string& d) {
  const Rational value = Rational(base) - *parse_rational(d);
  return '"' + to_string(value) + '"';
}
std::string less_half(int base, const std::string& d) {
  const Rational value = Rational(base) - *parse_rational(d) / 2;
  return '"' + to_string(value) + '"';
}
std::string more(int base, const std::string& d) {
  const Rational value = Rational(base) + *parse_rational(d);
  return '"' + to_string(value) + '"';
}

const std::vector<HardCase>& hard_cases() {
  static const std::string room = edge("left", "0, 0", "0, 4") + ", " + edge("top", "0, 4", "4, 4") + ", " +
                                  edge("right", "4, 4", "4, 0") + ", " + edge("bottom", "4, 0", "0, 0");
  static const std::vector<HardCase> cases = {
      {"crack", "A crack of width d in a wall",
       "A room of side 4 is halved by a wall with a crack of width d in its middle. The light that gets through "
       "is proportional to d, and none for d = 0.",
       "F(bottom, top) = (sqrt(8) - sqrt(4 + (2 - d)^2)) / 4", "bottom", "top",
       [](const std::string& d) {
         return room + ", " + edge("wall", "0, 2", "2, 2") + ", " + edge("other", more(2, d) + ", 2", "4, 2");
       },
       [](const Real& d) { return Real((root(real(8)) - root(4 + (2 - d) * (2 - d))) / 4, kBits); }, -1, "d"},
      {"leak", "A partition that misses the ceiling by d",
       "A slanted partition from the floor ends at distance about d below the ceiling of a room of side 4. The view "
       "factor between left and right wall is proportional to d²: 10⁻¹²⁰ for the smallest d.",
       "F(left, right) = (sqrt((3 - d/2)^2 + d^2) + sqrt((1 + d/2)^2 + d^2) - 4) / 8", "left", "right",
       [](const std::string& d) {
         return room + ", " + edge("partition", "1, 0", less_half(3, d) + ", " + less(4, d));
       },
       [](const Real& d) {
         const Real a = 3 - d / 2, b = 1 + d / 2;
         return Real((root(a * a + d * d) + root(b * b + d * d) - 4) / 8, kBits);
       },
       -1, "d"},
      {"gap", "What escapes between close plates",
       "Two unit plates face each other at distance d. Nearly all light stays between them; what escapes to the sky is "
       "proportional to d.",
       "F(lower, sky) = 1 + d - sqrt(1 + d^2)", "lower", "sky",
       [](const std::string& d) { return edge("lower", "1, 0", "0, 0") + ", " + edge("upper", "0, " + d, "1, " + d); },
       [](const Real& d) { return Real(1 + d - root(1 + d * d), kBits); }, -1, "d"},
      {"wedge", "What escapes from a wedge that closes",
       "Two plates meet in an edge at an angle of about d. What escapes to the sky is proportional to d.",
       "F(lower, sky) = (1 + d - sqrt(1 + d^2)) / 2", "lower", "sky",
       [](const std::string& d) { return edge("lower", "1, 0", "0, 0") + ", " + edge("upper", "0, 0", "1, " + d); },
       [](const Real& d) { return Real((1 + d - root(1 + d * d)) / 2, kBits); }, -1, "d"},
      {"flat", "A wall that is nearly straight",
       "Two plates of length 1 meet end to end, with a kink of angle d. The view factor between them is about d²/8.",
       "F(first, second) = (1 + sqrt(1 + d^2) - sqrt(4 + d^2)) / 2", "first", "second",
       [](const std::string& d) { return edge("first", "1, 0", "0, 0") + ", " + edge("second", "2, " + d, "1, 0"); },
       [](const Real& d) { return Real((1 + root(1 + d * d) - root(4 + d * d)) / 2, kBits); }, -1, "d"},
      {"small", "A plate that shrinks",
       "A plate of length 2 d, centred above a plate of length 2 at distance 1. Its smallest size is 10⁻⁶⁰ of "
       "the other plate's.",
       "F(large, small) = (sqrt(1 + (1 + d)^2) - sqrt(1 + (1 - d)^2)) / 2", "large", "small",
       [](const std::string& d) {
         return edge("large", "1, 0", "-1, 0") + ", " + edge("small", "-" + d + ", 1", d + ", 1");
       },
       [](const Real& d) { return Real((root(1 + (1 + d) * (1 + d)) - root(1 + (1 - d) * (1 - d))) / 2, kBits); }, -1,
       "d"},
      {"far", "Plates that move apart", "Two unit plates face each other at distance d, up to 10⁶⁰ times their length.",
       "F(lower, upper) = sqrt(1 + d^2) - d", "lower", "upper",
       [](const std::string& d) { return edge("lower", "1, 0", "0, 0") + ", " + edge("upper", "0, " + d, "1, " + d); },
       [](const Real& d) { return Real(1 / (root(1 + d * d) + d), kBits); }, +1, "d"},
  };
  return cases;
}

const std::vector<std::string> kMethods = {"exact",  "arithmetic:doubles", "arithmetic:naive", "strings", "gauss:8",
                                           "center", "hemicube:256",       "rays:10000"};
constexpr int kDecades = 60;
constexpr double kBroken = 1e-6;  // a relative error that nobody would call a rounding error

// |value - reference| / reference.
double relative_error(double value, const Real& reference) {
  if (std::isnan(value)) return value;
  const Real error(abs(Real(value, kBits) - reference) / reference, kBits);
  return error.get_d();
}

struct Curve {
  std::string method;
  std::vector<double> errors;  // by decade
};

struct Result {
  const HardCase* hard;
  std::vector<Curve> curves;
};

std::string decade(const HardCase& hard, int k) { return fmt::format("1e{}", hard.direction * k); }

Result sweep(const HardCase& hard, const MethodCatalogue2& methods) {
  Result result{&hard, {}};
  std::vector<std::unique_ptr<ExchangeMethod2>> makers;
  for (const std::string& name : kMethods) {
    makers.push_back(methods.make(name));
    result.curves.push_back({name, {}});
  }
  for (int k = 0; k <= kDecades; ++k) {
    const std::string d = decade(hard, k);
    const std::string text =
        R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, "edges": [)" + hard.edges(d) + "]}";
    const PreparedScene2 prepared = prepare(parse_scene_2(text, hard.name + " " + d));
    const Real reference = hard.factor(power_of_ten(hard.direction * k));
    for (std::size_t m = 0; m < makers.size(); ++m) {
      MethodReport report;
      const ExchangeMatrix matrix = makers[m]->compute(prepared, {.granularity = Granularity::kElement}, report);
      const double value = matrix.factor(*matrix.find(hard.from), *matrix.find(hard.to)).value;
      result.curves[m].errors.push_back(relative_error(value, reference));
    }
  }
  return result;
}

LogPlot plot_of(const Result& result) {
  LogPlot plot;
  plot.width = 1200;
  plot.height = 640;
  plot.title = result.hard->title;
  plot.subtitle = result.hard->closed_form;
  plot.x_title = result.hard->parameter;
  plot.y_title = "relative error of the view factor";
  for (const Curve& curve : result.curves) {
    LogPlotCurve drawn{curve.method, {}};
    for (std::size_t k = 0; k < curve.errors.size(); ++k)
      drawn.points.push_back(
          {std::pow(10, result.hard->direction * static_cast<double>(k)), std::min(curve.errors[k], 1e3)});
    plot.curves.push_back(drawn);
  }
  return plot;
}

// The largest error, and where the error first exceeds kBroken.
std::string row_of(const Result& result, const Curve& curve) {
  double largest = 0;
  int broken = -1;
  for (std::size_t k = 0; k < curve.errors.size(); ++k) {
    const double error = std::isnan(curve.errors[k]) ? HUGE_VAL : curve.errors[k];
    largest = std::max(largest, error);
    if (broken < 0 && error > kBroken) broken = static_cast<int>(k);
  }
  return fmt::format(
      "| `{}` | {:.1e} | {} |\n", curve.method, largest,
      broken < 0 ? "never" : fmt::format("{} = {}", result.hard->parameter, decade(*result.hard, broken)));
}

// Reflectivity towards 1
// ------------------------------------------------------------------------------------------------

constexpr int kLeastBits = 4, kMostBits = 50;

// The unit square, one element a side, E = 1 on the bottom, in the symmetric unknowns bottom, side, top.
std::vector<Real> square_radiosities(const Real& rho) {
  const Real opposite = root(real(2)) - 1, adjacent = 1 - root(real(2)) / 2;
  std::vector<std::vector<Real>> a = {
      {real(1), Real(-2 * rho * adjacent, kBits), Real(-rho * opposite, kBits), real(1)},
      {Real(-rho * adjacent, kBits), Real(1 - rho * opposite, kBits), Real(-rho * adjacent, kBits), real(0)},
      {Real(-rho * opposite, kBits), Real(-2 * rho * adjacent, kBits), real(1), real(0)}};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == k) continue;
      const Real factor(a[i][k] / a[k][k], kBits);
      for (std::size_t j = k; j < 4; ++j) a[i][j] -= factor * a[k][j];
    }
  return {Real(a[0][3] / a[0][0], kBits), Real(a[1][3] / a[1][1], kBits), Real(a[2][3] / a[2][2], kBits)};
}

LogPlot reflectivity_plot(std::string& table) {
  LogPlot plot;
  plot.width = 1200;
  plot.height = 640;
  plot.title = "Reflectivity towards 1";
  plot.subtitle = "unit square, E = 1 on the bottom; radiosity of the top";
  plot.x_title = "1 - rho";
  plot.y_title = "relative error of the radiosity";
  const std::vector<std::pair<std::string, Solver>> solvers = {{"cholesky, without subtraction", Solver::kCholesky},
                                                               {"cg, constant deflated", Solver::kCg},
                                                               {"lu in doubles", Solver::kLu},
                                                               {"gauss-seidel, 10,000 steps", Solver::kGaussSeidel}};
  for (const auto& [name, solver] : solvers) plot.curves.push_back({name, {}});
  plot.curves.push_back({"proven width of the bounds", {}});
  std::vector<double> largest(plot.curves.size(), 0);
  for (int k = kLeastBits; k <= kMostBits; ++k) {
    const Rational loss(1, Integer(1) << k);
    const std::string rho = to_string(Rational(1 - loss));
    const std::string text = fmt::format(
        R"({{"hottel": 1, "dimension": 2, "materials": {{"m": {{"reflectivity": "{0}"}}, "lamp": {{"reflectivity": "{0}", "emission": 1}}}},
"edges": [{{"name": "bottom", "points": [[1, 0], [0, 0]], "material": "lamp"}}],
"polylines": [{{"name": "rest", "points": [[0, 0], [0, 1], [1, 1], [1, 0]], "material": "m"}}]}})",
        rho);
    const PreparedScene2 prepared = prepare(parse_scene_2(text, "square"));
    const ExchangeMatrix matrix = exact_exchange(prepared);
    const Real reference = square_radiosities(Real(Real(1, kBits) - Real(loss, kBits), kBits))[2];
    const std::uint32_t top = *matrix.find("rest[1]");
    const double x = std::ldexp(1.0, -k);
    for (std::size_t s = 0; s < solvers.size(); ++s) {
      RadiosityOptions options;
      options.solver = solvers[s].second;
      const RadiositySolution solution =
          solve_radiosity(matrix, prepared.scene.materials, prepared.scene.sky_emission, options);
      const ElementRadiosity& element = solution.channels[0].elements[top];
      const double error = relative_error(element.radiosity, reference);
      plot.curves[s].points.push_back({x, error});
      largest[s] = std::max(largest[s], error);
      if (s > 0) continue;
      const double width = (element.upper - element.lower) / element.radiosity;
      plot.curves.back().points.push_back({x, width});
      largest.back() = std::max(largest.back(), width);
    }
  }
  table = "| | largest |\n|---|--:|\n";
  for (std::size_t s = 0; s < plot.curves.size(); ++s)
    table += fmt::format("| {} | {:.1e} |\n", plot.curves[s].name, largest[s]);
  return plot;
}

// The page
// --------------------------------------------------------------------------------------------------------------

constexpr const char* kIntroduction = R"(# Hard cases

What happens when geometry comes near to degeneracy? Each case below has a parameter that drives it there, over sixty
orders of magnitude, and a closed form that is evaluated with 1024 bits. The curves show the relative error of one view
factor: by the exact method, by the same method in plain doubles (`arithmetic:doubles`; `arithmetic:naive` also decides in
doubles what hides what), and by the methods that most codes use ([what they are](../solver/plane/methods)). An error of
1 means that the method printed 0, or twice the true value. Larger errors are drawn at 1000. The exact method stays below
1.2e-16, half a unit in the last place: it prints the double nearest to the true number.

Coordinates are typed as decimals and read exactly, so 4 - 10⁻⁶⁰ is not 4. That makes most of the difference: a program
that reads coordinates as doubles has closed the crack before it begins.

The same [in space](hard_cases_in_space.md). This page and its pictures are made by `tools/hard_cases`; the numbers are in
[hard_cases.csv](hard_cases.csv).

)";

void write_file(const std::filesystem::path& path, const std::string& bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.finish();
  file.commit();
}

int run(const std::filesystem::path& folder) {
  const MethodCatalogue2 methods = methods_2();
  std::string page = kIntroduction, csv = "case,parameter,method,relative_error\n";
  for (const HardCase& hard : hard_cases()) {
    const Result result = sweep(hard, methods);
    const std::string picture = "images/hard_case_" + hard.name + ".png";
    write_file(folder / picture, log_plot(plot_of(result), PictureFormat::kPng));
    page += fmt::format("## {}\n\n{}\n\n    {}\n\n![{}]({})\n\n", hard.title, hard.story, hard.closed_form, hard.title,
                        picture);
    page += fmt::format("| method | largest relative error | error above {:.0e} from |\n|---|--:|---|\n", kBroken);
    for (const Curve& curve : result.curves) {
      page += row_of(result, curve);
      for (std::size_t k = 0; k < curve.errors.size(); ++k)
        csv += fmt::format("{},{},{},{}\n", hard.name, decade(hard, static_cast<int>(k)), curve.method,
                           shortest(curve.errors[k]));
    }
    page += "\n";
    std::printf("%s\n", hard.name.c_str());
  }
  std::string table;
  const LogPlot reflectivity = reflectivity_plot(table);
  write_file(folder / "images/hard_case_reflectivity.png", log_plot(reflectivity, PictureFormat::kPng));
  page += fmt::format(
      "## Reflectivity towards 1\n\nIn a closed room hardly any light is lost when 1 - rho is small: the system is "
      "nearly singular, and ordinary solvers lose a digit with each digit of 1 - rho. In row-defect form, where 1 - "
      "rho itself is an input ([Radiosity](design/radiosity.md)), none is lost, and the bounds stay a few ulps "
      "wide.\n\n"
      "![Reflectivity towards 1](images/hard_case_reflectivity.png)\n\n{}",
      table);
  write_file(folder / "hard_cases.csv", csv);
  write_file(folder / "hard_cases.md", page);
  return 0;
}

}  // namespace
}  // namespace hottel

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "report_hard_cases FOLDER\n");
    return 2;
  }
  try {
    return hottel::run(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "report_hard_cases: %s\n", error.what());
    return 1;
  }
}
