#include "tests/storm/space/laws.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <utility>

#include "tests/oracle/space/pair_quadrature.h"

namespace hottel::storm {

using oracle::PairScene3;
using oracle::SpacePoint;
using oracle::SpacePolygon;

namespace {

constexpr double kTolerance = 1e-12;     // asked for, of the smaller area; and at least
constexpr double kDigits = 1e-14;        // of the square of the distance over which light goes
constexpr double kRounding = 1e-15;      // of the area: what is not told from nothing
constexpr std::uint64_t kRays = 32'000;  // some 1e-3 of the area
constexpr double kNeverTooMuch = 1e-9;
constexpr std::array<long, 6> kSkies{1, 2, 3, 5, 7, 1000};  // how far off the sky is
constexpr double kDeviations = 6;
constexpr double kEstimate = 4;  // times an estimate of an error: what is not told from luck

PairRequest3 request(double tolerance) {
  PairRequest3 result;
  result.tolerance = tolerance;
  return result;
}
PairRequest3 request(const Subject3& subject) { return request(subject.tolerance(subject.area())); }

std::string with_problem(const char* what, const PairResult3& measure) {
  return measure.problem.empty() ? "" : fmt::format("{}: {}\n", what, measure.problem);
}

// What is wrong with a measure that should be the subject's. Each of so many numbers may be off by a tolerance.
std::string other_than(const Subject3& subject, const PairResult3& measure, const char* what, int numbers = 2) {
  std::string wrong = with_problem(what, measure);
  const double off = measure.measure - subject.measure().measure;
  if (!(std::fabs(off) <= numbers * subject.slack()))
    wrong += fmt::format("S = {:.17g}, {}: {:.17g}, off by {:.2g} of the area\n", subject.measure().measure, what,
                         measure.measure, off / subject.area());
  const Enclosure &mine = subject.measure().bounds, &other = measure.bounds;
  if (!(std::max(mine.lower, other.lower) <= std::min(mine.upper, other.upper)))
    wrong += fmt::format("in [{:.17g}, {:.17g}], {}: in [{:.17g}, {:.17g}]\n", mine.lower, mine.upper, what,
                         other.lower, other.upper);
  if ((measure.measure == 0) != (subject.measure().measure == 0)) wrong += fmt::format("{}: S is 0 only once\n", what);
  if (measure.is_whole != subject.measure().is_whole)
    wrong += fmt::format("whole: {}, {}: {}\n", subject.measure().is_whole, what, measure.is_whole);
  return wrong;
}

std::string answer_is_broken(const Subject3& subject) {
  const PairResult3& m = subject.measure();
  std::string wrong = with_problem("pair", m);
  if (!(m.error <= subject.slack() * 1.001)) wrong += fmt::format("error {:.3g}\n", m.error);
  if (!(m.residual <= m.residual_bound))
    wrong += fmt::format("residual {:.3g} > {:.3g}\n", m.residual, m.residual_bound);
  if (!(0 <= m.bounds.lower && m.bounds.lower <= m.measure && m.measure <= m.bounds.upper))
    wrong += fmt::format("S = {:.17g} in [{:.17g}, {:.17g}]\n", m.measure, m.bounds.lower, m.bounds.upper);
  if (m.measure > subject.unobstructed() + subject.slack())
    wrong += fmt::format("S = {:.17g} > S0 = {:.17g}\n", m.measure, subject.unobstructed());
  if (m.sight == PairVisibility3::kHidden && (m.measure != 0 || m.bounds.upper != 0 || m.is_whole))
    wrong += fmt::format("hidden, S = {:.17g}\n", m.measure);
  if (m.sight == PairVisibility3::kClear && !m.is_whole) wrong += "clear, but not whole\n";
  return wrong;
}

bool is_on_lattice(const Polygons3& polygons) {
  return std::all_of(polygons.begin(), polygons.end(), [](const SpacePolygon& polygon) {
    return std::all_of(polygon.begin(), polygon.end(), [](const SpacePoint& p) {
      return p.x.get_den() <= 4 && p.y.get_den() <= 4 && p.z.get_den() <= 4;
    });
  });
}

std::string whole_is_broken(const Subject3& subject) {
  const PairResult3& m = subject.measure();
  const double lost = (subject.unobstructed() - m.measure) / subject.area();
  if (m.is_whole && !(std::fabs(lost) <= subject.tolerance(subject.area())))
    return fmt::format("whole, but {:.3g} of the area lost\n", lost);
  if (!m.is_whole && subject.unobstructed() > 0 && !(lost > kRounding) && is_on_lattice(subject.polygons()))
    return fmt::format("not whole, but only {:.3g} of the area lost; S = {:.17g}\n", lost, m.measure);
  return "";
}

std::string origin_is_broken(const Subject3& subject) {
  std::string wrong;
  for (const double size : {0.25, -1.0, 3.0}) {
    PairRequest3 moved = request(subject);
    // Of the size of the scene; the first one is a share of a length where the origin moves along a line.
    const double unit = size * std::sqrt(subject.area() / subject.scene().unit());
    const double shift[3] = {size, -unit / 2, unit / 4};
    std::copy(shift, shift + 3, moved.origin_shift);
    wrong += other_than(subject, subject.scene().measure(subject.i(), subject.j(), moved), "origin moved");
  }
  return wrong;
}

std::string reversal_is_broken(const Subject3& subject) {
  PairRequest3 reversed = request(subject);
  reversed.is_reversed = true;
  return other_than(subject, subject.scene().measure(subject.i(), subject.j(), reversed), "from j to i") +
         other_than(subject, subject.scene().measure(subject.j(), subject.i(), request(subject)), "exchanged");
}

std::string edges_are_broken(const Subject3& subject) {
  PairRequest3 along = request(subject);
  along.always_along_edges = true;
  std::string wrong = other_than(subject, subject.scene().measure(subject.i(), subject.j(), along), "along edges");
  along.is_reversed = true;
  return wrong + other_than(subject, subject.scene().measure(subject.i(), subject.j(), along), "along edges, from j");
}

std::string looseness_is_broken(const Subject3& subject) {
  std::string wrong;
  for (const double tolerance : {1e-6, 1e-9}) {
    PairRequest3 loose;
    loose.tolerance = tolerance;
    const PairResult3 m = subject.scene().measure(subject.i(), subject.j(), loose);
    wrong += with_problem("loose", m);
    const double off = std::fabs(m.measure - subject.measure().measure);
    if (!(off <= kEstimate * m.error + subject.measure().error && off <= 2 * tolerance * subject.area()))
      wrong += fmt::format("within {:.0e}: off by {:.3g}, error {:.3g}\n", tolerance, off, m.error);
    if (m.is_whole != subject.measure().is_whole || (m.measure == 0) != (subject.measure().measure == 0))
      wrong += fmt::format("within {:.0e}: other verdicts\n", tolerance);
  }
  return wrong;
}

// What two rules and a residual agree on is no part of a proof: that holds them, each way, about whatever origin.
std::string proof_is_broken(const Subject3& subject) {
  const PairResult3& m = subject.measure();
  if (!m.problem.empty()) return "";  // which other laws tell
  std::string wrong;
  for (const bool is_reversed : {false, true})
    for (const double tolerance : {1e-7, 1e-10}) {
      PairRequest3 how = request(tolerance);
      how.proves = true;
      how.is_reversed = is_reversed;
      if (is_reversed) how.origin_shift[1] = std::sqrt(subject.area() / subject.scene().unit()) / 3;
      const PairResult3 proven = subject.scene().measure(subject.i(), subject.j(), how);
      const double slack = 2 * subject.slack();
      if (!(proven.bounds.lower - slack <= m.measure && m.measure <= proven.bounds.upper + slack))
        wrong += fmt::format("S = {:.17g}, proven within {:.0e}: in [{:.17g}, {:.17g}]\n", m.measure, tolerance,
                             proven.bounds.lower, proven.bounds.upper);
      if ((proven.bounds.upper == 0) != (m.bounds.upper == 0)) wrong += "proven: S is 0 only once\n";
    }
  return wrong;
}

// Bounds that hold S need not hold the sum of a rule, but that is off by no more than it states, rounding included.
std::string statement_is_broken(const Subject3& subject) {
  const PairResult3& m = subject.measure();
  if (!m.problem.empty()) return "";                                    // which other laws tell
  const bool is_hard = subject.tolerance(subject.area()) > kTolerance;  // needles
  PairRequest3 how = request(1e-9);
  how.proves = true;
  const auto proven = subject.scene().measure(subject.i(), subject.j(), how).bounds;
  if (proven.lower - m.error <= m.measure && m.measure <= proven.upper + m.error &&
      (is_hard || proven.width() <= how.tolerance * subject.area()))
    return "";
  return fmt::format("S = {:.17g} +- {:.3g}, proven in [{:.17g}, {:.17g}]\n", m.measure, m.error, proven.lower,
                     proven.upper);
}

std::string rays_are_broken(const Subject3& subject) {
  const oracle::FlatPair pair = oracle::first_pair(subject.polygons());
  const PairResult3& m = subject.measure();
  std::string wrong;
  for (const bool is_reversed : {false, true}) {
    const oracle::RayEstimate rays =
        oracle::exchange_by_rays(is_reversed ? pair.reversed() : pair, subject.chance(), kRays);
    if (m.measure == 0 && rays.seen > 0) wrong += fmt::format("S = 0, but {} of {} rays arrive\n", rays.seen, kRays);
    if (std::fabs(rays.measure - m.measure) > kDeviations * rays.standard_error)
      wrong += fmt::format("S = {:.10g}, by rays {:.10g} +- {:.2g}\n", m.measure, rays.measure, rays.standard_error);
  }
  if (m.is_whole) {
    const std::uint64_t seen = oracle::exchange_by_rays(pair, subject.chance(), kRays).seen;
    const std::uint64_t all = oracle::exchange_by_rays({pair.i, pair.j, {}}, subject.chance(), kRays).seen;
    if (seen != all) wrong += fmt::format("whole, but {} of {} rays are held up\n", all - seen, all);
  }
  return wrong;
}

// Of the angle that their planes make.
double sine_between(const SpacePolygon& a, const SpacePolygon& b) {
  const auto normal = [](const SpacePolygon& polygon) { return oracle::FlatPlane(oracle::to_doubles(polygon)).normal; };
  return oracle::length(cross(normal(a), normal(b)));
}

std::string quadrature_is_broken(const Subject3& subject) {
  constexpr double kAsked = 1e-7;
  constexpr double kUndecided = 1e-5;    // its errors are estimates: in narrow wedges both ways may be off by more
  constexpr double kNarrowWedge = 1e-3;  // sine: what is lost, in a strip as narrow along the borders, no point may see
  constexpr std::uint64_t kMostPoints = 200'000;
  constexpr std::size_t kMostPolygons = 6;  // with more it takes seconds
  if (subject.polygons().size() > kMostPolygons) return "";
  if (const double sine = sine_between(subject.polygons()[0], subject.polygons()[1]); sine > 0 && sine < kNarrowWedge)
    return "";
  const oracle::FlatPair pair = oracle::first_pair(subject.polygons());
  const oracle::QuadratureResult there = oracle::exchange_by_quadrature(pair, kAsked, kMostPoints);
  const oracle::QuadratureResult back = oracle::exchange_by_quadrature(pair.reversed(), kAsked, kMostPoints);
  if (std::fabs(there.measure - back.measure) > kUndecided * subject.area()) return "";
  const oracle::QuadratureResult& better = there.error < back.error ? there : back;
  const double off = std::fabs(better.measure - subject.measure().measure);
  if (off <= 20 * better.error + std::fabs(there.measure - back.measure) + 1e-9 * subject.area()) return "";
  return fmt::format("S = {:.12g}, by quadrature {:.12g} +- {:.2g}, from j {:.12g} +- {:.2g}\n",
                     subject.measure().measure, there.measure, there.error, back.measure, back.error);
}

using Move = std::function<SpacePoint(const SpacePoint&)>;
Polygons3 moved(Polygons3 polygons, const Move& move) {
  for (SpacePolygon& polygon : polygons)
    for (SpacePoint& p : polygon) p = move(p);
  return polygons;
}

// The measure of polygons 0 and 1.
PairResult3 measure_of(const Polygons3& polygons, const Subject3& subject) {
  const PairScene3 scene(polygons);
  return scene.measure(scene.patch(0), scene.patch(1), request(subject));
}

// What differs from a measure that should be the same bit for bit, with areas in a unit of its own.
std::string not_the_same(const PairResult3& m, const PairResult3& other, double unit, const char* what) {
  const bool is_same = m.measure * unit == other.measure && m.error * unit == other.error &&
                       m.bounds.lower * unit == other.bounds.lower && m.bounds.upper * unit == other.bounds.upper &&
                       m.is_whole == other.is_whole && m.sight == other.sight && m.residual == other.residual &&
                       m.maps == other.maps && m.pieces == other.pieces && m.problem == other.problem;
  return is_same ? ""
                 : fmt::format("{}: S = {:.17g} in {} maps, not {:.17g} in {}\n", what, other.measure, other.maps,
                               unit * m.measure, m.maps);
}

std::string translation_is_broken(const Subject3& subject) {
  const SpacePoint far{(mpq_class(1) << 53) + 1, -(mpq_class(1) << 60) + 7, mpq_class(1) / 3};
  const Polygons3 polygons = moved(subject.polygons(), [&](const SpacePoint& p) {
    return SpacePoint{p.x + far.x, p.y + far.y, p.z + far.z};
  });
  return not_the_same(subject.measure(), measure_of(polygons, subject), 1, "moved");
}

std::string scaling_is_broken(const Subject3& subject) {
  const auto scaled = [&](const mpq_class& scale) {
    return moved(subject.polygons(), [&](const SpacePoint& p) {
      return SpacePoint{scale * p.x, scale * p.y, scale * p.z};
    });
  };
  std::string wrong =
      not_the_same(subject.measure(), measure_of(scaled(mpq_class(1) << 20), subject), 0x1p40, "times 2^20");
  const PairScene3 other(scaled(mpq_class(3) / 7));
  PairResult3 measure = other.measure(other.patch(0), other.patch(1), request(subject));
  const double same = measure.measure * (subject.scene().unit() / other.unit());
  if (std::fabs(same - subject.measure().measure) > 4e-16 * same)
    wrong += fmt::format("S = {:.17g}, times 3/7: {:.17g}\n", subject.measure().measure, same);
  return wrong;
}

std::string axes_are_broken(const Subject3& subject) {
  const auto to_y_z_x = [](const SpacePoint& p) { return SpacePoint{p.y, p.z, p.x}; };
  const auto to_other_side = [](const SpacePoint& p) { return SpacePoint{p.y, p.x, p.z}; };
  std::string wrong = other_than(subject, measure_of(moved(subject.polygons(), to_y_z_x), subject), "axes turned");
  Polygons3 reflected = moved(subject.polygons(), to_other_side);
  for (SpacePolygon& polygon : reflected) std::reverse(polygon.begin(), polygon.end());
  return wrong + other_than(subject, measure_of(reflected, subject), "reflected");
}

std::string rotation_is_broken(const Subject3& subject) {
  const auto turned = [&](const mpq_class& s, const mpq_class& t) {  // tangents of half the angles
    const mpq_class a = (1 - s * s) / (1 + s * s), b = 2 * s / (1 + s * s);
    const mpq_class c = (1 - t * t) / (1 + t * t), d = 2 * t / (1 + t * t);
    return moved(subject.polygons(), [&](const SpacePoint& p) {
      const SpacePoint q{a * p.x - b * p.y, b * p.x + a * p.y, p.z};
      return SpacePoint{q.x, c * q.y - d * q.z, d * q.y + c * q.z};
    });
  };
  const mpq_class s("123456789012345678901/987654321098765432109"), t("31415926535897932/27182818284590452");
  return other_than(subject, measure_of(turned(mpq_class(1, 2), mpq_class(2, 3)), subject), "turned") +
         other_than(subject, measure_of(turned(s, t), subject), "turned, many digits");
}

std::string order_is_broken(const Subject3& subject) {
  std::mt19937_64 random(subject.chance());
  Polygons3 polygons = subject.polygons();
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const auto begin = static_cast<std::ptrdiff_t>(random() % polygons[k].size());
    std::rotate(polygons[k].begin(), polygons[k].begin() + begin, polygons[k].end());
    if (k >= 2 && random() % 2 == 0) std::reverse(polygons[k].begin(), polygons[k].end());
  }
  for (std::size_t k = polygons.size(); k > 3; --k) std::swap(polygons[k - 1], polygons[2 + random() % (k - 2)]);
  // The pair stands last, so that vertices have other numbers.
  std::rotate(polygons.begin(), polygons.begin() + 2, polygons.end());
  const PairScene3 scene(polygons);
  const std::size_t n = polygons.size();
  return other_than(subject, scene.measure(scene.patch(n - 2), scene.patch(n - 1), request(subject)),
                    "in another order");
}

std::string cut_is_broken(const Subject3& subject) {
  std::mt19937_64 random(subject.chance());
  Polygons3 polygons = subject.polygons();
  if (polygons.size() < 3) return "";
  const std::size_t k = 2 + random() % (polygons.size() - 2);
  SpacePolygon& whole = polygons[k];
  std::rotate(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(random() % whole.size()), whole.end());
  // From the first corner to a point of a side that does not end there.
  const mpq_class t = mpq_class(1 + static_cast<long>(random() % 3)) / 4;
  const SpacePoint &p = whole[1], &q = whole[2];
  const SpacePoint at{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)};
  SpacePolygon rest{whole[0], at};
  rest.insert(rest.end(), whole.begin() + 2, whole.end());
  whole = {whole[0], whole[1], at};
  if (random() % 2 == 0) std::reverse(rest.begin(), rest.end());
  polygons.push_back(std::move(rest));
  return other_than(subject, measure_of(polygons, subject), "one is cut");
}

std::string fewer_is_broken(const Subject3& subject) {
  std::string wrong;
  for (std::size_t k = 2; k < subject.polygons().size(); ++k) {
    Polygons3 fewer = subject.polygons();
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
    const PairResult3 m = measure_of(fewer, subject);
    wrong += with_problem("without one", m);
    if (m.measure < subject.measure().measure - subject.slack())
      wrong += fmt::format("S = {:.17g}, without polygon {}: {:.17g}\n", subject.measure().measure, k, m.measure);
    if (subject.measure().is_whole && !m.is_whole) wrong += fmt::format("whole, but not without polygon {}\n", k);
  }
  return wrong;
}

// How much S can change at most where corners of polygons between move by 1: a side sweeps over lines of a measure of
// at most pi times its length, or twice that where light passes it on both sides; where a polygon meets a patch it
// moves along it the faster, the smaller the angle between them is.
double sensitivity(const Polygons3& polygons) {
  double lengths = 0;
  for (std::size_t k = 2; k < polygons.size(); ++k) {
    const oracle::FlatPolygon flat = oracle::to_doubles(polygons[k]);
    double outline = 0;
    for (std::size_t c = 0; c < flat.size(); ++c) outline += oracle::length(flat[(c + 1) % flat.size()] - flat[c]);
    lengths += outline;
    for (const std::size_t patch : {0, 1}) {
      const double sine = sine_between(polygons[k], polygons[patch]);
      if (sine > 0) lengths += outline / 2 / sine;
    }
  }
  return 2 * std::numbers::pi * lengths;
}

std::string nudge_is_broken(const Subject3& subject) {
  Polygons3 polygons = subject.polygons();
  const double size = nudge_3(polygons, subject.chance());
  if (size == 0) return "";
  const PairScene3 scene(polygons);
  const PairResult3 m = scene.measure(scene.patch(0), scene.patch(1), request(subject));
  PairRequest3 reversed = request(subject);
  reversed.is_reversed = true;
  const PairResult3 back = scene.measure(scene.patch(0), scene.patch(1), reversed);
  std::string wrong = with_problem("nudged", m) + with_problem("nudged, from j to i", back);
  const double off = std::fabs(m.measure - subject.measure().measure), slack = 2 * subject.slack();
  if (!(off <= size * sensitivity(polygons) + slack))
    wrong += fmt::format("S = {:.17g}, nudged by {:.3g}: {:.17g}\n", subject.measure().measure, size, m.measure);
  if (!(std::fabs(back.measure - m.measure) <= slack))
    wrong += fmt::format("nudged by {:.3g}: S = {:.17g}, from j to i: {:.17g}\n", size, m.measure, back.measure);
  if (back.is_whole != m.is_whole || (back.measure == 0) != (m.measure == 0))
    wrong += fmt::format("nudged by {:.3g}: other verdicts from j to i; S = {:.3g}, {:.3g}\n", size, m.measure,
                         back.measure);
  return wrong;
}

bool has_quarters(const SpacePolygon& p) { return p.size() == 3 || (p.size() == 4 && p[0] - p[1] == p[3] - p[2]); }

std::string elements_are_broken(const Subject3& subject) {
  const PairScene3& scene = subject.scene();
  std::string wrong;
  for (const std::size_t divided : {0, 1}) {
    if (!has_quarters(subject.polygons()[divided])) continue;
    PairResult3 sum;
    sum.is_whole = true;
    sum.bounds = {0, 0};
    for (const Patch3& part : scene.quarters(divided)) {
      const PairRequest3 how = request(subject.tolerance(subject.area() / 4));
      const PairResult3 m =
          divided == 0 ? scene.measure(part, subject.j(), how) : scene.measure(subject.i(), part, how);
      wrong += with_problem("quarter", m);
      sum.measure += m.measure;
      sum.bounds = {sum.bounds.lower + m.bounds.lower * (1 - kRounding),
                    sum.bounds.upper + m.bounds.upper * (1 + kRounding)};
      // A quarter that does not face the other one is not whole, but nothing of it is hidden either.
      const bool faces = scene.unobstructed(part, divided == 0 ? subject.j() : subject.i()) > 0;
      sum.is_whole = sum.is_whole && (m.is_whole || !faces);
    }
    sum.is_whole = sum.is_whole && sum.measure > 0;
    wrong += other_than(subject, sum, divided == 0 ? "sum of quarters of i" : "sum of quarters of j", 5);
  }
  return wrong;
}

std::string quarters_are_broken(const Subject3& subject) {
  const PairScene3& scene = subject.scene();
  if (!has_quarters(subject.polygons()[0]) || !has_quarters(subject.polygons()[1])) return "";
  double sum = 0;
  std::string wrong;
  for (const Patch3& a : scene.quarters(0))
    for (const Patch3& b : scene.quarters(1)) {
      const PairResult3 m = scene.measure(a, b, request(subject.tolerance(subject.area() / 4)));
      wrong += with_problem("two quarters", m);
      sum += m.measure;
    }
  const double off = (sum - subject.measure().measure) / subject.area();
  if (!(std::fabs(off) <= 17 * subject.tolerance(subject.area())))
    wrong += fmt::format("S = {:.17g}, sum of 16: {:.17g}, off by {:.2g} of the area\n", subject.measure().measure, sum,
                         off);
  return wrong;
}

std::string closure_is_broken(const Subject3& subject) {
  const PairScene3& scene = subject.scene();
  std::string wrong;
  for (const std::size_t from : {0, 1}) {
    const Patch3 i = scene.patch(from);
    const long margin = kSkies[subject.chance() % kSkies.size()];
    double sum = 0, slack = 0;
    const auto add = [&](const Patch3& to) {
      const double smaller = std::min(scene.area(i), scene.area(to));
      const double tolerance = std::max(subject.tolerance(smaller), margin < 10 ? 0 : kNeverTooMuch);
      const PairResult3 m = scene.measure(i, to, request(tolerance));
      wrong += with_problem("row", m);
      sum += m.measure;
      slack += std::max(tolerance * smaller, m.error);
    };
    for (std::size_t s = 0; s < subject.polygons().size(); ++s)
      for (const bool is_back : {false, true})
        if (s != from) add(scene.patch(s, is_back));
    for (const Patch3& side : scene.sky(margin)) add(side);
    const double area = scene.area(i), off = (sum - area) / area;
    if (!(std::fabs(off) * area <= slack)) wrong += fmt::format("row of polygon {} sums to 1 {:+.3g}\n", from, off);
  }
  return wrong;
}

// The square of the largest distance of a corner of polygon 0 or 1.
double square_of(const Polygons3& polygons) {
  double square = 0;
  for (const std::size_t k : {0, 1})
    for (const SpacePoint& p : polygons[k])
      for (const SpacePolygon& other : polygons)
        for (const SpacePoint& q : other) square = std::max(square, oracle::dot(q - p, q - p).get_d());
  return square;
}

}  // namespace

Subject3::Subject3(Polygons3 polygons, std::uint64_t chance)
    : polygons_(std::move(polygons)),
      chance_(chance),
      scene_(polygons_),
      i_(scene_.patch(0)),
      j_(scene_.patch(1)),
      area_(std::min(scene_.area(i_), scene_.area(j_))),
      square_(square_of(polygons_)),
      measure_(scene_.measure(i_, j_, request(tolerance(area_)))),
      unobstructed_(scene_.unobstructed(i_, j_)) {}

double Subject3::tolerance(double area) const { return std::max(kTolerance, kDigits * square_ / area); }

const std::vector<Law3>& laws_3() {
  static const std::vector<Law3> all{{"answer", answer_is_broken, 1},
                                     {"whole", whole_is_broken, 1},
                                     {"origin", origin_is_broken, 3},
                                     {"reversal", reversal_is_broken, 1},
                                     {"along edges", edges_are_broken, 2},
                                     {"loose", looseness_is_broken, 3},
                                     {"proven", proof_is_broken, 4},
                                     {"stated", statement_is_broken, 1},
                                     {"rays", rays_are_broken, 2},
                                     {"quadrature", quadrature_is_broken, 37},
                                     {"translation", translation_is_broken, 7},
                                     {"scaling", scaling_is_broken, 7},
                                     {"axes", axes_are_broken, 3},
                                     {"rotation", rotation_is_broken, 4},
                                     {"order", order_is_broken, 3},
                                     {"cut", cut_is_broken, 2},
                                     {"fewer", fewer_is_broken, 6},
                                     {"nudge", nudge_is_broken, 2},
                                     {"elements", elements_are_broken, 6},
                                     {"quarters", quarters_are_broken, 13},
                                     {"closure", closure_is_broken, 11}};
  return all;
}

}  // namespace hottel::storm
