// Bytes as a tiny scene on a lattice, where nearly everything touches, overlaps or lines up: overlay, factors,
// radiosities and light, held against the brute force over rationals and against the laws.
#include <fuzzer/FuzzedDataProvider.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/plane/light/illumination_grid.h"
#include "solver/radiosity/radiosity.h"
#include "tests/oracle/plane/brute_force.h"
#include "tests/oracle/plane/split.h"

namespace hottel {
namespace {

constexpr unsigned kBits = 256;

// The scene under test, for the report of a failure.
const Scene2* current = nullptr;

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n%s", what, write_scene_2(*current).c_str());
  std::abort();
}

Material material(const char* name, Rational reflectivity, int emission) {
  return {name, Spectrum::scalar(reflectivity), Spectrum::scalar(emission)};
}

// At most seven edges on a lattice of step 1, 1/2, 1/3 or 1/10, in a room or not.
Scene2 scene_of(FuzzedDataProvider& bytes) {
  Scene2 scene;
  scene.file = "fuzz";
  scene.materials = {material("white", Rational(1, 2), 0), material("lamp", Rational(1, 4), 1),
                     material("mirror", 1, 0), material("nearly", 1 - Rational(1, 1L << 40), 0)};
  const int steps = bytes.ConsumeIntegralInRange(1, 6);
  const int denominator = std::vector{1, 2, 3, 10}[bytes.ConsumeIntegralInRange<std::size_t>(0, 3)];
  const auto coordinate = [&] {
    Rational value(bytes.ConsumeIntegralInRange(0, steps), denominator);
    value.canonicalize();
    return value;
  };
  const auto add = [&scene](const Point2& from, const Point2& to, std::uint32_t front,
                            std::optional<std::uint32_t> back) {
    Surface surface;
    surface.name = "e" + std::to_string(scene.surfaces.size());
    surface.material = front;
    surface.back = back;
    surface.group = static_cast<std::uint32_t>(scene.groups.size());
    scene.groups.push_back(surface.name);
    scene.add(surface, {from, to});
  };
  if (bytes.ConsumeBool()) {
    Rational far(steps, denominator);
    far.canonicalize();
    const Point2 corners[] = {{0, 0}, {0, far}, {far, far}, {far, 0}};
    for (int k = 0; k < 4; ++k) add(corners[k], corners[(k + 1) % 4], k == 0 ? 1 : 0, {});
  }
  const int edges = bytes.ConsumeIntegralInRange(1, 7);
  for (int k = 0; k < edges; ++k) {
    const Point2 from{coordinate(), coordinate()}, to{coordinate(), coordinate()};
    const auto front = bytes.ConsumeIntegralInRange<std::uint32_t>(0, 3);
    const auto back = bytes.ConsumeIntegralInRange<std::uint32_t>(0, 4);
    if (from != to) add(from, to, front, back < 4 ? std::optional(back) : std::nullopt);
  }
  return scene;
}

std::vector<oracle::InputSegment> for_oracle(const Scene2& scene) {
  std::vector<oracle::InputSegment> edges;
  for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
    const Surface& s = scene.surfaces[k];
    const auto& [from, to] = scene.edges[k];
    edges.push_back(
        {from.x, from.y, to.x, to.y, static_cast<int>(s.material), s.back ? static_cast<int>(*s.back) : -1});
  }
  return edges;
}

mpf_class value_of(const oracle::LengthSum& lengths) {
  mpf_class sum(0, kBits);
  for (const auto& [squared, coefficient] : lengths) sum += coefficient * sqrt(mpf_class(squared, kBits));
  return sum;
}

// Every factor against M / (2 A) of the brute force, to its enclosure; no entry where M is 0.
void check_against_oracle(const ExchangeMatrix& matrix, const std::vector<oracle::Segment>& pieces) {
  const oracle::Measures measures = oracle::exchange_measures(pieces);
  std::map<int, mpf_class> length;
  for (const oracle::Segment& piece : pieces) {
    const mpq_class x = piece.bx - piece.ax, y = piece.by - piece.ay;
    for (const int label : {piece.left, piece.right}) {
      const auto place = length.try_emplace(label, mpf_class(0, kBits)).first;
      place->second += sqrt(mpf_class(x * x + y * y, kBits));
    }
  }
  const auto label = [&](std::uint32_t i) { return i == matrix.sky() ? oracle::kInfinity : static_cast<int>(i); };
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    for (std::uint32_t j = 0; j <= matrix.sky(); ++j) {
      const Rounded factor = matrix.factor(i, j);
      const auto place = measures.find(std::minmax({label(i), label(j)}));
      const mpf_class real(place == measures.end() ? mpf_class(0, kBits) : value_of(place->second), kBits);
      const mpf_class expected(real / (2 * length.at(label(i))), kBits);
      const Enclosure bounds = factor.enclosure();
      const mpf_class slack(1e-60, kBits);  // of the reference itself
      require(mpf_class(bounds.lower, kBits) <= expected + slack && expected <= mpf_class(bounds.upper, kBits) + slack,
              "a factor differs from the brute force");
    }
  }
}

void check_laws(const ExchangeMatrix& matrix, const ExchangeReport& report) {
  require(report.closure_is_exact, "rows do not close");
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    double sum = 0;
    for (const FactorEntry& entry : matrix.row(i)) {
      require(entry.factor.value > 0 && entry.factor.value <= 1, "a factor is not in (0, 1]");
      require(entry.visibility > 0 && entry.visibility <= 1, "a visibility is not in (0, 1]");
      sum += entry.factor.value;
    }
    if (matrix.has_row(i)) require(std::fabs(sum - 1) < 1e-14, "a row does not sum to 1");
  }
}

void check_light(const PreparedScene2& prepared, const ExchangeMatrix& matrix) {
  RadiositySolution solution;
  try {
    solution = solve_radiosity(matrix, prepared.scene.materials, prepared.scene.sky_emission);
  } catch (const RequestError&) {
    return;  // a mirrored cell that emits
  }
  double brightest = 0;
  for (const ElementRadiosity& element : solution.channels[0].elements) {
    require(element.lower <= element.radiosity && element.radiosity <= element.upper, "a radiosity is out of bounds");
    require(element.lower >= 0 && element.radiosity >= element.emission, "a radiosity is below its emission");
    brightest = std::max(brightest, element.radiosity);
  }
  const ElementTable2& table = *prepared.elements(Granularity::kFace);
  const IlluminationGrid2 light =
      illuminate_points(prepared, grid_over(prepared.scene, 4, 4), table, sent_out_2(table, solution, prepared.scene));
  for (const double value : light.values)
    require(value >= 0 && value <= brightest, "light at a point exceeds the brightest face");
}

}  // namespace
}  // namespace hottel

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hottel;
  FuzzedDataProvider bytes(data, size);
  Scene2 scene = scene_of(bytes);
  if (scene.surfaces.empty()) return 0;
  current = &scene;
  const oracle::Split split = oracle::split(for_oracle(scene));
  const bool is_conflicting = !split.conflicts.empty();
  try {
    const PreparedScene2 prepared = prepare(scene);
    require(!is_conflicting, "a conflict of claims was not seen");
    ExchangeReport report;
    const ExchangeMatrix matrix = exact_exchange(prepared, {}, &report);
    check_laws(matrix, report);
    check_against_oracle(matrix, split.pieces);
    check_light(prepared, matrix);
  } catch (const InputError&) {
    require(is_conflicting, "a scene without conflict was refused");
  }
  return 0;
}
