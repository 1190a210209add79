// GUARANTEE: exact, enclosed or estimated, as the arithmetic allows.
// REFERENCE: docs/design/plane/exchange.md; for the naive signs L. Kettner, K. Mehlhorn, S. Pion, S. Schirra, C. Yap,
// Classroom examples of robustness problems in geometric computations, 2008.
#include "solver/plane/methods/arithmetic.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/doubles.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "solver/plane/methods/arithmetic_cgal.h"
#include "solver/plane/methods/arithmetic_naive.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/radiosity/matrix_checks.h"

namespace hottel {
namespace {

constexpr double kConversion = 0x1p12;  // more than the error of a fixed-point number below 2^63 in doubles
constexpr std::array<const char*, 5> kNames{"naive", "doubles", "bounds", "rounded", "cgal"};

// Vertices by exact signs and rounded lengths.
class FilteredPoints {
 public:
  explicit FilteredPoints(const Vertices2& vertices) : vertices_(vertices) {}
  int orientation(VertexId i, VertexId j, VertexId k) const { return vertices_.orientation(i, j, k); }
  double distance(VertexId i, VertexId j) const {
    const Vertices2::Approximate &p = vertices_.approximate(i), &q = vertices_.approximate(j);
    const double dx = q.x - p.x, dy = q.y - p.y;
    return std::sqrt(dx * dx + dy * dy);
  }

 private:
  const Vertices2& vertices_;
};

ExchangeMatrix naive_exchange(const PreparedScene2& prepared, const std::function<void(double)>& progress,
                              MethodReport& report) {
  const Arrangement2& arrangement = prepared.arrangement;
  const NaivePoints2 points(arrangement.vertices());
  const std::uint64_t limit = naive_step_limit(arrangement.triangulation());
  std::atomic<std::uint64_t> cut_off = 0;
  Stopwatch watch;
  const ElementTable2& table = *prepared.elements(Granularity::kElement);
  const PlainSums2 sums =
      plain_sums(arrangement, table, progress, [&](VertexId) { return StepLimit2(points, limit, cut_off); });
  ExchangeMatrix matrix = plain_matrix(table, sums, plain_lengths(arrangement, table, points));
  report.seconds = watch.lap();
  const WrongOrientations2 counts = count_wrong_orientations(arrangement, points);
  report.notes.push_back(fmt::format("of {} orientations {} have the wrong sign", counts.asked, counts.wrong));
  if (cut_off > 0)
    report.notes.push_back(fmt::format("{} of {} views were cut off", cut_off.load(), arrangement.vertices().size()));
  return matrix;
}

ExchangeMatrix filtered_exchange(const PreparedScene2& prepared, const std::function<void(double)>& progress) {
  const FilteredPoints points(prepared.arrangement.vertices());
  const ElementTable2& table = *prepared.elements(Granularity::kElement);
  const PlainSums2 sums =
      plain_sums(prepared.arrangement, table, progress, [&](VertexId) -> const FilteredPoints& { return points; });
  return plain_matrix(table, sums, plain_lengths(prepared.arrangement, table, points));
}

ExchangeMatrix cgal_exchange(const PreparedScene2& prepared, const std::function<void(double)>& progress,
                             MethodReport& report) {
  const ElementTable2& table = *prepared.elements(Granularity::kElement);
  const CgalExchange2 exchange = cgal_exchange(prepared.arrangement, table, progress);
  Stopwatch watch;
  ExchangeMatrix matrix = plain_matrix(table, exchange.sums, exchange.lengths);
  report.seconds = exchange.seconds + watch.lap();
  return matrix;
}

// The quotient of two sums in doubles, and an interval that contains it and the real one. (Conversions are good to
// 2^-51, and so is a quotient of what is; ends are moved outwards by more.)
struct EnclosedQuotient {
  double value;
  Enclosure bounds;
};
EnclosedQuotient quotient(const FixedSum& numerator, const FixedSum& denominator) {
  constexpr double kSlack = 0x1p-48;
  const double n = double_near(numerator.value), d = double_near(denominator.value);
  const double n_error = numerator.error + kConversion, d_error = denominator.error + kConversion;
  const double lower = (n - n_error) / (d + d_error), upper = (n + n_error) / (d - d_error);
  const Enclosure bounds{std::max(0.0, lower * (1 - kSlack)), d > d_error ? std::min(1.0, upper * (1 + kSlack)) : 1};
  return {d > 0 ? std::clamp(n / d, bounds.lower, bounds.upper) : bounds.lower, bounds};
}

// Entries of pairs that ascend by both labels, laid out by rows: each_entry(visit) calls visit(from, to, number), the
// same twice over; put(place, from, to, number) is called after allot(count).
template <class EachEntry, class Allot, class Put>
std::vector<std::size_t> lay_out_rows(std::uint32_t rows, const EachEntry& each_entry, const Allot& allot,
                                      const Put& put) {
  std::vector<std::size_t> begin(rows + std::size_t{1}, 0);
  each_entry([&](std::uint32_t from, std::uint32_t, const auto&) { ++begin[from + 1]; });
  for (std::uint32_t i = 0; i < rows; ++i) begin[i + 1] += begin[i];
  allot(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  each_entry([&](std::uint32_t from, std::uint32_t to, const auto& number) { put(next[from]++, from, to, number); });
  return begin;
}

FactorEntry entry_of(std::uint32_t to, double factor) {
  return {to, {factor, 0}, std::numeric_limits<double>::quiet_NaN()};
}

ExchangeMatrix enclosed_exchange(const PreparedScene2& prepared, const std::function<void(double)>& progress,
                                 MethodReport& report) {
  const ElementTable2& table = *prepared.elements(Granularity::kElement);
  const double length_error = prepared.arrangement.vertices().length_error();
  SumCounts2 counts;
  const PairSums2 pairs =
      sum_visible_pairs(prepared.arrangement, table, progress, std::numeric_limits<std::uint64_t>::max(), counts);
  const auto each_entry = [&](const auto& visit) {
    pairs.for_each([&](const PairSum2& pair) {
      const std::uint32_t i = pair.i(), j = pair.j();
      if (pair.value == 0 && pair.inexact == 0) return;
      if (table.has_row(i)) visit(i, j, pair);
      if (j != i && table.has_row(j)) visit(j, i, pair);
    });
  };
  FactorEntries entries;
  std::vector<Enclosure> bounds;
  double widest = 0;
  const auto allot = [&](std::size_t count) {
    entries.resize(count);
    bounds.resize(count);
  };
  const auto put = [&](std::size_t place, std::uint32_t from, std::uint32_t to, const PairSum2& pair) {
    const FixedSum& length = table.length(from);
    const EnclosedQuotient factor = quotient(pair.sum(length_error), {2 * length.value, 2 * length.error});
    // Of a pair that may see each other something must be said.
    entries.set(place, entry_of(to, factor.value != 0 ? factor.value : factor.bounds.upper / 2));
    bounds[place] = factor.bounds;
    widest = std::max({widest, factor.value - factor.bounds.lower, factor.bounds.upper - factor.value});
  };
  std::vector<std::size_t> begin = lay_out_rows(table.count(), each_entry, allot, put);

  report.notes.push_back(fmt::format("every factor lies within {:.2g} of the real one", 1.06 * widest));
  std::size_t undecided = 0;
  pairs.for_each([&](const PairSum2& pair) {
    undecided += pair.inexact > 0 && double_near(pair.value) <= pair.sum(length_error).error;
  });
  if (undecided > 0)
    report.notes.push_back(fmt::format("of {} pairs it is not decided whether they see each other", undecided));
  ExchangeMatrix matrix(table.elements(), Guarantee::kEnclosed);
  matrix.assign(std::move(begin), std::move(entries), {}, std::move(bounds));
  matrix.promise_closed_rows();
  return matrix;
}

// What bounds the sums of any pair, in units of the smallest element's length.
struct SumScale {
  double terms;          // at most so many in one sum
  double longest;        // no distance is longer
  double length_error;   // of a fixed-point length
  double conversion;     // of a fixed-point sum to doubles, as quotient() allows for it
  double approximation;  // of a coordinate in doubles
};
// Nothing when no element has a row, or one is too short for fixed point.
std::optional<SumScale> scale_of(const PreparedScene2& prepared, const ElementTable2& table) {
  const Vertices2& vertices = prepared.arrangement.vertices();
  std::optional<Int128> least;
  for (std::uint32_t label = 0; label < table.count(); ++label)
    if (table.has_row(label) && (!least || table.length(label).value < *least)) least = table.length(label).value;
  if (!least || *least <= 0) return std::nullopt;
  const Int128 smallest = *least;
  const Rational unit = vertices.fixed_unit();
  const double coordinate =
      to_double(scaled_by_power_of_two(Rational(1), vertices.exponent()) / (unit * Rational(to_integer(smallest))));
  const auto n = static_cast<double>(vertices.size());
  // Each of n (n - 1) / 2 gaps gives a pair four terms or fewer. Approximate coordinates are below 2^60 or 2^53 and
  // off by half a unit of their last place at most.
  return SumScale{2 * n * n, 3 * coordinate, vertices.length_error() / double_near(smallest),
                  kConversion / double_near(smallest), vertices.approximation_error() > 0 ? coordinate * 0x1p-52 : 0};
}

class Arithmetic2 final : public ElementMethod2 {
 public:
  explicit Arithmetic2(ArithmeticKind2 arithmetic) : arithmetic_(arithmetic) {
    info_.name = info_.family = std::string("arithmetic:") + kNames[static_cast<std::size_t>(arithmetic)];
    info_.reference = "docs/design/plane/exchange.md";
    info_.guarantee = arithmetic == ArithmeticKind2::kRounded  ? Guarantee::kExact
                      : arithmetic == ArithmeticKind2::kBounds ? Guarantee::kEnclosed
                                                               : Guarantee::kEstimated;
  }
  const MethodInfo& info() const override { return info_; }
  std::optional<double> declared_error(const PreparedScene2& prepared) const override;

  ExchangeMatrix compute_elements(const PreparedScene2& prepared, const std::function<void(double)>& progress,
                                  MethodReport& report) const override {
    ExchangeMatrix matrix = run(prepared, progress, report);
    report.row_defect = closure_defect(matrix);
    return matrix;
  }

 private:
  ExchangeMatrix run(const PreparedScene2& prepared, const std::function<void(double)>& progress,
                     MethodReport& report) const {
    switch (arithmetic_) {
      case ArithmeticKind2::kNaive:
        return naive_exchange(prepared, progress, report);
      case ArithmeticKind2::kDoubles:
        return filtered_exchange(prepared, progress);
      case ArithmeticKind2::kBounds:
        return enclosed_exchange(prepared, progress, report);
      case ArithmeticKind2::kCgal:
        return cgal_exchange(prepared, progress, report);
      case ArithmeticKind2::kRounded:
        break;
    }
    return exact_exchange(prepared,
                          {.granularity = Granularity::kElement, .wants_visibility = false, .progress = progress});
  }

  ArithmeticKind2 arithmetic_;
  MethodInfo info_;
};

// A sum of n doubles is off by n 2^-53 times the sum of their absolute values; sums of n lengths that are each off by
// e, by n e more. CGAL::to_double promises five digits and no more; naive signs nothing.
std::optional<double> Arithmetic2::declared_error(const PreparedScene2& prepared) const {
  if (arithmetic_ == ArithmeticKind2::kRounded) return 0;
  if (arithmetic_ == ArithmeticKind2::kNaive || arithmetic_ == ArithmeticKind2::kCgal) return std::nullopt;
  const std::optional<SumScale> scale = scale_of(prepared, *prepared.elements(Granularity::kElement));
  if (!scale) return std::nullopt;
  // Both the sum and the length it is divided by; a factor is at most 1.
  const auto of_quotient = [](double rounding, double of_sum) {
    return of_sum < 0.25 ? std::optional(rounding + 2 * of_sum) : std::nullopt;
  };
  if (arithmetic_ == ArithmeticKind2::kBounds)
    return of_quotient(0x1p-48, scale->terms * scale->length_error + scale->conversion);
  const double of_length = 8 * kUnitRoundoff * scale->longest + 4 * scale->approximation;
  return of_quotient(4 * kUnitRoundoff, scale->terms * (of_length + scale->terms * kUnitRoundoff * scale->longest));
}

}  // namespace

ExchangeMatrix plain_matrix(const ElementTable2& table, const PlainSums2& sums, const std::vector<double>& lengths) {
  const auto each_entry = [&](const auto& visit) {
    const auto visit_row = [&](std::uint32_t from, std::uint32_t to, double sum) {
      if (table.has_row(from) && lengths[from] > 0) visit(from, to, sum / (2 * lengths[from]));
    };
    for (const auto& part : sums)
      for (const PlainTerm2& sum : part) {
        const std::uint32_t i = sum.i(), j = sum.j();
        if (sum.value == 0) continue;
        visit_row(i, j, sum.value);
        if (j != i) visit_row(j, i, sum.value);
      }
  };
  FactorEntries entries;
  std::vector<std::size_t> begin = lay_out_rows(
      table.count(), each_entry, [&](std::size_t count) { entries.resize(count); },
      [&](std::size_t place, std::uint32_t, std::uint32_t to, double factor) {
        entries.set(place, entry_of(to, factor));
      });
  ExchangeMatrix matrix(table.elements(), Guarantee::kEstimated);
  matrix.assign(std::move(begin), std::move(entries));
  return matrix;
}

std::unique_ptr<ExchangeMethod2> arithmetic_method_2(ArithmeticKind2 arithmetic) {
  return std::make_unique<Arithmetic2>(arithmetic);
}

MethodFamily2 arithmetic_family_2() {
  return {
      .name = "arithmetic",
      .pattern = "arithmetic:naive|doubles|bounds|rounded|cgal",
      .what = "the exact method's sweep in other arithmetic: what exactness costs",
      .reference = "docs/design/plane/exchange.md",
      .guarantee = Guarantee::kEstimated,
      .sweep = {"arithmetic:naive", "arithmetic:doubles", "arithmetic:bounds", "arithmetic:rounded", "arithmetic:cgal"},
      .make = [](std::string_view variant) {
        for (std::size_t k = 0; k < kNames.size(); ++k)
          if (variant == ":" + std::string(kNames[k])) return arithmetic_method_2(static_cast<ArithmeticKind2>(k));
        throw UsageError("the method arithmetic has the variants :naive, :doubles, :bounds, :rounded and :cgal");
      }};
}

}  // namespace hottel
