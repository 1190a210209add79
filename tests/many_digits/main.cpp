// hottel_many_digits: what pairs exchange, to thirty digits, as lines that a test holds against proven bounds. Exit
// code 1 when one fails: from 1 to 0 it is another sum, and both must agree.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/oracle/space/exchange_to_digits.h"
#include "tests/oracle/space/real_of_digits.h"
#include "tests/oracle/space/space_scenes.h"
#include "tests/storm/space/lattice_scene.h"

namespace {

using namespace hottel;
using oracle::SpacePolygon;
using Digits = oracle::RealOf<50>;

constexpr double kAgree = 1e-31;  // of the smaller area

double area(const SpacePolygon& polygon) {
  oracle::SpacePoint sum{0, 0, 0};
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const oracle::SpacePoint part = cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
    sum = {sum.x + part.x, sum.y + part.y, sum.z + part.z};
  }
  return std::sqrt(dot(sum, sum).get_d()) / 2;
}

// The measure, or nothing where from 1 to 0 it is another one.
std::optional<std::string> measure_of(std::vector<SpacePolygon> polygons, bool asks_all) {
  const oracle::DigitsResult there = oracle::exchange_to_digits(polygons, asks_all);
  std::swap(polygons[0], polygons[1]);
  const oracle::DigitsResult back = oracle::exchange_to_digits(polygons, asks_all);
  const Digits apart = abs(Digits(there.measure) - Digits(back.measure));
  if (apart > kAgree * std::min(area(polygons[0]), area(polygons[1]))) return std::nullopt;
  return there.measure;
}

// Prints NAME,MEASURE; returns false where there is none.
bool print_line(const std::string& name, const std::vector<SpacePolygon>& polygons) {
  try {
    std::optional<std::string> measure = measure_of(polygons, false);
    if (!measure) measure = measure_of(polygons, true);
    if (!measure) throw std::runtime_error("the sum from 1 to 0 is another one");
    fmt::print("{},{}\n", name, *measure);
    std::fflush(stdout);
    return true;
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}: {}\n", name, e.what());
    return false;
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t first = 0, scenes = 1, step = 1;
  std::string file;
  CLI::App app{"What polygons 0 and 1 exchange past all others, to thirty digits: of lattice scenes, or of a file"};
  app.add_option("--seed", first, "number of the first scene of the lattice")->capture_default_str();
  app.add_option("--scenes", scenes, "how many")->capture_default_str();
  app.add_option("--step", step, "take one of so many")->capture_default_str()->check(CLI::PositiveNumber);
  app.add_option("--file", file, "the cases of a file like occluded.json instead")->check(CLI::ExistingFile);
  CLI11_PARSE(app, argc, argv);
  bool is_right = true;
  const auto add = [&](const std::string& name, const std::vector<SpacePolygon>& polygons) {
    is_right = print_line(name, polygons) && is_right;
  };
  if (file.empty())
    for (std::uint64_t k = 0; k < scenes; ++k)
      add(std::to_string(first + k * step), storm::lattice_scene_3(first + k * step).polygons);
  else
    for (const oracle::SpaceCase& one : oracle::read_space_cases(file)) add(one.name, one.polygons);
  return is_right ? 0 : 1;
}
