#include "solver/space/light/gathered_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/space/prepared/face_patches.h"
#include "geometry/space/visibility/convex_cut.h"

namespace hottel {
namespace {

constexpr double kSlack = 1e-4;  // what a part of a run may be off, of all that arrives
constexpr int kMostHalvings = 40;

double coordinate(const Direction3& p, std::size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

Direction3 rounded_point(const Point3& p) { return {to_double(p.x), to_double(p.y), to_double(p.z)}; }

}  // namespace

bool GatheredLight3::Box::meets(const Box& other) const {
  return low_u < other.high_u && other.low_u < high_u && low_v < other.high_v && other.low_v < high_v;
}

double GatheredLight3::Linear::reach(const Box& box) const {
  double sum = 0;
  for (std::size_t c = 0; c < one.size(); ++c)
    sum += std::fabs(by_u[c]) * (box.high_u - box.low_u) + std::fabs(by_v[c]) * (box.high_v - box.low_v);
  return sum;
}

GatheredLight3::Box GatheredLight3::box_of(const Outline& outline) {
  Box box{outline[0].u, outline[0].u, outline[0].v, outline[0].v};
  for (const Flat& p : outline)
    box = {std::min(box.low_u, p.u), std::max(box.high_u, p.u), std::min(box.low_v, p.v), std::max(box.high_v, p.v)};
  return box;
}

// The part of a convex polygon within another one that goes around counter-clockwise.
GatheredLight3::Outline GatheredLight3::common(const Outline& polygon, const Outline& convex) {
  return common_convex(
      polygon, convex,
      [](const Flat& a, const Flat& b, const Flat& p) { return (b.u - a.u) * (p.v - a.v) - (b.v - a.v) * (p.u - a.u); },
      [](const Flat& p, const Flat& q, double t) {
        return Flat{p.u + t * (q.u - p.u), p.v + t * (q.v - p.v)};
      });
}

GatheredLight3::Outline GatheredLight3::flat(const Side& side, std::span<const Direction3> corners) {
  Outline result;
  for (const Direction3& p : corners) result.push_back({coordinate(p, side.axes[0]), coordinate(p, side.axes[1])});
  double area = 0;
  for (std::size_t k = 2; k < result.size(); ++k)
    area += (result[k - 1].u - result[0].u) * (result[k].v - result[0].v) -
            (result[k - 1].v - result[0].v) * (result[k].u - result[0].u);
  if (area < 0) std::ranges::reverse(result);
  return result;
}

Direction3 GatheredLight3::place(const Side& side, const Flat& p) {
  std::array<double, 3> result{};
  result[side.axes[0]] = p.u;
  result[side.axes[1]] = p.v;
  result[side.axes[2]] = side.one + p.u * side.by_u + p.v * side.by_v;
  return {result[0], result[1], result[2]};
}

double GatheredLight3::factor(const Side& side, const Outline& outline, const Eye& eye) {
  std::array<Direction3, 16> few;
  std::vector<Direction3> many;
  if (outline.size() > few.size()) many.resize(outline.size());
  const std::span<Direction3> ways = many.empty() ? std::span(few).first(outline.size()) : std::span<Direction3>(many);
  for (std::size_t k = 0; k < outline.size(); ++k) ways[k] = unit(place(side, outline[k]) - eye.place);
  return std::fabs(view_factor_3(ways, eye.normal));
}

GatheredLight3::GatheredLight3(const PreparedScene3& prepared, Granularity granularity,
                               const RadiositySolution& solution, std::span<const PartRun3> runs)
    : prepared_(prepared), solution_(solution), sides_(2 * prepared.occluders().size()) {
  const ElementTable3& table = *prepared.elements(granularity);
  for (std::size_t k = 0; k < table.parts().size(); ++k) {
    const ElementTable3::Part& part = table.parts()[k];
    if (part.patch.is_sky() || !table.has_row(part.label)) continue;
    Side& side = sides_[Face{part.patch.surface, part.is_back}.number()];
    if (side.parts.empty()) add_side(part.patch, side);
    std::vector<Direction3> corners;
    for (const Point3& corner : corners_of(prepared.occluders().vertices(), part.patch))
      corners.push_back(rounded_point(corner));
    Part& own = side.parts.emplace_back(Part{part.label, flat(side, corners), {}, {}, 0});
    own.box = box_of(own.outline);
    if (!runs.empty()) add_run(runs[k], side, own);
    side.is_one_value = side.is_one_value && own.runs.empty() && own.label == side.parts[0].label;
  }
  for (const Rational& emission : prepared.scene.sky_emission.value) sky_.push_back(to_double(emission));
}

// The coordinates by which a plane is told best.
void GatheredLight3::add_side(const Patch3& patch, Side& side) const {
  const Direction3 n = unit_of_3(normal_of_side_3(prepared_.occluders(), {patch.surface, false}));
  const std::array<double, 3> size{std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
  const auto most = static_cast<std::size_t>(std::ranges::max_element(size) - size.begin());
  side.axes = {(most + 1) % 3, (most + 2) % 3, most};
  const Direction3 corner = rounded_point(corners_of(prepared_.occluders().vertices(), patch)[0]);
  const double out = coordinate(n, most);
  side.by_u = -coordinate(n, side.axes[0]) / out;
  side.by_v = -coordinate(n, side.axes[1]) / out;
  side.one = dot(n, corner) / out;
}

void GatheredLight3::add_run(const PartRun3& run, const Side& side, Part& part) const {
  for (const PartRun3::Triangle& triangle : run.triangles) {
    std::array<Flat, 3> p;
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = {coordinate(triangle.corners[k], side.axes[0]), coordinate(triangle.corners[k], side.axes[1])};
    const Flat a{p[1].u - p[0].u, p[1].v - p[0].v}, b{p[2].u - p[0].u, p[2].v - p[0].v};
    const double area = a.u * b.v - a.v * b.u;
    if (area == 0) continue;
    Run own{flat(side, triangle.corners), {}, {}};
    own.box = box_of(own.outline);
    for (std::size_t c = 0; c < channels(); ++c) {
      const double to_a = triangle.values[1][c] - triangle.values[0][c];
      const double to_b = triangle.values[2][c] - triangle.values[0][c];
      own.value.by_u[c] = (to_a * b.v - to_b * a.v) / area;
      own.value.by_v[c] = (to_b * a.u - to_a * b.u) / area;
      own.value.one[c] = triangle.values[0][c] - own.value.by_u[c] * p[0].u - own.value.by_v[c] * p[0].v;
    }
    part.runs.push_back(std::move(own));
  }
  for (std::size_t c = 0; c < channels() && !part.runs.empty(); ++c) {
    double low = run.triangles[0].values[0][c], high = low;
    for (const PartRun3::Triangle& triangle : run.triangles)
      for (const auto& value : triangle.values) {
        low = std::min(low, value[c]);
        high = std::max(high, value[c]);
      }
    part.reach += high - low;
  }
}

void GatheredLight3::irradiance(const Point3& point, const Face& side, std::span<double> result) const {
  const Vector3 normal = normal_of_side_3(prepared_.occluders(), side);
  const VisibilityMap3 map =
      map_from(prepared_.occluders(), {.eye = point, .normal = Point3{normal.x, normal.y, normal.z}});
  const Eye eye{rounded_point(point), unit_of_3(normal)};
  std::fill(result.begin(), result.end(), 0.0);
  std::vector<Seen> near;
  for (const VisibilityMap3::Fragment& fragment : map.fragments) add_fragment(map, fragment, eye, result, near);
  for (std::size_t c = 0; c < result.size(); ++c) result[c] += map.sky_factor * sky_[c];
  double all = 0;
  for (const double value : result) all += value;
  for (const Seen& seen : near) add_runs(seen, eye, kSlack * all, result);
}

// Each element by what is seen of it, in the proportion of their factors.
void GatheredLight3::add_fragment(const VisibilityMap3& map, const VisibilityMap3::Fragment& fragment, const Eye& eye,
                                  std::span<double> result, std::vector<Seen>& near) const {
  const Side& side = sides_[fragment.face.number()];
  if (side.parts.empty()) return;
  if (side.is_one_value) return add(side.parts[0].label, fragment.factor, result);
  std::vector<Direction3> corners;
  for (std::uint32_t c = fragment.begin; c < fragment.end; ++c)
    corners.push_back({map.corners[c].x, map.corners[c].y, map.corners[c].z});
  const Outline outline = flat(side, corners);
  const Box box = box_of(outline);
  const std::size_t first = near.size();
  double sum = 0;
  for (const Part& part : side.parts) {
    if (!box.meets(part.box)) continue;
    Outline seen = common(outline, part.outline);
    const double its = seen.size() > 2 ? factor(side, seen, eye) : 0;
    if (!(its > 0)) continue;
    sum += its;
    near.push_back({&side, &part, std::move(seen), its});
  }
  if (!(sum > 0)) return add(side.parts[0].label, fragment.factor, result);
  for (std::size_t k = first; k < near.size(); ++k) {
    near[k].factor *= fragment.factor / sum;
    add(near[k].part->label, near[k].factor, result);
  }
}

void GatheredLight3::add(std::uint32_t label, double factor, std::span<double> result) const {
  for (std::size_t c = 0; c < result.size(); ++c) result[c] += factor * solution_.channels[c].elements[label].radiosity;
}

// A part of a run, halved until its middle stands for it.
struct GatheredLight3::Halving {
  const Side& side;
  const Run& run;
  const Eye& eye;
  double slack;
  std::span<double> result;

  void add(const Outline& outline, double its, int depth) const {
    const Box box = box_of(outline);
    const Flat middle = middle_of(outline);
    const double wide = box.high_u - box.low_u, high = box.high_v - box.low_v;
    const double away = length(place(side, middle) - eye.place);
    const double off = its * run.value.reach(box) * std::min(1.0, std::hypot(wide, high) / away) / 4;
    if (!(off > slack) || depth == kMostHalvings) {
      for (std::size_t c = 0; c < result.size(); ++c) result[c] += its * run.value.at(c, middle);
      return;
    }
    const auto half = [&](double sign) {
      return cut_convex(
          outline,
          [&](const Flat& p) {
            return sign * (wide > high ? p.u - (box.low_u + box.high_u) / 2 : p.v - (box.low_v + box.high_v) / 2);
          },
          [](const Flat& p, const Flat& q, double t) {
            return Flat{p.u + t * (q.u - p.u), p.v + t * (q.v - p.v)};
          });
    };
    const Outline low = half(-1), rest = half(1);
    const double of_low = low.size() > 2 ? std::min(factor(side, low, eye), its) : 0;
    if (low.size() > 2) add(low, of_low, depth + 1);
    if (rest.size() > 2) add(rest, its - of_low, depth + 1);
  }

  static Flat middle_of(const Outline& outline) {
    const Flat& o = outline[0];
    Flat moment{0, 0};
    double sum = 0;
    for (std::size_t k = 2; k < outline.size(); ++k) {
      const Flat &a = outline[k - 1], &b = outline[k];
      const double area = (a.u - o.u) * (b.v - o.v) - (a.v - o.v) * (b.u - o.u);
      sum += area;
      moment = {moment.u + area * (a.u - o.u + b.u - o.u) / 3, moment.v + area * (a.v - o.v + b.v - o.v) / 3};
    }
    return sum > 0 ? Flat{o.u + moment.u / sum, o.v + moment.v / sum} : o;
  }
};

// In place of what the element sends as one, what its runs send.
void GatheredLight3::add_runs(const Seen& seen, const Eye& eye, double slack, std::span<double> result) const {
  if (seen.part->runs.empty()) return;
  const Box box = box_of(seen.outline);
  const double away = length(place(*seen.side, seen.outline[0]) - eye.place);
  const double size = std::hypot(box.high_u - box.low_u, box.high_v - box.low_v);
  if (seen.factor * seen.part->reach * std::min(1.0, size / away) / 4 <= slack) return;
  std::vector<std::pair<const Run*, Outline>> pieces;
  std::vector<double> factors;
  double sum = 0;
  for (const Run& run : seen.part->runs) {
    if (!box.meets(run.box)) continue;
    Outline piece = common(seen.outline, run.outline);
    if (piece.size() < 3) continue;
    factors.push_back(factor(*seen.side, piece, eye));
    sum += factors.back();
    pieces.emplace_back(&run, std::move(piece));
  }
  if (!(sum > 0)) return;
  add(seen.part->label, -seen.factor, result);
  for (std::size_t k = 0; k < pieces.size(); ++k)
    Halving{*seen.side, *pieces[k].first, eye, slack, result}.add(pieces[k].second, factors[k] * (seen.factor / sum),
                                                                  0);
}

}  // namespace hottel
