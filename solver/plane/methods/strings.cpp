// Crossed strings of each pair as if it were alone, times the visibility of the centres: what most codes do.
// F_ij = (crossed - uncrossed strings) / (2 A_i), of the parts of the two that lie before each other, if the centres
// see each other.
// GUARANTEE: estimated. Exact but for rounding between elements that lie before each other and see each other wholly;
// then the error is below 2^-50 times the strings over A_i.
// REFERENCE: Hottel's crossed strings (Hottel and Sarofim, Radiative Transfer, 1967).
#include <limits>
#include <memory>

#include "kernel/support/failure.h"
#include "solver/plane/methods/cosine_kernel.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/plane/methods/pair_method.h"
#include "solver/plane/methods/run_points.h"

namespace hottel {
namespace {

constexpr const char* kStringsReference = "crossed strings; Hottel and Sarofim 1967";

// The part of a run that lies before the front of another.
struct Part {
  LocalPoint2 from, to;
  bool is_whole = true;
};

std::optional<Part> part_before(const Vertices2& vertices, const ElementRun2& run, const ElementRun2& front) {
  const int from_side = vertices.orientation(front.ends.a, front.ends.b, run.ends.a);
  const int to_side = vertices.orientation(front.ends.a, front.ends.b, run.ends.b);
  if (from_side >= 0 && to_side >= 0) return std::nullopt;
  Part part{run.from, run.to};
  if (from_side <= 0 && to_side <= 0) return part;
  const double from_height = dot(front.normal(), run.from - front.from);
  const double to_height = dot(front.normal(), run.to - front.from);
  const double difference = from_height - to_height;
  const double cut = difference != 0 ? std::min(1.0, std::max(0.0, from_height / difference)) : 0.5;
  (from_side > 0 ? part.from : part.to) = run.at(cut);
  part.is_whole = false;
  return part;
}

// S(a, b) of two runs alone in the plane. With fronts on the right, crossed strings join from to from and to to to.
double crossed_strings(const Vertices2& vertices, const ElementRun2& a, const ElementRun2& b) {
  const auto p = part_before(vertices, a, b), q = part_before(vertices, b, a);
  if (!p || !q) return 0;
  const double crossed = length(q->from - p->from) + length(q->to - p->to);
  const double uncrossed = length(q->to - p->from) + length(q->from - p->to);
  return std::max(0.0, (crossed - uncrossed) / 2);
}

class Strings2 final : public PairMethod2 {
 public:
  Strings2() : PairMethod2({"strings", "strings", 0, Guarantee::kEstimated, kStringsReference}) {}

 protected:
  Pairs pairs(const PreparedScene2& prepared, const ElementGeometry2& geometry) const override {
    const auto centres = std::make_shared<const RunPoints2>(prepared, geometry, std::vector{Rational(1, 2)});
    const auto factors = [&geometry, &vertices = prepared.arrangement.vertices(), centres](std::uint32_t i,
                                                                                           std::uint32_t j) {
      return sum_over_runs(geometry, i, j, [&](const ElementRun2& a, const ElementRun2& b) {
        return centres->see_each_other(a, 0, b, 0) ? crossed_strings(vertices, a, b) : 0;
      });
    };
    return {partners_of(centres), factors};
  }
  double error_of_free_runs(const Vertices2& vertices, const ElementGeometry2&, const ElementRun2& a,
                            const ElementRun2& b) const override {
    const auto p = part_before(vertices, a, b), q = part_before(vertices, b, a);
    if (!p || !q || !p->is_whole || !q->is_whole) return std::numeric_limits<double>::infinity();
    const double strings =
        length(q->from - p->from) + length(q->to - p->to) + length(q->to - p->from) + length(q->from - p->to);
    return (0x1p-50 * strings + 0x1p-100) / (a.length * b.length);
  }
};

}  // namespace

MethodFamily2 strings_family_2() {
  return {.name = "strings",
          .pattern = "strings",
          .what = "crossed strings of the pair alone, times the visibility of the centres",
          .reference = kStringsReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = {"strings"},
          .make = [](std::string_view variant) -> std::unique_ptr<ExchangeMethod2> {
            if (!variant.empty()) throw UsageError("the method strings has no variants");
            return std::make_unique<Strings2>();
          }};
}

}  // namespace hottel
