#include "tests/storm/space/hiding_laws.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <random>
#include <utility>

#include "geometry/space/arrangement/merged_occluders.h"
#include "geometry/space/hiding/hiders.h"
#include "geometry/space/pairs/pair_details.h"
#include "geometry/space/pairs/patch_halves.h"
#include "tests/oracle/space/filtered_rays.h"
#include "tests/storm/space/contacts.h"

namespace hottel::storm {

using oracle::SpacePoint;
using oracle::SpacePolygon;
using Row = HidingSubject3::Row;
using Target = HidingSubject3::Target;

namespace {

constexpr double kTolerance = 1e-12;  // asked for, of the smaller area; and at least
constexpr double kDigits = 1e-14;     // of the square of the distance over which light goes
constexpr double kFarTolerance = 1e-9;
constexpr std::array<long, 5> kSkies{1, 2, 3, 7, 1000};  // how far off the sky is
constexpr int kEyes = 3, kRaysOfEye = 50, kRaysOfBody = 40, kTargets = 12, kWalked = 80;

SpacePoint operator+(const SpacePoint& a, const SpacePoint& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
SpacePoint times(const mpq_class& s, const SpacePoint& a) { return {s * a.x, s * a.y, s * a.z}; }

SpacePoint to_scene(const Vertices3& vertices, const IntegerVector& corner, const Integer& weight) {
  const mpq_class scale = vertices.scale() / weight;
  const Point3& origin = vertices.origin();
  return {origin.x + scale * corner.x, origin.y + scale * corner.y, origin.z + scale * corner.z};
}
SpacePolygon to_scene(const Vertices3& vertices, const Patch3& patch) {
  SpacePolygon polygon;
  for (const IntegerVector& corner : patch.corners) polygon.push_back(to_scene(vertices, corner, patch.weight));
  return polygon;
}

double square_of(const Polygons3& polygons) {
  double square = 0;
  for (const SpacePoint& p : polygons[0])
    for (const SpacePolygon& other : polygons)
      for (const SpacePoint& q : other) square = std::max(square, oracle::dot(q - p, q - p).get_d());
  return square;
}

std::string name_of(const HidingSubject3& subject, const Row& row, const Target& target) {
  const std::string to = target.polygon < subject.polygons().size()
                             ? fmt::format("{} of polygon {}", target.is_back ? "back" : "front", target.polygon)
                         : target.patch.is_all_of_the_sky()
                             ? "all of the sky"
                             : fmt::format("side {} of the sky", target.polygon - subject.polygons().size());
  return fmt::format("{} of polygon 0 to {}", row.is_back ? "back" : "front", to);
}

class Drawer {
 public:
  Drawer(std::uint64_t chance, std::uint64_t salt) : random_(chance * 31 + salt) {}
  long below(std::size_t count) { return static_cast<long>(random_() % count); }

  // Inside a convex polygon or body; one in two is close to a corner, or to a side.
  SpacePoint within(const std::vector<SpacePoint>& corners) {
    const bool is_close = below(2) == 0;
    SpacePoint sum;
    mpq_class weights = 0;
    for (const SpacePoint& corner : corners) {
      const long weight = is_close && below(2) == 0 ? 1 + below(3) : 1000 + below(1000);
      sum = sum + times(weight, corner);
      weights += weight;
    }
    return times(1 / weights, sum);
  }
  SpacePoint way() {
    const auto any = [this] { return below(199) - 99; };
    SpacePoint way;
    do {
      const long x = any(), y = any(), z = any();
      way = {x, y, z};
    } while (way == SpacePoint{});
    return way;
  }

 private:
  std::mt19937_64 random_;
};

// Whether a polygon in another plane touches the point of a patch: a ray from there may go into a body that stands on
// it.
bool is_touched(const Polygons3& polygons, const SpacePoint& point, const SpacePoint& normal_of_patch) {
  return std::any_of(polygons.begin(), polygons.end(), [&](const SpacePolygon& polygon) {
    return side_of(polygon, point) == 0 && cross(oracle::normal_of(polygon), normal_of_patch) != SpacePoint{} &&
           place_in(polygon, point) >= 0;
  });
}

// Sends rays from points of a patch to its front and calls visit(polygon, is_back) for what each meets first. Points at
// which something touches the patch send none.
template <class Visit>
void send_rays(const HidingSubject3& subject, const SpacePolygon& patch, std::uint64_t salt, const Visit& visit) {
  Drawer draw(subject.chance(), salt);
  const Polygons3& polygons = subject.with_sky();
  for (int e = 0; e < kEyes; ++e) {
    const SpacePoint eye = draw.within(patch), front = oracle::normal_of(patch);
    if (is_touched(polygons, eye, front)) continue;
    oracle::FilteredRayCaster cast(polygons, eye);
    for (int k = 0; k < kRaysOfEye; ++k) {
      const SpacePoint way = draw.below(3) == 0
                                 ? draw.way()
                                 : draw.within(polygons[static_cast<std::size_t>(draw.below(polygons.size()))]) - eye;
      if (sgn(dot(front, way)) <= 0) continue;
      const oracle::NearestPolygon met = cast(way);
      if (!met.is_plain || met.polygon < 0) continue;
      const auto number = static_cast<std::size_t>(met.polygon);
      visit(number, sgn(dot(oracle::normal_of(polygons[number]), way)) > 0);
    }
  }
}

std::string rays_are_broken(const HidingSubject3& subject) {
  std::string wrong;
  for (const Row& row : subject.rows()) {
    std::vector<std::array<int, 2>> arrived(subject.with_sky().size());
    send_rays(subject, to_scene(subject.scene().occluders().vertices(), row.patch), row.is_back,
              [&](std::size_t polygon, bool is_back) { ++arrived[polygon][is_back]; });
    for (const Target& target : row.targets)
      if (target.measure.measure == 0 && arrived[target.polygon][target.is_back] > 0)
        wrong += fmt::format("{}: S = 0, but {} rays arrive\n", name_of(subject, row, target),
                             arrived[target.polygon][target.is_back]);
  }
  return wrong;
}

std::vector<Patch3> quarters_of(const Patch3& patch) {
  std::vector<Patch3> quarters;
  for (const Patch3& half : halves_of(patch))
    for (Patch3& quarter : halves_of(half)) quarters.push_back(std::move(quarter));
  return quarters;
}

std::string never_first_is_broken(const HidingSubject3& subject) {
  std::string wrong;
  const Vertices3& vertices = subject.scene().occluders().vertices();
  const MergedOccluders3 merged(subject.scene().occluders());
  const Hiders3 hiders(merged.occluders());
  for (const Row& row : subject.rows()) {
    std::vector<Patch3> patches = quarters_of(row.patch);
    patches.push_back(row.patch);
    for (std::size_t k = 0; k < patches.size(); ++k) {
      patches[k].surface = merged.surface_of(0);
      FirstMet3 first_met(hiders, patches[k], merged.occluders().size());
      send_rays(subject, to_scene(vertices, patches[k]), 2 * k + row.is_back, [&](std::size_t polygon, bool) {
        if (polygon >= subject.polygons().size()) return;
        const std::uint32_t surface = merged.surface_of(static_cast<std::uint32_t>(polygon));
        if (first_met.is_never_first(surface))
          wrong += fmt::format("{} of polygon 0, patch {}: polygon {} is never first, but a ray arrives there\n",
                               row.is_back ? "back" : "front", k, polygon);
      });
    }
  }
  return wrong;
}

// Along a line from a point, in the unit of the direction.
struct Way {
  SpacePoint eye, direction;
};

class BodyCheck {
 public:
  BodyCheck(const Occluders3& occluders, const ConvexBody3& body) : vertices_(occluders.vertices()), body_(body) {
    for (const VertexId3 v : body.corners) corners_.push_back(place(v));
    for (const std::uint32_t s : body.surfaces) {
      surfaces_.emplace_back();
      for (const VertexId3 v : occluders.outline(s)) surfaces_.back().push_back(place(v));
    }
  }

  std::string broken(Drawer draw) const {
    for (std::size_t k = 0; k <= body_.planes.size(); ++k) {
      const BodyPlane3* plane = k < body_.planes.size() ? &body_.planes[k] : body_.lid ? &*body_.lid : nullptr;
      if (plane == nullptr) continue;
      int inside = 0;
      for (const SpacePoint& p : corners_) {
        const int sign = sgn(height(*plane, p));
        if (sign > 0) return "a corner is beyond a plane\n";
        inside += sign < 0;
      }
      if (inside == 0) return "no corner is off a plane\n";
    }
    for (int k = 0; k < kRaysOfBody; ++k) {
      const Way way{draw.within(corners_), draw.way()};
      if (std::string wrong = leaves_wrongly(way); !wrong.empty()) return wrong;
    }
    return "";
  }

 private:
  SpacePoint place(VertexId3 v) const { return to_scene(vertices_, vertices_.exact(v), 1); }
  static SpacePoint normal(const BodyPlane3& plane) {
    return {mpq_class(plane.outward.x), mpq_class(plane.outward.y), mpq_class(plane.outward.z)};
  }
  mpq_class height(const BodyPlane3& plane, const SpacePoint& p) const {
    return oracle::dot(normal(plane), p - place(plane.at));
  }
  // How far it is to a plane, where the line leaves the half space.
  std::optional<mpq_class> distance(const BodyPlane3& plane, const Way& way) const {
    const mpq_class slope = oracle::dot(normal(plane), way.direction);
    if (slope <= 0) return std::nullopt;
    return -height(plane, way.eye) / slope;
  }

  std::string leaves_wrongly(const Way& way) const {
    const oracle::NearestPolygon met = oracle::FilteredRayCaster(surfaces_, way.eye)(way.direction);
    if (!met.is_plain) return "";
    const std::optional<mpq_class> to_lid = body_.lid ? distance(*body_.lid, way) : std::nullopt;
    std::optional<mpq_class> nearest;
    for (const BodyPlane3& plane : body_.planes)
      if (const auto to = distance(plane, way); to && (!nearest || *to < *nearest)) nearest = to;
    if (!nearest && !to_lid) return "a line does not leave a body\n";
    if (to_lid && (!nearest || *to_lid <= *nearest)) {
      if (met.polygon < 0 || (nearest && *to_lid == *nearest)) return "";
      const std::uint32_t plane = body_.plane_of[static_cast<std::size_t>(met.polygon)];
      return plane == ConvexBody3::kNone ? "" : "a line through the lid meets a surface that is not in it\n";
    }
    if (met.polygon < 0) return "a line leaves a body, but not through a surface or its lid\n";
    const std::uint32_t plane = body_.plane_of[static_cast<std::size_t>(met.polygon)];
    if (plane == ConvexBody3::kNone) return "a line meets a surface in the lid, but does not pass it\n";
    return distance(body_.planes[plane], way) == nearest ? "" : "a line leaves a body through another surface\n";
  }

  const Vertices3& vertices_;
  const ConvexBody3& body_;
  std::vector<SpacePoint> corners_;
  std::vector<SpacePolygon> surfaces_;
};

std::string bodies_are_broken(const HidingSubject3& subject) {
  const MergedOccluders3 merged(subject.scene().occluders());
  const ConvexBodies3 bodies(merged.occluders());
  std::string wrong;
  for (std::size_t b = 0; b < bodies.bodies().size(); ++b)
    wrong += BodyCheck(merged.occluders(), bodies.bodies()[b]).broken(Drawer(subject.chance(), b));
  return wrong;
}

// What is wrong with a measure of the same.
std::string other_than(const HidingSubject3& subject, const Row& row, const Target& target, const PairResult3& other,
                       const char* what, double slack) {
  const PairResult3& m = target.measure;
  std::string wrong;
  if (!other.problem.empty() && m.problem.empty()) return "";  // what is walked may be too much for doubles
  if (other.problem != m.problem) wrong += fmt::format("'{}', {}: '{}'; ", m.problem, what, other.problem);
  if ((m.measure == 0) != (other.measure == 0) || m.is_whole != other.is_whole)
    wrong += fmt::format("{}: other verdicts; ", what);
  if (!(std::fabs(m.measure - other.measure) <= slack)) wrong += fmt::format("off by more than {:.2g}; ", slack);
  if (!(std::max(m.bounds.lower, other.bounds.lower) <= std::min(m.bounds.upper, other.bounds.upper)))
    wrong += "bounds are apart; ";
  if (wrong.empty()) return "";
  return fmt::format("{}: {}S = {:.17g} ({}), {}: {:.17g} ({})\n", name_of(subject, row, target), wrong, m.measure,
                     m.is_whole ? "whole" : "not whole", what, other.measure, other.is_whole ? "whole" : "not whole");
}

std::string walked_is_broken(const HidingSubject3& subject) {
  std::string wrong;
  Drawer draw(subject.chance(), 9);
  for (const Row& row : subject.rows())
    for (const Target& target : row.targets) {
      // Where there are many it takes long.
      if (draw.below(row.targets.size()) >= kWalked) continue;
      PairRequest3 request = subject.request(row.patch, target.patch);
      request.asks_hiders = false;
      const PairResult3 walked = subject.scene().measure(row.patch, target.patch, request);
      wrong += other_than(subject, row, target, walked, "walked", 2 * subject.slack(row.patch, target.patch));
    }
  return wrong;
}

std::string closure_is_broken(const HidingSubject3& subject) {
  std::string wrong;
  for (const Row& row : subject.rows()) {
    double sum = 0, slack = 0, lower = 0, upper = 0;
    for (const Target& target : row.targets) {
      if (!target.measure.problem.empty())
        wrong += fmt::format("{}: {}\n", name_of(subject, row, target), target.measure.problem);
      sum += target.measure.measure;
      lower += target.measure.bounds.lower;
      upper += target.measure.bounds.upper;
      slack += std::max(subject.slack(row.patch, target.patch), target.measure.error);
    }
    const double area = subject.scene().area(row.patch);
    if (!(std::fabs(sum - area) <= slack) || lower > area * (1 + 1e-14) || upper < area * (1 - 1e-14))
      wrong += fmt::format("{} of polygon 0: its row sums to 1 {:+.3g}, in [{:.17g}, {:.17g}]\n",
                           row.is_back ? "back" : "front", (sum - area) / area, lower / area, upper / area);
  }
  return wrong;
}

template <class Visit>
void for_some_targets(const HidingSubject3& subject, std::uint64_t salt, const Visit& visit) {
  Drawer draw(subject.chance(), salt);
  for (int k = 0; k < kTargets; ++k) {
    const Row& row = subject.rows()[static_cast<std::size_t>(draw.below(subject.rows().size()))];
    visit(row, row.targets[static_cast<std::size_t>(draw.below(row.targets.size()))]);
  }
}

std::string reversal_is_broken(const HidingSubject3& subject) {
  std::string wrong;
  for_some_targets(subject, 7, [&](const Row& row, const Target& target) {
    const PairResult3 reversed =
        subject.scene().measure(target.patch, row.patch, subject.request(row.patch, target.patch));
    wrong += other_than(subject, row, target, reversed, "reversed", 2 * subject.slack(row.patch, target.patch));
  });
  return wrong;
}

std::string alone_is_broken(const HidingSubject3& subject) {
  std::string wrong;
  const double unit = subject.scene().unit();
  for_some_targets(subject, 10, [&](const Row& row, const Target& target) {
    const PairRequest3 request = subject.request(row.patch, target.patch);
    PairDetails3 details;
    const PairResult3& m = target.measure;
    for (PairDetails3* told : {static_cast<PairDetails3*>(nullptr), &details}) {
      const PairResult3 alone = subject.scene().measurer().measure(row.patch, target.patch, request, told);
      if (unit * alone.measure != m.measure || unit * alone.error != m.error ||
          unit * alone.bounds.lower != m.bounds.lower || unit * alone.bounds.upper != m.bounds.upper ||
          alone.is_whole != m.is_whole || alone.problem != m.problem)
        wrong += fmt::format("{}: S = {:.17g} in a row, {:.17g} {}\n", name_of(subject, row, target), m.measure,
                             unit * alone.measure, told ? "with details" : "alone");
    }
  });
  return wrong;
}

std::string parts_are_broken(const HidingSubject3& subject) {
  std::string wrong;
  for_some_targets(subject, 8, [&](const Row& row, const Target& target) {
    PairResult3 sum;
    double slack = 2 * subject.slack(row.patch, target.patch);
    for (const Patch3& part : quarters_of(row.patch)) {
      const PairResult3 m = subject.scene().measure(part, target.patch, subject.request(part, target.patch));
      sum.measure += m.measure;
      sum.bounds = {sum.bounds.lower + m.bounds.lower, sum.bounds.upper + m.bounds.upper};
      if (!m.problem.empty()) sum.problem = m.problem;
      slack += subject.slack(part, target.patch);
    }
    sum.bounds = {sum.bounds.lower * (1 - 1e-15), sum.bounds.upper * (1 + 1e-15)};
    sum.is_whole = target.measure.is_whole;
    wrong += other_than(subject, row, target, sum, "in parts", slack);
  });
  return wrong;
}

// All of the sky from a patch, in scene units.
PairResult3 sky_from(const HidingSubject3& subject, const Patch3& patch, const PairRequest3& request) {
  PairResult3 m = subject.scene().measurer().measure(patch, Patch3::all_of_the_sky(), request);
  const double unit = subject.scene().unit();
  m.measure *= unit;
  m.error *= unit;
  m.bounds = {m.bounds.lower * unit, m.bounds.upper * unit};
  return m;
}

std::string sky_is_broken(const HidingSubject3& subject) {
  std::string wrong;
  for (const Row& row : subject.rows()) {
    Target all{subject.polygons().size(), false, Patch3::all_of_the_sky(), {}};
    PairRequest3 request{
        .tolerance = std::max(kTolerance, kDigits * square_of(subject.polygons()) / subject.scene().area(row.patch))};
    const double slack = request.tolerance * subject.scene().area(row.patch);
    all.measure = sky_from(subject, row.patch, request);
    PairResult3 of_sides;
    of_sides.is_whole = true;
    double slack_of_sides = slack;
    for (const Target& side : row.targets) {
      if (!side.patch.is_sky()) continue;
      of_sides.measure += side.measure.measure;
      of_sides.bounds = {of_sides.bounds.lower + side.measure.bounds.lower * (1 - 1e-15),
                         of_sides.bounds.upper + side.measure.bounds.upper * (1 + 1e-15)};
      of_sides.is_whole &= side.measure.is_whole || side.measure.sight == PairVisibility3::kHidden;
      if (!side.measure.problem.empty()) of_sides.problem = side.measure.problem;
      slack_of_sides += std::max(subject.slack(row.patch, side.patch), side.measure.error);
    }
    of_sides.is_whole = all.measure.is_whole;  // of sides nothing is whole that is hidden by the horizon
    wrong += other_than(subject, row, all, of_sides, "by six sides", slack_of_sides);
    request.asks_hiders = false;
    wrong += other_than(subject, row, all, sky_from(subject, row.patch, request), "walked", 2 * slack);
    request.asks_hiders = true;
    PairResult3 of_parts;
    double slack_of_parts = slack;
    for (const Patch3& part : quarters_of(row.patch)) {
      PairRequest3 of_part = request;
      of_part.tolerance = std::max(kTolerance, slack / subject.scene().area(part));
      const PairResult3 m = sky_from(subject, part, of_part);
      of_parts.measure += m.measure;
      of_parts.bounds = {of_parts.bounds.lower + m.bounds.lower * (1 - 1e-15),
                         of_parts.bounds.upper + m.bounds.upper * (1 + 1e-15)};
      if (!m.problem.empty()) of_parts.problem = m.problem;
      slack_of_parts += of_part.tolerance * subject.scene().area(part);
    }
    of_parts.is_whole = all.measure.is_whole;
    wrong += other_than(subject, row, all, of_parts, "in parts", slack_of_parts);
  }
  return wrong;
}

std::string matrix_is_broken(const HidingSubject3& subject) { return subject.matrix().wrong; }

}  // namespace

HidingSubject3::HidingSubject3(Polygons3 polygons, std::uint64_t chance)
    : polygons_(std::move(polygons)), with_sky_(polygons_), chance_(chance), scene_(polygons_) {
  const std::vector<Patch3> sky = scene_.sky(kSkies[chance % kSkies.size()]);
  for (const Patch3& side : sky) with_sky_.push_back(to_scene(scene_.occluders().vertices(), side));
  square_ = square_of(polygons_);
  sky_square_ = square_of(with_sky_);
  for (const bool is_back : {false, true}) {
    Row row{is_back, scene_.patch(0, is_back), {}};
    PairRow3 pairs(scene_.measurer(), row.patch);
    const double unit = scene_.unit();
    const auto add = [&](std::size_t polygon, bool is_other_back, Patch3 patch) {
      PairResult3 m = pairs.measure(patch, request(row.patch, patch));
      m.measure *= unit;
      m.error *= unit;
      m.bounds = {m.bounds.lower * unit, m.bounds.upper * unit};
      row.targets.push_back({polygon, is_other_back, std::move(patch), std::move(m)});
    };
    for (std::size_t k = 1; k < polygons_.size(); ++k)
      for (const bool is_other_back : {false, true}) add(k, is_other_back, scene_.patch(k, is_other_back));
    for (std::size_t k = 0; k < sky.size(); ++k) add(polygons_.size() + k, false, sky[k]);
    rows_.push_back(std::move(row));
  }
}

const MatrixAnswer3& HidingSubject3::matrix() const {
  if (!matrix_) matrix_ = matrix_answer_3(polygons_, chance_);
  return *matrix_;
}

PairRequest3 HidingSubject3::request(const Patch3& i, const Patch3& j) const {
  const double area = std::min(scene_.area(i), scene_.area(j));
  const bool is_far = (i.is_sky() || j.is_sky()) && kSkies[chance_ % kSkies.size()] > 10;
  const double square = i.is_sky() || j.is_sky() ? sky_square_ : square_;
  PairRequest3 request;
  request.tolerance = std::max({kTolerance, kDigits * square / area, is_far ? kFarTolerance : 0.0});
  return request;
}

double HidingSubject3::slack(const Patch3& i, const Patch3& j) const {
  return request(i, j).tolerance * std::min(scene_.area(i), scene_.area(j));
}

const std::vector<HidingLaw3>& hiding_laws_3() {
  static const std::vector<HidingLaw3> all{{"bodies", bodies_are_broken, 1},
                                           {"rays", rays_are_broken, 1},
                                           {"never first", never_first_is_broken, 1},
                                           {"walked", walked_is_broken, 1},
                                           {"closure", closure_is_broken, 1},
                                           {"reversed", reversal_is_broken, 2},
                                           {"alone", alone_is_broken, 5},
                                           {"parts", parts_are_broken, 3},
                                           {"sky", sky_is_broken, 2},
                                           {"matrix", matrix_is_broken, 4, true}};
  return all;
}

}  // namespace hottel::storm
